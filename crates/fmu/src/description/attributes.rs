//! Attributes and elements that the model descriptions of FMI 2.0 and FMI 3.0 both have.

use std::collections::BTreeSet;
use std::io;

use super::xml::{Xml, empty};
use crate::plan::Plan;
use crate::table::{Causality, Class, Enumeration, Table, Variable};
use crate::unit::Unit;

/// The copyright line of the libraries in the FMU; `license.txt` in the FMU has the whole text.
pub(super) const COPYRIGHT: &str = "Copyright (c) 2026 The fenderline authors";

pub(super) const LICENCE: &str = "MIT OR Apache-2.0";

/// Attributes of the whole model that both versions of FMI have.
pub(super) fn about(plan: &Plan, name: &str) -> [(&'static str, String); 8] {
    let what = match plan.bundle.kind {
        crate::Kind::Engine => "contact engine",
        crate::Kind::Simulation => "simulation",
    };
    let version = env!("CARGO_PKG_VERSION");
    let title = &plan.scenario.title;
    let plain = |text: &str| text.replace(|c: char| c.is_control(), " ");
    let of_report = plan.scenario.report.iter().find(|(key, _)| *key == "author");
    let author = of_report.map_or("The fenderline authors", |(_, author)| author.as_str());
    [
        ("modelName", name.to_owned()),
        ("description", plain(&format!("{title} ({what})"))),
        ("author", plain(author)),
        ("version", version.to_owned()),
        ("copyright", COPYRIGHT.to_owned()),
        ("license", LICENCE.to_owned()),
        ("generationTool", format!("fenderline {version}")),
        ("variableNamingConvention", "flat".to_owned()),
    ]
}

/// The units that the variables of the table use.
pub(super) fn units(table: &Table) -> BTreeSet<Unit> {
    table.variables.iter().map(|v| v.unit).filter(|unit| unit.name().is_some()).collect()
}

/// The enumerations that the variables of the table use, each once.
pub(super) fn enumerations(table: &Table) -> Vec<&'static Enumeration> {
    let mut all: Vec<&'static Enumeration> = Vec::new();
    for one in table.variables.iter().filter_map(Variable::enumeration) {
        if all.iter().all(|other| other.name != one.name) {
            all.push(one);
        }
    }
    all
}

/// The items of an enumeration.
pub(super) fn items(xml: &mut Xml, of: &Enumeration) -> io::Result<()> {
    (1..).zip(of.items).try_for_each(|(value, (name, description)): (u32, _)| {
        let about = [
            ("name", (*name).to_owned()),
            ("value", value.to_string()),
            ("description", (*description).to_owned()),
        ];
        empty(xml, "Item", &about)
    })
}

pub(super) fn causality(variable: &Variable) -> &'static str {
    match variable.causality {
        Causality::Independent => "independent",
        Causality::Parameter => "parameter",
        Causality::Input => "input",
        Causality::Output => "output",
    }
}

/// Real inputs and outputs are continuous, so that masters interpolate them.
pub(super) fn variability(variable: &Variable) -> &'static str {
    match (variable.causality, variable.class) {
        (Causality::Parameter, _) => "fixed",
        (_, Class::Real) => "continuous",
        (_, Class::Integer | Class::Boolean | Class::Enumeration) => "discrete",
    }
}

/// The attribute `initial` of a variable; `None` where the standard forbids the attribute.
pub(super) fn initial(variable: &Variable) -> Option<&'static str> {
    match variable.causality {
        Causality::Parameter => Some("exact"),
        Causality::Output => Some("calculated"),
        Causality::Independent | Causality::Input => None,
    }
}

/// The start value of a variable as text; `None` for outputs and time.
pub(super) fn start(variable: &Variable) -> Option<String> {
    match (variable.causality, variable.class) {
        (Causality::Independent | Causality::Output, _) => None,
        (_, Class::Boolean) => Some((variable.start != 0.0).to_string()),
        (_, Class::Integer | Class::Real | Class::Enumeration) => Some(variable.start.to_string()),
    }
}

/// The attributes for the smallest and largest value of a variable.
pub(super) fn range(variable: &Variable) -> Vec<(&'static str, String)> {
    match variable.range {
        Some([least, most]) => vec![("min", least.to_string()), ("max", most.to_string())],
        None => Vec::new(),
    }
}

pub(super) fn outputs(table: &Table) -> impl Iterator<Item = usize> {
    let is = |(_, v): &(usize, &Variable)| v.causality == Causality::Output;
    table.variables.iter().enumerate().filter(is).map(|(index, _)| index)
}
