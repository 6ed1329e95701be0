//! Describes how far the engine's motion of a body is ahead of the host's motion, and how the host catches up.
//!
//! A host with a constant step follows the engine *exactly*: each step of the host ends at the engine's position
//! ([`super::steering`]). The host's velocity then differs by ½ a Δt from the engine's, and the wrench of the next step
//! corrects this difference. If the step changes, this method fails: a correction meant for half a second, applied in
//! 1/60 s, takes thirty times the force.
//!
//! So a host with a varying step gets the mean contact wrench of each step, and ends the step with the engine's
//! *velocity* of the body. The host's position of the body is then up to ½ a Δt² from the engine's position. The engine
//! continues from its own state of the body. The engine remembers its lead over the host: p in position and e in
//! velocity. The lead is closed like the deflection of a critically damped spring in T = 10 s, by the implicit rule e′
//! = (e − Δt p/T²) / (1 + Δt/T)². The implicit rule is stable for any Δt. The force that closes the lead is at most ½
//! (Δt/T)² of the contact force: 2 % after a step of 2 s.

use crate::host::velocity::{Offset, Velocity};
use crate::state::body_state::BodyState;

/// Time T in which a host with a varying step catches up with the engine (s).
const CLOSING_S: f64 = 10.0;

/// Time in which the host's velocity is corrected after the contact has ended (s).
const DUE_S: f64 = 2.0;

/// Largest distance of the engine's pose from the host's pose (m, rad) at which the engine continues from the host's
/// pose after the contact has ended.
const NEAR_M: f64 = 5e-3;
const NEAR_RAD: f64 = 1e-4;

/// Relative difference within which the lengths of two steps count as equal. Two equal step lengths differ by rounding,
/// because hosts compute steps as differences of times.
const SAME_STEP: f64 = 1e-6;

/// Returns true if a step is as long as the last step, or is the first step.
pub(super) fn is_steady(last_step_s: f64, step_s: f64) -> bool {
    last_step_s == 0.0 || (step_s - last_step_s).abs() <= SAME_STEP * last_step_s
}

/// The lead: how far the engine's motion of a body is ahead of the host's motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Lead {
    /// Lead of the engine in velocity, in addition to `half_kick`.
    pub(super) velocity: Velocity,
    /// Velocity change by half of the load of the last step, if the host follows exactly: the host's velocity is then
    /// the mean over a step.
    pub(super) half_kick: Velocity,
    /// Lead of the engine in position; zero if the host follows exactly.
    pub(super) offset: Offset,
    /// True if all steps since the contact began had the same length. If this is true, each step of the host ends at
    /// the engine's position.
    pub(super) exact: bool,
    /// Time in which the lead `velocity` is to decay to zero after the contact has ended (s).
    pub(super) due_s: f64,
}

/// The state from which the engine starts, relative to the host's present state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Start {
    /// True if the host follows the engine exactly, or if the host's velocity is the one with which the engine ended.
    pub(super) exact: bool,
    /// The engine's velocity less the host's velocity, V − v; and the engine's position less the host's position, X −
    /// x.
    pub(super) velocity: Velocity,
    pub(super) offset: Offset,
}

/// The relative state from which the engine starts for a host with a varying step.
pub(super) fn start_varying(lead: Option<&Lead>, present: &BodyState, early_s: f64) -> Start {
    let Some(lead) = lead else { return Start::default() };
    // The engine is one step ahead of a forward Euler host that follows the engine exactly.
    let early_s = if lead.exact { early_s } else { 0.0 };
    Start {
        exact: false,
        velocity: lead.velocity.plus(lead.half_kick),
        offset: lead.offset.plus(Velocity::of(present).displacement(early_s)),
    }
}

/// The lead e′ in velocity after a step, while the engine continues from its own state.
pub(super) fn closed(start: &Start, step_s: f64) -> Velocity {
    let damping = 1.0 + step_s / CLOSING_S;
    let pull = start.offset.per(CLOSING_S * CLOSING_S / step_s);
    start.velocity.minus(pull).times(1.0 / (damping * damping))
}

/// Returns true if the host is so near to the engine that, without contact, the engine continues from the host's pose.
pub(super) fn is_near(offset: Offset) -> bool {
    offset.linear_m.length() < NEAR_M && offset.rotation_rad.abs() < NEAR_RAD
}

/// The part of a [`Lead`] in velocity that is left after a step without contact. Returns `None` when the lead has
/// decayed to zero.
pub(super) fn decayed(velocity: Velocity, due_s: f64, step_s: f64) -> Option<Lead> {
    if step_s >= due_s {
        return None;
    }
    Some(Lead {
        velocity: velocity.times(1.0 - step_s / due_s),
        due_s: due_s - step_s,
        ..Lead::default()
    })
}

/// The engine's lead over a host with a varying step, while the engine continues from its own state.
pub(super) fn apart(velocity: Velocity, offset: Offset) -> Lead {
    Lead { velocity, offset, due_s: DUE_S, ..Lead::default() }
}
