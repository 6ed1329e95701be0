//! Piles that hold bodies to their places: the law of one pile, and how it takes a step.
//!
//! With e the elastic deflection, the pile's force on its body is −K e − C v, as long as K |e| is at most the yield load.
//! Beyond it the pile yields: the deflection grows at the yield load, and what was plastic stays.
//!
//! A step of length κ takes both implicitly by the midpoint rule, which is stable for any κ and adds no energy:
//!
//! m (v⁺ − v) = κ (F − K (e + κ v̄ / 2) − C v̄), v̄ = (v + v⁺)/2, e⁺ = e + κ v̄.
//!
//! So for any force F on the body, v⁺ = v + κ (F − K (e + κ v / 2) − C v)/m′ with m′ = m + κ² K / 4 + κ C / 2. The period is
//! too long by (ωκ)²/12 of itself. Where K |e⁺| exceeds the yield load, e⁺ returns to it along its radius, and the energy
//! between the two is lost: that is never negative. From then on the force is the yield load, as long as the body moves
//! outward.

use crate::number::{greater, lesser};
use crate::vec2::Vec2;

/// A load nearer to the yield load than this share of it is at it.
const AT_LIMIT: f64 = 1e-9;

/// A pile, or a group of piles, that holds a body to its place: a spring with damping and a yield load, the same in all
/// horizontal directions. It does not let the body turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pile {
    /// Where the body stands without load, north and east (m).
    pub place_m: Vec2,
    /// Stiffness at the height of the load (N/m).
    pub stiffness_npm: f64,
    /// Damping (N·s/m).
    pub damping_nspm: f64,
    /// The load at which the pile yields (N); infinite for one that does not.
    pub yield_n: f64,
}

/// What a pile did in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PileMotion {
    /// Deflection at the end of the step, the permanent part included (m).
    pub deflection_m: Vec2,
    /// The permanent part (m).
    pub offset_m: Vec2,
    /// The spring's force on the body at the end of the step (N).
    pub force_n: Vec2,
    /// Largest deflection in the step (m).
    pub peak_deflection_m: f64,
    /// Largest load on the spring in the step (N).
    pub peak_load_n: f64,
    /// Energy in the spring at the end of the step (J), and the largest in the step.
    pub stored_j: f64,
    /// The largest in the step (J).
    pub peak_stored_j: f64,
    /// Work of the pile on its body in the step (J): less the change of `stored_j`, less `damping_j` and `yield_j`.
    pub work_j: f64,
    /// Energy lost to damping in the step (J).
    pub damping_j: f64,
    /// Energy lost to yielding in the step (J).
    pub yield_j: f64,
}

/// The state of a pile: deflections at the time of its body's velocity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PileState {
    /// Deflection (m).
    pub(crate) deflection_m: Vec2,
    /// Its permanent part (m).
    pub(crate) offset_m: Vec2,
}

impl PileState {
    pub(crate) fn elastic_m(&self) -> Vec2 {
        self.deflection_m - self.offset_m
    }
}

impl Pile {
    /// The direction in which it yields, if it does at the start of a step: at the yield load, and the body moves on.
    fn flows_to(&self, state: &PileState, velocity_mps: Vec2) -> Option<Vec2> {
        let elastic_m = state.elastic_m();
        let length_m = elastic_m.length();
        let is_at_limit = self.stiffness_npm * length_m >= self.yield_n * (1.0 - AT_LIMIT);
        let flows = is_at_limit && elastic_m.dot(velocity_mps) > 0.0;
        flows.then(|| elastic_m * (1.0 / length_m))
    }

    /// m′, and the force of the pile at the start of a step of κ, to be applied to it (kg, N).
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

    /// The state after a step of κ in which the body's velocity went from one to the other, and what the pile did.
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
            // The force was that of the limit throughout.
            Some(outward) => {
                let taken_j = self.yield_n * outward.dot(by_m);
                // Back already: what it gave came from the spring.
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
    /// At the start of a step.
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
