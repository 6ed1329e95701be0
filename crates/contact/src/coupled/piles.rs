//! Bodies on piles in the coupled method.
//!
//! A sub-step treats a body on a pile as any other body, but with the mass m′ and with the pile's force in v_free: see
//! [`crate::model::pile`]. The pile's deflection is kept for the time to which the velocity belongs, so that the midpoint rule
//! holds to the last bit. The position of a body on a pile follows from the pile's deflection and the body's velocity.

use crate::broad::bodies::{Bodies, Displaced};
use crate::coupled::dynamics::{Dynamics, HostInput};
use crate::coupled::island::Group;
use crate::coupled::motion::{SpeedBound, kick_s};
use crate::coupled::moving_pile::MovingPile;
use crate::coupled::sub_step::SubStep;
use crate::coupled::sub_step_count::MOST_SUB_STEPS;
use crate::maths::number::{bounded, greater, lesser};
use crate::maths::vec2::Vec2;
use crate::model::Model;
use crate::model::mass::InverseMatrix;
use crate::model::pile::{PileMotion, PileState};
use crate::state::memory::Memory;
use crate::state::report::{Displacement, Wrench};
use crate::state::results::Results;

/// Largest ωh, natural frequency times sub-step, of a body on a pile that touches nothing. At this value of ωh the
/// relative error of the pile's period is 3e-5.
const TURN_WHEN_FREE: f64 = 0.02;

/// Least swing of a pile (m): a pile with a smaller swing counts as still.
const STILL_M: f64 = 1e-9;

impl Dynamics {
    /// Begins the reports on the piles for this step.
    #[inline(never)]
    pub(crate) fn begin_pile_motions(&self, model: &Model, results: &mut Results) {
        let both = model.piles.iter().zip(&self.piles);
        results.piles.clear();
        results.piles.extend(both.map(|(of, moving)| PileMotion::begin(&of.pile, &moving.state)));
    }

    /// Stores the permanent deflections of the piles for the next step.
    pub(crate) fn store_offsets(&self, memory: &mut Memory) {
        memory.pile_offsets_m.clear();
        memory.pile_offsets_m.extend(self.piles.iter().map(|moving| moving.state.offset_m));
    }

    /// Stage 1 for bodies on piles, after stage 1 for all bodies: places the piles, and bounds their speeds.
    #[inline(never)]
    pub(crate) fn begin_piles(
        &mut self,
        model: &Model,
        memory: &Memory,
        input: &HostInput<'_>,
        bodies: &mut Bodies,
        displaced: &mut Displaced,
    ) {
        self.piles.clear();
        for (index, ranked) in model.piles.iter().enumerate() {
            let (rank, pile) = (ranked.rank as usize, &ranked.pile);
            let (state, load) = (self.states[rank], &input.loads[model.id_of[rank].0 as usize]);
            // A swinging body may end a long step anywhere, so only the host's mark shows a teleport.
            if memory.placed.binary_search(&ranked.rank).is_err() {
                displaced.forget(ranked.rank);
                self.velocity_lags_s[rank] = memory.behind_s.get(rank).copied().unwrap_or(0.0);
            }
            let lag_s = self.velocity_lags_s[rank];
            let deflection_m =
                state.position_m - pile.place_m - state.velocity_mps * greater(lag_s, 0.0);
            let offset_m = memory.pile_offsets_m.get(index).copied().unwrap_or(Vec2::ZERO);
            let own = PileState { deflection_m, offset_m };
            let rate_radps = ranked.rate_radps();
            let speed_mps = state.velocity_mps.length();
            let swing_m = own.elastic_m().length()
                + speed_mps / rate_radps
                + load.force_n.length() / pile.stiffness_npm;
            let fastest_mps = lesser(swing_m * rate_radps, 2.0 * swing_m / input.step_s);
            self.speed_bounds[rank] = SpeedBound {
                fastest_mps: greater(fastest_mps, speed_mps),
                room_mps: fastest_mps + speed_mps,
            };
            let body = &model.ranked[rank];
            bodies.reach_m[rank] = body.reach_m + greater(fastest_mps, speed_mps) * input.step_s;
            self.piles.push(MovingPile {
                state: own,
                is_still: swing_m <= STILL_M,
                before_mps: state.velocity_mps,
                kick_s: 0.0,
            });
            self.free_pile(model, index, load, input.step_s);
        }
    }

    /// Computes the velocity v_free without contact and the inverse mass M⁻¹ of a body on a pile for a sub-step of
    /// length h.
    fn free_pile(&mut self, model: &Model, index: usize, load: &Wrench, h: f64) {
        let ranked = &model.piles[index];
        let (rank, pile, moving) = (ranked.rank as usize, &ranked.pile, &mut self.piles[index]);
        let state = &mut self.states[rank];
        state.yaw_rate_radps = 0.0;
        moving.kick_s = kick_s(self.velocity_lags_s[rank], h);
        moving.before_mps = state.velocity_mps;
        let (mass_kg, pile_n) =
            pile.begin(&moving.state, ranked.mass_kg, moving.before_mps, moving.kick_s);
        let per_kg = 1.0 / mass_kg;
        let gain_mps = (load.force_n + pile_n) * (moving.kick_s * per_kg);
        self.inverses[rank] = InverseMatrix::unturnable(per_kg);
        self.velocities[rank] = (moving.before_mps + gain_mps, 0.0);
    }

    /// Begins a sub-step of the piles of a group, after [`Dynamics::begin_sub_step`] for all bodies.
    #[inline(never)]
    pub(crate) fn begin_pile_sub_step(
        &mut self,
        model: &Model,
        loads: &[Wrench],
        group: &Group,
        sub_step: SubStep,
    ) {
        for (index, ranked) in model.piles.iter().enumerate() {
            if group.bodies.binary_search(&ranked.rank).is_ok() {
                let load = &loads[model.id_of[ranked.rank as usize].0 as usize];
                self.free_pile(model, index, load, sub_step.h);
            }
        }
    }

    /// Ends a sub-step of the piles of a group, after [`Dynamics::advance_positions`] for all bodies.
    #[inline(never)]
    pub(crate) fn advance_piles(
        &mut self,
        model: &Model,
        group: &Group,
        bodies: &mut Bodies,
        results: &mut Results,
        sub_step: SubStep,
    ) {
        for (index, ranked) in model.piles.iter().enumerate() {
            if group.bodies.binary_search(&ranked.rank).is_err() {
                continue;
            }
            let (rank, moving) = (ranked.rank as usize, &mut self.piles[index]);
            let after_mps = self.velocities[rank].0;
            let motion = &mut results.piles[index];
            let speeds = (moving.before_mps, after_mps);
            ranked.pile.advance(&mut moving.state, motion, speeds, moving.kick_s);
            let lead_m = after_mps * (0.5 * sub_step.h);
            let place_m = ranked.pile.place_m;
            self.states[rank].position_m = place_m + moving.state.deflection_m + lead_m;
            bodies.poses[rank] = self.states[rank].pose();
            results.states_after[model.id_of[rank].0 as usize] = self.states[rank];
        }
    }

    /// Moves the bodies on piles that no island contains, after [`Dynamics::drift`] for all bodies.
    ///
    /// The sub-steps of the piles begin at the time to which the velocity belongs, and all have the same length. With
    /// sub-steps of one length, a long step before the present step costs no accuracy.
    #[inline(never)]
    pub(crate) fn drift_piles(
        &mut self,
        model: &Model,
        loads: &[Wrench],
        bodies: &Bodies,
        step_s: f64,
        results: &mut Results,
    ) {
        for (index, ranked) in model.piles.iter().enumerate() {
            let rank = ranked.rank as usize;
            if self.roles[rank].in_island {
                continue;
            }
            let (pile, id) = (&ranked.pile, model.id_of[rank].0 as usize);
            let (moving, load) = (&mut self.piles[index], &loads[id]);
            let input = bodies.input[rank];
            let turn = ranked.rate_radps() * step_s * (1.0 / TURN_WHEN_FREE);
            let most = f64::from(MOST_SUB_STEPS);
            let count = if moving.is_still { 1.0 } else { libm::ceil(bounded(turn, 1.0, most)) };
            let lead_s = 0.5 * step_s / count;
            // `begin_piles` set κ for the whole step: the lag of the velocity plus half the step.
            let kick_s = (moving.kick_s + 0.5 * step_s - lead_s) / count;
            let mut velocity_mps = input.velocity_mps;
            let from_m = moving.state.deflection_m;
            for _ in 0..count as u32 {
                let (mass_kg, pile_n) =
                    pile.begin(&moving.state, ranked.mass_kg, velocity_mps, kick_s);
                let after_mps = velocity_mps + (load.force_n + pile_n) * (kick_s / mass_kg);
                let speeds = (velocity_mps, after_mps);
                pile.advance(&mut moving.state, &mut results.piles[index], speeds, kick_s);
                velocity_mps = after_mps;
            }
            let state = &mut self.states[rank];
            *state = input;
            state.velocity_mps = velocity_mps;
            state.yaw_rate_radps = 0.0;
            state.position_m = pile.place_m + moving.state.deflection_m + velocity_mps * lead_s;
            self.velocity_lags_s[rank] = lead_s;
            results.displacements[id] = Displacement {
                translation_m: moving.state.deflection_m - from_m,
                rotation_rad: 0.0,
            };
            results.states_after[id] = *state;
        }
    }
}
