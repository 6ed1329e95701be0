//! Predictions of ships' paths, made with a copy of the simulation.

use fenderline_sim::{SimError, Simulation};

use crate::cast::Cast;
use crate::message::{Reply, ShipPath};
use crate::session::Session;

/// Largest number of ships whose paths a prediction contains.
pub const MOST_PATHS: usize = 3;

/// A copy of the simulation that runs ahead of the session, also on another thread.
#[derive(Clone, Debug)]
pub struct Prediction {
    simulation: Simulation,
    /// Tick at which the prediction begins.
    tick: u64,
    /// Number of times that something other than a step had changed the run before the prediction: commands, events, or
    /// going to another tick.
    interventions: u64,
    /// Number of the scenario's orders that the prediction has dropped.
    dropped: usize,
    /// Indices of the vessels whose paths the prediction keeps.
    vessels: Vec<usize>,
}

impl Cast {
    /// Indices of the vessels whose paths are predicted, at most [`MOST_PATHS`]: the own ship, then the other ships,
    /// then the tugs.
    #[must_use]
    pub fn predicted(&self) -> Vec<usize> {
        let tugs = (0..self.vessels.len()).filter(|index| self.is_tug[*index]);
        self.ships().into_iter().chain(tugs).take(MOST_PATHS).collect()
    }
}

impl Session {
    /// A prediction from the present state of the session without further orders; `None` without vessels.
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
    /// A prediction that begins in the state of `simulation`. A prediction drops the scenario's later orders; orders
    /// that are due in the next step stay. The weather stays during a prediction as it is now.
    pub(crate) fn of(mut simulation: Simulation, tick: u64, vessels: Vec<usize>) -> Prediction {
        let end_s = simulation.time_s() + simulation.setup().step_s;
        let planned = simulation.pending_orders().len();
        simulation.retain_orders(|order| order.at_s < end_s);
        let dropped = planned - simulation.pending_orders().len();
        // Setting the present weather ends changes that run over a time. Otherwise a pilot could see the instructor's
        // plan in a path.
        let environment = &simulation.setup().world.environment;
        let (wind, current) = (environment.wind.clone(), environment.current.clone());
        simulation.set_wind(wind);
        simulation.set_current(current);
        Prediction { simulation, tick, interventions: 0, dropped, vessels }
    }

    /// Leaves the paths of the vessels `vessels` out of the prediction.
    pub(crate) fn leave_out(&mut self, vessels: &[usize]) {
        self.vessels.retain(|vessel| !vessels.contains(vessel));
    }

    /// Tick at which the prediction begins.
    pub(crate) fn tick(&self) -> u64 {
        self.tick
    }

    /// True if an earlier prediction of the same run can be continued in place of this prediction, provided that both
    /// have the same state at this tick. Only steps have changed the run since the earlier prediction, and no order is
    /// due that the earlier prediction dropped.
    pub(crate) fn may_continue(&self, earlier: &Prediction) -> bool {
        self.interventions == earlier.interventions
            && self.dropped == earlier.dropped
            && self.simulation.pending_orders().is_empty()
    }

    pub(crate) fn vessels(&self) -> &[usize] {
        &self.vessels
    }

    /// Takes one step.
    ///
    /// # Errors
    /// The step failed.
    pub(crate) fn step(&mut self) -> Result<(), SimError> {
        self.simulation.step().map(|_| ())
    }

    /// Number of the simulation's steps in `seconds`, and number of steps between two positions of a path.
    pub(crate) fn steps_of(&self, seconds: f64, every_s: f64) -> (u64, u64) {
        let steps = |time_s: f64| libm::round(time_s / self.simulation.setup().step_s) as u64;
        (steps(seconds), steps(every_s).max(1))
    }

    /// Time (s), position (m) and heading (rad) of a vessel, as a path has them.
    pub(crate) fn position(&self, vessel: usize) -> [f64; 4] {
        let body = self.simulation.setup().world.vessels[vessel].body;
        let state = &self.simulation.states()[body];
        [self.simulation.time_s(), state.position_m.x, state.position_m.y, state.heading_rad]
    }

    pub(crate) fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Runs the prediction for a number of seconds and returns the ships' paths, with a position every `every_s`. The
    /// first position of each path is the present position.
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

    /// Runs as [`Prediction::run`] does. Returns the predicted paths, and whether they reach the end. The function
    /// `go_on` gets the paths at each new position. The prediction ends early if `go_on` returns false or a step fails.
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
