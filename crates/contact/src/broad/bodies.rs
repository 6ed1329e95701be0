//! The bodies of a step: their input states, poses and reach, by rank.
//!
//! The rank of a body is its place in the order of the bodies' keys. All sums run in the order of the ranks, so that
//! the order in which bodies were added changes no bit of a result.

use alloc::vec::Vec;
use core::f64::consts::TAU;

use crate::maths::room::room_for;
use crate::maths::vec2::{Pose, Vec2};
use crate::state::body_state::BodyState;

/// Stage 1 of a step computes these lists of bodies from the host's states. Each sub-step updates the poses of the
/// bodies.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bodies {
    /// States of the bodies that the host gave for this step. At the end of the step these states move to the memory.
    pub(crate) input: Vec<BodyState>,
    /// Poses of the bodies at the start of the step or sub-step.
    pub(crate) poses: Vec<Pose>,
    /// How far from its centre of gravity each body may reach within this step (m).
    pub(crate) reach_m: Vec<f64>,
    /// Ranks, ascending, of the bodies whose pose is computed in this step. The bodies that are not listed stay where
    /// they were in the last step.
    pub(crate) active: Vec<u32>,
}

impl Bodies {
    pub(crate) fn with_capacity(count: usize) -> Bodies {
        Bodies {
            input: room_for(count),
            poses: room_for(count),
            reach_m: room_for(count),
            active: room_for(count),
        }
    }

    /// Makes room for `count` bodies; no body is active yet.
    pub(crate) fn resize(&mut self, count: usize) {
        self.input.resize(count, BodyState::default());
        self.poses.resize(count, Pose::IDENTITY);
        self.reach_m.resize(count, 0.0);
        self.active.clear();
    }
}

/// Bodies that their host displaced since the last step: the bodies moved otherwise than their velocities say. Computed
/// by stage 1. The ranks in both lists ascend.
#[derive(Clone, Debug, Default)]
pub(crate) struct Displaced {
    /// Ranks of all displaced bodies, including the teleported bodies.
    pub(crate) all: Vec<u32>,
    /// Ranks of the bodies that were displaced so far that their contacts start afresh.
    pub(crate) teleported: Vec<u32>,
}

/// The displaced bodies of a sub-step after the first: none, because a host displaces bodies only before a step.
pub(crate) static NONE_DISPLACED: Displaced = Displaced { all: Vec::new(), teleported: Vec::new() };

impl Displaced {
    pub(crate) fn clear(&mut self) {
        self.all.clear();
        self.teleported.clear();
    }

    /// Adds a body to the lists according to the change of its pose. The ranks must be added in ascending order.
    pub(crate) fn add(&mut self, rank: u32, change: PoseChange) {
        if change != PoseChange::Consistent {
            self.all.push(rank);
        }
        if change == PoseChange::Teleported {
            self.teleported.push(rank);
        }
    }

    /// Removes a body from both lists of displaced bodies.
    pub(crate) fn forget(&mut self, rank: u32) {
        self.all.retain(|&other| other != rank);
        self.teleported.retain(|&other| other != rank);
    }

    /// Returns true if one of the two bodies was teleported.
    pub(crate) fn is_teleported(&self, a: u32, b: u32) -> bool {
        has_either(&self.teleported, a, b)
    }

    /// Returns true if one of the two bodies was displaced.
    pub(crate) fn is_displaced(&self, a: u32, b: u32) -> bool {
        has_either(&self.all, a, b)
    }
}

fn has_either(ranks: &[u32], a: u32, b: u32) -> bool {
    !ranks.is_empty() && (ranks.binary_search(&a).is_ok() || ranks.binary_search(&b).is_ok())
}

/// How a pose that the host gives relates to the state of the last step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PoseChange {
    /// The body moved as its velocities say.
    Consistent,
    /// The host placed the body elsewhere: neither the old nor the new velocity of the body leads that far.
    Displaced,
    /// The host placed the body so far away that nothing of the body's contacts can be kept. The test for a teleported
    /// body allows a deviation of a tenth of the body's size, for hosts whose integrators differ from this engine's.
    Teleported,
}

/// The smallest change of place (m) for which a body counts as displaced. The smallest change is not zero, because far
/// from the chart's origin positions are rounded.
const SMALLEST_DISPLACEMENT_M: f64 = 1e-6;

/// Classifies the change of a body's state from `last` to `now`, which is `step_s` later. `radius_m` is the radius of
/// the body's outline about its centre of gravity.
#[inline(always)]
pub(crate) fn classify(
    last: &BodyState,
    now: &BodyState,
    step_s: f64,
    radius_m: f64,
) -> PoseChange {
    let way_m = now.position_m - last.position_m;
    let unexplained_m = way_m - (now.velocity_mps + last.velocity_mps) * (0.5 * step_s);
    let turn_rad = now.heading_rad - last.heading_rad;
    // The full test needs square roots. Nearly all bodies pass this stricter test, which needs none.
    let near_m = 0.09 * radius_m;
    if unexplained_m.length_squared() <= near_m * near_m
        && is_within_motion(last, now, way_m, turn_rad, Tolerance { step_s, radius_m })
    {
        return PoseChange::Consistent;
    }
    classify_far(last, now, way_m, unexplained_m, Tolerance { step_s, radius_m })
}

#[derive(Clone, Copy)]
struct Tolerance {
    step_s: f64,
    radius_m: f64,
}

/// Returns true if the body can have moved and turned this far with its velocities. The velocities of the body may
/// change direction within a step.
#[inline(always)]
fn is_within_motion(
    last: &BodyState,
    now: &BodyState,
    way_m: Vec2,
    turn_rad: f64,
    Tolerance { step_s, radius_m }: Tolerance,
) -> bool {
    let farthest = 4.0 * step_s * step_s;
    let speeds = last.velocity_mps.length_squared() + now.velocity_mps.length_squared();
    let turns = last.yaw_rate_radps * last.yaw_rate_radps + now.yaw_rate_radps * now.yaw_rate_radps;
    let too_far = way_m.length_squared() - farthest * speeds;
    let turned_too_far = turn_rad * turn_rad - farthest * turns;
    too_far + turned_too_far * (radius_m * radius_m)
        <= SMALLEST_DISPLACEMENT_M * SMALLEST_DISPLACEMENT_M
}

/// The full test of [`classify`], for bodies that its quick test does not settle.
#[cold]
#[inline(never)]
fn classify_far(
    last: &BodyState,
    now: &BodyState,
    way_m: Vec2,
    unexplained_m: Vec2,
    tolerance: Tolerance,
) -> PoseChange {
    let change_mps = now.velocity_mps - last.velocity_mps;
    let allowed_m = change_mps.length() * tolerance.step_s + 0.1 * tolerance.radius_m;
    if unexplained_m.length() > allowed_m {
        return PoseChange::Teleported;
    }
    // A host may wrap its headings at a full turn.
    let turn_rad = now.heading_rad - last.heading_rad;
    let turn_rad = turn_rad - libm::rint(turn_rad / TAU) * TAU;
    if is_within_motion(last, now, way_m, turn_rad, tolerance) {
        PoseChange::Consistent
    } else {
        PoseChange::Displaced
    }
}
