//! The error of a text that is not a quantity.

/// Says why a text is not a quantity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitError {
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub help: Option<String>,
}

impl UnitError {
    pub(super) fn new(message: impl Into<String>) -> UnitError {
        UnitError { message: message.into(), help: None }
    }

    pub(super) fn with_help(message: impl Into<String>, help: impl Into<String>) -> UnitError {
        UnitError { message: message.into(), help: Some(help.into()) }
    }
}
