//! The constant part of a simulation: what a scenario file says, in SI units.

use fenderline_contact::{Material, Outline, Vec2};

use crate::berthing::BerthingSetup;
use crate::fender::FenderSetup;
use crate::world::WorldSetup;

/// A whole simulation before its first step.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Δt (s).
    pub step_s: f64,
    /// Length of the run (s); the number of steps is its ratio to Δt, rounded up.
    pub duration_s: f64,
    /// How states advance.
    pub integrator: Integrator,
    /// Which contact method.
    pub method: Method,
    /// Bodies, in the order of the scenario.
    pub bodies: Vec<BodySetup>,
    /// Materials, named by the pairs.
    pub materials: Vec<NamedMaterial>,
    /// Who may touch whom.
    pub pairs: Vec<PairSetup>,
    /// Material of every pair that `pairs` does not name; `None`: those do not touch.
    pub all_other_pairs: Option<usize>,
    /// Fenders on the bodies.
    pub fenders: Vec<FenderSetup>,
    /// Particulars for the berthing energy by formula, where it is asked for.
    pub berthing: Option<BerthingSetup>,
    /// External loads.
    pub loads: Vec<Load>,
    /// Everything else that acts on the bodies.
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

/// How states advance from step to step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Forward Euler, as the paper: positions with the old velocities.
    Euler,
    /// Velocities first, then positions with the new velocities.
    SemiImplicit,
    /// Classical fourth-order Runge–Kutta; contact forces are taken anew at each stage.
    Rk4,
}

/// Which contact method limits the forces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// One solve for all contacts of a step with the loads in it, in sub-steps where needed; the full
    /// mass matrix of each body.
    Coupled,
    /// The paper's: each pair limited by itself (eq. 9–26), masses with the smallest added mass.
    Paper,
}

/// One body of a [`Setup`].
#[derive(Clone, Debug, PartialEq)]
pub struct BodySetup {
    /// Unique name.
    pub name: String,
    /// Outline in the body's frame, origin at the centre of gravity.
    pub outline: Outline,
    /// Mass and inertia; `None` for a fixed body.
    pub mass: Option<MassProperties>,
    /// Initial position of the centre of gravity, north and east (m).
    pub position_m: Vec2,
    /// Initial heading (rad).
    pub heading_rad: f64,
    /// Initial velocity, body-fixed.
    pub velocity: BodyVelocity,
}

impl BodySetup {
    /// It does not float, so that the tide comes and goes about it.
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
    /// First moment of the load (s).
    pub from_s: f64,
    /// End of the load (s); infinity for a steady one.
    pub until_s: f64,
}
