//! The set-up of a simulation: everything that is constant in a run, in SI units.

pub(crate) mod body;
pub(crate) mod load;
pub(crate) mod material;
pub(crate) mod method;

pub use self::body::{BodySetup, BodyVelocity, MassProperties};
pub use self::load::Load;
pub use self::material::NamedMaterial;
pub use self::method::{Integrator, Method};
use crate::approach::Approach;
use crate::berthing::BerthingSetup;
use crate::fender::FenderSetup;
use crate::world::setup::WorldSetup;

/// The constant part of a simulation.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Time step Δt (s).
    pub step_s: f64,
    /// Length of the run (s); the number of steps is this length divided by Δt, rounded up.
    pub duration_s: f64,
    /// Time integrator.
    pub integrator: Integrator,
    /// Contact method.
    pub method: Method,
    /// Bodies, in the order of the scenario.
    pub bodies: Vec<BodySetup>,
    /// Materials to which pairs and fenders refer.
    pub materials: Vec<NamedMaterial>,
    /// Pairs of bodies that may touch, with their material.
    pub pairs: Vec<PairSetup>,
    /// Material of every pair that is not in `pairs`; with `None`, such pairs do not touch.
    pub all_other_pairs: Option<usize>,
    /// Fenders on the bodies.
    pub fenders: Vec<FenderSetup>,
    /// Approaches of ships to berths. The initial states of these ships follow from the approaches.
    pub approaches: Vec<Approach>,
    /// Particulars for the berthing formulas, if the user asks for a comparison with the formulas.
    pub berthing: Option<BerthingSetup>,
    /// External loads.
    pub loads: Vec<Load>,
    /// Vessels, tugs, lines, environment and orders.
    pub world: WorldSetup,
}

impl Setup {
    /// True if the two bodies can touch each other.
    #[must_use]
    pub fn may_touch(&self, [one, other]: [usize; 2]) -> bool {
        let named = |pair: &PairSetup| pair.bodies == [one, other] || pair.bodies == [other, one];
        self.all_other_pairs.is_some() || self.pairs.iter().any(named)
    }
}

/// Two bodies that may touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PairSetup {
    /// Indices into [`Setup::bodies`].
    pub bodies: [usize; 2],
    /// Index into [`Setup::materials`].
    pub material: usize,
}
