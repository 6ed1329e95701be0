//! Statistics of the motions of vessels over a run, use of lines and fenders, and the limits of a scenario.
//!
//! | file | content |
//! |---|---|
//! | `statistics/peaks.rs` | mean, standard deviation, peaks, ranges and zero crossings of a series of values |
//! | `statistics/series.rs` | the motions of a vessel, sampled at equal intervals of time |
//! | `statistics/rainflow.rs` | cycles of a line's tension |
//! | `statistics/limit.rs` | the values of a run that are compared with limits |

mod limit;
mod peaks;
mod rainflow;
mod series;

use fenderline_world::record::StepRecord;
use fenderline_world::setup::Setup;

pub use peaks::MotionStatistics;
pub use rainflow::{RAINFLOW_BINS, Rainflow};
use series::MotionSeries;

/// The statistics that a run keeps if its set-up has a [`fenderline_world::limit::StatisticsSetup`].
#[derive(Clone, Debug)]
pub struct Statistics {
    from_s: f64,
    /// The statistics of each vessel, in the order of the set-up.
    motions: Vec<MotionSeries>,
    /// Cycles of the tension of each line, divided by its break load, in the order of the set-up.
    pub lines: Vec<Rainflow>,
}

impl Statistics {
    /// Makes the statistics before the first step; returns `None` if the set-up asks for no statistics.
    pub fn new(setup: &Setup) -> Option<Statistics> {
        let from_s = setup.world.statistics.from_s?;
        Some(Statistics {
            from_s,
            motions: setup.world.vessels.iter().map(|_| MotionSeries::default()).collect(),
            lines: setup.world.lines.iter().map(|_| Rainflow::default()).collect(),
        })
    }

    /// Adds one step.
    pub fn add(&mut self, setup: &Setup, step: &StepRecord<'_>) {
        if step.t_s < self.from_s {
            return;
        }
        for ((own, vessel), now) in
            self.motions.iter_mut().zip(&setup.world.vessels).zip(step.vessels)
        {
            own.push(&step.states_after[vessel.body], now);
        }
        for ((own, line), now) in self.lines.iter_mut().zip(&setup.world.lines).zip(step.lines) {
            own.push(now.load.tension_n / line.line.kind.break_load_n());
        }
    }

    /// Time from which steps count in the statistics (s).
    #[must_use]
    pub fn from_s(&self) -> f64 {
        self.from_s
    }

    /// Statistics of a vessel's surge, sway, heave, roll, pitch and yaw about their means; `vessel` is the vessel's
    /// index. Surge and sway are motions of the centre of gravity along and across the mean heading.
    ///
    /// # Panics
    /// Panics if there is no such vessel.
    #[must_use]
    pub fn motions(&self, vessel: usize, step_s: f64) -> [MotionStatistics; 6] {
        self.motions[vessel].statistics(step_s)
    }
}
