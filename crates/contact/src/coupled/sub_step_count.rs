//! Computes the number of sub-steps that an island needs in a step. The number of sub-steps follows from bounds on the
//! natural frequencies of the island and on the travel of its bodies.

use alloc::vec::Vec;

use crate::broad::are_apart;
use crate::broad::bodies::Bodies;
use crate::broad::candidates::{Candidate, Candidates, Pairing};
use crate::coupled::dynamics::Dynamics;
use crate::coupled::island::Island;
use crate::geometry::clip::Hint;
use crate::geometry::gap::gap_m;
use crate::geometry::shapes::{Piece, near_pairs};
use crate::maths::number::{bounded, greater, lesser};
use crate::maths::vec2::{Pose, Vec2};
use crate::model::Model;
use crate::model::fender::{FenderBounds, RankedFender};
use crate::model::material::Material;
use crate::model::pair::{Bounds, InverseMassBound};
use crate::model::ranked::RankedBody;
use crate::model::reaction::FenderLaw;
use crate::overlap::patch::Patch;
use crate::panel::press::deepest_m;
use crate::state::memory::HintMemory;

/// Largest ωh, natural frequency times length, of a sub-step. The force of a contact that begins within a sub-step acts
/// late, by the length h of the sub-step at most. Because of this late force the depth of the contact is wrong by a
/// share of (ωh)²/2 at most: 0.5 % for this limit, and less because the bounds on ω are wide.
pub(crate) const TURN_PER_SUB_STEP: f64 = 0.1;

/// Largest ωh, natural frequency times length of the sub-step, for the springs of an existing contact. The sub-steps
/// are a leapfrog scheme: its oscillation on a linear spring has an amplitude error of (ωh)²/8 and a frequency error of
/// (ωh)²/24. For the limit ωh = 0.15 the amplitude error is 0.3 %, and the frequency error 0.1 %.
const TURN_IN_CONTACT: f64 = 0.15;

/// Weight of the ω² of an existing contact, relative to the ω² of a contact that may begin.
const EXISTING: f64 = (TURN_PER_SUB_STEP / TURN_IN_CONTACT) * (TURN_PER_SUB_STEP / TURN_IN_CONTACT);

/// Largest distance by which two bodies may approach each other in a sub-step, as a fraction of the thinner body's
/// half-width.
const TRAVEL_PER_SUB_STEP: f64 = 0.5;

/// Largest number of sub-steps in a step. This largest number of sub-steps bounds the work, whatever the host asks for.
pub(crate) const MOST_SUB_STEPS: u32 = 4096;

/// What the candidates of an island, its pairs of bodies that may touch, demand of the length of the sub-steps.
#[derive(Clone, Copy, Default)]
struct Demand {
    /// A bound on the largest ω² of the candidates' springs and dampers (1/s²): see [`Sums`].
    rate_squared: f64,
    /// The distance by which the bodies may approach each other in the step, divided by the largest travel in a
    /// sub-step.
    travel: f64,
}

/// For each floating body, by rank, the sum of ω² over its contacts (1/s²). The sums are used if islands have several
/// floating bodies.
///
/// The largest of the bodies' sums bounds the ω² of the whole island. For a contact of stiffness k and Jacobian j =
/// (j_a, j_b), k j jᵀ is at most the block diagonal of k (1 + w_b/w_a) j_a j_aᵀ and k (1 + w_a/w_b) j_b j_bᵀ, where w_a
/// and w_b are the inverse masses of the two bodies at the contact. In M^(−1/2) K M^(−1/2) the largest eigenvalue of a
/// body's block is at most the block's trace. Each contact of the body adds k (w_a + w_b) to this trace, which is the
/// contact's own ω². So a chain of a hundred barges needs no more sub-steps than a chain of three.
pub(crate) type Sums = Vec<f64>;

impl Demand {
    /// Adds the demand of one candidate to this demand, for an island with one floating body.
    #[inline(always)]
    fn add(&mut self, one: Demand) {
        self.travel = greater(self.travel, one.travel);
        self.rate_squared += one.rate_squared;
    }

    /// Does the same as [`Demand::add`] for an island that may have several floating bodies.
    fn add_joined(&mut self, one: Demand, candidate: &Candidate, model: &Model, sums: &mut Sums) {
        self.travel = greater(self.travel, one.travel);
        for rank in [candidate.a, candidate.b] {
            if !model.ranked[rank as usize].is_fixed() {
                let sum = &mut sums[rank as usize];
                *sum += one.rate_squared;
                self.rate_squared = greater(self.rate_squared, *sum);
            }
        }
    }

    /// Number of sub-steps. `turn` is the length of the step divided by [`TURN_PER_SUB_STEP`].
    #[inline(always)]
    fn sub_steps(self, turn: f64) -> u32 {
        if self.rate_squared * (turn * turn) <= 1.0 && self.travel <= 1.0 {
            return 1;
        }
        let needed = greater(libm::sqrt(self.rate_squared) * turn, self.travel);
        libm::ceil(bounded(needed, 1.0, f64::from(MOST_SUB_STEPS))) as u32
    }
}

/// The data from which the number of sub-steps is computed.
#[derive(Clone, Copy)]
pub(crate) struct Bounded<'w> {
    pub(crate) model: &'w Model,
    pub(crate) bodies: &'w Bodies,
    pub(crate) dynamics: &'w Dynamics,
    pub(crate) candidates: &'w Candidates,
    /// The hints for the clip of polygons, as the overlap at the start of the step has left them.
    pub(crate) hints: &'w [HintMemory],
    pub(crate) step_s: f64,
}

impl Bounded<'_> {
    /// Sets the number of sub-steps of each island, and the patches that each island has in the first overlap of the
    /// step.
    #[inline(never)]
    pub(crate) fn set_sub_steps(
        &self,
        patches: &[Patch],
        islands: &mut [Island],
        mut sums: Option<&mut Sums>,
    ) {
        let turn = self.step_s * (1.0 / TURN_PER_SUB_STEP);
        let mut left = patches;
        let mut from = 0;
        for island in &mut *islands {
            island.sub_steps = match self.slow(island, left, 1.0 / (turn * turn)) {
                Some(others) => {
                    left = others;
                    1
                }
                None => self.sub_steps(island, &mut left, turn, sums.as_deref_mut()),
            };
            let to = patches.len() - left.len();
            island.set_patches(from..to);
            from = to;
        }
        if !self.model.piles.is_empty() {
            self.add_piles(islands, turn);
        }
    }

    /// Raises the number of sub-steps to the number that bodies on piles need if they move or touch something.
    #[inline(never)]
    fn add_piles(&self, islands: &mut [Island], turn: f64) {
        for island in islands {
            let pairings = &self.candidates.pairings[island.candidates()];
            let is_quiet = island.sub_steps == 1 && island.patches_from(0).is_empty();
            let mut rate_squared = 0.0;
            for (pile, moving) in self.model.piles.iter().zip(&self.dynamics.piles) {
                let is_of = |pairing: &Pairing| {
                    [pairing.candidate.a, pairing.candidate.b].contains(&pile.rank)
                };
                if !(is_quiet && moving.is_still) && pairings.iter().any(is_of) {
                    rate_squared = greater(rate_squared, pile.rate_squared());
                }
            }
            if rate_squared > 0.0 {
                let others = f64::from(island.sub_steps) / turn;
                let others_squared = if island.sub_steps > 1 { others * others } else { 0.0 };
                let demand = Demand { rate_squared: rate_squared + others_squared, travel: 0.0 };
                island.sub_steps = demand.sub_steps(turn);
            }
        }
    }

    /// Tests whether the island is a single contact of two outlines, with an ω² of at most `share` (the ω² that one
    /// sub-step allows, 1/s²), whose bodies approach by no more than one sub-step allows. If the test is passed,
    /// returns the patches of the islands after this island. An island that passes the test needs no sums over
    /// candidates: this saves 2.5 % of a step of the benchmark `pairs-1000`.
    #[inline(always)]
    fn slow<'p>(&self, island: &Island, left: &'p [Patch], share: f64) -> Option<&'p [Patch]> {
        let [Pairing { candidate, pair, .. }] = &self.candidates.pairings[island.candidates()]
        else {
            return None;
        };
        let (only, others) = left.split_first()?;
        let is_alone = only.of as usize == island.candidates().start
            && others.first().is_none_or(|other| other.of != only.of);
        if candidate.face != 0 || !is_alone {
            return None;
        }
        let bounds = self.candidates.bounds_of(self.model, *pair);
        let is_slow = self.existing_rate_squared(candidate, bounds, only, share) <= share
            && !self.may_travel(candidate, bounds);
        is_slow.then_some(others)
    }

    /// Computes the number of sub-steps of an island. Removes the patches of the island from the front of the list of
    /// patches.
    #[inline(never)]
    fn sub_steps(
        &self,
        island: &Island,
        left: &mut &[Patch],
        turn: f64,
        sums: Option<&mut Sums>,
    ) -> u32 {
        let pairings = &self.candidates.pairings[island.candidates()];
        // The share of ω² of each candidate that needs no further sub-step.
        let share = 1.0 / (turn * turn * f64::from(pairings.len() as u32));
        let candidates = (island.candidates().start..).zip(pairings);
        let mut demand = Demand::default();
        // Two loops. For a ship on fenders the first loop skips what only islands of several floating bodies need.
        let Some(sums) = sums else {
            let all = *left;
            let mut is_bound = false;
            for (index, pairing) in candidates.clone() {
                let own = patches_of(left, index);
                let (one, is_bound_of_one) = self.demand_at_most(pairing, own, share);
                demand.add(one);
                is_bound |= is_bound_of_one;
            }
            let count = demand.sub_steps(turn);
            if count == 1 || !is_bound {
                return count;
            }
            (*left, demand) = (all, Demand::default());
            for (index, pairing) in candidates {
                demand.add(self.demand_of(pairing, patches_of(left, index), share));
            }
            return demand.sub_steps(turn);
        };
        for (index, pairing) in candidates {
            let one = self.demand_of_joined(pairing, patches_of(left, index), share);
            demand.add_joined(one, &pairing.candidate, self.model, sums);
        }
        for Pairing { candidate, .. } in pairings {
            (sums[candidate.a as usize], sums[candidate.b as usize]) = (0.0, 0.0);
        }
        demand.sub_steps(turn)
    }

    /// Returns the demand of a candidate with these patches, and false; or a bound on this demand, and true. If a
    /// fender is not touched, the bound saves the computation of the gap to the hull: a quarter of the time of a step
    /// of a ship before eight fenders.
    #[inline(always)]
    fn demand_at_most(&self, pairing: &Pairing, own: &[Patch], share: f64) -> (Demand, bool) {
        let Pairing { candidate, .. } = pairing;
        if own.is_empty()
            && let Some(face) = candidate.fender(self.model)
            && face.panel.is_none()
        {
            let bound = self.demand_of_face(own, candidate, face, 1.0);
            if bound.rate_squared <= share && bound.travel <= 1.0 {
                return (bound, true);
            }
        }
        (self.demand_of(pairing, own, share), false)
    }

    /// Does the same as [`Bounded::demand_of`], but the compiler does not inline this function.
    #[inline(never)]
    fn demand_of_joined(&self, pairing: &Pairing, own: &[Patch], share: f64) -> Demand {
        self.demand_of(pairing, own, share)
    }

    /// Computes the demand of a candidate whose patches of contact are `own`.
    #[inline(always)]
    fn demand_of(&self, pairing: &Pairing, own: &[Patch], share: f64) -> Demand {
        let Pairing { candidate, pair, .. } = pairing;
        match (own, candidate.fender(self.model)) {
            ([only], None) => {
                let bounds = self.candidates.bounds_of(self.model, *pair);
                let rate_squared = self.existing_rate_squared(candidate, bounds, only, share);
                let travel = if self.may_travel(candidate, bounds) {
                    self.travel(candidate, bounds)
                } else {
                    0.0
                };
                Demand { rate_squared, travel }
            }
            ([only], Some(face)) => match self.slow_rate_squared(candidate, face, only, share) {
                Some(rate_squared) => Demand { rate_squared, travel: 0.0 },
                None => self.demand_of_other(pairing, own),
            },
            _ => self.demand_of_other(pairing, own),
        }
    }

    /// A bound on the ω² of an existing contact of two outlines in one patch (1/s²). A contact whose ω² is at most
    /// `share`, the ω² that one sub-step allows, needs no more than one sub-step.
    #[inline(always)]
    fn existing_rate_squared(
        &self,
        candidate: &Candidate,
        bounds: &Bounds,
        only: &Patch,
        share: f64,
    ) -> f64 {
        let (spring, damping) =
            (EXISTING * bounds.spring_rate_squared, bounds.damping_rate_squared);
        // Tighter bounds are computed only if the pair's bound is too large: first a bound by the patch's lever, then
        // one by its chord.
        if spring + damping <= share || only.per_chord_m <= 0.0 {
            return spring + damping;
        }
        let [normal, ..] = inverse_masses(bounds, only, bounds.half_chord_m);
        let felt = normal / bounds.inverse_mass;
        let by_lever = (spring + damping * felt) * felt;
        if by_lever <= share {
            return by_lever;
        }
        let closing_m = self.closing_mps(candidate) * self.step_s;
        let material = &self.model.materials()[candidate.material.0 as usize];
        lesser(rate_squared_of_patch(bounds, material, only, closing_m), by_lever)
    }

    /// Returns true if two outlines may approach each other by more than the largest travel of a sub-step.
    #[inline(always)]
    fn may_travel(&self, candidate: &Candidate, bounds: &Bounds) -> bool {
        self.fastest_m(candidate) > TRAVEL_PER_SUB_STEP * bounds.half_width_m
    }

    /// Computes the demand of any other candidate: of a fender, or of two outlines that do not touch or touch in
    /// several patches.
    #[inline(never)]
    fn demand_of_other(&self, pairing: &Pairing, own: &[Patch]) -> Demand {
        let model = self.model;
        let Pairing { candidate, pair, .. } = pairing;
        if own.is_empty() && !self.may_touch(candidate) {
            return Demand::default();
        }
        let counts = if own.is_empty() { 1.0 } else { EXISTING };
        if let Some(face) = candidate.fender(model) {
            return self.demand_of_face(own, candidate, face, counts);
        }
        let bounds = self.candidates.bounds_of(model, *pair);
        Demand {
            rate_squared: counts * bounds.spring_rate_squared + bounds.damping_rate_squared,
            travel: self.travel(candidate, bounds),
        }
    }

    /// Computes the demand of a fender and a hull that touches the fender or may touch it. `counts` is the weight of
    /// the ω² of the fender's spring in the demand: see [`EXISTING`].
    #[inline(never)]
    fn demand_of_face(
        &self,
        own: &[Patch],
        candidate: &Candidate,
        face: &RankedFender,
        counts: f64,
    ) -> Demand {
        let closing_m = self.closing_mps(candidate) * self.step_s;
        let fender = &self.model.fenders()[face.id.0 as usize];
        let (spring, damper) = self.rates_squared_of_face(own, candidate, face, closing_m);
        Demand {
            rate_squared: counts * spring + damper,
            travel: closing_m / (TRAVEL_PER_SUB_STEP * 0.5 * fender.projection_m),
        }
    }

    /// The distance by which two outlines may approach each other in the step, divided by the largest travel of a
    /// sub-step.
    #[cold]
    fn travel(&self, candidate: &Candidate, bounds: &Bounds) -> f64 {
        self.closing_mps(candidate) * self.step_s / (TRAVEL_PER_SUB_STEP * bounds.half_width_m)
    }

    /// A bound on the ω² of a fender that touches a hull in one patch (1/s²). Returns `None` if the bound exceeds
    /// `share`, if the fender may reach its stop in this step, or if the bodies may approach by more than one sub-step
    /// allows.
    #[inline(always)]
    fn slow_rate_squared(
        &self,
        candidate: &Candidate,
        face: &RankedFender,
        only: &Patch,
        share: f64,
    ) -> Option<f64> {
        if face.panel.is_some() {
            return None;
        }
        let (a, b) = (candidate.a as usize, candidate.b as usize);
        let FenderBounds { spring_npm, stop_from_m, damping_nspm, projection_m, arm_m, spread_m } =
            face.bounds;
        let closing_m = self.fastest_m(candidate);
        if closing_m > TRAVEL_PER_SUB_STEP * 0.5 * projection_m
            || only.area_m2 > (stop_from_m - closing_m) * face.width_m
        {
            return None;
        }
        // Some point of the other body lies in the fender's zone, or may come into it.
        let (host, other) = if face.host == candidate.a { (a, b) } else { (b, a) };
        let (host, other) = (&self.model.ranked[host], &self.model.ranked[other]);
        let of_body = |body: &RankedBody, arm_m: f64| {
            body.lightest_inverse_mass + body.inverse_of_turning * arm_m * arm_m
        };
        let inverse_mass =
            of_body(host, arm_m) + of_body(other, other.radius_m + spread_m + closing_m);
        let damping_rate = damping_nspm * inverse_mass;
        let rate_squared = EXISTING * spring_npm * inverse_mass + damping_rate * damping_rate;
        (rate_squared <= share).then_some(rate_squared)
    }

    /// Bounds on the ω² of the contact of a fender and its hull (1/s²). The first bound is for spring and stop, for all
    /// deflections that this step can reach; the second bound is for the damper.
    #[inline(never)]
    fn rates_squared_of_face(
        &self,
        own: &[Patch],
        candidate: &Candidate,
        face: &RankedFender,
        closing_m: f64,
    ) -> (f64, f64) {
        let fender = &self.model.fenders()[face.id.0 as usize];
        let material = &self.model.materials()[face.material.0 as usize];
        let area_m2: f64 = own.iter().map(|patch| patch.area_m2).sum();
        // A fender with a panel: the bound takes all cones together, at the place of the outermost.
        let (deflection_m, cones, reach_m) = match &face.panel {
            None => (area_m2 / face.width_m + closing_m, 1.0, 0.0),
            Some(law) => {
                let deepest_m = self.deepest_m(candidate, face);
                (deepest_m + closing_m, law.places_m.len() as f64, law.reach_m)
            }
        };
        let spring_npm = match fender.law {
            FenderLaw::Area => material.stiffness_npm2 * face.width_m,
            FenderLaw::Curve(_) => cones * fender.law.steepest_npm(deflection_m),
        };
        let stop_npm = match fender.stop {
            Some(stop) if deflection_m > stop.from_m => cones * stop.stiffness_npm,
            _ => 0.0,
        };
        let face_m = self.bodies.poses[face.host as usize].apply(face.face_m);
        let inverse_mass: f64 = [candidate.a, candidate.b]
            .map(|rank| {
                let arm_m = face_m - self.bodies.poses[rank as usize].position_m;
                let body = &self.model.ranked[rank as usize];
                let of_panel_m2 = reach_m * (2.0 * arm_m.length() + reach_m);
                body.lightest_inverse_mass
                    + body.inverse_of_turning * (arm_m.length_squared() + of_panel_m2)
            })
            .iter()
            .sum();
        let damping_rate = material.damping_nspm2 * face.width_m * inverse_mass;
        let spring = (spring_npm + stop_npm) * face.largest_factor * inverse_mass;
        (spring, damping_rate * damping_rate)
    }

    /// Depth of the deepest point of a hull behind the face of a panel (m).
    #[inline(never)]
    fn deepest_m(&self, candidate: &Candidate, face: &RankedFender) -> f64 {
        let model = self.model;
        let hull = if face.host == candidate.a { candidate.b } else { candidate.a };
        let edges = model.edges_met(candidate.face, hull);
        let poses = &self.bodies.poses;
        // Computed relative to the host, so that no digits are lost far from the origin.
        let hull_in_host = poses[face.host as usize].to(poses[hull as usize]);
        let to_face = face.hull_to_face(Pose::IDENTITY, hull_in_host);
        deepest_m(edges, to_face, face.panel_reach())
    }

    /// Returns true if the bodies of the candidate could touch in this step. The test whether bodies could touch
    /// compares bounding boxes first, and then the gaps between convex pieces.
    #[inline(never)]
    fn may_touch(&self, candidate: &Candidate) -> bool {
        if are_apart(self.model, self.bodies, candidate) {
            return false;
        }
        let hints = self.hints;
        let (a, b) = (candidate.a as usize, candidate.b as usize);
        let b_in_a = self.bodies.poses[a].to(self.bodies.poses[b]);
        let reach_m = self.closing_mps(candidate) * self.step_s;
        let is_near = |[(piece_a, shape_a), (piece_b, shape_b)]: [Piece<'_>; 2]| {
            let key = (candidate.a, candidate.b, candidate.face, piece_a, piece_b);
            let hint = match hints.binary_search_by_key(&key, HintMemory::key) {
                Ok(index) => hints[index].hint,
                Err(_) => Hint::None,
            };
            gap_m(shape_a, shape_b, b_in_a, hint) <= reach_m
        };
        let [of_a, of_b] = self.model.shapes_of(candidate);
        match (of_a.pieces, of_b.pieces) {
            ([a], [b]) => is_near([(0, a), (0, b)]),
            _ => near_pairs(of_a, of_b, b_in_a, reach_m).any(is_near),
        }
    }

    /// A bound on the speed at which any two points of the candidate's bodies approach each other in this step (m/s).
    fn closing_mps(&self, candidate: &Candidate) -> f64 {
        let (a, b) = (candidate.a as usize, candidate.b as usize);
        let apart =
            (self.bodies.input[a].velocity_mps - self.bodies.input[b].velocity_mps).length();
        apart + self.dynamics.speed_bounds[a].room_mps + self.dynamics.speed_bounds[b].room_mps
    }

    /// A bound on the distance by which the bodies approach each other in this step (m). This bound on the distance is
    /// cheaper to compute than a bound by `closing_mps`, and larger.
    #[inline(always)]
    fn fastest_m(&self, candidate: &Candidate) -> f64 {
        let [a, b] = [candidate.a, candidate.b]
            .map(|rank| self.dynamics.speed_bounds[rank as usize].fastest_mps);
        (a + b) * self.step_s
    }
}

/// Bounds on the ω² of a contact of two outlines in one patch while the bodies approach by `closing_m` (1/s²): one for
/// the spring along the normal together with the shear spring, and one for the damper. The other, larger bounds on this
/// ω², from the longest chord that the pair can have, leave the shear spring out; so far no test has needed the shear
/// spring in those bounds.
fn rate_squared_of_patch(
    bounds: &Bounds,
    material: &Material,
    patch: &Patch,
    closing_m: f64,
) -> f64 {
    let half_chord_m = half_chord_m(bounds, patch, closing_m);
    let chord_m = 2.0 * half_chord_m;
    let [normal, tangential, cross] = inverse_masses(bounds, patch, half_chord_m);
    let (spring_npm, shear_npm) = (material.stiffness_npm2 * chord_m, material.shear_stiffness_npm);
    // The larger eigenvalue of the two springs.
    let (along, across) = (spring_npm * normal, shear_npm * tangential);
    let (mean, half) = (0.5 * (along + across), 0.5 * (along - across));
    let larger = mean + libm::sqrt(half * half + spring_npm * shear_npm * (cross * cross));
    let damping_rate = material.damping_nspm2 * chord_m * normal;
    EXISTING * larger + damping_rate * damping_rate
}

/// A bound on half the length of a patch's chord while the bodies approach by `closing_m` (m), at most the bound of the
/// pair.
///
/// The chord c of a patch is the derivative of its area A along the normal. For convex outlines √A is a concave
/// function of the depth (Brunn and Minkowski), so an approach by the distance δ makes the chord at most c (1 + δ
/// c/(2A)). The chord of a corner grows exactly as fast as the bound c (1 + δ c/(2A)). The bound on the chord is exact
/// if the bodies move along the normal; if a body turns, the distance δ is that of the points that move most.
#[inline(always)]
fn half_chord_m(bounds: &Bounds, patch: &Patch, closing_m: f64) -> f64 {
    let half_m = 0.5 * patch.chord_m.length_squared() * patch.per_chord_m;
    let grown_m = half_m + half_m * (closing_m * half_m / patch.area_m2);
    lesser(grown_m, bounds.half_chord_m)
}

/// Removes the patches of the candidate with the number `index` from the front of `patches`, and returns them.
#[inline(always)]
fn patches_of<'p>(patches: &mut &'p [Patch], index: usize) -> &'p [Patch] {
    let is_own = |patch: &&Patch| patch.of as usize == index;
    let count = match patches {
        [first, others @ ..] if is_own(&first) => 1 + others.iter().take_while(is_own).count(),
        _ => 0,
    };
    let (own, rest) = patches.split_at(count);
    *patches = rest;
    own
}

/// Bounds on the inverse effective mass of a contact (1/kg): along the normal, along the chord, and the coupling of the
/// two directions.
///
/// Along the normal, the bound is twice the inverse mass without rotation, which allows for a contact off the centre.
/// The lever of the contact may show that rotation adds less. The patch lies on the chord, so the place of the patch
/// varies by at most half the chord. The patch also lies within the smaller body, so it is no farther from that body's
/// centre of gravity than the body reaches.
#[inline(always)]
fn inverse_masses(bounds: &Bounds, patch: &Patch, half_chord_m: f64) -> [f64; 3] {
    let chord = patch.chord_m * patch.per_chord_m;
    // Places of the patch and of B's centre of gravity relative to A's centre of gravity, along the chord and along the
    // normal.
    let by_chord = |place_m: Vec2| (place_m.dot(chord), place_m.cross(chord));
    let (along_m, across_m) = by_chord(patch.centroid_m);
    let (b_along_m, b_across_m) = by_chord(patch.b_in_a.position_m);
    let smaller_m = b_along_m * bounds.b_is_smaller;
    let [a, b] = &bounds.bodies;
    // The bounds of a fixed body are zero.
    let of_a =
        inverse_masses_of(a, lesser(along_m.abs(), smaller_m.abs()) + half_chord_m, across_m);
    let b_lever_m = lesser((along_m - b_along_m).abs(), (smaller_m - b_along_m).abs());
    let of_b = inverse_masses_of(b, b_lever_m + half_chord_m, across_m - b_across_m);
    core::array::from_fn(|part| of_a[part] + of_b[part])
}

/// The bounds on the inverse effective mass for one body, from the levers of forces along the normal and along the
/// chord (m).
#[inline(always)]
fn inverse_masses_of(body: &InverseMassBound, normal_m: f64, chord_m: f64) -> [f64; 3] {
    let linear = body.lightest_inverse_mass;
    let (chord_m, turn_n) = (chord_m.abs(), body.of_yaw * normal_m);
    let turn_t = body.of_yaw * chord_m;
    [linear + lesser(turn_n * normal_m, linear), linear + turn_t * chord_m, turn_n * chord_m]
}
