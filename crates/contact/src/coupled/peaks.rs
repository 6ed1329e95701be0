//! Finds the greatest contact wrench on each body within a step of several sub-steps.
//!
//! The reported wrenches of a step are means over the step, so that the impulse is right. If a force falls off within a
//! long step, the mean of the force is much less than its peak. In a step of one sub-step the mean and the peak of a
//! wrench are equal, and no peak is recorded.

use alloc::vec::Vec;

use crate::broad::candidates::Pairing;
use crate::model::Model;
use crate::state::report::Wrench;

/// The greatest wrench of one body in a group of islands that take the step together. A fixed body may be in several
/// groups of islands.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PeakWrench {
    id: u32,
    /// The mean wrench accumulated before the group's first sub-step, and the mean wrench accumulated after the group's
    /// last sub-step so far.
    at_start: Wrench,
    so_far: Wrench,
    greatest: Wrench,
}

/// Adds an entry for each body of a group before the first sub-step of the group: for the floating bodies among
/// `bodies`, and for the fixed bodies of the group's candidates.
pub(crate) fn begin(
    model: &Model,
    bodies: &[u32],
    candidates: &[Pairing],
    wrenches: &[Wrench],
    peaks: &mut Vec<PeakWrench>,
) {
    let fixed = |rank: u32| model.ranked[rank as usize].is_fixed();
    let peak_of = |rank: u32| {
        let id = model.id_of[rank as usize].0;
        let wrench = wrenches[id as usize];
        PeakWrench { id, at_start: wrench, so_far: wrench, ..PeakWrench::default() }
    };
    peaks.extend(bodies.iter().copied().filter(|&rank| !fixed(rank)).map(peak_of));
    let first_fixed = peaks.len();
    for pairing in candidates {
        let both = [pairing.candidate.a, pairing.candidate.b];
        if let Some(rank) = both.into_iter().find(|&rank| fixed(rank)) {
            peaks.push(peak_of(rank));
        }
    }
    remove_duplicates(peaks, first_fixed);
}

/// Removes duplicates from index `from` on, so that each body has one entry.
fn remove_duplicates(peaks: &mut Vec<PeakWrench>, from: usize) {
    peaks[from..].sort_unstable_by_key(|peak| peak.id);
    let mut kept = from;
    for index in from..peaks.len() {
        if kept == from || peaks[kept - 1].id != peaks[index].id {
            peaks[kept] = peaks[index];
            kept += 1;
        }
    }
    peaks.truncate(kept);
}

/// Updates the peak wrenches of a group after one of its sub-steps. `share` is the length of the sub-step as a share of
/// the step.
pub(crate) fn update(peaks: &mut [PeakWrench], wrenches: &[Wrench], share: f64) {
    for peak in peaks {
        let wrench = wrenches[peak.id as usize];
        let of_sub_step = wrench.minus(&peak.so_far).times(1.0 / share);
        peak.so_far = wrench;
        if of_sub_step.force_n.length_squared() > peak.greatest.force_n.length_squared() {
            peak.greatest = of_sub_step;
        }
    }
}

/// Writes the greatest wrench of the step for each body. `means` are the mean wrenches of the step.
pub(crate) fn write(peaks: &[PeakWrench], means: &[Wrench], into: &mut Vec<Wrench>) {
    into.clear();
    into.extend_from_slice(means);
    for PeakWrench { id, at_start, so_far, greatest } in peaks {
        let wrench = &mut into[*id as usize];
        let mean = so_far.minus(at_start);
        if means[*id as usize] == mean {
            *wrench = *greatest;
        } else {
            *wrench = wrench.plus(&greatest.minus(&mean));
        }
    }
}
