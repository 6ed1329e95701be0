//! An estimate with its confidence interval.

use core::fmt;
use core::str::FromStr;

use super::normal;

/// A closed interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

impl Interval {
    /// Whether a value lies in the interval.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }
}

/// A value that was estimated, with its confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The estimate.
    pub value: f64,
    /// Interval of the estimate.
    pub interval: Interval,
}

/// The confidence level of two-sided intervals: a number between 0.5 and 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Confidence(f64);

/// A confidence level that is not between 0.5 and 0.999999.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotAConfidence;

impl fmt::Display for NotAConfidence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a confidence is a number from 0.5 to 0.999999, such as 0.95")
    }
}

impl std::error::Error for NotAConfidence {}

impl Confidence {
    /// 95 %.
    pub const USUAL: Confidence = Confidence(0.95);

    /// A level.
    ///
    /// # Errors
    /// Fails if the level is below 0.5 or above 0.999999.
    pub fn new(level: f64) -> Result<Confidence, NotAConfidence> {
        if (0.5..=0.999_999).contains(&level) { Ok(Confidence(level)) } else { Err(NotAConfidence) }
    }

    /// The level.
    #[must_use]
    pub fn level(self) -> f64 {
        self.0
    }

    /// Probability outside the interval on each side.
    #[must_use]
    pub fn tail(self) -> f64 {
        0.5 * (1.0 - self.0)
    }

    /// Half the width of the interval of a standard normal variable: 1.96 for 95 %.
    #[must_use]
    pub fn normal_quantile(self) -> f64 {
        normal::value_exceeded(self.tail())
    }
}

impl FromStr for Confidence {
    type Err = NotAConfidence;

    fn from_str(text: &str) -> Result<Confidence, NotAConfidence> {
        Confidence::new(text.parse().map_err(|_| NotAConfidence)?)
    }
}
