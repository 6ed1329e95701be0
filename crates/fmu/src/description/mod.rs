//! Model descriptions, written from the table by an XML writer.

mod fmi2;
mod fmi3;
mod osp;
mod xml;

use std::collections::BTreeSet;
use std::io;

use crate::Fmi;
use crate::plan::Plan;
use crate::table::{Causality, Class, Table, Variable};
use crate::unit::Unit;

pub(crate) use osp::osp;

/// The `modelDescription.xml` of a version.
pub(crate) fn model(plan: &Plan, fmi: Fmi, name: &str, identifier: &str) -> io::Result<String> {
    match fmi {
        Fmi::Two => fmi2::model(plan, name, identifier),
        Fmi::Three => fmi3::model(plan, name, identifier),
    }
}

/// Attributes of the whole model, common to both versions.
fn about(plan: &Plan, name: &str) -> [(&'static str, String); 5] {
    let what = match plan.bundle.kind {
        crate::Kind::Engine => "contact engine",
        crate::Kind::Simulation => "simulation",
    };
    let version = env!("CARGO_PKG_VERSION");
    let title = &plan.scenario.title;
    [
        ("modelName", name.to_owned()),
        ("description", format!("{title} ({what})").replace(|c: char| c.is_control(), " ")),
        ("version", version.to_owned()),
        ("generationTool", format!("fenderline {version}")),
        ("variableNamingConvention", "flat".to_owned()),
    ]
}

/// The units that the table uses.
fn units(table: &Table) -> BTreeSet<Unit> {
    table.variables.iter().map(|v| v.unit).filter(|unit| unit.name().is_some()).collect()
}

fn causality(variable: &Variable) -> &'static str {
    match variable.causality {
        Causality::Independent => "independent",
        Causality::Parameter => "parameter",
        Causality::Input => "input",
        Causality::Output => "output",
    }
}

/// Real inputs and outputs are continuous, so that masters interpolate them.
fn variability(variable: &Variable) -> &'static str {
    match (variable.causality, variable.class) {
        (Causality::Parameter, _) => "fixed",
        (_, Class::Real) => "continuous",
        (_, Class::Integer | Class::Boolean) => "discrete",
    }
}

/// `None` where the standard forbids the attribute.
fn initial(variable: &Variable) -> Option<&'static str> {
    match variable.causality {
        Causality::Parameter => Some("exact"),
        Causality::Output => Some("calculated"),
        Causality::Independent | Causality::Input => None,
    }
}

/// The start value as text; `None` for outputs and time.
fn start(variable: &Variable) -> Option<String> {
    match (variable.causality, variable.class) {
        (Causality::Independent | Causality::Output, _) => None,
        (_, Class::Boolean) => Some((variable.start != 0.0).to_string()),
        (_, Class::Integer | Class::Real) => Some(variable.start.to_string()),
    }
}

/// Smallest and largest value, as attributes.
fn range(variable: &Variable) -> Vec<(&'static str, String)> {
    match variable.range {
        Some([least, most]) => vec![("min", least.to_string()), ("max", most.to_string())],
        None => Vec::new(),
    }
}

fn outputs(table: &Table) -> impl Iterator<Item = usize> {
    let is = |(_, v): &(usize, &Variable)| v.causality == Causality::Output;
    table.variables.iter().enumerate().filter(is).map(|(index, _)| index)
}
