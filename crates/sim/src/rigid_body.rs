//! A rigid body in the plane.

use fenderline_contact::{BodyState, Mobility, Vec2, Wrench, vec2};

use crate::setup::{BodySetup, BodyVelocity, MassProperties, Method};

/// How a body answers a wrench: inverse mass and inertia, zero for a fixed body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Inertia {
    pub(crate) mass_kg: f64,
    pub(crate) yaw_kgm2: f64,
    pub(crate) fixed: bool,
}

impl Inertia {
    /// By the paper's method the mass is displacement plus the *smallest* added mass in the plane,
    /// in every direction (§3.1 of the paper), for the limiter and for the motion alike: else the
    /// limiter's promise of γV⁰ would not be kept.
    pub(crate) fn of(mass: Option<&MassProperties>, method: Method) -> Inertia {
        let Method::Paper = method;
        match mass {
            None => Inertia { mass_kg: 0.0, yaw_kgm2: 0.0, fixed: true },
            Some(m) => Inertia {
                mass_kg: m.mass_kg + m.added_surge_kg.min(m.added_sway_kg),
                yaw_kgm2: m.yaw_inertia_kgm2 + m.added_yaw_kgm2,
                fixed: false,
            },
        }
    }

    /// As the contact engine wants it.
    pub(crate) fn mobility(&self) -> Mobility {
        if self.fixed {
            return Mobility::Fixed;
        }
        Mobility::Free { mass_kg: self.mass_kg, yaw_inertia_kgm2: self.yaw_kgm2 }
    }

    /// Earth-fixed acceleration under a wrench about the centre of gravity [m/s², rad/s²].
    pub(crate) fn acceleration(&self, wrench: &Wrench) -> (Vec2, f64) {
        if self.fixed {
            return (Vec2::ZERO, 0.0);
        }
        (wrench.force_n * (1.0 / self.mass_kg), wrench.moment_nm / self.yaw_kgm2)
    }

    /// Kinetic energy [J].
    pub(crate) fn kinetic_j(&self, state: &BodyState) -> f64 {
        0.5 * (self.mass_kg * state.velocity_mps.length_squared()
            + self.yaw_kgm2 * state.yaw_rate_radps * state.yaw_rate_radps)
    }
}

/// The state that a body starts from.
pub(crate) fn initial_state(body: &BodySetup) -> BodyState {
    let BodyVelocity { surge_mps, sway_mps, yaw_radps } = body.velocity;
    let still = BodyState {
        position_m: body.position_m,
        heading_rad: body.heading_rad,
        ..BodyState::default()
    };
    BodyState {
        velocity_mps: still.pose().rotation.apply(vec2(surge_mps, sway_mps)),
        yaw_rate_radps: yaw_radps,
        ..still
    }
}
