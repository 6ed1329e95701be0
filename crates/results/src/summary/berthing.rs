//! A berthing by formula and in the run, in `summary.json`.

use fenderline_sim::Setup;
use fenderline_sim::berthing::{AddedMass, AddedMassFormula, BerthingError, BerthingOutcome};

use crate::json::{Json, object};

/// The factors and energies of a berthing, or the reason why there are none.
pub(super) fn berthing_json(
    berthing: Result<&BerthingOutcome, &BerthingError>,
    setup: &Setup,
) -> Json {
    let outcome = match berthing {
        Ok(outcome) => outcome,
        Err(error) => return object!({ "error": error.to_string() }),
    };
    let by_formula = |values: [Option<f64>; 4]| {
        let known = AddedMassFormula::ALL.iter().zip(values);
        known
            .filter_map(|(formula, value)| Some((formula.key().to_owned(), value?)))
            .collect::<Json>()
    };
    let fenders = outcome.fenders.iter().map(|&index| setup.fenders[index].name.as_str());
    let mut object = object!({
        "first_touch_s": outcome.first_touch_s,
        "fenders": fenders.collect::<Vec<_>>(),
        "speed_mps": outcome.speed_mps,
        "formula_speed_mps": outcome.formula_speed_mps(),
        "angle_rad": outcome.angle_rad,
        "along_m": outcome.along_m,
        "displacement_kg": outcome.displacement_kg,
        "added_mass": outcome.chosen_added_mass,
        "added_mass_by": match outcome.chosen {
            AddedMass::By(formula) => formula.key(),
            AddedMass::Given(_) => "given",
        },
        "added_masses": by_formula(outcome.added_mass),
        "added_mass_simulated": outcome.added_mass_simulated,
        "added_sway_in_deep_water": outcome.added_sway.deep,
        "shallow_water_factor": outcome.added_sway.shallow.map_or(1.0, |shallow| shallow.factor),
        "mass_of_run": outcome.mass_of_run(),
        "gyradius_m": outcome.gyradius_m,
        "gyradius_simulated_m": outcome.gyradius_simulated_m,
        "eccentricity": outcome.eccentricity,
        "eccentricity_of_run": outcome.eccentricity_of_run,
        "eccentricity_measured": outcome.eccentricity_measured,
        "softness": outcome.softness,
        "configuration": outcome.configuration,
        "energy_j": outcome.energy_j,
        "energy_at_touch_j": outcome.energy_at_touch_j,
        "energies_j": by_formula(outcome.energies_j),
        "kinetic_j": outcome.kinetic_j,
        "fender_energy_j": outcome.fender_energy_j,
        "later_energy_j": outcome.later.map_or(0.0, |later| later.energy_j),
    });
    // Only flexible dolphins have piles.
    if outcome.pile_energy_j > 0.0 {
        object.put("pile_energy_j", outcome.pile_energy_j);
    }
    if let Some(later) = outcome.later {
        object.put("later_at_s", later.at_s);
        object.put("later_hit", later.number);
    }
    if let Some(other) = outcome.other {
        object.put("other_displacement_kg", other.displacement_kg);
        object.put("other_added_mass", other.added_mass);
    }
    if let Some(abnormal_j) = outcome.abnormal_energy_j {
        object.put("abnormal_energy_j", abnormal_j);
    }
    object
}
