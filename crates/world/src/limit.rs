//! Limits of a scenario on motions, lines and fenders.

mod subject;

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
    /// All six, in the order of the statistics of a run.
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
