//! Selects the pairs of bodies that the charts draw.

use super::recorder::{PairTrace, Recorder};

/// Largest number of pairs in a chart; more lines cannot be told apart.
const DRAWN_PAIRS: usize = 6;

/// The pairs of bodies with the largest forces, the largest first.
pub(super) fn strongest(recorder: &Recorder) -> Vec<&PairTrace> {
    let mut pairs: Vec<&PairTrace> = recorder.pairs.iter().collect();
    pairs.sort_by(|a, b| b.peak.normal_n.total_cmp(&a.peak.normal_n));
    pairs.truncate(DRAWN_PAIRS);
    pairs
}
