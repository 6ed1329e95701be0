//! Statistics of the motions of vessels over a run, use of lines and fenders, and the limits of a scenario.
//!
//! | file | content |
//! |---|---|
//! | `statistics/peaks.rs` | mean, standard deviation, peaks, ranges and zero crossings of a series |
//! | `statistics/series.rs` | the motions of a vessel, kept at even times |
//! | `statistics/rainflow.rs` | cycles of a line's tension |
//! | `statistics/limit.rs` | limits, and what exceeds them |

mod limit;
mod peaks;
mod rainflow;
mod series;

use fenderline_world::record::StepRecord;
use fenderline_world::setup::Setup;

pub use peaks::MotionStatistics;
pub use rainflow::{RAINFLOW_BINS, Rainflow};
use series::MotionSeries;

/// The statistics that a run with [`fenderline_world::limit::StatisticsSetup`] keeps.
#[derive(Clone, Debug)]
pub struct Statistics {
    from_s: f64,
    /// The vessels, in the order of the set-up.
    motions: Vec<MotionSeries>,
    /// Cycles of the tension of each line over its break load, in the order of the set-up.
    pub lines: Vec<Rainflow>,
}

impl Statistics {
    /// Statistics before the first step; `None` if the set-up asks for none.
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

    /// Time from which steps count (s).
    #[must_use]
    pub fn from_s(&self) -> f64 {
        self.from_s
    }

    /// Surge, sway, heave, roll, pitch and yaw of a vessel about their means, by the vessel's index. Surge and sway are
    /// motions of the centre of gravity along and across the mean heading.
    ///
    /// # Panics
    /// If there is no such vessel.
    #[must_use]
    pub fn motions(&self, vessel: usize, step_s: f64) -> [MotionStatistics; 6] {
        self.motions[vessel].statistics(step_s)
    }
}
