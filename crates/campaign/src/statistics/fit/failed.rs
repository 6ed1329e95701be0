//! A fit that failed.

use core::fmt;

use super::error::FitFault;
use super::laws::Law;

/// A fit that failed.
#[derive(Clone, Debug, PartialEq)]
pub struct FitError {
    /// The law.
    pub law: Law,
    /// The reason.
    pub fault: FitFault,
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.law.title(), self.fault)
    }
}

impl std::error::Error for FitError {}
