//! The set-up of a simulation: everything that is constant in a run, in SI units.

use fenderline_contact::{Material, Outline, Vec2};

use crate::approach::Approach;
use crate::berthing::BerthingSetup;
use crate::dolphin::DolphinSetup;
use crate::fender::FenderSetup;
use crate::hull::HullByHeight;
use crate::world::WorldSetup;

/// The constant part of a simulation.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Δt (s).
    pub step_s: f64,
    /// Length of the run (s); the number of steps is its ratio to Δt, rounded up.
    pub duration_s: f64,
    /// Time integrator.
    pub integrator: Integrator,
    /// Contact method.
    pub method: Method,
    /// Bodies, in the order of the scenario.
    pub bodies: Vec<BodySetup>,
    /// Materials, referenced by pairs and fenders.
    pub materials: Vec<NamedMaterial>,
    /// Pairs of bodies that may touch, with their material.
    pub pairs: Vec<PairSetup>,
    /// Material of every pair that is not in `pairs`; `None`: those pairs do not touch.
    pub all_other_pairs: Option<usize>,
    /// Fenders on the bodies.
    pub fenders: Vec<FenderSetup>,
    /// Approaches of ships to berths, which gave the start of these bodies.
    pub approaches: Vec<Approach>,
    /// Particulars for the berthing formulas, if the comparison is wanted.
    pub berthing: Option<BerthingSetup>,
    /// External loads.
    pub loads: Vec<Load>,
    /// Vessels, tugs, lines, environment and orders.
    pub world: WorldSetup,
}

impl Setup {
    /// Whether two bodies can touch each other.
    #[must_use]
    pub fn may_touch(&self, [one, other]: [usize; 2]) -> bool {
        let named = |pair: &PairSetup| pair.bodies == [one, other] || pair.bodies == [other, one];
        self.all_other_pairs.is_some() || self.pairs.iter().any(named)
    }
}

/// Time integrator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Forward Euler, as in the paper: positions with the old velocities.
    Euler,
    /// Semi-implicit Euler: velocities first, then positions with the new velocities. With the coupled method the
    /// contact engine moves the bodies itself, as a leapfrog, in sub-steps where needed.
    SemiImplicit,
    /// Classical fourth-order Runge–Kutta. With the paper's method each stage computes its own contact forces; with the
    /// coupled method the mean contact wrench of the step acts in all stages.
    Rk4,
}

/// Contact method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// All contacts and loads of a step are solved together, in sub-steps where needed, with the full mass matrix of
    /// each body.
    Coupled,
    /// The paper's method: each pair is limited on its own (eq. 9–26), with the smaller added mass in all directions.
    Paper,
}

/// One body of a [`Setup`].
#[derive(Clone, Debug, PartialEq)]
pub struct BodySetup {
    /// Unique name.
    pub name: String,
    /// Outline in the body's frame, origin at the centre of gravity.
    pub outline: Outline,
    /// The hull by height, which fenders meet instead; `None`: vertical sides of the outline. By the coupled method only.
    pub hull: Option<HullByHeight>,
    /// Mass and inertia; `None` for a body that stands on the ground.
    pub mass: Option<MassProperties>,
    /// The pile that it stands on, if it is a flexible dolphin; by the coupled method and the semi-implicit integrator only.
    pub dolphin: Option<DolphinSetup>,
    /// Initial position of the centre of gravity, north and east (m).
    pub position_m: Vec2,
    /// Initial heading (rad).
    pub heading_rad: f64,
    /// Initial velocity, body-fixed.
    pub velocity: BodyVelocity,
}

impl BodySetup {
    /// True if the body stands on the ground, fixed or on a pile, so that the water level around it changes with the tide.
    #[must_use]
    pub fn is_fixed(&self) -> bool {
        self.mass.is_none()
    }
}

/// Rigid-body and added mass of a floating body about its centre of gravity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MassProperties {
    /// Displacement (kg).
    pub mass_kg: f64,
    /// Moment of inertia about the vertical (kg·m²).
    pub yaw_inertia_kgm2: f64,
    /// Added mass in surge (kg).
    pub added_surge_kg: f64,
    /// Added mass in sway (kg).
    pub added_sway_kg: f64,
    /// Added moment of inertia in yaw (kg·m²).
    pub added_yaw_kgm2: f64,
}

/// Velocity in the body's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyVelocity {
    /// u, forward (m/s).
    pub surge_mps: f64,
    /// v, to starboard (m/s).
    pub sway_mps: f64,
    /// r, to starboard (rad/s).
    pub yaw_radps: f64,
}

/// A material and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedMaterial {
    /// Unique name.
    pub name: String,
    /// Parameters.
    pub material: Material,
}

/// Two bodies that may touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PairSetup {
    /// Indices into [`Setup::bodies`].
    pub bodies: [usize; 2],
    /// Index into [`Setup::materials`].
    pub material: usize,
}

/// An external load at a body's centre of gravity, earth-fixed, while `from_s ≤ t < until_s`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Index into [`Setup::bodies`].
    pub body: usize,
    /// Force, north and east (N).
    pub force_n: Vec2,
    /// Moment about the vertical, positive to starboard (N·m).
    pub moment_nm: f64,
    /// Start of the load (s).
    pub from_s: f64,
    /// End of the load (s); infinite for a steady load.
    pub until_s: f64,
}
