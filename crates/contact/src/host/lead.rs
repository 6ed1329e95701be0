//! How far the engine's motion of a body is ahead of its host's, and how the host is brought after it.
//!
//! A host with a steady step is steered *exactly*: each of its steps ends where the engine's did
//! ([`super::steering`]). It gets what is owed of one step's velocity, ½ a Δt, with the next step's
//! wrench. Where the next step is another one that does not do: half a second's debt, paid in 1/60 s, is
//! thirty times the force.
//!
//! So a host whose step varies gets, in each step, the mean of the contact's wrench over it, and ends with
//! the engine's *velocity*. Its own integration then goes elsewhere than the engine did, by up to ½ a Δt².
//! The engine goes on from where it was, not from there: what it is ahead, p in place and e in velocity, is
//! remembered, and closed as a spring with critical damping would in T = 10 s, by the implicit rule
//!
//! e′ = (e − Δt p/T²) / (1 + Δt/T)²,
//!
//! which is stable for any Δt. The force for it is at most ½ (Δt/T)² of the contact's own: 2 % after a step
//! of 2 s.

use crate::host::steering::{Velocity, Way};
use crate::state::BodyState;

/// T: in which time the host comes to where the engine is, where its step varies (s).
const CLOSING_S: f64 = 10.0;

/// In which time it gets what is owed in velocity when the contact has ended, where its step varies (s).
const DUE_S: f64 = 2.0;

/// How near to the engine's place the host goes on from its own, when the contact has ended (m, rad).
const NEAR_M: f64 = 5e-3;
const NEAR_RAD: f64 = 1e-4;

/// Share by which a step may differ from the last one and be as long: hosts subtract times.
const SAME_STEP: f64 = 1e-6;

/// Is a step as long as the last one, or the first?
pub(super) fn is_steady(last_step_s: f64, step_s: f64) -> bool {
    last_step_s == 0.0 || (step_s - last_step_s).abs() <= SAME_STEP * last_step_s
}

/// How far the engine's motion of a body is ahead of the host's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Lead {
    /// In velocity, beyond `half_kick`.
    pub(super) velocity: Velocity,
    /// What half of the last step's load does, where the host is steered exactly: by then its velocity is
    /// the mean over a step.
    pub(super) half_kick: Velocity,
    /// In place; nothing where the host is steered exactly.
    pub(super) way: Way,
    /// Whether all steps since this began were as long, so that the host is steered exactly.
    pub(super) exact: bool,
    /// In which time `velocity` is to be nothing, where nothing touches the body any more (s).
    pub(super) due_s: f64,
}

/// Where the engine begins, beside the host's present.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Start {
    pub(super) exact: bool,
    /// V − v and X − x.
    pub(super) velocity: Velocity,
    pub(super) way: Way,
}

/// Where the engine begins with a body whose host's step varies.
pub(super) fn start_varying(lead: Option<&Lead>, present: &BodyState, early_s: f64) -> Start {
    let Some(lead) = lead else { return Start::default() };
    // A forward Euler host that was steered exactly has the engine a step ahead.
    let early_s = if lead.exact { early_s } else { 0.0 };
    Start {
        exact: false,
        velocity: lead.velocity.plus(lead.half_kick),
        way: lead.way.plus(Velocity::of(present).way(early_s)),
    }
}

/// e′, while the engine goes on from a place of its own.
pub(super) fn closed(start: &Start, step_s: f64) -> Velocity {
    let damping = 1.0 + step_s / CLOSING_S;
    let pull = start.way.per(CLOSING_S * CLOSING_S / step_s);
    start.velocity.minus(pull).times(1.0 / (damping * damping))
}

/// Is the host so near to the engine's place that it may go on from its own, where nothing touches the body?
pub(super) fn is_near(way: Way) -> bool {
    way.linear_m.length() < NEAR_M && way.rotation_rad.abs() < NEAR_RAD
}

/// What is left of the velocity, where nothing touches the body any more, after a step.
pub(super) fn paid_off(velocity: Velocity, due_s: f64, step_s: f64) -> Option<Lead> {
    if step_s >= due_s {
        return None;
    }
    Some(Lead {
        velocity: velocity.times(1.0 - step_s / due_s),
        due_s: due_s - step_s,
        ..Lead::default()
    })
}

/// A lead while the engine goes on from a place of its own, where the host's step varies.
pub(super) fn apart(velocity: Velocity, way: Way) -> Lead {
    Lead { velocity, way, due_s: DUE_S, ..Lead::default() }
}
