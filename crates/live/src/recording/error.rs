//! What makes a file no recording that can be played.

use std::fmt;

use super::FORMAT;
use crate::limits::LARGEST_RECORDING_BYTES;

/// A recording that is refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecordingError {
    /// Which line, from 1.
    pub line: usize,
    /// What is wrong with it.
    pub fault: Fault,
}

/// What is wrong with a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The file could not be read on: the system's text.
    Unreadable(String),
    /// It does not begin as a recording does, or not even its first line is whole.
    NoRecording,
    /// It is of another format: its number.
    Format(String),
    /// It is longer than any line is written; how long it may be (bytes).
    TooLong(u64),
    /// The recording is larger than any is written.
    TooLarge,
    /// Its check sum is not that of what stands there: it was changed, or lines before it were changed, removed,
    /// repeated or put elsewhere.
    Damaged,
    /// Something follows the end.
    AfterEnd,
    /// Its check sum is right and it is none of ours: why.
    NotOurs(String),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Unreadable(why) => f.write_str(why),
            Fault::NoRecording => f.write_str("it is no recording of a session"),
            Fault::Format(other) => {
                write!(f, "it has format {other}, but this program reads {FORMAT}")
            }
            Fault::TooLong(most) => write!(f, "it is longer than {most} bytes, as no line is"),
            Fault::TooLarge => {
                let mib = LARGEST_RECORDING_BYTES >> 20;
                write!(f, "the recording is larger than {mib} MiB, as none is written")
            }
            Fault::Damaged => f.write_str(
                "the recording is damaged: the line's check sum is not that of what stands there",
            ),
            Fault::AfterEnd => {
                f.write_str("the recording is damaged: something follows the line that ends it")
            }
            Fault::NotOurs(why) => write!(f, "no session says this: {why}"),
        }
    }
}

impl fmt::Display for RecordingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.fault)
    }
}

impl std::error::Error for RecordingError {}
