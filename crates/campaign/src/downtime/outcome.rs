//! How the run of a state or hour ended.

/// How a run ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Within all limits.
    Works,
    /// Beyond limits: their names, the gravest first.
    Lost(Vec<String>),
    /// The run could not be made, or not to its end: nothing is known.
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
