//! Limits of a scenario on motions, lines and fenders.

use super::Statistics;
use super::peaks::MotionStatistics;
use crate::fender::FenderSummary;
use crate::setup::Setup;

/// Statistics of a run, and the limits with which they are compared.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StatisticsSetup {
    /// Time from which steps count (s); `None`: no statistics, and no limits.
    pub from_s: Option<f64>,
    /// Limits, in the order of the file.
    pub limits: Vec<LimitSetup>,
}

/// A limit.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitSetup {
    /// Name of the limit.
    pub name: String,
    /// The quantity that is limited.
    pub what: Limited,
    /// The largest permissible value (m, rad, or a share).
    pub most: f64,
}

/// The quantity that is limited.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limited {
    /// A motion of a vessel.
    Motion {
        /// Index of the vessel.
        vessel: usize,
        /// The motion.
        motion: MotionName,
        /// The statistic of the motion.
        measure: Measure,
    },
    /// The largest tension of any line over its break load.
    Lines,
    /// The largest energy, deflection or reaction of any fender over its rating.
    Fenders,
}

/// A motion in one of the six degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionName {
    /// Motion along the vessel's mean heading.
    Surge,
    /// Motion across the vessel's mean heading.
    Sway,
    /// Up and down.
    Heave,
    /// About the longitudinal axis.
    Roll,
    /// About the transverse axis.
    Pitch,
    /// Heading.
    Yaw,
}

impl MotionName {
    /// All six, in the order of [`Statistics::motions`].
    pub const ALL: [MotionName; 6] = [
        MotionName::Surge,
        MotionName::Sway,
        MotionName::Heave,
        MotionName::Roll,
        MotionName::Pitch,
        MotionName::Yaw,
    ];

    /// The motion in words.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            MotionName::Surge => "surge",
            MotionName::Sway => "sway",
            MotionName::Heave => "heave",
            MotionName::Roll => "roll",
            MotionName::Pitch => "pitch",
            MotionName::Yaw => "yaw",
        }
    }

    /// Whether the motion is an angle.
    #[must_use]
    pub fn is_angle(self) -> bool {
        matches!(self, MotionName::Roll | MotionName::Pitch | MotionName::Yaw)
    }
}

/// A statistic of a motion: see [`MotionStatistics`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Largest distance from the mean.
    Maximum,
    /// Mean of the highest third of the peaks.
    Significant,
    /// Largest range from crest to trough.
    MaximumRange,
    /// Mean of the highest third of the ranges.
    SignificantRange,
    /// Standard deviation.
    Deviation,
}

impl Measure {
    fn of(self, of: &MotionStatistics) -> f64 {
        match self {
            Measure::Maximum => of.maximum,
            Measure::Significant => of.significant,
            Measure::MaximumRange => of.maximum_range,
            Measure::SignificantRange => of.significant_range,
            Measure::Deviation => of.deviation,
        }
    }

    /// The statistic in words.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Measure::Maximum => "maximum",
            Measure::Significant => "significant amplitude",
            Measure::MaximumRange => "largest range",
            Measure::SignificantRange => "significant range",
            Measure::Deviation => "standard deviation",
        }
    }
}

impl LimitSetup {
    /// The limited quantity in words.
    #[must_use]
    pub fn subject(&self, setup: &Setup) -> String {
        match self.what {
            Limited::Motion { vessel, motion, measure } => {
                let name = &setup.bodies[setup.world.vessels[vessel].body].name;
                format!("{} of {name}, {}", motion.word(), measure.word())
            }
            Limited::Lines => "largest tension of a line over its break load".to_owned(),
            Limited::Fenders => "largest use of a fender over its rating".to_owned(),
        }
    }

    /// A value of the limited quantity, in words.
    #[must_use]
    pub fn shown(&self, value: f64) -> String {
        match self.what {
            Limited::Motion { motion, .. } if motion.is_angle() => {
                format!("{:.2} deg", value.to_degrees())
            }
            Limited::Motion { .. } => format!("{value:.2} m"),
            Limited::Lines | Limited::Fenders => format!("{:.0} %", 100.0 * value),
        }
    }
}

impl Statistics {
    /// The values with which the limits are compared, in the order of the set-up. Lines and fenders count from the
    /// start of the run.
    pub(crate) fn values<'a>(
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
                motions[vessel].map_or(0.0, |of| measure.of(&of[motion as usize]))
            }
            Limited::Lines => of_lines,
            Limited::Fenders => of_fenders,
        };
        limits.iter().map(value).collect()
    }
}
