//! The anchors of a simulation: places of the anchors on the ships, and orders to the anchors.

use fenderline_contact::{BodyState, Vec2, Wrench, vec2};

use super::afloat::Lever;
use super::environment::Environment;
use super::event::{WorldEvent, WorldEventKind};
use super::shore::Shore;
use crate::order::{AnchorAction, OrderError};
use crate::setup::body::BodySetup;
use fenderline_ship::anchor::{
    AnchorError, AnchorGear, AnchorLoad, AnchorPosition, AnchorState, AnchorStep, Hawse, LostBy,
    WindlassOrder,
};
use fenderline_ship::range::within;
use fenderline_ship::step_time::StepTime;

/// An anchor of a set-up.
#[derive(Clone, Debug, PartialEq)]
pub struct AnchorSetup {
    /// The anchor, with its chain and windlass.
    pub gear: AnchorGear,
    /// Index of the vessel that carries the anchor, in [`crate::world::WorldSetup::vessels`].
    pub vessel: usize,
    /// Place of the hawse pipe in the frame of the vessel's body (m).
    pub hawse_m: Vec2,
    /// Height of the hawse pipe above the still water (m).
    pub hawse_above_water_m: f64,
    /// Place and chain of the anchor at the start; `None` if the anchor is home in the hawse pipe.
    pub start: Option<AnchorStart>,
}

/// An anchor that is on the bottom at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnchorStart {
    /// Place of the anchor, north and east (m).
    pub at_m: Vec2,
    /// Chain out (m).
    pub chain_m: f64,
}

/// The state of an anchor in a run, as plain data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnchorAtWork {
    /// State of the anchor.
    pub state: AnchorState,
    /// Forces of the anchor and its chain in the last step.
    pub load: AnchorLoad,
    /// Place on the ship where the chain pulled in the last step.
    pub lever: Lever,
}

impl AnchorSetup {
    /// Height of the hawse pipe above the bottom (m), with the ship upright and the deepest water of the run; `None` in
    /// deep water.
    #[must_use]
    pub fn most_above_bottom_m(&self, environment: &Environment) -> Option<f64> {
        let [_, deepest_m] = environment.depth_range_m()?;
        Some(deepest_m + self.hawse_above_water_m)
    }

    /// Checks the numbers of the anchor. If the anchor is on the bottom at the start of a run, also checks that the
    /// chain reaches the anchor.
    ///
    /// # Errors
    /// Returns the first fault, with the name of the anchor.
    pub fn check(&self, body: &BodySetup, environment: &Environment) -> Result<(), AnchorError> {
        self.gear.check()?;
        let name = || self.gear.name.clone();
        let out_of_range = |error| AnchorError::OutOfRange { anchor: name(), error };
        let in_range = |what, value, low, high| {
            within(what, value, low, high).map(|_| ()).map_err(out_of_range)
        };
        in_range(
            "distance of the hawse pipe from the ship's centre of gravity [m]",
            self.hawse_m.length(),
            0.0,
            5e3,
        )?;
        in_range(
            "height of the hawse pipe above the still water [m]",
            self.hawse_above_water_m,
            0.0,
            100.0,
        )?;
        let Some(start) = self.start else { return Ok(()) };
        in_range(
            "distance of the anchor from the origin of the scenario [m]",
            start.at_m.length(),
            0.0,
            1e8,
        )?;
        in_range("chain out [m]", start.chain_m, 0.0, self.gear.chain_length_m)?;
        let state = crate::rigid_body::initial_state(body);
        let hawse_m = state.pose().apply(self.hawse_m);
        let Ok(Some(depth_m)) = environment.depth_at_m(hawse_m, 0.0) else {
            return Err(AnchorError::NoBottom { anchor: name() });
        };
        let span_m = (hawse_m - start.at_m).length();
        let reach_m = libm::hypot(span_m, depth_m + self.hawse_above_water_m);
        if start.chain_m < reach_m {
            let chain_m = start.chain_m;
            return Err(AnchorError::ChainTooShort { anchor: name(), chain_m, reach_m });
        }
        Ok(())
    }
}

/// A ship with her anchor in a step.
#[derive(Clone, Copy, Debug)]
pub struct AnchoredShip<'a> {
    /// Index of the ship's body.
    pub body: usize,
    /// The states of all bodies.
    pub states: &'a [BodyState],
    /// Which bodies stand on the ground, and the level of the water.
    pub shore: Shore<'a>,
    /// The water.
    pub environment: &'a Environment,
    /// The mean depth under the ship (m); `None` in deep water.
    pub under_m: Option<f64>,
}

impl AnchorAtWork {
    /// An anchor with this state and these forces, whose chain has not yet pulled.
    #[must_use]
    pub fn with(state: AnchorState, load: AnchorLoad) -> AnchorAtWork {
        AnchorAtWork { state, load, lever: Lever::default() }
    }

    /// The anchor at the start of a run.
    pub fn new(setup: &AnchorSetup) -> AnchorAtWork {
        let state = match setup.start {
            Some(start) => AnchorState::on_bottom(start.at_m, start.chain_m),
            None => AnchorState::housed(),
        };
        AnchorAtWork { state, load: AnchorLoad::default(), lever: Lever::default() }
    }

    /// Checks whether the anchor can carry out an order now.
    pub fn may(&self, setup: &AnchorSetup, action: AnchorAction) -> Result<(), OrderError> {
        let anchor = || setup.gear.name.clone();
        let AnchorState { position, chain_m: out_m, faults, .. } = self.state;
        let out = |more: bool| {
            let anchor = anchor();
            Err(OrderError::NoChainToMove { anchor, out_m, more })
        };
        match position {
            AnchorPosition::Lost(by) => {
                return Err(OrderError::AnchorLost { anchor: anchor(), by });
            }
            AnchorPosition::Housed => match action {
                AnchorAction::LetGo { .. } | AnchorAction::Veer { .. } => {}
                // The anchor is being let go or veered, but no chain is out yet.
                AnchorAction::Hold if self.state.order != WindlassOrder::Hold => {}
                AnchorAction::Hold | AnchorAction::Heave { .. } | AnchorAction::Slip => {
                    return Err(OrderError::AnchorHome { anchor: anchor() });
                }
            },
            AnchorPosition::OnBottom(_) => {
                if matches!(action, AnchorAction::LetGo { .. }) {
                    return Err(OrderError::AnchorDown { anchor: anchor() });
                }
            }
            AnchorPosition::Hanging => {}
        }
        let needs_power = matches!(action, AnchorAction::Veer { .. } | AnchorAction::Heave { .. });
        if needs_power && faults.windlass_failed {
            return Err(OrderError::WindlassFailed { anchor: anchor() });
        }
        match action {
            AnchorAction::LetGo { chain_m } | AnchorAction::Veer { chain_m }
                if chain_m <= out_m =>
            {
                out(true)
            }
            AnchorAction::Heave { chain_m } if chain_m >= out_m => out(false),
            _ => Ok(()),
        }
    }

    /// Takes an order. [`AnchorAtWork::may`] must allow the order.
    pub fn take(&mut self, action: AnchorAction) {
        self.state.order = match action {
            AnchorAction::LetGo { chain_m } => WindlassOrder::LetGo(chain_m),
            AnchorAction::Veer { chain_m } => WindlassOrder::Veer(chain_m),
            AnchorAction::Heave { chain_m } => WindlassOrder::Heave(chain_m),
            AnchorAction::Hold => WindlassOrder::Hold,
            AnchorAction::Slip => {
                self.state.lose(LostBy::Slipped);
                WindlassOrder::Hold
            }
        };
    }

    /// Does one step: moves windlass and anchor, and adds the pull of the chain to the load of the ship. The bottom is
    /// at the depth under the hawse pipe or, if no depth is known there, at [`AnchoredShip::under_m`].
    pub fn step(
        &mut self,
        index: usize,
        of: &AnchorSetup,
        AnchoredShip { body, states, shore, environment, under_m }: AnchoredShip<'_>,
        StepTime { t_s, step_s }: StepTime,
        loads: &mut [Wrench],
        events: &mut Vec<WorldEvent>,
    ) {
        let (at_m, above_water_m) = shore.place(body, of.hawse_m, of.hawse_above_water_m);
        let at_m = states[body].pose().apply(at_m);
        let depth_m = environment.depth_at_m(at_m, t_s).unwrap_or(under_m);
        let above_bottom_m = depth_m.map(|depth_m| depth_m + above_water_m);
        let hawse = Hawse { at_m, above_bottom_m };
        let given = AnchorStep {
            last_n: self.load.tension_n,
            water_kgpm3: environment.water_density_kgpm3,
            step_s,
        };
        self.load = of.gear.step(&mut self.state, &hawse, given, &mut |event| {
            events.push(WorldEvent { who: index, kind: WorldEventKind::Anchor(event) });
        });
        self.lever = shore.lever(body, of.hawse_m, of.hawse_above_water_m);
        let [north_n, east_n, _] = self.load.on_ship_n;
        let force_n = vec2(north_n, east_n);
        let arm_m = states[body].pose().rotation.apply(self.lever.at_m);
        loads[body].force_n += force_n;
        loads[body].moment_nm += arm_m.cross(force_n);
    }
}
