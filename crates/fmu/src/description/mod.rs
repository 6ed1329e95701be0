//! Model descriptions of an FMU, which an XML writer writes from the table of variables.

mod attributes;
mod fmi2;
mod fmi3;
mod nominal;
mod osp;
mod xml;

use std::io;

use crate::Fmi;
use crate::plan::Plan;

pub(crate) use osp::osp;

/// The `modelDescription.xml` for a version of FMI.
pub(crate) fn model(plan: &Plan, fmi: Fmi, name: &str, identifier: &str) -> io::Result<String> {
    match fmi {
        Fmi::Two => fmi2::model(plan, name, identifier),
        Fmi::Three => fmi3::model(plan, name, identifier),
    }
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
        assert!(own.contains(super::attributes::COPYRIGHT));
    }
}
