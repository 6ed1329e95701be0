//! Computes the periods of heave and roll of the container ship of Moreno et al. (2023).

use fenderline_sim::attitude::{HydrostaticParticulars, Hydrostatics};
use fenderline_sim::constants::SEA_WATER_KGPM3;

use super::Values;
use super::ships::container;

pub(super) fn compute(values: &mut Values) {
    for (gm_m, name) in [(1.0, "1"), (2.0, "2"), (5.0, "5")] {
        values.put(format!("roll/{name}"), afloat(gm_m).roll.period_s(), "s");
    }
    values.put("heave", afloat(1.0).heave.period_s(), "s");
}

fn afloat(gm_m: f64) -> Hydrostatics {
    let hull = container();
    let ship = HydrostaticParticulars {
        mass_kg: SEA_WATER_KGPM3 * hull.volume_m3,
        length_m: hull.length_m,
        beam_m: hull.beam_m,
        draught_m: hull.draught_m,
        waterplane_m2: 10_612.0,
        gm_m,
        water_kgpm3: SEA_WATER_KGPM3,
    };
    Hydrostatics::of(&ship).expect("she floats upright")
}
