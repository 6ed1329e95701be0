//! A rigid body in the plane: inertia, acceleration, kinetic energy.

use fenderline_contact::number::lesser;
use fenderline_contact::{BodyState, Mobility, Pile, Vec2, Wrench, vec2};

use crate::dolphin::DolphinSetup;
use crate::setup::body::{BodySetup, BodyVelocity, MassProperties};
use crate::setup::method::Method;

/// Inertia of a body: rigid-body and added mass. A fixed body has no inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia {
    /// Mass in surge (kg).
    pub surge_kg: f64,
    /// Mass in sway (kg).
    pub sway_kg: f64,
    /// Moment of inertia in yaw (kg·m²).
    pub yaw_kgm2: f64,
    /// Coupling of sway and yaw about the centre of gravity (kg·m).
    pub coupling_kgm: f64,
    /// True if the contact engine moves the body and adds the Coriolis terms.
    pub engine_turns: bool,
    /// True if the body does not move.
    pub fixed: bool,
    /// The pile that holds the body; `None` if the body is not on a pile. A body on a pile does not turn.
    pub pile: Option<Pile>,
}

impl Inertia {
    /// The inertia of a body that is neither a vessel nor a dolphin.
    ///
    /// In the coupled method, surge, sway and yaw each have an added mass. In the method of Moreno et al. (2023), the
    /// mass in every direction is the displacement plus the *smaller* of the two added masses (§3.1 of their paper).
    /// Both the limit of the contact force and the motion use this mass. With another mass in the limit than in the
    /// motion, the body would not rebound at the speed γV⁰.
    pub fn of(mass: Option<&MassProperties>, method: Method, engine_turns: bool) -> Inertia {
        let Some(m) = mass else {
            return Inertia {
                surge_kg: 0.0,
                sway_kg: 0.0,
                yaw_kgm2: 0.0,
                coupling_kgm: 0.0,
                engine_turns: false,
                fixed: true,
                pile: None,
            };
        };
        let (added_surge_kg, added_sway_kg) = match method {
            Method::Coupled => (m.added_surge_kg, m.added_sway_kg),
            Method::Paper => {
                let smallest_kg = lesser(m.added_surge_kg, m.added_sway_kg);
                (smallest_kg, smallest_kg)
            }
        };
        Inertia {
            surge_kg: m.mass_kg + added_surge_kg,
            sway_kg: m.mass_kg + added_sway_kg,
            yaw_kgm2: m.yaw_inertia_kgm2 + m.added_yaw_kgm2,
            coupling_kgm: 0.0,
            engine_turns,
            fixed: false,
            pile: None,
        }
    }

    /// The inertia of a vessel, from the vessel's mass matrix about the centre of gravity.
    pub fn of_vessel(matrix: &[[f64; 3]; 3]) -> Inertia {
        Inertia {
            surge_kg: matrix[0][0],
            sway_kg: matrix[1][1],
            yaw_kgm2: matrix[2][2],
            coupling_kgm: matrix[1][2],
            engine_turns: false,
            fixed: false,
            pile: None,
        }
    }

    /// The inertia of a flexible dolphin that stands at this place.
    pub fn of_dolphin(dolphin: &DolphinSetup, place_m: Vec2) -> Inertia {
        Inertia {
            surge_kg: dolphin.mass_kg,
            sway_kg: dolphin.mass_kg,
            yaw_kgm2: 0.0,
            coupling_kgm: 0.0,
            engine_turns: false,
            fixed: false,
            pile: Some(dolphin.pile(place_m)),
        }
    }

    /// The inertia in the form of the contact engine.
    pub fn mobility(&self) -> Mobility {
        if self.fixed {
            return Mobility::Fixed;
        }
        if let Some(pile) = self.pile {
            return Mobility::OnPile { mass_kg: self.surge_kg, pile };
        }
        if self.surge_kg == self.sway_kg && self.coupling_kgm == 0.0 {
            return Mobility::Free { mass_kg: self.surge_kg, yaw_inertia_kgm2: self.yaw_kgm2 };
        }
        if self.engine_turns {
            return Mobility::SurgeSway {
                surge_kg: self.surge_kg,
                sway_kg: self.sway_kg,
                yaw_inertia_kgm2: self.yaw_kgm2,
            };
        }
        let c = self.coupling_kgm;
        let matrix = [[self.surge_kg, 0.0, 0.0], [0.0, self.sway_kg, c], [0.0, c, self.yaw_kgm2]];
        Mobility::FullMatrix { matrix }
    }

    /// The Coriolis and centripetal wrench C (force and moment) of a body in a current (m/s), earth-fixed: M v̇ = F +
    /// C.
    ///
    /// Let Δ be the sway mass minus the surge mass, c the coupling of sway and yaw, and u, v, r the velocities relative
    /// to the water. Then the components of C in the body's axes are (Δ r v + c r², Δ r u, −Δ u v). The last of the
    /// components is the Munk moment. C is zero if the mass is the same in all directions.
    #[inline]
    pub fn momentum_wrench(&self, state: &BodyState, current_mps: Vec2) -> Wrench {
        let difference_kg = self.sway_kg - self.surge_kg;
        if (difference_kg == 0.0 && self.coupling_kgm == 0.0) || self.engine_turns {
            return Wrench::default();
        }
        let rotation = state.pose().rotation;
        let uv = rotation.apply_inverse(state.velocity_mps - current_mps);
        let r = state.yaw_rate_radps;
        let centripetal_n = self.coupling_kgm * r * r;
        let own_n = vec2(r * uv.y * difference_kg + centripetal_n, r * uv.x * difference_kg);
        Wrench { force_n: rotation.apply(own_n), moment_nm: -difference_kg * uv.x * uv.y }
    }

    /// Earth-fixed acceleration of the body (m/s², rad/s²) under a wrench (force and moment) about the centre of
    /// gravity. The wrench includes the Coriolis terms.
    pub fn acceleration(&self, state: &BodyState, wrench: &Wrench) -> (Vec2, f64) {
        if self.fixed {
            return (Vec2::ZERO, 0.0);
        }
        if self.surge_kg == self.sway_kg && self.coupling_kgm == 0.0 {
            let inverse = 1.0 / self.surge_kg;
            return (wrench.force_n * inverse, wrench.moment_nm / self.yaw_kgm2);
        }
        let rotation = state.pose().rotation;
        let own = rotation.apply_inverse(wrench.force_n);
        let moment_nm = wrench.moment_nm;
        let c = self.coupling_kgm;
        let determinant = self.sway_kg * self.yaw_kgm2 - c * c;
        let sway = (own.y * self.yaw_kgm2 - moment_nm * c) / determinant;
        let yaw = (moment_nm * self.sway_kg - own.y * c) / determinant;
        (rotation.apply(vec2(own.x / self.surge_kg, sway)), yaw)
    }

    /// Kinetic energy (J).
    pub fn kinetic_j(&self, state: &BodyState) -> f64 {
        let translation_j = if self.surge_kg == self.sway_kg && self.coupling_kgm == 0.0 {
            self.surge_kg * state.velocity_mps.length_squared()
        } else {
            let uv = state.pose().rotation.apply_inverse(state.velocity_mps);
            self.surge_kg * uv.x * uv.x
                + self.sway_kg * uv.y * uv.y
                + 2.0 * self.coupling_kgm * uv.y * state.yaw_rate_radps
        };
        0.5 * (translation_j + self.yaw_kgm2 * state.yaw_rate_radps * state.yaw_rate_radps)
    }
}

/// The initial state of a body.
pub fn initial_state(body: &BodySetup) -> BodyState {
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
