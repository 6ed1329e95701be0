//! Statistics of motions, their limits, and load cycles of mooring lines in `summary.json`.

use fenderline_sim::statistics::MotionName;

use crate::json::{Json, object};
use crate::outcome::Outcome;

/// Adds `motions`, `limits` and the load cycles of mooring lines, if the scenario asks for these.
pub(super) fn put_statistics(whole: &mut Json, outcome: &Outcome<'_>) {
    let Some(statistics) = outcome.statistics else { return };
    let setup = outcome.setup;
    let vessels = setup.world.vessels.iter().enumerate().map(|(index, vessel)| {
        let mut object = object!({ "vessel": setup.bodies[vessel.body].name });
        let all = statistics.motions(index, setup.step_s);
        for (name, of) in MotionName::ALL.into_iter().zip(all) {
            let unit = if name.is_angle() { "rad" } else { "m" };
            let one = object!({
                (format!("mean_{unit}")): of.mean,
                (format!("standard_deviation_{unit}")): of.deviation,
                (format!("maximum_{unit}")): of.maximum,
                (format!("significant_{unit}")): of.significant,
                (format!("maximum_range_{unit}")): of.maximum_range,
                (format!("significant_range_{unit}")): of.significant_range,
                "zero_crossing_period_s": of.zero_crossing_s,
                "peaks": of.peaks,
            });
            object.put(name.word(), one);
        }
        object
    });
    whole.put("motions", vessels.collect::<Json>());
    let limits = setup.world.statistics.limits.iter().zip(outcome.limit_values);
    whole.put(
        "limits",
        limits
            .map(|(limit, value)| {
                object!({
                    "name": limit.name,
                    "of": limit.subject(setup),
                    "value": value,
                    "limit": limit.most,
                    "exceeded": *value > limit.most,
                })
            })
            .collect::<Json>(),
    );
    let lines = setup.world.lines.iter().zip(&statistics.lines);
    whole.put(
        "line_cycles",
        lines
            .map(|(line, counts)| object!({ "line": line.line.name, "cycles": counts.cycles() }))
            .collect::<Json>(),
    );
}
