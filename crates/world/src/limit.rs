//! Limits of a scenario on motions, lines and fenders.

use crate::setup::Setup;

/// Statistics of a run, and the limits that they are compared with.
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
    /// Its name.
    pub name: String,
    /// What is limited.
    pub what: Limited,
    /// The most that is permissible (m, rad, or a share).
    pub most: f64,
}

/// What is limited.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limited {
    /// A motion of a vessel.
    Motion {
        /// Index of the vessel.
        vessel: usize,
        /// The motion.
        motion: MotionName,
        /// Which of its statistics.
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
    /// Along her mean heading.
    Surge,
    /// Across her mean heading.
    Sway,
    /// Up and down.
    Heave,
    /// About her long axis.
    Roll,
    /// About her cross axis.
    Pitch,
    /// Heading.
    Yaw,
}

impl MotionName {
    /// All six, in the order of the statistics of a run.
    pub const ALL: [MotionName; 6] = [
        MotionName::Surge,
        MotionName::Sway,
        MotionName::Heave,
        MotionName::Roll,
        MotionName::Pitch,
        MotionName::Yaw,
    ];

    /// In words.
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

    /// Whether it is an angle.
    #[must_use]
    pub fn is_angle(self) -> bool {
        matches!(self, MotionName::Roll | MotionName::Pitch | MotionName::Yaw)
    }
}

/// A statistic of a motion: see `MotionStatistics` of the crate `fenderline-assess`.
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
    /// In words.
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
    /// What is limited, in words.
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

    /// A value of it, in words.
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
