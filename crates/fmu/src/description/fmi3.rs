//! FMI 3.0.

use std::io;

use super::attributes::{
    about, causality, enumerations, initial, items, outputs, range, start, units, variability,
};
use super::nominal::{Scales, nominal};
use super::xml::{Attributes, Xml, document, element, empty};
use crate::plan::Plan;
use crate::table::{Class, Kind, Variable};

pub(super) fn model(plan: &Plan, name: &str, identifier: &str) -> io::Result<String> {
    let [model_name, rest @ ..] = about(plan, name);
    let token = ("instantiationToken", plan.token.clone());
    let mut attributes: Attributes = vec![("fmiVersion", "3.0".into()), model_name, token];
    attributes.extend(rest);
    let setup = &plan.scenario.setup;
    document("fmiModelDescription", &attributes, |xml| {
        let yes = || "true".to_owned();
        let mut abilities = vec![
            ("modelIdentifier", identifier.to_owned()),
            ("canGetAndSetFMUState", yes()),
            ("canSerializeFMUState", yes()),
            ("canHandleVariableCommunicationStepSize", yes()),
        ];
        if plan.bundle.kind == Kind::Simulation {
            abilities.push(("fixedInternalStepSize", setup.step_s.to_string()));
        }
        empty(xml, "CoSimulation", &abilities)?;
        super::xml::units(xml, &units(&plan.table))?;
        types(xml, plan)?;
        element(xml, "LogCategories", &[], |xml| {
            empty(xml, "Category", &[("name", "logStatusError".to_owned())])
        })?;
        let experiment = [
            ("startTime", "0".to_owned()),
            ("stopTime", setup.duration_s.to_string()),
            ("stepSize", setup.step_s.to_string()),
        ];
        empty(xml, "DefaultExperiment", &experiment)?;
        element(xml, "ModelVariables", &[], |xml| {
            let mut all = plan.table.variables.iter().enumerate();
            let scales = Scales::of(setup);
            all.try_for_each(|(reference, v)| variable(xml, reference, v, scales))
        })?;
        element(xml, "ModelStructure", &[], |xml| {
            for name in ["Output", "InitialUnknown"] {
                for reference in outputs(&plan.table) {
                    empty(xml, name, &[("valueReference", reference.to_string())])?;
                }
            }
            Ok(())
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
            element(xml, "EnumerationType", &about, |xml| items(xml, one))
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
    let name = match variable.class {
        Class::Real => "Float64",
        Class::Integer => "Int32",
        Class::Boolean => "Boolean",
        Class::Enumeration => "Enumeration",
    };
    if variable.class == Class::Real {
        attributes.extend(variable.unit.name().map(|name| ("unit", name.to_owned())));
    }
    let declared = variable.enumeration().map(|one| ("declaredType", one.name.to_owned()));
    attributes.extend(declared);
    attributes.extend(range(variable));
    attributes.extend(nominal(variable, scales).map(|value| ("nominal", value.to_string())));
    attributes.extend(start(variable).map(|text| ("start", text)));
    empty(xml, name, &attributes)
}
