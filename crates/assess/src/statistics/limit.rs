//! The values of a run that are compared with the limits on motions, lines and fenders.

use fenderline_world::fender::FenderSummary;
use fenderline_world::limit::{LimitSetup, Limited, Measure};
use fenderline_world::setup::Setup;

use super::Statistics;
use super::peaks::MotionStatistics;

/// The statistic of a motion that the limit is set on, such as the maximum or the significant value.
fn measured(measure: Measure, of: &MotionStatistics) -> f64 {
    match measure {
        Measure::Maximum => of.maximum,
        Measure::Significant => of.significant,
        Measure::MaximumRange => of.maximum_range,
        Measure::SignificantRange => of.significant_range,
        Measure::Deviation => of.deviation,
    }
}

impl Statistics {
    /// The values of the run that are compared with the limits, in the order of the limits in the set-up. The values of
    /// lines and fenders count from the start of the run.
    pub fn values<'a>(
        &self,
        setup: &Setup,
        peak_tensions_n: &[f64],
        fenders: impl Iterator<Item = &'a FenderSummary>,
    ) -> Vec<f64> {
        let largest = |shares: &mut dyn Iterator<Item = f64>| {
            shares.fold(0.0, fenderline_contact::number::greater)
        };
        let lines = setup.world.lines.iter().zip(peak_tensions_n);
        let of_lines =
            largest(&mut lines.map(|(line, peak_n)| peak_n / line.line.kind.break_load_n()));
        let of_fenders = largest(&mut fenders.filter_map(|own| Some(own.governing()?.1)));
        // A vessel may have several limits.
        let vessels = 0..setup.world.vessels.len();
        let limits = &setup.world.statistics.limits;
        let is_limited = |index: usize| {
            limits.iter().any(
                |limit| matches!(limit.what, Limited::Motion { vessel, .. } if vessel == index),
            )
        };
        let motions: Vec<_> = vessels
            .map(|vessel| is_limited(vessel).then(|| self.motions(vessel, setup.step_s)))
            .collect();
        let value = |limit: &LimitSetup| match limit.what {
            Limited::Motion { vessel, motion, measure } => {
                motions[vessel].map_or(0.0, |of| measured(measure, &of[motion as usize]))
            }
            Limited::Lines => of_lines,
            Limited::Fenders => of_fenders,
        };
        limits.iter().map(value).collect()
    }
}
