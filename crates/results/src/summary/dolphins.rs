//! Flexible dolphins as `summary.json` has them.

use fenderline_sim::{DolphinSummary, Setup};

use crate::json::{Json, object};
use crate::quantities::DOLPHINS;

/// One object per flexible dolphin, in the order of the scenario. A value that is not known, or that was not reached,
/// has no key.
pub(super) fn dolphins_json(dolphins: &[DolphinSummary], setup: &Setup) -> Vec<Json> {
    dolphins.iter().map(|dolphin| dolphin_json(dolphin, setup)).collect()
}

fn dolphin_json(summary: &DolphinSummary, setup: &Setup) -> Json {
    let body = &setup.bodies[summary.body];
    let mut object = object!({ "name": body.name });
    DOLPHINS.put(&mut object, body, summary);
    object
}
