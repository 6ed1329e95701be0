//! Statistics of motions, limits and cycles of lines in `summary.json`.

use fenderline_sim::statistics::MotionName;
use serde_json::{Map, Value, json};

use crate::outcome::Outcome;

/// Adds `motions`, `limits` and the cycles of lines, if the scenario asks for them.
pub(super) fn put_statistics(whole: &mut Value, outcome: &Outcome<'_>) {
    let Some(statistics) = outcome.statistics else { return };
    let setup = outcome.setup;
    let vessels = setup.world.vessels.iter().enumerate().map(|(index, vessel)| {
        let mut object = Map::new();
        object.insert("vessel".to_owned(), json!(setup.bodies[vessel.body].name));
        let all = statistics.motions(index, setup.step_s);
        for (name, of) in MotionName::ALL.into_iter().zip(all) {
            let unit = if name.is_angle() { "rad" } else { "m" };
            let one = json!({
                format!("mean_{unit}"): of.mean,
                format!("standard_deviation_{unit}"): of.deviation,
                format!("maximum_{unit}"): of.maximum,
                format!("significant_{unit}"): of.significant,
                format!("maximum_range_{unit}"): of.maximum_range,
                format!("significant_range_{unit}"): of.significant_range,
                "zero_crossing_period_s": of.zero_crossing_s,
                "peaks": of.peaks,
            });
            object.insert(name.word().to_owned(), one);
        }
        Value::Object(object)
    });
    whole["motions"] = vessels.collect();
    let limits = setup.world.statistics.limits.iter().zip(outcome.limit_values);
    whole["limits"] = limits
        .map(|(limit, value)| {
            json!({
                "name": limit.name,
                "of": limit.subject(setup),
                "value": value,
                "limit": limit.most,
                "exceeded": *value > limit.most,
            })
        })
        .collect();
    let lines = setup.world.lines.iter().zip(&statistics.lines);
    whole["line_cycles"] = lines
        .map(|(line, counts)| json!({ "line": line.line.name, "cycles": counts.cycles() }))
        .collect();
}
