//! One body of a set-up: outline, hull, mass, and initial state.

use fenderline_contact::{Outline, Vec2};

use crate::dolphin::DolphinSetup;
use crate::hull::HullByHeight;

/// One body of a [`crate::setup::Setup`].
#[derive(Clone, Debug, PartialEq)]
pub struct BodySetup {
    /// Unique name.
    pub name: String,
    /// Outline in the body's frame, whose origin is the centre of gravity.
    pub outline: Outline,
    /// The hull by its outlines at several heights, which fenders meet instead of `outline`; `None` if the sides of the
    /// body are vertical. Such a hull needs the coupled method.
    pub hull: Option<HullByHeight>,
    /// Mass and inertia; `None` for a body that stands on the ground.
    pub mass: Option<MassProperties>,
    /// The pile on which the body stands, if it is a flexible dolphin. A pile needs the coupled method with the
    /// semi-implicit integrator.
    pub dolphin: Option<DolphinSetup>,
    /// Initial position of the centre of gravity, north and east (m).
    pub position_m: Vec2,
    /// Initial heading (rad).
    pub heading_rad: f64,
    /// Initial velocity of the body, in the body's axes.
    pub velocity: BodyVelocity,
}

impl BodySetup {
    /// True if the body stands on the ground, fixed or on a pile. The water level at such a body changes with the tide.
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

/// Velocity of a body, in the body's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyVelocity {
    /// Surge velocity u, forward (m/s).
    pub surge_mps: f64,
    /// Sway velocity v, to starboard (m/s).
    pub sway_mps: f64,
    /// Yaw rate r, to starboard (rad/s).
    pub yaw_radps: f64,
}
