//! The pairs that the charts draw.

use super::recorder::{PairTrace, Recorder};

/// Most pairs in a chart: more lines cannot be told apart.
const DRAWN_PAIRS: usize = 6;

/// The pairs with the largest forces, largest first.
pub(super) fn strongest(recorder: &Recorder) -> Vec<&PairTrace> {
    let mut pairs: Vec<&PairTrace> = recorder.pairs.iter().collect();
    pairs.sort_by(|a, b| b.peak.normal_n.total_cmp(&a.peak.normal_n));
    pairs.truncate(DRAWN_PAIRS);
    pairs
}
