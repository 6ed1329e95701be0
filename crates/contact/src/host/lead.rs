//! How far the engine's motion of a body is ahead of its host's, and how the host catches up.
//!
//! A host with a constant step follows the engine *exactly*: each step of the host ends at the engine's position
//! ([`super::steering`]). The host's velocity is then off by ½ a Δt, which the wrench of the next step corrects. If the
//! step changes, this fails: a correction meant for half a second, applied in 1/60 s, takes thirty times the force.
//!
//! So a host with a varying step gets the mean contact wrench of each step, and ends the step with the engine's
//! *velocity*. The host's position is then up to ½ a Δt² from the engine's. The engine continues from its own state.
//! The host's lead, p in position and e in velocity, is remembered. The lead is closed like a critically damped spring
//! in T = 10 s, by the implicit rule
//!
//! e′ = (e − Δt p/T²) / (1 + Δt/T)²,
//!
//! which is stable for any Δt. The force for this is at most ½ (Δt/T)² of the contact force: 2 % after a step of 2 s.

use crate::host::velocity::{Offset, Velocity};
use crate::state::BodyState;

/// T: time in which a host with a varying step catches up with the engine (s).
const CLOSING_S: f64 = 10.0;

/// Time in which the host's velocity is corrected after the contact has ended (s).
const DUE_S: f64 = 2.0;

/// After the contact has ended, the engine continues from the host's pose once it is this near to the engine's (m,
/// rad).
const NEAR_M: f64 = 5e-3;
const NEAR_RAD: f64 = 1e-4;

/// Relative difference within which two steps count as equal. Hosts compute steps as differences of times.
const SAME_STEP: f64 = 1e-6;

/// Whether a step is as long as the last step, or is the first step.
pub(super) fn is_steady(last_step_s: f64, step_s: f64) -> bool {
    last_step_s == 0.0 || (step_s - last_step_s).abs() <= SAME_STEP * last_step_s
}

/// How far the engine's motion of a body is ahead of the host's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Lead {
    /// Lead in velocity, in addition to `half_kick`.
    pub(super) velocity: Velocity,
    /// Velocity change by half of the last step's load, if the host follows exactly: the host's velocity is then the
    /// mean over a step.
    pub(super) half_kick: Velocity,
    /// Lead in position; zero if the host follows exactly.
    pub(super) offset: Offset,
    /// True if all steps since the contact began were equally long. Each step of the host then ends at the engine's position.
    pub(super) exact: bool,
    /// Time in which `velocity` is to decay to zero after the contact has ended (s).
    pub(super) due_s: f64,
}

/// The engine's start relative to the host's present state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Start {
    /// Whether the host has the velocity that the engine left, or follows the engine exactly.
    pub(super) exact: bool,
    /// The engine's velocity less the host's, V − v; the same for the position, X − x.
    pub(super) velocity: Velocity,
    pub(super) offset: Offset,
}

/// The engine's start for a host with a varying step.
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

/// The lead in velocity after a step, e′, while the engine continues from its own state.
pub(super) fn closed(start: &Start, step_s: f64) -> Velocity {
    let damping = 1.0 + step_s / CLOSING_S;
    let pull = start.offset.per(CLOSING_S * CLOSING_S / step_s);
    start.velocity.minus(pull).times(1.0 / (damping * damping))
}

/// Whether the host is so near to the engine that, without contact, the engine continues from the host's pose.
pub(super) fn is_near(offset: Offset) -> bool {
    offset.linear_m.length() < NEAR_M && offset.rotation_rad.abs() < NEAR_RAD
}

/// What is left of a [`Lead`] in velocity after a step without contact. `None` when the lead has decayed to zero.
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

/// The lead of a host with a varying step, while the engine continues from its own state.
pub(super) fn apart(velocity: Velocity, offset: Offset) -> Lead {
    Lead { velocity, offset, due_s: DUE_S, ..Lead::default() }
}
