//! Model descriptions, written from the table by an XML writer.

mod fmi2;
mod fmi3;
mod nominal;
mod osp;
mod xml;

use std::collections::BTreeSet;
use std::io;

use self::xml::{Xml, empty};
use crate::Fmi;
use crate::plan::Plan;
use crate::table::{Causality, Class, Enumeration, Table, Variable};
use crate::unit::Unit;

pub(crate) use osp::osp;

/// The `modelDescription.xml` of a version.
pub(crate) fn model(plan: &Plan, fmi: Fmi, name: &str, identifier: &str) -> io::Result<String> {
    match fmi {
        Fmi::Two => fmi2::model(plan, name, identifier),
        Fmi::Three => fmi3::model(plan, name, identifier),
    }
}

/// Copyright of the libraries in the FMU; `license.txt` in the FMU has the text.
const COPYRIGHT: &str = "Copyright (c) 2026 The fenderline authors";
const LICENCE: &str = "MIT OR Apache-2.0";

/// Attributes of the whole model, common to both versions.
fn about(plan: &Plan, name: &str) -> [(&'static str, String); 8] {
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

/// The units that the table uses.
fn units(table: &Table) -> BTreeSet<Unit> {
    table.variables.iter().map(|v| v.unit).filter(|unit| unit.name().is_some()).collect()
}

/// The enumerations that the table uses, each once.
fn enumerations(table: &Table) -> Vec<&'static Enumeration> {
    let mut all: Vec<&'static Enumeration> = Vec::new();
    for one in table.variables.iter().filter_map(Variable::enumeration) {
        if all.iter().all(|other| other.name != one.name) {
            all.push(one);
        }
    }
    all
}

/// The items of an enumeration.
fn items(xml: &mut Xml, of: &Enumeration) -> io::Result<()> {
    (1..).zip(of.items).try_for_each(|(value, (name, description)): (u32, _)| {
        let about = [
            ("name", (*name).to_owned()),
            ("value", value.to_string()),
            ("description", (*description).to_owned()),
        ];
        empty(xml, "Item", &about)
    })
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
        (_, Class::Integer | Class::Boolean | Class::Enumeration) => "discrete",
    }
}

/// `None` if the standard forbids the attribute.
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
        (_, Class::Integer | Class::Real | Class::Enumeration) => Some(variable.start.to_string()),
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

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::model;
    use crate::bundle::Bundle;
    use crate::plan::Plan;
    use crate::{Fmi, Kind};

    fn plan(kind: Kind, changes: Vec<[String; 2]>) -> Plan {
        let path =
            concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/berth/eight_cones_at_5_deg.toml");
        let bundle = Bundle::load(kind, Path::new(path), changes).expect("a good scenario");
        Plan::new(bundle).expect("a good scenario")
    }

    /// The element of a variable, with its type.
    fn of<'t>(text: &'t str, name: &str) -> &'t str {
        let (_, rest) = text.split_once(&format!("name=\"{name}\"")).expect("the variable");
        rest.split("name=").next().unwrap_or_default()
    }

    #[test]
    fn a_description_has_author_licence_and_the_sizes_of_its_variables() {
        for (fmi, kind) in [(Fmi::Two, Kind::Engine), (Fmi::Three, Kind::Simulation)] {
            let text = model(&plan(kind, vec![]), fmi, "berth", "berth").expect("XML");
            assert!(text.contains("author=\"The fenderline authors\""), "{text}");
            assert!(text.contains("license=\"MIT OR Apache-2.0\"") && text.contains("copyright="));
            // Every force, moment, mass and energy has a size that is not 1.
            for unit in ["N", "N.m", "kg", "J"] {
                let with = format!("unit=\"{unit}\"");
                let all = text.lines().filter(|line| line.contains(&with));
                assert!(all.clone().all(|line| line.contains("nominal=\"")), "{unit}");
            }
        }
        let named = vec![["report.author".to_owned(), "A. Engineer & Sons".to_owned()]];
        let text = model(&plan(Kind::Engine, named), Fmi::Two, "berth", "berth").expect("XML");
        assert!(text.contains("author=\"A. Engineer &amp; Sons\""), "{text}");
    }

    /// The ship of the scenario has 52 400 t and 220 m: powers of ten below.
    #[test]
    fn nominal_values_follow_the_ship() {
        let plan = plan(Kind::Simulation, vec![]);
        let text = model(&plan, Fmi::Three, "berth", "berth").expect("XML");
        let ship = plan.scenario.setup.bodies.iter().find(|body| body.mass.is_some());
        let ship = ship.expect("she floats");
        let mass_kg = ship.mass.as_ref().map_or(0.0, |mass| mass.mass_kg);
        let nominal = |name: &str| -> f64 {
            let (_, rest) = of(&text, name).split_once("nominal=\"").expect("a nominal value");
            rest.split('"').next().and_then(|text| text.parse().ok()).expect("a number")
        };
        let force_n = nominal(&format!("body.{}.external_x_n", ship.name));
        assert!(force_n <= 0.1 * mass_kg && force_n > 0.01 * mass_kg, "{force_n} N, {mass_kg} kg");
    }

    #[test]
    fn an_enumeration_is_defined_where_a_variable_has_its_type() {
        for (fmi, item) in [(Fmi::Two, "SimpleType"), (Fmi::Three, "EnumerationType")] {
            let text = model(&plan(Kind::Engine, vec![]), fmi, "berth", "berth").expect("XML");
            assert!(text.contains(&format!("<{item} name=\"Integration\"")), "{text}");
            assert!(text.contains("<Item name=\"semi_implicit\" value=\"2\""), "{text}");
            let own = of(&text, "host.integration");
            assert!(
                own.contains("declaredType=\"Integration\"") && own.contains("start=\"1\""),
                "{own}"
            );
            let text = model(&plan(Kind::Simulation, vec![]), fmi, "berth", "berth").expect("XML");
            assert!(!text.contains("TypeDefinitions"));
        }
    }

    #[test]
    fn the_licence_in_an_fmu_is_the_project_s() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../LICENSE-MIT");
        let own = std::fs::read_to_string(file).expect("it is there");
        assert!(crate::pack::LICENCE.ends_with(&own));
        assert!(own.contains(super::COPYRIGHT));
    }
}
