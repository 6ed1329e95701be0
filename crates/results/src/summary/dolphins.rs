//! Flexible dolphins as `summary.json` has them.

use fenderline_sim::{DolphinSummary, Setup};
use serde_json::{Value, json};

/// One object per flexible dolphin, in the order of the scenario. What is not known, or was not reached, has no key.
pub(super) fn dolphins_json(dolphins: &[DolphinSummary], setup: &Setup) -> Vec<Value> {
    dolphins.iter().map(|dolphin| dolphin_json(dolphin, setup)).collect()
}

fn dolphin_json(summary: &DolphinSummary, setup: &Setup) -> Value {
    let body = &setup.bodies[summary.body];
    let mut object = json!({
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
        object["stiffness_npm"] = json!(dolphin.stiffness_npm);
        object["mass_kg"] = json!(dolphin.mass_kg);
        object["period_s"] = json!(dolphin.period_s());
        if let Some(load_n) = dolphin.yield_load_n {
            object["yield_load_n"] = json!(load_n);
        }
    }
    if let Some(share) = summary.share_of_yield_load {
        object["share_of_yield_load"] = json!(share);
    }
    if let Some(at_s) = summary.yielded_at_s {
        object["yielded_at_s"] = json!(at_s);
    }
    object
}
