//! Fenders as `summary.json` has them.

use fenderline_sim::{FenderSetup, FenderSource, FenderSummary};
use serde_json::{Map, Value, json};

use crate::outcome::Outcome;
use crate::verdict::FenderVerdict;

/// One object per touched fender, in the order of the scenario. Missing data (rating, permissible hull pressure, source)
/// have no key.
pub(super) fn fenders_json(outcome: &Outcome<'_>) -> Vec<Value> {
    let setup = outcome.setup;
    let objects = outcome.fenders.iter().map(|summary| {
        let fender = &setup.fenders[summary.fender];
        fender_json(fender, &setup.bodies[fender.body].name, summary)
    });
    objects.collect()
}

fn fender_json(fender: &FenderSetup, body: &str, summary: &FenderSummary) -> Value {
    let mut object = json!({
        "name": fender.name,
        "body": body,
        "verdict": FenderVerdict::of(fender, summary).key(),
        "failed": summary.failed,
        "first_touch_s": summary.first_touch_s,
        "approach_speed_mps": summary.approach_speed_mps,
        "approach_angle_rad": summary.approach_angle_rad,
        "factor": summary.factor,
        "peak_deflection_m": summary.peak_deflection_m,
        "peak_deflection_at_s": summary.peak_deflection_at_s,
        "peak_reaction_n": summary.peak_reaction_n,
        "peak_reaction_at_s": summary.peak_reaction_at_s,
        "peak_energy_j": summary.peak_energy_j,
        "last_deflection_m": summary.last_deflection_m,
        "last_reaction_n": summary.last_reaction_n,
    });
    let known = object.as_object_mut().expect("an object");
    let rated = fender.rated.as_ref();
    put(known, "peak_hull_pressure_npm2", summary.peak_hull_pressure_npm2);
    put(known, "capacity_j", summary.capacity_j);
    put(known, "share_of_rated_energy", summary.share_of_rated_energy);
    put(known, "share_of_rated_reaction", summary.share_of_rated_reaction);
    put(known, "share_of_rated_deflection", summary.share_of_rated_deflection);
    put(known, "share_of_hull_pressure", summary.share_of_hull_pressure);
    put(known, "rated_deflection_m", rated.map(|r| r.deflection_m));
    put(known, "rated_reaction_n", rated.map(|r| r.reaction_n));
    put(known, "rated_energy_j", rated.map(|r| r.energy_j));
    put(known, "hull_pressure_limit_npm2", fender.hull_pressure_limit_npm2);
    if let Some(FenderSource { designation, source, standing }) = &fender.source {
        known.insert("designation".to_owned(), json!(designation));
        known.insert("source".to_owned(), json!(source));
        known.insert("standing".to_owned(), json!(standing));
    }
    object
}

fn put(object: &mut Map<String, Value>, key: &str, value: Option<f64>) {
    if let Some(value) = value {
        object.insert(key.to_owned(), json!(value));
    }
}
