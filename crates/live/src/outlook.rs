//! Predictions of the ships' paths, one after the other. The latest prediction is continued as long as the run does
//! what was predicted.
//!
//! In most ticks, nobody gives an order. Without an order the run reaches the state that the latest prediction has for
//! the present tick. The next prediction is the latest prediction without its first tick and with one more tick at its
//! end. Continuing a prediction costs one step in place of thousands, and has the same bits as a prediction from the
//! beginning.

use std::collections::VecDeque;

use crate::bits::fingerprint;
use crate::message::{Reply, ShipPath};
use crate::prediction::{MOST_PATHS, Prediction};

/// Predictions of a session's run, one after the other.
#[derive(Debug, Default)]
pub struct Outlook {
    latest: Option<Latest>,
}

/// The latest prediction.
#[derive(Debug)]
struct Latest {
    /// The predicting simulation after its last step, at the end of the paths.
    at_end: Prediction,
    /// Number of the first tick in the list `ticks`.
    first: u64,
    ticks: VecDeque<Tick>,
}

/// The predicted state of one tick.
#[derive(Debug)]
struct Tick {
    /// Fingerprint of the predicted state.
    bits: u64,
    /// Time (s), north (m), east (m) and heading (rad) of each vessel.
    positions: [[f64; 4]; MOST_PATHS],
}

impl Outlook {
    /// The paths of a prediction over `seconds`, with a position every `every_s`. The first position of each path is
    /// the present position. The prediction ends early if a step fails or `go_on` returns false. The function `go_on`
    /// is called at each position of the paths.
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

    /// Forgets the latest prediction. The next prediction then starts from the beginning, as is necessary if another
    /// run is predicted.
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

    /// Keeps the rest of the latest prediction from the first tick of the prediction `other` on, if the state at that
    /// tick is as predicted.
    fn from(mut self, other: &Prediction) -> Option<Latest> {
        let passed = usize::try_from(other.tick().checked_sub(self.first)?).ok()?;
        let is_as_said = other.may_continue(&self.at_end)
            && self.ticks.get(passed)?.bits == fingerprint(other.simulation());
        self.ticks.drain(..passed);
        self.first = other.tick();
        is_as_said.then_some(self)
    }

    /// Runs the prediction until the paths have `steps` steps. Returns false if the prediction ends before the paths
    /// have `steps` steps.
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

    /// Keeps the predicted state of the tick that the prediction has reached.
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
