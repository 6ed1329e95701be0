//! Kirchhoff's equations: the momentum of a body with different masses in surge and sway turns with the body.

use crate::state::BodyState;
use crate::vec2::{Rotation, vec2};

/// Masses of a body in surge, sway and yaw (kg, kg, kg·m²).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Kirchhoff {
    surge_kg: f64,
    sway_kg: f64,
    yaw_kgm2: f64,
    /// 2(m_y/m_x + m_x/m_y): see [`Kirchhoff::rate_squared`].
    coupling: f64,
}

/// Most rounds of the fixed-point iteration. Each reduces the error by about the angle turned in the sub-step: a few
/// hundredths, and at most a half.
const ROUNDS: u32 = 60;

/// Most parts of a sub-step: bounded work. Velocities that would turn faster are left unchanged.
const MOST_PARTS: f64 = 64.0;

impl Kirchhoff {
    /// `None` if surge and sway have the same mass: the momentum does not turn then.
    pub(crate) fn new(surge_kg: f64, sway_kg: f64, yaw_kgm2: f64) -> Option<Kirchhoff> {
        let coupling = 2.0 * (sway_kg / surge_kg + surge_kg / sway_kg);
        (surge_kg != sway_kg).then_some(Kirchhoff { surge_kg, sway_kg, yaw_kgm2, coupling })
    }

    /// The velocities after `h` seconds of Kirchhoff's equations without forces,
    ///
    /// m_x u̇ = m_y v r, m_y v̇ = −m_x u r, I ṙ = −(m_y − m_x) u v,
    ///
    /// by the implicit midpoint rule. It conserves the kinetic energy exactly, so a body that nothing touches neither gains
    /// nor loses energy by the time step. `before` is the attitude that the velocities in `state` belong to, `after` the
    /// one that the body has turned to.
    pub(crate) fn turn(&self, state: &mut BodyState, before: Rotation, after: Rotation, h: f64) {
        let own = before.apply_inverse(state.velocity_mps);
        let mut velocity = (own.x, own.y, state.yaw_rate_radps);
        let turns_squared = h * h * self.rate_squared(velocity);
        if turns_squared <= 1.0 {
            velocity = self.part(velocity, h);
        } else if turns_squared <= MOST_PARTS * MOST_PARTS {
            velocity = self.in_parts(velocity, h, libm::ceil(libm::sqrt(turns_squared)) as u32);
        }
        state.velocity_mps = after.apply(vec2(velocity.0, velocity.1));
        state.yaw_rate_radps = velocity.2;
    }

    /// A bound on the square of the rate at which the equations turn velocities of this energy (1/s²). In √m_x u,
    /// √m_y v and √I r their Jacobian has, with ρ² twice the energy, a Frobenius norm of at most
    /// ρ √(2(m_y/m_x + m_x/m_y)/I).
    fn rate_squared(&self, (u, v, r): (f64, f64, f64)) -> f64 {
        let &Kirchhoff { surge_kg, sway_kg, yaw_kgm2, coupling } = self;
        let energy = surge_kg * u * u + sway_kg * v * v + yaw_kgm2 * r * r;
        coupling * energy / yaw_kgm2
    }

    /// A step in which they turn too far for one fixed-point iteration.
    #[cold]
    fn in_parts(&self, velocity: (f64, f64, f64), h: f64, parts: u32) -> (f64, f64, f64) {
        (0..parts).fold(velocity, |velocity, _| self.part(velocity, h / f64::from(parts)))
    }

    /// One step of the midpoint rule, by a fixed point.
    fn part(&self, (u0, v0, r0): (f64, f64, f64), h: f64) -> (f64, f64, f64) {
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
        (u, v, r)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vec2::Vec2;

    fn ship() -> Kirchhoff {
        Kirchhoff::new(9e7, 1.4e8, 8e11).expect("the masses differ")
    }

    /// A ship that drifts and turns, alone for ten minutes, in steps of 0.1 s.
    #[test]
    fn a_free_body_conserves_energy_and_momentum() {
        let ship = ship();
        let mut state = BodyState {
            velocity_mps: vec2(2.0, 0.6),
            yaw_rate_radps: 0.01,
            ..BodyState::default()
        };
        let energy = |state: &BodyState| {
            let own = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
            ship.surge_kg * own.x * own.x
                + ship.sway_kg * own.y * own.y
                + ship.yaw_kgm2 * state.yaw_rate_radps * state.yaw_rate_radps
        };
        let momentum = |state: &BodyState| {
            let rotation = Rotation::from_angle(state.heading_rad);
            let own = rotation.apply_inverse(state.velocity_mps);
            rotation.apply(vec2(ship.surge_kg * own.x, ship.sway_kg * own.y))
        };
        let (start_j, start) = (energy(&state), momentum(&state));
        for _ in 0..6000 {
            let before = Rotation::from_angle(state.heading_rad);
            state.heading_rad += 0.1 * state.yaw_rate_radps;
            let after = Rotation::from_angle(state.heading_rad);
            ship.turn(&mut state, before, after, 0.1);
            assert!((energy(&state) / start_j - 1.0).abs() < 1e-12);
        }
        // The heading goes by the yaw rate at each step's start: momentum is kept to first order in it.
        let off = (momentum(&state) - start).length() / start.length();
        assert!(off < 0.02, "{off}");
        assert!(state.heading_rad.abs() > 0.5, "she has turned: {}", state.heading_rad);
    }

    /// The fixed point diverged in steps of many seconds: a tug at 6 m/s nearly doubled her energy in one of 5 s, and
    /// a step of a minute was refused, though she was alone.
    #[test]
    fn a_free_body_conserves_energy_in_steps_of_any_length() {
        let tug = Kirchhoff::new(1.01e6, 1.71e6, 8.3e7).expect("the masses differ");
        for body in [ship(), tug] {
            let energy = |own: Vec2, r: f64| {
                body.surge_kg * own.x * own.x + body.sway_kg * own.y * own.y + body.yaw_kgm2 * r * r
            };
            for h in [0.1, 1.0, 5.0, 20.0, 60.0, 600.0, 1e6] {
                let own = vec2(6.0, 0.6);
                let mut state =
                    BodyState { velocity_mps: own, yaw_rate_radps: 0.05, ..BodyState::default() };
                for _ in 0..20 {
                    body.turn(&mut state, Rotation::IDENTITY, Rotation::IDENTITY, h);
                }
                let off = energy(state.velocity_mps, state.yaw_rate_radps) / energy(own, 0.05);
                assert!((off - 1.0).abs() < 1e-10, "{h} s: {off}");
            }
        }
    }
}
