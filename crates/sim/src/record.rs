//! What one step of a simulation reports (stage 8).

use fenderline_contact::{BodyState, Contact, Event, Wrench};

/// One step, seen at its start: states at `t_s`, the forces that act from there on.
#[derive(Clone, Copy, Debug)]
pub struct StepRecord<'a> {
    /// Number of the step, from 0.
    pub index: u64,
    /// Start of the step [s].
    pub t_s: f64,
    /// States at the start of the step, one a body, in the order of the set-up.
    pub states: &'a [BodyState],
    /// States at the end of the step.
    pub states_after: &'a [BodyState],
    /// Touching patches at the start of the step, in a fixed order.
    pub contacts: &'a [Contact],
    /// What contact did in this step, one entry a pair of bodies.
    pub works: &'a [PairWork],
    /// Sum of contact forces on each body at the start of the step, one a body.
    pub wrenches: &'a [Wrench],
    /// Events of this step.
    pub events: &'a [Event],
    /// The energy ledger at the end of the step.
    pub energy: Energy,
}

/// What the contact of two bodies did in one step, over all the integrator's stages.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairWork {
    /// Indices of the bodies in the set-up, the smaller first.
    pub bodies: [usize; 2],
    /// ∫ N dt [N·s].
    pub normal_impulse_ns: f64,
    /// Work of the normal force on the two bodies [J]: negative while it takes energy.
    pub normal_j: f64,
    /// Work of the tangential force on the two bodies [J].
    pub tangential_j: f64,
}

/// The energy ledger since the start of the run [J].
///
/// Work is force times the mean of the velocities before and after the step, so that it accounts
/// for the change of kinetic energy exactly. A contact that leaves with more energy than it came
/// with shows as positive `normal_work_j`: energy that the method or the time step made up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Kinetic energy now, added mass included.
    pub kinetic_j: f64,
    /// Work done by external loads.
    pub load_work_j: f64,
    /// Work done by normal contact forces on the bodies.
    pub normal_work_j: f64,
    /// Work done by tangential contact forces on the bodies.
    pub tangential_work_j: f64,
    /// Kinetic energy now, less that at the start, less all work. Rounding where a body's mass is the
    /// same in surge and sway; else also what a step makes of momentum that turns with the body,
    /// which falls with Δt.
    pub residual_j: f64,
}
