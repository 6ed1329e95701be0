//! Kirchhoff's equations: the momentum of a body with different masses in surge and sway turns relative to the body
//! when the body turns.

use crate::maths::vec2::{Rotation, vec2};
use crate::state::body_state::BodyState;

/// Kirchhoff's equations of motion for a body without forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Kirchhoff {
    /// m_y/m_x, m_x/m_y.
    sway_by_surge: f64,
    surge_by_sway: f64,
    /// m_x/I and m_y/I (1/m²).
    surge_by_yaw: f64,
    sway_by_yaw: f64,
    /// The sum 2(m_y/m_x + m_x/m_y) of mass ratios: see [`Kirchhoff::rate_squared`].
    coupling: f64,
}

/// The fixed-point iteration ends when the square of its error, in the variables √m_x u, √m_y v and √I r, is at most
/// this share of twice the kinetic energy: the relative error is then an eighth of the machine epsilon.
const ERROR_SQUARED: f64 = f64::EPSILON * f64::EPSILON / 64.0;

/// Largest number of parts into which a sub-step is divided. The largest number of parts bounds the work: velocities
/// that would need more parts are left unchanged.
const MOST_PARTS: f64 = 64.0;

impl Kirchhoff {
    /// Kirchhoff's equations for a body with these masses in surge, sway and yaw (kg, kg, kg·m²). Returns `None` if
    /// surge and sway have the same mass, because the momentum then does not turn.
    pub(crate) fn new(surge_kg: f64, sway_kg: f64, yaw_kgm2: f64) -> Option<Kirchhoff> {
        let (sway_by_surge, surge_by_sway) = (sway_kg / surge_kg, surge_kg / sway_kg);
        (surge_kg != sway_kg).then_some(Kirchhoff {
            sway_by_surge,
            surge_by_sway,
            surge_by_yaw: surge_kg / yaw_kgm2,
            sway_by_yaw: sway_kg / yaw_kgm2,
            coupling: 2.0 * (sway_by_surge + surge_by_sway),
        })
    }

    /// Computes the velocities of the body after `h` seconds of Kirchhoff's equations without forces, m_x u̇ = m_y v r,
    /// m_y v̇ = −m_x u r, I ṙ = −(m_y − m_x) u v. The function uses the implicit midpoint rule, which conserves the
    /// kinetic energy exactly, so the time step neither adds energy to a body that touches nothing nor takes energy
    /// from it. `before` is the attitude of the body to which the velocities in `state` belong, and `after` the
    /// attitude to which the body has turned.
    #[inline]
    pub(crate) fn turn(&self, state: &mut BodyState, before: Rotation, after: Rotation, h: f64) {
        let own = before.apply_inverse(state.velocity_mps);
        let mut velocity = (own.x, own.y, state.yaw_rate_radps);
        let turns_squared = h * h * self.rate_squared(velocity);
        if turns_squared <= 1.0 {
            velocity = self.part(velocity, h, turns_squared);
        } else if turns_squared <= MOST_PARTS * MOST_PARTS {
            velocity = self.in_parts(velocity, h, libm::ceil(libm::sqrt(turns_squared)) as u32);
        }
        state.velocity_mps = after.apply(vec2(velocity.0, velocity.1));
        state.yaw_rate_radps = velocity.2;
    }

    /// A bound on the square of the rate at which Kirchhoff's equations turn velocities of this energy (1/s²). In the
    /// variables √m_x u, √m_y v and √I r, the Frobenius norm of the Jacobian of the equations is at most ρ
    /// √(2(m_y/m_x + m_x/m_y)/I), where ρ² is twice the energy.
    #[inline]
    fn rate_squared(&self, velocity: (f64, f64, f64)) -> f64 {
        self.coupling * self.energy(velocity)
    }

    /// Twice the kinetic energy of the body, divided by its inertia in yaw (1/s²).
    #[inline]
    fn energy(&self, (u, v, r): (f64, f64, f64)) -> f64 {
        self.surge_by_yaw * u * u + self.sway_by_yaw * v * v + r * r
    }

    /// Computes a step in several parts if the velocities turn too far for one fixed-point iteration.
    #[cold]
    #[inline(never)]
    fn in_parts(&self, velocity: (f64, f64, f64), h: f64, parts: u32) -> (f64, f64, f64) {
        (0..parts).fold(velocity, |velocity, _| self.part(velocity, h / f64::from(parts), 1.0))
    }

    /// Computes one step of the midpoint rule. A fixed-point iteration finds the mean velocities of this step.
    /// `turns_squared` is a bound on h² times [`Kirchhoff::rate_squared`], at most 1.
    ///
    /// Each round of the iteration divides the error in √m_x u, √m_y v and √I r by at least 2/√`turns_squared`. So the
    /// error at the start of the fixed-point iteration is at most twice the change by its first round. The falling
    /// error bounds the number of rounds: a body that goes straight ahead needs one round.
    #[inline]
    fn part(&self, start: (f64, f64, f64), h: f64, turns_squared: f64) -> (f64, f64, f64) {
        let ((u0, v0, r0), half_s) = (start, 0.5 * h);
        let (of_u, of_v) = (half_s * self.sway_by_surge, half_s * self.surge_by_sway);
        let of_r = half_s * (self.sway_by_yaw - self.surge_by_yaw);
        let changes = |u, v, r| (of_u * (v * r), -of_v * (u * r), -of_r * (u * v));
        let reduction_squared = 0.25 * turns_squared;
        let small = ERROR_SQUARED * self.energy(start);
        let mut change = changes(u0, v0, r0);
        let mut error_squared = 4.0 * reduction_squared * self.energy(change);
        while error_squared > small {
            change = changes(u0 + change.0, v0 + change.1, r0 + change.2);
            error_squared *= reduction_squared;
        }
        let (of_surge, of_sway, of_yaw) = change;
        (u0 + 2.0 * of_surge, v0 + 2.0 * of_sway, r0 + 2.0 * of_yaw)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::maths::number::lesser;
    use crate::maths::vec2::Vec2;

    /// Masses in surge, sway and yaw (kg, kg, kg·m²).
    type Masses = [f64; 3];

    const SHIP: Masses = [9e7, 1.4e8, 8e11];
    const TUG: Masses = [1.01e6, 1.71e6, 8.3e7];

    fn of([surge_kg, sway_kg, yaw_kgm2]: Masses) -> Kirchhoff {
        Kirchhoff::new(surge_kg, sway_kg, yaw_kgm2).expect("the masses differ")
    }

    fn twice_energy_j([surge_kg, sway_kg, yaw_kgm2]: Masses, own: Vec2, r: f64) -> f64 {
        surge_kg * own.x * own.x + sway_kg * own.y * own.y + yaw_kgm2 * r * r
    }

    /// A ship that drifts and turns, alone for ten minutes, in steps of 0.1 s.
    #[test]
    fn a_free_body_conserves_energy_and_momentum() {
        let ship = of(SHIP);
        let mut state = BodyState {
            velocity_mps: vec2(2.0, 0.6),
            yaw_rate_radps: 0.01,
            ..BodyState::default()
        };
        let energy = |state: &BodyState| {
            let own = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
            twice_energy_j(SHIP, own, state.yaw_rate_radps)
        };
        let momentum = |state: &BodyState| {
            let rotation = Rotation::from_angle(state.heading_rad);
            let own = rotation.apply_inverse(state.velocity_mps);
            rotation.apply(vec2(SHIP[0] * own.x, SHIP[1] * own.y))
        };
        let (start_j, start) = (energy(&state), momentum(&state));
        for _ in 0..6000 {
            let before = Rotation::from_angle(state.heading_rad);
            state.heading_rad += 0.1 * state.yaw_rate_radps;
            let after = Rotation::from_angle(state.heading_rad);
            ship.turn(&mut state, before, after, 0.1);
            assert!((energy(&state) / start_j - 1.0).abs() < 1e-12);
        }
        // The heading changes by the yaw rate at the start of each step, so momentum is kept to first order in the
        // step.
        let off = (momentum(&state) - start).length() / start.length();
        assert!(off < 0.02, "{off}");
        assert!(state.heading_rad.abs() > 0.5, "she has turned: {}", state.heading_rad);
    }

    /// The fixed point diverged in steps of many seconds. A tug at 6 m/s nearly doubled her energy in one step of 5 s,
    /// and a step of a minute was refused although she was alone.
    #[test]
    fn a_free_body_conserves_energy_in_steps_of_any_length() {
        for masses in [SHIP, TUG] {
            let body = of(masses);
            let energy = |own, r| twice_energy_j(masses, own, r);
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

    /// The iteration gives the midpoint rule to rounding, for slow and fast velocities, in steps up to the longest that
    /// is not divided.
    #[test]
    fn the_iteration_ends_at_the_midpoint_rule() {
        for masses in [SHIP, TUG] {
            let body = of(masses);
            let [surge_kg, sway_kg, yaw_kgm2] = masses;
            for speed in [1e-9, 1e-6, 1e-3, 0.1, 1.0, 6.0] {
                for (u0, v0, r0) in [(1.0, 0.1, 0.01), (-0.3, 1.0, 0.0), (0.1, -0.2, -0.03)] {
                    let start = (speed * u0, speed * v0, speed * r0);
                    let longest_s = 1.0 / libm::sqrt(body.rate_squared(start));
                    for h in [lesser(0.1, longest_s), 0.999 * longest_s] {
                        let turns_squared = h * h * body.rate_squared(start);
                        let (u1, v1, r1) = body.part(start, h, turns_squared);
                        let (u0, v0, r0) = start;
                        let (u, v, r) = (0.5 * (u0 + u1), 0.5 * (v0 + v1), 0.5 * (r0 + r1));
                        let off_j = twice_energy_j(
                            masses,
                            vec2(
                                u0 + h * sway_kg / surge_kg * v * r - u1,
                                v0 - h * surge_kg / sway_kg * u * r - v1,
                            ),
                            r0 - h * (sway_kg - surge_kg) / yaw_kgm2 * u * v - r1,
                        );
                        let all_j = twice_energy_j(masses, vec2(u0, v0), r0);
                        // The error is at most a few roundings of each number.
                        assert!(off_j <= 1e-31 * all_j, "{start:?}, {h} s: {off_j} of {all_j}");
                    }
                }
            }
        }
    }
}
