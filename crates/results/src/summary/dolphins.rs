//! Flexible dolphins as `summary.json` has them.

use fenderline_sim::{DolphinSummary, Setup};

use crate::json::{Json, object};

/// One object per flexible dolphin, in the order of the scenario. What is not known, or was not reached, has no key.
pub(super) fn dolphins_json(dolphins: &[DolphinSummary], setup: &Setup) -> Vec<Json> {
    dolphins.iter().map(|dolphin| dolphin_json(dolphin, setup)).collect()
}

fn dolphin_json(summary: &DolphinSummary, setup: &Setup) -> Json {
    let body = &setup.bodies[summary.body];
    let mut object = object!({
        "name": body.name,
        "peak_deflection_m": summary.peak_deflection_m,
        "peak_deflection_at_s": summary.peak_deflection_at_s,
        "peak_load_n": summary.peak_load_n,
        "peak_load_at_s": summary.peak_load_at_s,
        "peak_energy_j": summary.peak_energy_j,
        "damping_j": summary.damping_j,
        "yield_j": summary.yield_j,
        "offset_m": summary.offset_m,
    });
    if let Some(dolphin) = &body.dolphin {
        object.put("stiffness_npm", dolphin.stiffness_npm);
        object.put("mass_kg", dolphin.mass_kg);
        object.put("period_s", dolphin.period_s());
        if let Some(load_n) = dolphin.yield_load_n {
            object.put("yield_load_n", load_n);
        }
    }
    if let Some(share) = summary.share_of_yield_load {
        object.put("share_of_yield_load", share);
    }
    if let Some(at_s) = summary.yielded_at_s {
        object.put("yielded_at_s", at_s);
    }
    object
}
