//! The momentum of a vessel that turns, over a step.
//!
//! Her mass differs between surge and sway, so that her momentum turns with her: Kirchhoff's terms. They do no work,
//! but held over a step as they are at its start they do, in a turn always to one side. So the wrench is found that
//! stands for them over the whole step: what takes the momentum M V of the water's and the ship's mass from the heading before to the
//! one after, with the moment by which the step's ends have the energy that all other forces gave.

use fenderline_contact::{BodyState, Rotation, Vec2, Wrench, vec2};

use crate::rigid_body::Inertia;

/// Most rounds of the fixed point: each takes off a factor of about the angle that she turns in the step.
const ROUNDS: u32 = 40;

/// Which yaw rate the integrator turns her with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Turns {
    /// That before the step: forward Euler.
    Before,
    /// That after it: the engine's sub-steps.
    After,
}

/// The wrench that turns a vessel's momentum over a step in which `load` acts on her. Velocities
/// are those through a stream, which carries the frame along. Forces act for a time, which for the engine's first step is
/// half of it: the velocities that it begins with belong to its start, and those that it goes on with to its middle. More than a radian a step, and what does not settle, is
/// taken as at the start.
pub(crate) fn turning_wrench(
    inertia: &Inertia,
    state: &BodyState,
    load: &Wrench,
    stream_mps: Vec2,
    (step_s, acts_s, turns): (f64, f64, Turns),
) -> Wrench {
    let start = inertia.momentum_wrench(state, stream_mps);
    let before = Moment::of(state, stream_mps);
    let mut wrench = start;
    for _ in 0..ROUNDS {
        let sum = Wrench {
            force_n: load.force_n + wrench.force_n,
            moment_nm: load.moment_nm + wrench.moment_nm,
        };
        let (along_mps2, around_radps2) = inertia.acceleration(state, &sum);
        let after = Moment {
            velocity_mps: before.velocity_mps + along_mps2 * acts_s,
            yaw_radps: before.yaw_radps + around_radps2 * acts_s,
        };
        let turned_rad = step_s
            * match turns {
                Turns::Before => before.yaw_radps,
                Turns::After => after.yaw_radps,
            };
        let is_within = turned_rad.abs() <= 1.0;
        if !is_within {
            return start;
        }
        let next =
            turned(inertia, state.heading_rad, (&before, &after), turned_rad, (step_s, acts_s));
        let moved_n = (next.force_n - wrench.force_n).length();
        let is_settled = moved_n <= 1e-14 * next.force_n.length()
            && (next.moment_nm - wrench.moment_nm).abs() <= 1e-14 * next.moment_nm.abs();
        wrench = next;
        if is_settled {
            break;
        }
    }
    wrench
}

/// Velocities through the water at one moment.
struct Moment {
    velocity_mps: Vec2,
    yaw_radps: f64,
}

impl Moment {
    fn of(state: &BodyState, stream_mps: Vec2) -> Moment {
        Moment { velocity_mps: state.velocity_mps - stream_mps, yaw_radps: state.yaw_rate_radps }
    }

    fn mean(&self, other: &Moment) -> Moment {
        Moment {
            velocity_mps: (self.velocity_mps + other.velocity_mps) * 0.5,
            yaw_radps: 0.5 * (self.yaw_radps + other.yaw_radps),
        }
    }

    /// M V at a heading: momentum and angular momentum about the centre of gravity.
    fn momentum(&self, inertia: &Inertia, rotation: Rotation) -> (Vec2, f64) {
        let own = rotation.apply_inverse(self.velocity_mps);
        let Inertia { surge_kg, sway_kg, yaw_kgm2, coupling_kgm, .. } = *inertia;
        let sway_ns = sway_kg * own.y + coupling_kgm * self.yaw_radps;
        let around_nms = coupling_kgm * own.y + yaw_kgm2 * self.yaw_radps;
        (rotation.apply(vec2(surge_kg * own.x, sway_ns)), around_nms)
    }

    /// V·P.
    fn along(&self, (momentum_ns, around_nms): (Vec2, f64)) -> f64 {
        self.velocity_mps.dot(momentum_ns) + self.yaw_radps * around_nms
    }
}

/// The wrench between two moments. With M₀ and M₁ the mass matrix at the two headings: force −(M₁ − M₀)V₁ over the time that
/// it acts, so that M V is what loads make of it, and Munk's moment half-way, −Δ u v. What is left to −½V₁ᵀ(M₁ − M₀)V₁ of work, which
/// leaves ½VᵀMV to the loads, is of third order in a steady turn and of second where she begins to turn, as integrators
/// turn her with one of the yaw rates and not with their mean; it is made up by that little of her momentum.
fn turned(
    inertia: &Inertia,
    heading_rad: f64,
    (before, after): (&Moment, &Moment),
    turned_rad: f64,
    (step_s, acts_s): (f64, f64),
) -> Wrench {
    let at = |rad: f64| Rotation::from_angle(heading_rad + rad);
    let (first, half_way, last) = (at(0.0), at(0.5 * turned_rad), at(turned_rad));
    let (to_ns, to_nms) = after.momentum(inertia, last);
    let (as_before_ns, as_before_nms) = after.momentum(inertia, first);
    let difference = (to_ns - as_before_ns, to_nms - as_before_nms);
    let [from, to] = [before, after].map(|m| half_way.apply_inverse(m.velocity_mps));
    let difference_kg = inertia.sway_kg - inertia.surge_kg;
    let munk_nm = -0.5 * difference_kg * (to.y * from.x + to.x * from.y);
    let impulse = (difference.0 * -1.0, munk_nm * step_s);
    let mean = before.mean(after);
    let missing_j = -0.5 * after.along(difference) - mean.along(impulse);
    let (mean_ns, mean_nms) = mean.momentum(inertia, first);
    let twice_j = mean.along((mean_ns, mean_nms));
    let share = if twice_j > 0.0 { missing_j / twice_j } else { 0.0 };
    Wrench {
        force_n: (impulse.0 + mean_ns * share) * (1.0 / acts_s),
        moment_nm: (impulse.1 + mean_nms * share) / acts_s,
    }
}
