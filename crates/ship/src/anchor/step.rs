//! One time step of an anchor: windlass, chain, bottom.

use fenderline_contact::Vec2;
use fenderline_contact::number::{greater, lesser};

use super::gear::AnchorGear;
use super::ground::{Ground, Pull};
use super::state::{
    AnchorEvent, AnchorLoad, AnchorPosition, AnchorState, Hawse, LostBy, WindlassOrder,
};

/// What a step of an anchor needs beside the place of the hawse pipe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnchorStep {
    /// Tension of the chain at the hawse pipe in the last step (N).
    pub last_n: f64,
    /// Density of the water (kg/m³).
    pub water_kgpm3: f64,
    /// Length of the step (s).
    pub step_s: f64,
}

impl AnchorGear {
    /// Takes one step of an anchor: the windlass carries out its order for `step_s`, then chain and anchor give the
    /// force on the ship. `last_n` is the chain's tension in the last step, against which the windlass heaves. Events
    /// of the anchor are passed to `tell`.
    ///
    /// If the pull is too strong, the anchor drags towards the hawse pipe until it holds the pull. If the tension of
    /// the chain is still above the limit of the brake, the brake renders (the chain slips out).
    pub fn step(
        &self,
        state: &mut AnchorState,
        hawse: &Hawse,
        AnchorStep { last_n, water_kgpm3, step_s }: AnchorStep,
        tell: &mut impl FnMut(AnchorEvent),
    ) -> AnchorLoad {
        if state.is_lost() {
            return AnchorLoad::default();
        }
        let before = *state;
        self.run_windlass(state, last_n, step_s);
        if state.position == AnchorPosition::Housed {
            if state.chain_m <= 0.0 {
                return AnchorLoad::default();
            }
            state.position = AnchorPosition::Hanging;
        }
        if state.chain_m <= 0.0 {
            let AnchorState { dragged_j, faults, .. } = *state;
            *state = AnchorState { dragged_j, faults, ..AnchorState::housed() };
            tell(AnchorEvent::Home);
            return AnchorLoad::default();
        }
        let (chain_npm, anchor_n) =
            (self.chain_weight_npm(water_kgpm3), self.anchor_weight_in_water_n(water_kgpm3));
        let ground = hawse.above_bottom_m.map(|rise_m| Ground {
            gear: self,
            rise_m: greater(rise_m, 0.1),
            chain_npm,
            anchor_n,
        });
        let of_bottom = ground.filter(|ground| state.chain_m >= ground.rise_m);
        match (of_bottom, state.position) {
            (Some(ground), AnchorPosition::OnBottom(place_m)) => {
                self.hold(state, place_m, hawse.at_m, &ground, &before, tell)
            }
            (Some(ground), _) => {
                state.position = AnchorPosition::OnBottom(hawse.at_m);
                state.dragged_m = 0.0;
                tell(AnchorEvent::OnBottom);
                self.hold(state, hawse.at_m, hawse.at_m, &ground, &before, tell)
            }
            (None, was) => {
                if matches!(was, AnchorPosition::OnBottom(_)) {
                    tell(AnchorEvent::Aweigh);
                }
                state.position = AnchorPosition::Hanging;
                (state.dragging, state.rendering) = (false, false);
                let tension_n = anchor_n + chain_npm * state.chain_m;
                self.hang(state, tension_n, &before, tell)
            }
        }
    }

    /// Moves the chain by the order to the windlass.
    fn run_windlass(&self, state: &mut AnchorState, last_n: f64, step_s: f64) {
        let windlass = &self.windlass;
        let has_power = !state.faults.windlass_failed;
        let paid_out = |chain_m: f64, to_m: f64, rate_mps: f64| {
            let to_m = lesser(to_m, self.chain_length_m);
            greater(lesser(chain_m + rate_mps * step_s, to_m), chain_m)
        };
        let (chain_m, is_done) = match state.order {
            WindlassOrder::Hold => return,
            WindlassOrder::LetGo(to_m) => {
                let chain_m = paid_out(state.chain_m, to_m, windlass.let_go_mps);
                (chain_m, chain_m >= lesser(to_m, self.chain_length_m))
            }
            WindlassOrder::Veer(to_m) if has_power => {
                let chain_m = paid_out(state.chain_m, to_m, windlass.heave_mps);
                (chain_m, chain_m >= lesser(to_m, self.chain_length_m))
            }
            WindlassOrder::Heave(to_m) if has_power => {
                let hove_m = windlass.heaving_mps(last_n) * step_s;
                let chain_m = lesser(greater(state.chain_m - hove_m, to_m), state.chain_m);
                (chain_m, chain_m <= to_m)
            }
            WindlassOrder::Veer(_) | WindlassOrder::Heave(_) => return,
        };
        state.chain_m = chain_m;
        if is_done {
            state.order = WindlassOrder::Hold;
        }
    }

    /// Takes a step of an anchor that hangs on its chain.
    fn hang(
        &self,
        state: &mut AnchorState,
        tension_n: f64,
        before: &AnchorState,
        tell: &mut impl FnMut(AnchorEvent),
    ) -> AnchorLoad {
        let mut load =
            AnchorLoad { tension_n, on_ship_n: [0.0, 0.0, -tension_n], ..AnchorLoad::default() };
        if state.chain_m < before.chain_m && tension_n > self.windlass.stall_n() {
            (state.chain_m, state.order) = (before.chain_m, before.order);
            load.stalled = true;
        }
        // In very deep water chain and anchor may weigh more than the brake holds: then all chain runs out.
        if tension_n > self.windlass.brake_n {
            load.rendered_m = self.chain_length_m - state.chain_m;
            state.chain_m = self.chain_length_m;
            if tension_n > self.bitter_end_n() {
                return lose(state, LostBy::RanOut, tension_n, tell);
            }
        }
        load
    }

    /// Takes a step of an anchor on the bottom at `place_m`.
    fn hold(
        &self,
        state: &mut AnchorState,
        place_m: Vec2,
        hawse_m: Vec2,
        ground: &Ground<'_>,
        before: &AnchorState,
        tell: &mut impl FnMut(AnchorEvent),
    ) -> AnchorLoad {
        let towards = hawse_m - place_m;
        let was_dragging = state.dragging;
        let mut held = self.held(state, towards.length(), ground);
        let mut load = AnchorLoad::default();
        if state.chain_m < before.chain_m && held.pull.tension_n() > self.windlass.stall_n() {
            // The windlass cannot move the chain against this tension.
            (state.chain_m, state.order) = (before.chain_m, before.order);
            held = self.held(state, towards.length(), ground);
            load.stalled = true;
        }
        let (rendered_m, tension_n) = (held.rendered_m, held.pull.tension_n());
        state.chain_m += rendered_m;
        // With all chain out the brake slips, and the bitter end takes the load.
        let held_n = greater(self.windlass.brake_n, self.bitter_end_n());
        if state.chain_m >= self.chain_length_m && tension_n > held_n {
            return lose(state, LostBy::RanOut, tension_n, tell);
        }
        if tension_n > self.chain().break_load_n() {
            return lose(state, LostBy::Parted, tension_n, tell);
        }
        let span_m = towards.length();
        let direction = if span_m > 0.0 { towards * (1.0 / span_m) } else { Vec2::ZERO };
        let moved_m = span_m - held.span_m;
        state.position = AnchorPosition::OnBottom(place_m + direction * moved_m);
        state.dragging = moved_m > 0.0;
        state.dragged_m += moved_m;
        state.dragged_j += held.pull.horizontal_n * moved_m;
        match (was_dragging, state.dragging) {
            (false, true) => tell(AnchorEvent::Drags),
            (true, false) => tell(AnchorEvent::Holds),
            _ => {}
        }
        if rendered_m > 0.0 && !state.rendering {
            tell(AnchorEvent::Renders);
        }
        state.rendering = rendered_m > 0.0;
        // The chain pulls the ship towards the anchor.
        let force_n = direction * -held.pull.horizontal_n;
        AnchorLoad {
            tension_n,
            on_ship_n: [force_n.x, force_n.y, -held.pull.down_n],
            holding_n: held.holding_n,
            on_bottom_m: held.pull.on_bottom_m,
            moved_m,
            rendered_m,
            ..load
        }
    }

    /// The equilibrium of chain and anchor with the hawse pipe `span_m` away, after the anchor has dragged and the
    /// brake has rendered.
    fn held(&self, state: &AnchorState, span_m: f64, ground: &Ground<'_>) -> Held {
        let (chain_m, faults) = (state.chain_m, state.faults);
        let bites = !state.dragging && !faults.does_not_bite;
        let factor = if bites { self.holding_factor } else { self.dragging_factor };
        let mut pull = ground.pull(chain_m, span_m);
        let drags = ground.excess_n(&pull, factor) > 0.0;
        let span_m = match drags {
            true => ground.holding_span_m(chain_m, span_m, self.dragging_factor),
            false => span_m,
        };
        if drags {
            pull = ground.pull(chain_m, span_m);
        }
        let mut rendered_m = 0.0;
        if pull.tension_n() > self.windlass.brake_n {
            let longer_m = ground.rendered_m(chain_m, span_m, self.windlass.brake_n);
            rendered_m = longer_m - chain_m;
            pull = ground.pull(longer_m, span_m);
        }
        // An anchor that stops dragging holds again.
        let factor = match drags || faults.does_not_bite {
            true => self.dragging_factor,
            false => self.holding_factor,
        };
        Held { holding_n: ground.holding_n(&pull, factor), pull, span_m, rendered_m }
    }
}

/// Forces and lengths of a chain and its anchor in equilibrium.
struct Held {
    pull: Pull,
    /// Distance between anchor and hawse pipe (m).
    span_m: f64,
    /// Length of chain that ran out because the brake rendered (slipped under load) (m).
    rendered_m: f64,
    holding_n: f64,
}

/// Loses the anchor at the given tension of its chain.
fn lose(
    state: &mut AnchorState,
    by: LostBy,
    tension_n: f64,
    tell: &mut impl FnMut(AnchorEvent),
) -> AnchorLoad {
    state.lose(by);
    tell(match by {
        LostBy::Parted => AnchorEvent::Parted,
        LostBy::RanOut | LostBy::Slipped => AnchorEvent::RanOut,
    });
    AnchorLoad { lost_at_n: Some(tension_n), ..AnchorLoad::default() }
}
