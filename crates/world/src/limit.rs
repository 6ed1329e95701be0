//! Limits of a scenario on motions, lines and fenders.

mod subject;

/// Statistics of a run, and the limits with which they are compared.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StatisticsSetup {
    /// Time from which steps count in the statistics (s); `None` if there are no statistics and no limits.
    pub from_s: Option<f64>,
    /// The limits of the scenario, in the order of the file.
    pub limits: Vec<LimitSetup>,
}

/// A limit on a motion, on lines or on fenders.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitSetup {
    /// Name of the limit.
    pub name: String,
    /// The quantity that is limited.
    pub what: Limited,
    /// The largest permissible value of the limited quantity (m, rad, or a share).
    pub most: f64,
}

/// The quantity that is limited.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limited {
    /// A motion of a vessel.
    Motion {
        /// Index of the vessel.
        vessel: usize,
        /// The motion that is limited.
        motion: MotionName,
        /// The statistic of the motion that is limited.
        measure: Measure,
    },
    /// The largest tension of any line, divided by the line's break load.
    Lines,
    /// The largest energy, deflection or reaction of any fender, divided by the fender's rated value.
    Fenders,
}

/// A motion in one of the six degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionName {
    /// Motion along the vessel's mean heading.
    Surge,
    /// Motion across the vessel's mean heading.
    Sway,
    /// Motion up and down.
    Heave,
    /// Rotation about the longitudinal axis.
    Roll,
    /// Rotation about the transverse axis.
    Pitch,
    /// Change of heading.
    Yaw,
}

impl MotionName {
    /// All six motions, in the order of the statistics of a run.
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
    /// Largest distance of the motion from its mean.
    Maximum,
    /// Mean of the highest third of the motion's peaks.
    Significant,
    /// Largest range of the motion from crest to trough.
    MaximumRange,
    /// Mean of the highest third of the motion's ranges.
    SignificantRange,
    /// Standard deviation of the motion.
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
    /// A value of the limited quantity as text, with its unit.
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
