//! Writes the description for the Open Simulation Platform (OSP-IS 1.0), which groups the variables of a vector or an
//! angle, so that a system structure connects them in one connection.

use std::io;

use super::attributes::units;
use super::xml::{document, element, empty};
use crate::table::Table;

const NAMESPACE: &str = "https://open-simulation-platform.com/OspModelDescription/1.0.0";

pub(crate) fn osp(table: &Table) -> io::Result<String> {
    let attributes = [("xmlns", NAMESPACE.to_owned()), ("version", "1.0".to_owned())];
    document("OspModelDescription", &attributes, |xml| {
        super::xml::units(xml, &units(table))?;
        element(xml, "VariableGroups", &[], |xml| {
            for group in &table.groups {
                element(xml, group.kind, &[("name", group.name.clone())], |xml| {
                    for &member in &group.members {
                        let variable = &table.variables[member];
                        let mut attributes = vec![("ref", variable.name.clone())];
                        let unit = variable.unit.name();
                        attributes.extend(unit.map(|name| ("unit", name.to_owned())));
                        empty(xml, "Variable", &attributes)?;
                    }
                    Ok(())
                })?;
            }
            Ok(())
        })
    })
}
