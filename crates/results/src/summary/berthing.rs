//! A berthing by formula and in the run, in `summary.json`.

use fenderline_sim::Setup;
use fenderline_sim::berthing::{BerthingError, BerthingOutcome};
use serde_json::{Value, json};

/// The factors and energies, or why there are none.
pub(super) fn berthing_json(
    berthing: Result<&BerthingOutcome, &BerthingError>,
    setup: &Setup,
) -> Value {
    let outcome = match berthing {
        Ok(outcome) => outcome,
        Err(error) => return json!({ "error": error.to_string() }),
    };
    let by_formula = |[pianc_2002, ueda, vasco_costa]: [f64; 3]| json!({ "pianc_2002": pianc_2002, "ueda": ueda, "vasco_costa": vasco_costa });
    let mut object = json!({
        "first_touch_s": outcome.first_touch_s,
        "fender": setup.fenders[outcome.fender].name,
        "speed_mps": outcome.speed_mps,
        "angle_rad": outcome.angle_rad,
        "along_m": outcome.along_m,
        "displacement_kg": outcome.displacement_kg,
        "added_mass": by_formula(outcome.added_mass),
        "added_mass_simulated": outcome.added_mass_simulated,
        "gyradius_m": outcome.gyradius_m,
        "gyradius_simulated_m": outcome.gyradius_simulated_m,
        "eccentricity": outcome.eccentricity,
        "eccentricity_of_run": outcome.eccentricity_of_run,
        "eccentricity_measured": outcome.eccentricity_measured,
        "softness": outcome.softness,
        "configuration": outcome.configuration,
        "energy_j": by_formula(outcome.energy_j),
        "kinetic_j": outcome.kinetic_j,
        "fender_energy_j": outcome.fender_energy_j,
    });
    if let Some(abnormal_j) = outcome.abnormal_energy_j {
        object["abnormal_energy_j"] = json!(abnormal_j);
    }
    object
}
