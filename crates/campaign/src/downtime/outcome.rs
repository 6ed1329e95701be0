//! How the run of a state or hour ended.

/// How a run ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Within all limits.
    Works,
    /// The state or hour is lost: the names of the exceeded limits, the gravest first.
    Lost(Vec<String>),
    /// The run could not be made, or did not reach its end: nothing is known about the hours.
    NotRun,
}

impl Outcome {
    /// The gravest reason.
    #[must_use]
    pub fn reason(&self) -> Option<&str> {
        match self {
            Outcome::Lost(reasons) => reasons.first().map(String::as_str),
            Outcome::Works | Outcome::NotRun => None,
        }
    }
}
