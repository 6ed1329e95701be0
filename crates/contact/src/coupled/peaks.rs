//! The greatest wrench of contact on each body within a step of several sub-steps.
//!
//! What is handed over is a mean over the step, so that the impulse is right: of a force that falls off within a long
//! step it is much less than the force that was there. In a step of one sub-step the two are the same, and nothing is
//! done here.

use alloc::vec::Vec;

use crate::model::Model;
use crate::report::Wrench;
use crate::workspace::Workspace;

/// A body in a group of islands that go through the step together. One that is fixed may be in several groups.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Peak {
    id: u32,
    /// What is booked of the step's mean: before the group's first sub-step, and so far.
    at_start: Wrench,
    so_far: Wrench,
    greatest: Wrench,
}

/// Before the first sub-step of the islands in `work`, where there are to be several.
pub(crate) fn begin(model: &Model, work: &mut Workspace) {
    let Workspace {
        peaks, first_peak, island_bodies, candidates, own_candidates, wrenches, ..
    } = work;
    let fixed = |rank: u32| model.ranked[rank as usize].is_fixed();
    let peak_of = |rank: u32| {
        let id = model.id_of[rank as usize].0;
        let booked = wrenches[id as usize];
        Peak { id, at_start: booked, so_far: booked, ..Peak::default() }
    };
    *first_peak = peaks.len();
    peaks.extend(island_bodies.iter().copied().filter(|&rank| !fixed(rank)).map(peak_of));
    let first_fixed = peaks.len();
    for pairing in &candidates[own_candidates.clone()] {
        let both = [pairing.candidate.a, pairing.candidate.b];
        if let Some(rank) = both.into_iter().find(|&rank| fixed(rank)) {
            peaks.push(peak_of(rank));
        }
    }
    leave_one_each(peaks, first_fixed);
}

/// Leaves one of each body from that place on.
fn leave_one_each(peaks: &mut Vec<Peak>, from: usize) {
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

/// After one of their sub-steps, of this share of the step.
pub(crate) fn note(work: &mut Workspace, share: f64) {
    let Workspace { peaks, first_peak, wrenches, .. } = work;
    for peak in &mut peaks[*first_peak..] {
        let booked = wrenches[peak.id as usize];
        let of_sub_step = scaled(&less(&booked, &peak.so_far), 1.0 / share);
        peak.so_far = booked;
        if of_sub_step.force_n.length_squared() > peak.greatest.force_n.length_squared() {
            peak.greatest = of_sub_step;
        }
    }
}

/// The greatest wrenches of the step, one a body, from the mean ones.
pub(crate) fn tell(peaks: &[Peak], means: &[Wrench], into: &mut Vec<Wrench>) {
    into.clear();
    into.extend_from_slice(means);
    for Peak { id, at_start, so_far, greatest } in peaks {
        let told = &mut into[*id as usize];
        let mean = less(so_far, at_start);
        if means[*id as usize] == mean {
            *told = *greatest;
        } else {
            let more = less(greatest, &mean);
            told.force_n += more.force_n;
            told.moment_nm += more.moment_nm;
        }
    }
}

fn less(one: &Wrench, other: &Wrench) -> Wrench {
    Wrench { force_n: one.force_n - other.force_n, moment_nm: one.moment_nm - other.moment_nm }
}

fn scaled(wrench: &Wrench, factor: f64) -> Wrench {
    Wrench { force_n: wrench.force_n * factor, moment_nm: wrench.moment_nm * factor }
}
