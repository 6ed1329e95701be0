//! FMI 2.0.

use std::io;

use super::attributes::{
    about, causality, enumerations, initial, items, outputs, range, start, units, variability,
};
use super::nominal::{Scales, nominal};
use super::xml::{Attributes, Xml, document, element, empty};
use crate::plan::Plan;
use crate::table::{Class, Variable};

/// Time, the table's first variable, is left out: FMI 2.0 does not require it, and libcosim rejects a time without a
/// start value, although the standard forbids a start value.
const LEFT_OUT: usize = 1;

pub(super) fn model(plan: &Plan, name: &str, identifier: &str) -> io::Result<String> {
    let [model_name, rest @ ..] = about(plan, name);
    let mut attributes: Attributes =
        vec![("fmiVersion", "2.0".into()), model_name, ("guid", plan.token.clone())];
    attributes.extend(rest);
    document("fmiModelDescription", &attributes, |xml| {
        let yes = || "true".to_owned();
        let abilities = [
            ("modelIdentifier", identifier.to_owned()),
            ("canHandleVariableCommunicationStepSize", yes()),
            ("canNotUseMemoryManagementFunctions", yes()),
            ("canGetAndSetFMUstate", yes()),
            ("canSerializeFMUstate", yes()),
        ];
        empty(xml, "CoSimulation", &abilities)?;
        super::xml::units(xml, &units(&plan.table))?;
        types(xml, plan)?;
        element(xml, "LogCategories", &[], |xml| {
            empty(xml, "Category", &[("name", "logStatusError".to_owned())])
        })?;
        let setup = &plan.scenario.setup;
        let experiment = [
            ("startTime", "0".to_owned()),
            ("stopTime", setup.duration_s.to_string()),
            ("stepSize", setup.step_s.to_string()),
        ];
        empty(xml, "DefaultExperiment", &experiment)?;
        element(xml, "ModelVariables", &[], |xml| {
            let mut all = plan.table.variables.iter().enumerate().skip(LEFT_OUT);
            let scales = Scales::of(setup);
            all.try_for_each(|(reference, v)| variable(xml, reference, v, scales))
        })?;
        element(xml, "ModelStructure", &[], |xml| {
            unknowns(xml, "Outputs", plan)?;
            unknowns(xml, "InitialUnknowns", plan)
        })
    })
}

fn types(xml: &mut Xml, plan: &Plan) -> io::Result<()> {
    let all = enumerations(&plan.table);
    if all.is_empty() {
        return Ok(());
    }
    element(xml, "TypeDefinitions", &[], |xml| {
        all.iter().try_for_each(|one| {
            let about =
                [("name", one.name.to_owned()), ("description", one.description.to_owned())];
            element(xml, "SimpleType", &about, |xml| {
                element(xml, "Enumeration", &[], |xml| items(xml, one))
            })
        })
    })
}

fn variable(
    xml: &mut Xml,
    reference: usize,
    variable: &Variable,
    scales: Scales,
) -> io::Result<()> {
    let mut attributes: Attributes = vec![
        ("name", variable.name.clone()),
        ("valueReference", reference.to_string()),
        ("description", variable.description.clone()),
        ("causality", causality(variable).to_owned()),
        ("variability", variability(variable).to_owned()),
    ];
    attributes.extend(initial(variable).map(|text| ("initial", text.to_owned())));
    element(xml, "ScalarVariable", &attributes, |xml| {
        let (name, mut attributes) = match variable.class {
            Class::Real => {
                let unit = variable.unit.name().map(|name| ("unit", name.to_owned()));
                ("Real", unit.into_iter().collect())
            }
            Class::Integer => ("Integer", Vec::new()),
            Class::Boolean => ("Boolean", Vec::new()),
            Class::Enumeration => {
                let declared =
                    variable.enumeration().map(|one| ("declaredType", one.name.to_owned()));
                ("Enumeration", declared.into_iter().collect())
            }
        };
        attributes.extend(range(variable));
        let nominal = nominal(variable, scales);
        attributes.extend(nominal.map(|value| ("nominal", value.to_string())));
        attributes.extend(start(variable).map(|text| ("start", text)));
        empty(xml, name, &attributes)
    })
}

/// The description lists no dependencies, which means that all outputs depend on all inputs; this is true of the FMU.
/// The indices of outputs count from 1, among the variables of the description.
fn unknowns(xml: &mut Xml, name: &str, plan: &Plan) -> io::Result<()> {
    element(xml, name, &[], |xml| {
        let mut all = outputs(&plan.table);
        all.try_for_each(|index| {
            empty(xml, "Unknown", &[("index", (index + 1 - LEFT_OUT).to_string())])
        })
    })
}
