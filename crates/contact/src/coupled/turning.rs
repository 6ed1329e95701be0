//! The momentum of a body whose mass differs between surge and sway turns with the body.

use crate::model::Mobility;
use crate::state::BodyState;
use crate::vec2::{Rotation, vec2};

/// Masses of a body in surge, sway and yaw [kg, kg, kg·m²].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Turning {
    surge_kg: f64,
    sway_kg: f64,
    yaw_kgm2: f64,
}

/// Most rounds of the fixed point below: each takes off a factor of the angle turned meanwhile, a few
/// hundredths in a sub-step.
const ROUNDS: u32 = 60;

impl Turning {
    /// `None` for a body that the engine does not turn, and for one with nothing to turn.
    pub(crate) fn of(mobility: &Mobility) -> Option<Turning> {
        match *mobility {
            Mobility::Afloat { surge_kg, sway_kg, yaw_inertia_kgm2 } if surge_kg != sway_kg => {
                Some(Turning { surge_kg, sway_kg, yaw_kgm2: yaw_inertia_kgm2 })
            }
            _ => None,
        }
    }

    /// All of it, to tell one from another.
    pub(crate) fn to_bits(self) -> [u64; 3] {
        [self.surge_kg, self.sway_kg, self.yaw_kgm2].map(f64::to_bits)
    }

    /// The velocities after `h` seconds of Kirchhoff's equations without forces,
    ///
    /// m_x u̇ = m_y v r, m_y v̇ = −m_x u r, I ṙ = −(m_y − m_x) u v,
    ///
    /// by the implicit midpoint rule: it keeps the kinetic energy exactly, which is quadratic, so that a
    /// body that is alone neither gains nor loses by the time step. `before` is the attitude that the
    /// velocities in `state` belong to, `after` the one that the body has turned to.
    pub(crate) fn turn(&self, state: &mut BodyState, before: Rotation, after: Rotation, h: f64) {
        let own = before.apply_inverse(state.velocity_mps);
        let (u0, v0, r0) = (own.x, own.y, state.yaw_rate_radps);
        let (mut u, mut v, mut r) = (u0, v0, r0);
        for _ in 0..ROUNDS {
            let (um, vm, rm) = (0.5 * (u0 + u), 0.5 * (v0 + v), 0.5 * (r0 + r));
            let next = (
                u0 + h * self.sway_kg * vm * rm / self.surge_kg,
                v0 - h * self.surge_kg * um * rm / self.sway_kg,
                r0 - h * (self.sway_kg - self.surge_kg) * um * vm / self.yaw_kgm2,
            );
            let settled = next == (u, v, r);
            (u, v, r) = next;
            if settled {
                break;
            }
        }
        state.velocity_mps = after.apply(vec2(u, v));
        state.yaw_rate_radps = r;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHIP: Turning = Turning { surge_kg: 9e7, sway_kg: 1.4e8, yaw_kgm2: 8e11 };

    /// A ship that drifts and turns, alone for ten minutes, in steps of 0.1 s.
    #[test]
    fn a_body_alone_keeps_its_energy_and_its_momentum() {
        let mut state = BodyState {
            velocity_mps: vec2(2.0, 0.6),
            yaw_rate_radps: 0.01,
            ..BodyState::default()
        };
        let energy = |state: &BodyState| {
            let own = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
            SHIP.surge_kg * own.x * own.x
                + SHIP.sway_kg * own.y * own.y
                + SHIP.yaw_kgm2 * state.yaw_rate_radps * state.yaw_rate_radps
        };
        let momentum = |state: &BodyState| {
            let rotation = Rotation::from_angle(state.heading_rad);
            let own = rotation.apply_inverse(state.velocity_mps);
            rotation.apply(vec2(SHIP.surge_kg * own.x, SHIP.sway_kg * own.y))
        };
        let (start_j, start) = (energy(&state), momentum(&state));
        for _ in 0..6000 {
            let before = Rotation::from_angle(state.heading_rad);
            state.heading_rad += 0.1 * state.yaw_rate_radps;
            let after = Rotation::from_angle(state.heading_rad);
            SHIP.turn(&mut state, before, after, 0.1);
            assert!((energy(&state) / start_j - 1.0).abs() < 1e-12);
        }
        // The heading goes by the yaw rate at each step's start: momentum is kept to first order in it.
        let off = (momentum(&state) - start).length() / start.length();
        assert!(off < 0.02, "{off}");
        assert!(state.heading_rad.abs() > 0.5, "she has turned: {}", state.heading_rad);
    }
}
