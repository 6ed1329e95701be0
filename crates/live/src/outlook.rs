//! The latest prediction, which is continued while the run does what it said.
//!
//! Nobody gives an order in most ticks. The run is then where the last prediction said that it would be, and the next prediction is the last
//! one without its first tick and with one more at its end: one step in place of thousands. It has the same bits as one that is made anew.

use std::collections::VecDeque;

use crate::bits::fingerprint;
use crate::message::{Reply, ShipPath};
use crate::prediction::{MOST_PATHS, Prediction};

/// Predictions of one run, one after the other.
#[derive(Debug, Default)]
pub struct Outlook {
    latest: Option<Latest>,
}

/// The latest prediction.
#[derive(Debug)]
struct Latest {
    /// It has been run to the end of the paths.
    at_end: Prediction,
    /// Tick of the first of `ticks`.
    first: u64,
    ticks: VecDeque<Tick>,
}

/// What the prediction says of one tick.
#[derive(Debug)]
struct Tick {
    /// Fingerprint of the state.
    bits: u64,
    /// Time (s), north (m), east (m) and heading (rad) of each vessel.
    positions: [[f64; 4]; MOST_PATHS],
}

impl Outlook {
    /// The paths of a prediction over a number of seconds, with a position every `every_s`, the present one first. Ends early if `go_on` returns
    /// false, which is asked at each position, or a step fails.
    pub fn run(
        &mut self,
        prediction: Prediction,
        seconds: f64,
        every_s: f64,
        mut go_on: impl FnMut() -> bool,
    ) -> Reply {
        let (steps, every) = prediction.steps_of(seconds, every_s);
        let tick = prediction.tick();
        let latest = self.latest.take().and_then(|latest| latest.from(&prediction));
        let mut latest = latest.unwrap_or_else(|| Latest::new(prediction));
        let is_complete = latest.reach(steps, every, &mut go_on);
        let paths = latest.paths(steps as usize + 1, every as usize);
        self.latest = is_complete.then_some(latest);
        Reply::Prediction { tick, paths }
    }

    /// Forgets the latest prediction: the next one is made anew, as for another run.
    pub fn forget(&mut self) {
        self.latest = None;
    }
}

impl Latest {
    fn new(prediction: Prediction) -> Latest {
        let mut latest =
            Latest { first: prediction.tick(), at_end: prediction, ticks: VecDeque::new() };
        latest.note();
        latest
    }

    /// What is left of it from the state in which another prediction begins, if that is as it said.
    fn from(mut self, other: &Prediction) -> Option<Latest> {
        let passed = usize::try_from(other.tick().checked_sub(self.first)?).ok()?;
        let is_as_said = other.may_continue(&self.at_end)
            && self.ticks.get(passed)?.bits == fingerprint(other.simulation());
        self.ticks.drain(..passed);
        self.first = other.tick();
        is_as_said.then_some(self)
    }

    /// Runs until the paths have this many steps. False if it ends before.
    fn reach(&mut self, steps: u64, every: u64, go_on: &mut impl FnMut() -> bool) -> bool {
        while (self.ticks.len() as u64) <= steps {
            if (self.ticks.len() as u64 - 1).is_multiple_of(every) && !go_on() {
                return false;
            }
            if self.at_end.step().is_err() {
                return false;
            }
            self.note();
        }
        true
    }

    /// Keeps what it says of the tick that it has reached.
    fn note(&mut self) {
        let mut positions = [[0.0; 4]; MOST_PATHS];
        for (position, vessel) in positions.iter_mut().zip(self.at_end.vessels()) {
            *position = self.at_end.position(*vessel);
        }
        self.ticks.push_back(Tick { bits: fingerprint(self.at_end.simulation()), positions });
    }

    fn paths(&self, ticks: usize, every: usize) -> Vec<ShipPath> {
        let shown = || self.ticks.iter().take(ticks).step_by(every);
        let path = |(place, vessel): (usize, &usize)| ShipPath {
            vessel: *vessel,
            path: shown().map(|tick| tick.positions[place]).collect(),
        };
        self.at_end.vessels().iter().enumerate().map(path).collect()
    }
}
