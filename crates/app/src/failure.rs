//! Why the program ends without a result, and its exit code.

use core::fmt;

use crate::output::OutputError;

/// The exit code of a run that was interrupted.
pub(crate) const INTERRUPTED: u8 = 130;

/// The way in which a command ended that did not succeed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Failure {
    /// The user's input cannot be used: exit code 2.
    Input(String),
    /// The input can be used, but the run failed: exit code 1.
    Case(String),
    /// The user interrupted the command, and the results up to then were written: exit code 130, as for a program that
    /// SIGINT ended.
    Interrupted,
    /// The reader of the output closed the output early, as `head` does. A reader that closes the output early is no
    /// failure: exit code 0.
    ReaderGone,
}

impl Failure {
    /// Makes a failure for input that is refused with the message `error`.
    pub(crate) fn input(error: impl fmt::Display) -> Failure {
        Failure::Input(error.to_string())
    }

    /// Makes a failure for a run that failed with the message `error`.
    pub(crate) fn case(error: impl fmt::Display) -> Failure {
        Failure::Case(error.to_string())
    }

    /// The program's exit code.
    pub(crate) fn exit_code(&self) -> u8 {
        match self {
            Failure::Input(_) => 2,
            Failure::Case(_) => 1,
            Failure::Interrupted => INTERRUPTED,
            Failure::ReaderGone => 0,
        }
    }

    /// The error text to print, if there is any.
    pub(crate) fn message(&self) -> Option<&str> {
        match self {
            Failure::Input(text) | Failure::Case(text) => Some(text),
            Failure::Interrupted | Failure::ReaderGone => None,
        }
    }
}

impl From<OutputError> for Failure {
    fn from(error: OutputError) -> Failure {
        if error.is_refused() { Failure::input(error) } else { Failure::case(error) }
    }
}
