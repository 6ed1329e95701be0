//! Reasons why a fit fails.

use core::fmt;

/// The reason why a fit failed.
#[derive(Clone, Debug, PartialEq)]
pub enum FitFault {
    /// The sample has fewer values than the fit needs (above the threshold, if there is a threshold).
    TooFew {
        /// How many there are.
        count: usize,
        /// How many are needed.
        needed: usize,
    },
    /// The law has positive values only.
    NotPositive {
        /// The smallest value.
        least: f64,
        /// Number of values that are not positive.
        count: usize,
    },
    /// All values are equal.
    Constant,
    /// A fit over a threshold needs a threshold.
    NoThreshold,
    /// The values have weights.
    Weighted,
    /// The likelihood did not reach a maximum within the largest number of steps.
    NotConverged {
        /// Steps that were made.
        steps: usize,
    },
    /// The likelihood is flat or has no maximum, so no standard error exists.
    Flat,
    /// The tail is so short that the likelihood has no regular maximum (Smith, Biometrika 72, 1985).
    Irregular {
        /// Shape ξ.
        shape: f64,
    },
}

impl fmt::Display for FitFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FitFault::TooFew { count, needed } => {
                write!(f, "at least {needed} values are needed, but there are {count}")
            }
            FitFault::NotPositive { least, count } => {
                write!(f, "the law has positive values only; {count} of the values are not \
                    positive, the smallest is {least}")
            }
            FitFault::Constant => f.write_str("all values are equal"),
            FitFault::NoThreshold => f.write_str("it needs a threshold"),
            FitFault::Weighted => f.write_str(
                "runs of importance sampling are not fitted: their weighted share above a value is the estimate",
            ),
            FitFault::NotConverged { steps } => {
                write!(f, "the likelihood did not settle in {steps} steps")
            }
            FitFault::Flat => f.write_str("the likelihood has no maximum that the values determine"),
            FitFault::Irregular { shape } => write!(
                f,
                "its shape {shape:.2} is below −0.5: the likelihood has no regular maximum, and no band exists"
            ),
        }
    }
}
