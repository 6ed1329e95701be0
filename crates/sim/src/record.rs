//! What one step of a simulation reports (stage 8).

use fenderline_contact::{BodyState, Contact, Event, Wrench};

/// One step, seen at its start: states at `t_s`, the forces that act from `t_s` to `t_s + step_s`.
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
    /// Touching patches, in a fixed order.
    pub contacts: &'a [Contact],
    /// Work done by each contact in this step, beside `contacts`.
    pub works: &'a [ContactWork],
    /// Sum of contact forces on each body, one a body.
    pub wrenches: &'a [Wrench],
    /// Events of this step.
    pub events: &'a [Event],
    /// The energy ledger at the end of the step.
    pub energy: Energy,
}

/// Work that a contact did on the two bodies in one step [J]: negative while it takes energy.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactWork {
    /// By the normal force.
    pub normal_j: f64,
    /// By the tangential force.
    pub tangential_j: f64,
}

/// The energy ledger since the start of the run [J].
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
    /// Kinetic energy now, less that at the start, less all work: what the integrator made up.
    pub residual_j: f64,
}
