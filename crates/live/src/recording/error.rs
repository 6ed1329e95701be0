//! Errors of recordings.

use std::fmt;

use super::FORMAT;
use crate::limits::LARGEST_RECORDING_BYTES;

/// An invalid recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecordingError {
    /// Number of the faulty line, counted from 1.
    pub line: usize,
    /// What is wrong with the line.
    pub fault: Fault,
}

/// What is wrong with a line of a recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The recording's file cannot be read. The text is the operating system's message.
    Unreadable(String),
    /// The file does not begin like a recording.
    NoRecording,
    /// The first line, which contains the scenario, is cut off. Nothing can be replayed.
    NoFirstLine,
    /// The recording has another format. The text is the number of the recording's format.
    Format(String),
    /// A line of the recording is too long. The number is the limit of a line's length (bytes).
    TooLong(u64),
    /// The recording is too large.
    TooLarge,
    /// The check sum of a line is wrong. Either the line itself was changed, or lines before it were changed, removed,
    /// repeated or moved.
    Damaged,
    /// There are lines after the line that ends the recording.
    AfterEnd,
    /// The check sum of a line is right, but the line is invalid. The text says why the line is invalid.
    Invalid(String),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Unreadable(why) => f.write_str(why),
            Fault::NoRecording => f.write_str("the file is not a recording of a session"),
            Fault::NoFirstLine => f.write_str(
                "the recording is cut off within its first line, which has the scenario, so that nothing of it \
                 can be played",
            ),
            Fault::Format(other) => {
                write!(f, "the recording has format {other}, but this program reads format {FORMAT}")
            }
            Fault::TooLong(most) => write!(f, "the line is longer than the limit of {most} bytes"),
            Fault::TooLarge => {
                let mib = LARGEST_RECORDING_BYTES >> 20;
                write!(f, "the recording is larger than the limit of {mib} MiB")
            }
            Fault::Damaged => {
                f.write_str("the recording is damaged: the check sum of the line is wrong")
            }
            Fault::AfterEnd => {
                f.write_str("the recording is damaged: it has lines after its end")
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
