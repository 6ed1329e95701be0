//! Errors of recordings.

use std::fmt;

use super::FORMAT;
use crate::limits::LARGEST_RECORDING_BYTES;

/// An invalid recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecordingError {
    /// Number of the line, from 1.
    pub line: usize,
    /// The fault of the line.
    pub fault: Fault,
}

/// A fault of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The file cannot be read. The text is the system's message.
    Unreadable(String),
    /// The file does not begin like a recording.
    NoRecording,
    /// The first line, which contains the scenario, is cut off. Nothing can be replayed.
    NoFirstLine,
    /// The recording has another format. The text is the number of the format.
    Format(String),
    /// The line is too long. The number is the limit (bytes).
    TooLong(u64),
    /// The recording is too large.
    TooLarge,
    /// The check sum is wrong. This line was changed, or lines before it were changed, removed, repeated or moved.
    Damaged,
    /// There are lines after the line that ends the recording.
    AfterEnd,
    /// The check sum is right, but the line is invalid. The text is the reason.
    Invalid(String),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Unreadable(why) => f.write_str(why),
            Fault::NoRecording => f.write_str("it is not a recording of a session"),
            Fault::NoFirstLine => f.write_str(
                "the recording is cut off within its first line, which has the scenario: nothing of it can be played",
            ),
            Fault::Format(other) => {
                write!(f, "it has format {other}, but this program reads {FORMAT}")
            }
            Fault::TooLong(most) => write!(f, "it is longer than the limit of {most} bytes"),
            Fault::TooLarge => {
                let mib = LARGEST_RECORDING_BYTES >> 20;
                write!(f, "the recording is larger than the limit of {mib} MiB")
            }
            Fault::Damaged => {
                f.write_str("the recording is damaged: the check sum of the line is wrong")
            }
            Fault::AfterEnd => {
                f.write_str("the recording is damaged: there are lines after its end")
            }
            Fault::Invalid(why) => write!(f, "the line is invalid: {why}"),
        }
    }
}

impl fmt::Display for RecordingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.fault)
    }
}

impl std::error::Error for RecordingError {}
