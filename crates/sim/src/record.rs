//! What one step of a simulation reports (stage 8).

use fenderline_contact::{BodyState, Contact, Event, Wrench};

use crate::world::{Mooring, TugAtWork, VesselForces, VesselState, WorldEvent};

/// One step, seen at its start: states at `t_s`, the forces that act from there on.
#[derive(Clone, Copy, Debug)]
pub struct StepRecord<'a> {
    /// Number of the step, from 0.
    pub index: u64,
    /// Start of the step (s).
    pub t_s: f64,
    /// States at the start of the step, one a body, in the order of the set-up.
    pub states: &'a [BodyState],
    /// States at the end of the step.
    pub states_after: &'a [BodyState],
    /// Touching patches at the start of the step, in a fixed order.
    pub contacts: &'a [Contact],
    /// What contact did in this step, one entry a fender and its hull or a pair of outlines; also for
    /// those that touched in the last step and have just let go.
    pub contact_energies: &'a [ContactEnergy],
    /// Sum of contact forces on each body at the start of the step, one a body.
    pub wrenches: &'a [Wrench],
    /// Events of this step.
    pub events: &'a [Event],
    /// The energy ledger at the end of the step.
    pub energy: Energy,
    /// Controls and attitude of the vessels at the end of the step, in the order of the set-up.
    pub vessels: &'a [VesselState],
    /// Where the forces on each vessel came from in this step.
    pub vessel_forces: &'a [VesselForces],
    /// The tugs at the end of the step, in the order of the set-up.
    pub tugs: &'a [TugAtWork],
    /// The lines at the end of the step, in the order of the set-up.
    pub lines: &'a [Mooring],
    /// What happened in the world.
    pub world_events: &'a [WorldEvent],
}

/// What one contact did in one step, over all the integrator's stages and the engine's sub-steps: a
/// fender and its hull, or two outlines.
///
/// What the bodies lose to the normal force goes four ways, `-normal_j = Δstored + hysteresis_j + damping_j +
/// restitution_j`, and what they lose to the tangential force two: `-tangential_j = Δshear_stored +
/// friction_j`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactEnergy {
    /// Indices of the bodies in the set-up, the smaller first.
    pub bodies: [usize; 2],
    /// Index of the fender in the set-up; `None`: outline on outline.
    pub fender: Option<usize>,
    /// ∫ N dt (N·s).
    pub normal_impulse_ns: f64,
    /// Work of the normal force on the two bodies (J): negative while it takes energy.
    pub normal_j: f64,
    /// Work of the tangential force on the two bodies (J).
    pub tangential_j: f64,
    /// Work of both on the two bodies since the contact began (J): positive where it has given them more than it took;
    /// −∞ for a contact that was there at the start, with who knows how much stored.
    pub since_began_j: f64,
    /// Stored in spring and stop at the end of the step, and to be had back (J).
    pub stored_j: f64,
    /// Stored in the shear spring at the end of the step (J).
    pub shear_stored_j: f64,
    /// Turned into heat by a fender's unloading law (J).
    pub hysteresis_j: f64,
    /// Turned into heat by damping (J).
    pub damping_j: f64,
    /// What the springs gave back and the limiter kept from the bodies (J).
    pub restitution_j: f64,
    /// Turned into heat by friction, and by the implicit shear spring (J).
    pub friction_j: f64,
    /// What was stored and is not: the spring's book at the end of a contact, and for a fender at each
    /// step what differs from its potential (J). With a fender it is the time step's, and falls with
    /// it; between outlines it is also what the chord's turning normal made (negative) or lost, as that
    /// law has no potential.
    pub residual_j: f64,
}

/// Work of the loads on the bodies since the start of the run, by what they come from (J): force times way over the
/// ground. What pushes a body on is positive; a hull that a current takes along is pushed by it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoadWork {
    /// Drag and lift of the vessels' hulls in the water, current within. Of the hull force of
    /// [`crate::VesselForces`] the part that turns the momentum of the added mass is not in it: it does no work.
    pub hull_j: f64,
    /// Propellers.
    pub propeller_j: f64,
    /// Rudders.
    pub rudder_j: f64,
    /// Tunnel thrusters and azimuth units.
    pub thrusters_j: f64,
    /// Wind on the vessels.
    pub wind_j: f64,
    /// Mean wave drift.
    pub waves_j: f64,
    /// Banks.
    pub banks_j: f64,
    /// The bottom, where vessels are aground.
    pub bottom_j: f64,
    /// What a current does besides its part in the hull's force: water that speeds up takes a vessel along, and the
    /// water that goes with her (her added mass) is another share of it when she has turned. Nothing in still water.
    pub current_j: f64,
    /// Vector tugs.
    pub tugs_j: f64,
    /// Mooring and tow lines: what they store, and what winches give or take.
    pub lines_j: f64,
    /// Loads of the set-up and of other programs.
    pub other_j: f64,
}

impl LoadWork {
    /// Each with the name that it has in tables.
    #[must_use]
    pub fn parts(&self) -> [(&'static str, f64); 12] {
        [
            ("hull", self.hull_j),
            ("propeller", self.propeller_j),
            ("rudder", self.rudder_j),
            ("thrusters", self.thrusters_j),
            ("wind", self.wind_j),
            ("waves", self.waves_j),
            ("banks", self.banks_j),
            ("bottom", self.bottom_j),
            ("current", self.current_j),
            ("tugs", self.tugs_j),
            ("lines", self.lines_j),
            ("other", self.other_j),
        ]
    }

    /// All together (J).
    #[must_use]
    pub fn total_j(&self) -> f64 {
        self.parts().iter().map(|(_, work_j)| work_j).sum()
    }

    pub(crate) fn add(&mut self, step: &LoadWork) {
        self.hull_j += step.hull_j;
        self.propeller_j += step.propeller_j;
        self.rudder_j += step.rudder_j;
        self.thrusters_j += step.thrusters_j;
        self.wind_j += step.wind_j;
        self.waves_j += step.waves_j;
        self.banks_j += step.banks_j;
        self.bottom_j += step.bottom_j;
        self.current_j += step.current_j;
        self.tugs_j += step.tugs_j;
        self.lines_j += step.lines_j;
        self.other_j += step.other_j;
    }
}

/// The energy ledger since the start of the run (J), over the ground: the kinetic energy is what a fender on a quay has
/// to take, and every work is force times way over the ground.
///
/// The way of a step is its mean velocity times Δt, so that it accounts for the change of kinetic energy exactly:
///
/// kinetic = kinetic at the start + load_work + normal_work + tangential_work + residual, and
/// −(normal_work + tangential_work) = stored + shear_stored + hysteresis + damping + restitution + friction +
/// contact_residual.
///
/// A contact that leaves with more energy than it came with shows as positive `normal_work_j` and
/// negative `contact_residual_j`: energy that the method or the time step made up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Kinetic energy now, added mass included.
    pub kinetic_j: f64,
    /// Work done by everything but contact: the sum of [`Energy::loads`].
    pub load_work_j: f64,
    /// The same by what it comes from.
    pub loads: LoadWork,
    /// Work done by normal contact forces on the bodies.
    pub normal_work_j: f64,
    /// Work done by tangential contact forces on the bodies.
    pub tangential_work_j: f64,
    /// Stored now in springs and stops.
    pub stored_j: f64,
    /// Stored now in shear springs.
    pub shear_stored_j: f64,
    /// Lost in rubber: by the unloading laws of fenders.
    pub hysteresis_j: f64,
    /// Lost to damping.
    pub damping_j: f64,
    /// Lost to restitution.
    pub restitution_j: f64,
    /// Lost to friction.
    pub friction_j: f64,
    /// Sum of the contacts' residuals: see [`ContactEnergy::residual_j`].
    pub contact_residual_j: f64,
    /// What came into contacts: the works of all steps and contacts in which the bodies lost energy.
    pub contact_taken_j: f64,
    /// What contacts have given the bodies more than they took from them since each began; those that were there at
    /// the start of the run, and may have had energy stored, are not counted.
    pub contact_gained_j: f64,
    /// Kinetic energy now, less that at the start, less all work. Rounding where a body's mass is the
    /// same in surge and sway, and for a vessel that nothing touches; else also what a step makes of momentum that
    /// turns with the body, which falls with Δt.
    pub residual_j: f64,
}

impl Energy {
    /// How much energy changed hands: the sum of the magnitudes of all works, each since the start (J). What
    /// [`Energy::residual_j`] is to be seen beside.
    #[must_use]
    pub fn exchanged_j(&self) -> f64 {
        let loads_j: f64 = self.loads.parts().iter().map(|(_, work_j)| work_j.abs()).sum();
        loads_j + self.normal_work_j.abs() + self.tangential_work_j.abs()
    }
}
