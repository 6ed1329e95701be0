//! Piles that hold bodies to their places: the law of one pile, and its motion in a step.
//!
//! With the elastic deflection e, the pile's force on its body is −K e − C v, as long as K |e| is at most the yield
//! load. Beyond the yield load the pile yields: the deflection grows while the spring's force stays at the yield load,
//! and the plastic part of the deflection stays.
//!
//! The midpoint rule takes the pile's spring and damping implicitly over a step of length κ: m (v⁺ − v) = κ (F − K (e +
//! κ v̄ / 2) − C v̄), with v̄ = (v + v⁺)/2 and e⁺ = e + κ v̄. The midpoint rule is stable for any κ and adds no energy.
//!
//! So for any force F on the body, v⁺ = v + κ (F − K (e + κ v / 2) − C v)/m′ with m′ = m + κ² K / 4 + κ C / 2. With the
//! midpoint rule the relative error of the pile's period is (ωκ)²/12. If K |e⁺| exceeds the yield load, the deflection
//! e⁺ is shortened along its own direction until the spring is at the yield load. The energy that this shortening takes
//! from the spring is lost; the loss is never negative. While the pile yields, its force is the yield load, as long as
//! the body moves outward.

use crate::maths::number::{greater, lesser};
use crate::maths::vec2::Vec2;

/// Relative tolerance: a load that differs from the yield load by less than this share counts as at the yield load.
const AT_LIMIT: f64 = 1e-9;

/// A pile, or a group of piles, that holds a body to its place: a spring with damping and a yield load, the same in all
/// horizontal directions. The pile does not let the body turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pile {
    /// Position of the body when no load acts on it, north and east (m).
    pub place_m: Vec2,
    /// Stiffness of the pile at the height of the load (N/m).
    pub stiffness_npm: f64,
    /// Damping (N·s/m).
    pub damping_nspm: f64,
    /// The load at which the pile yields (N); infinite for a pile that does not yield.
    pub yield_n: f64,
}

/// Motion, forces and energies of a pile in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PileMotion {
    /// Deflection of the pile at the end of the step, the permanent part included (m).
    pub deflection_m: Vec2,
    /// The permanent part of the pile's deflection at the end of the step (m).
    pub offset_m: Vec2,
    /// The force of the pile's spring on the body at the end of the step (N).
    pub force_n: Vec2,
    /// Largest deflection of the pile in the step (m).
    pub peak_deflection_m: f64,
    /// Largest load on the pile's spring in the step (N).
    pub peak_load_n: f64,
    /// Energy in the pile's spring at the end of the step (J).
    pub stored_j: f64,
    /// Largest energy in the pile's spring in the step (J).
    pub peak_stored_j: f64,
    /// Work of the pile on its body in the step (J): −(change of `stored_j` + `damping_j` + `yield_j`).
    pub work_j: f64,
    /// Energy lost to the pile's damping in the step (J).
    pub damping_j: f64,
    /// Energy lost to the pile's yielding in the step (J).
    pub yield_j: f64,
}

/// The state of a pile, with its deflections. The deflections are those at the time to which the body's velocity
/// belongs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PileState {
    /// Deflection (m).
    pub(crate) deflection_m: Vec2,
    /// The permanent part of the pile's deflection (m).
    pub(crate) offset_m: Vec2,
}

impl PileState {
    pub(crate) fn elastic_m(&self) -> Vec2 {
        self.deflection_m - self.offset_m
    }
}

impl Pile {
    /// The direction in which the pile yields at the start of a step; `None` if it does not yield. The pile yields if
    /// it is at the yield load and the body moves on outward.
    fn flows_to(&self, state: &PileState, velocity_mps: Vec2) -> Option<Vec2> {
        let elastic_m = state.elastic_m();
        let length_m = elastic_m.length();
        let is_at_limit = self.stiffness_npm * length_m >= self.yield_n * (1.0 - AT_LIMIT);
        let flows = is_at_limit && elastic_m.dot(velocity_mps) > 0.0;
        flows.then(|| elastic_m * (1.0 / length_m))
    }

    /// The mass m′ (kg), and the force of the pile at the start of a step of length κ, which must act on the mass m′
    /// (N).
    pub(crate) fn begin(
        &self,
        state: &PileState,
        mass_kg: f64,
        velocity_mps: Vec2,
        kick_s: f64,
    ) -> (f64, Vec2) {
        let damping_n = velocity_mps * -self.damping_nspm;
        let damped_kg = mass_kg + 0.5 * kick_s * self.damping_nspm;
        if let Some(outward) = self.flows_to(state, velocity_mps) {
            return (damped_kg, outward * -self.yield_n + damping_n);
        }
        let half_way_m = state.elastic_m() + velocity_mps * (0.5 * kick_s);
        let by_spring_kg = 0.25 * kick_s * kick_s * self.stiffness_npm;
        (damped_kg + by_spring_kg, half_way_m * -self.stiffness_npm + damping_n)
    }

    /// Computes the state of the pile after a step of length κ, in which the body's velocity went from the first to the
    /// second value, and the motion of the pile in the step.
    pub(crate) fn advance(
        &self,
        state: &mut PileState,
        motion: &mut PileMotion,
        (before_mps, after_mps): (Vec2, Vec2),
        kick_s: f64,
    ) {
        let mean_mps = (before_mps + after_mps) * 0.5;
        let by_m = mean_mps * kick_s;
        let from_m = state.elastic_m();
        let outward = self.flows_to(state, before_mps);
        state.deflection_m += by_m;
        let tried_m = state.elastic_m();
        let stored_j = |m: Vec2| 0.5 * self.stiffness_npm * m.length_squared();
        let limit_m = self.yield_n / self.stiffness_npm;
        let (to_m, taken_j) = match outward {
            // The force was the yield load throughout.
            Some(outward) => {
                let taken_j = self.yield_n * outward.dot(by_m);
                // The body is already back within the limit. The energy that the pile gave came from the spring.
                let least_m2 = limit_m * limit_m + 2.0 * taken_j / self.stiffness_npm;
                let length_m = lesser(limit_m, libm::sqrt(greater(least_m2, 0.0)));
                (tried_m * (length_m / tried_m.length()), taken_j)
            }
            None => {
                let length_m = tried_m.length();
                let is_beyond = length_m > limit_m;
                let to_m = if is_beyond { tried_m * (limit_m / length_m) } else { tried_m };
                (to_m, stored_j(tried_m) - stored_j(from_m))
            }
        };
        let damping_j = self.damping_nspm * mean_mps.length_squared() * kick_s;
        motion.work_j -= taken_j + damping_j;
        motion.damping_j += damping_j;
        if to_m != tried_m {
            state.offset_m = state.deflection_m - to_m;
            motion.yield_j += greater(taken_j - (stored_j(to_m) - stored_j(from_m)), 0.0);
        }
        motion.note(self, state, to_m);
    }
}

impl PileMotion {
    /// Begins the report on a pile at the start of a step.
    pub(crate) fn begin(pile: &Pile, state: &PileState) -> PileMotion {
        let mut motion = PileMotion::default();
        motion.note(pile, state, state.elastic_m());
        motion
    }

    fn note(&mut self, pile: &Pile, state: &PileState, elastic_m: Vec2) {
        self.deflection_m = state.deflection_m;
        self.offset_m = state.offset_m;
        self.force_n = elastic_m * -pile.stiffness_npm;
        self.stored_j = 0.5 * pile.stiffness_npm * elastic_m.length_squared();
        self.peak_deflection_m = greater(self.peak_deflection_m, state.deflection_m.length());
        self.peak_load_n = greater(self.peak_load_n, self.force_n.length());
        self.peak_stored_j = greater(self.peak_stored_j, self.stored_j);
    }
}
