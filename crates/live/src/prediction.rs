//! Predictions of ships' paths, by a copy of the simulation.

use fenderline_sim::{SimError, Simulation};

use crate::cast::Cast;
use crate::message::{Reply, ShipPath};
use crate::session::Session;

/// Most ships whose paths a prediction has.
pub const MOST_PATHS: usize = 3;

/// A copy of the simulation that can be run ahead, also on another thread.
#[derive(Clone, Debug)]
pub struct Prediction {
    simulation: Simulation,
    /// The tick from which it begins.
    tick: u64,
    /// How often commands, events or going to another tick had changed the run.
    interventions: u64,
    /// Number of orders of the scenario that were dropped.
    dropped: usize,
    /// Indices of the vessels whose paths are kept.
    vessels: Vec<usize>,
}

impl Cast {
    /// Indices of the vessels whose paths are predicted, at most [`MOST_PATHS`]: the own ship, the other ships, then the tugs.
    #[must_use]
    pub fn predicted(&self) -> Vec<usize> {
        let tugs = (0..self.vessels.len()).filter(|index| self.is_tug[*index]);
        self.ships().into_iter().chain(tugs).take(MOST_PATHS).collect()
    }
}

impl Session {
    /// A prediction from the present state without further orders; `None` without vessels.
    #[must_use]
    pub fn prediction(&self) -> Option<Prediction> {
        let vessels = self.cast().predicted();
        (!vessels.is_empty()).then(|| Prediction {
            interventions: self.interventions(),
            ..Prediction::of(self.simulation().clone(), self.tick(), vessels)
        })
    }
}

impl Prediction {
    /// A prediction that begins in a state. Later orders of the scenario are dropped; those that are due in the next step stay. The weather
    /// stays as it is.
    pub(crate) fn of(mut simulation: Simulation, tick: u64, vessels: Vec<usize>) -> Prediction {
        let end_s = simulation.time_s() + simulation.setup().step_s;
        let planned = simulation.pending_orders().len();
        simulation.retain_orders(|order| order.at_s < end_s);
        let dropped = planned - simulation.pending_orders().len();
        // Setting the weather of now ends changes over a time: a pilot must not see the instructor's plan in a path.
        let environment = &simulation.setup().world.environment;
        let (wind, current) = (environment.wind.clone(), environment.current.clone());
        simulation.set_wind(wind);
        simulation.set_current(current);
        Prediction { simulation, tick, interventions: 0, dropped, vessels }
    }

    /// Leaves out the paths of these vessels.
    pub(crate) fn leave_out(&mut self, vessels: &[usize]) {
        self.vessels.retain(|vessel| !vessels.contains(vessel));
    }

    /// The tick from which it begins.
    pub(crate) fn tick(&self) -> u64 {
        self.tick
    }

    /// Whether an earlier prediction of the same run can be continued in place of this one, if it has the same state at this tick: nothing but
    /// steps has changed the run since, and no order is due that the earlier one dropped.
    pub(crate) fn may_continue(&self, earlier: &Prediction) -> bool {
        self.interventions == earlier.interventions
            && self.dropped == earlier.dropped
            && self.simulation.pending_orders().is_empty()
    }

    pub(crate) fn vessels(&self) -> &[usize] {
        &self.vessels
    }

    /// Goes on by one step.
    ///
    /// # Errors
    /// The step failed.
    pub(crate) fn step(&mut self) -> Result<(), SimError> {
        self.simulation.step().map(|_| ())
    }

    /// Steps in a time (s), and between two positions.
    pub(crate) fn steps_of(&self, seconds: f64, every_s: f64) -> (u64, u64) {
        let steps = |time_s: f64| libm::round(time_s / self.simulation.setup().step_s) as u64;
        (steps(seconds), steps(every_s).max(1))
    }

    /// Time (s), position (m) and heading (rad) of one of the vessels, as a path has them.
    pub(crate) fn position(&self, vessel: usize) -> [f64; 4] {
        let body = self.simulation.setup().world.vessels[vessel].body;
        let state = &self.simulation.states()[body];
        [self.simulation.time_s(), state.position_m.x, state.position_m.y, state.heading_rad]
    }

    pub(crate) fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Runs for a number of seconds and returns the paths, with a position every `every_s`, the present one first.
    #[must_use]
    pub fn run(
        mut self,
        seconds: f64,
        every_s: f64,
        go_on: impl FnMut(&[ShipPath]) -> bool,
    ) -> Reply {
        let (paths, _) = self.advance(seconds, every_s, go_on);
        Reply::Prediction { tick: self.tick, paths }
    }

    /// As [`Prediction::run`]; returns the paths, and whether they reach the end. `go_on` sees the paths at each new position; the
    /// run ends early if it returns false or a step fails.
    pub(crate) fn advance(
        &mut self,
        seconds: f64,
        every_s: f64,
        mut go_on: impl FnMut(&[ShipPath]) -> bool,
    ) -> (Vec<ShipPath>, bool) {
        let (steps, every) = self.steps_of(seconds, every_s);
        let path = |vessel: &usize| ShipPath { vessel: *vessel, path: Vec::new() };
        let mut paths: Vec<ShipPath> = self.vessels.iter().map(path).collect();
        for step in 0..=steps {
            if step.is_multiple_of(every) {
                self.add_positions(&mut paths);
                if !go_on(&paths) {
                    return (paths, step == steps);
                }
            }
            if step < steps && self.step().is_err() {
                return (paths, false);
            }
        }
        (paths, true)
    }

    fn add_positions(&self, paths: &mut [ShipPath]) {
        for ShipPath { vessel, path } in paths {
            path.push(self.position(*vessel));
        }
    }
}
