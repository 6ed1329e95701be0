//! A session as lines of JSON: the first tells where it began, each later one what was commanded, branched or
//! reached. Lines are only ever added, so that a file of them loses nothing when its writer is killed but what was
//! torn off its last line.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::action::Action;
use crate::source::Source;

/// The format's number; a file with another one is refused.
const FORMAT: u32 = 1;

/// The first line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Header {
    fenderline_session: u32,
    /// Of the program that recorded it: another one may make other bits.
    version: String,
    source: Source,
}

/// Every line but the first.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "line", rename_all = "snake_case", deny_unknown_fields)]
pub enum Line {
    /// A command.
    Command {
        /// The branch that it was given in.
        branch: usize,
        /// The tick in which it counts.
        tick: u64,
        /// Who gave it.
        who: String,
        /// When, by the server's clock [ms since 1970]; the replay does not ask for it.
        at_ms: u64,
        /// What.
        action: Action,
    },
    /// A branch began.
    Branch {
        /// Its number, one above that of the last.
        id: usize,
        /// The branch that it left.
        parent: usize,
        /// Where.
        from_tick: u64,
    },
    /// A branch has come to a tick.
    Reached {
        /// Which.
        branch: usize,
        /// The tick.
        tick: u64,
        /// The state's fingerprint there, in hexadecimal, before that tick's commands.
        bits: String,
    },
}

/// A recording that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// The version of the program that recorded it.
    pub version: String,
    /// Where it began.
    pub source: Source,
    /// What happened, with the number of each line in the file.
    pub lines: Vec<(usize, Line)>,
    /// Length in bytes of what was read: a torn last line is not part of it.
    pub whole_bytes: usize,
    /// Bytes of a last line that was torn off, and dropped.
    pub torn_bytes: usize,
}

/// A text that is no recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecordingError {
    /// Which line, from 1.
    pub line: usize,
    /// What is wrong with it.
    pub message: String,
}

impl fmt::Display for RecordingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.message)
    }
}

impl std::error::Error for RecordingError {}

impl Recording {
    /// The first line of a recording, with its end.
    ///
    /// # Panics
    /// Never: text and numbers always have a JSON.
    #[must_use]
    pub fn header(source: &Source) -> String {
        let header = Header {
            fenderline_session: FORMAT,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            source: source.clone(),
        };
        let text = serde_json::to_string(&header).unwrap_or_else(|e| unreachable!("{e}"));
        text + "\n"
    }

    /// Does a text begin as a recording does?
    #[must_use]
    pub fn is_one(text: &str) -> bool {
        text.starts_with("{\"fenderline_session\":")
    }

    /// Reads a recording. A last line without its end was torn by a writer that was killed: it is dropped.
    ///
    /// # Errors
    /// The first line that is none.
    pub fn parse(text: &str) -> Result<Recording, RecordingError> {
        let whole_bytes = text.rfind('\n').map_or(0, |end| end + 1);
        let torn_bytes = text.len() - whole_bytes;
        let mut lines = text[..whole_bytes].lines().enumerate();
        let error = |line, message: String| RecordingError { line, message };
        let Some((_, first)) = lines.next() else {
            return Err(error(1, "a recording begins with a line of its own".to_owned()));
        };
        let header: Header =
            serde_json::from_str(first).map_err(|e| error(1, format!("no recording: {e}")))?;
        if header.fenderline_session != FORMAT {
            let other = header.fenderline_session;
            return Err(error(1, format!("format {other}, but this program reads {FORMAT}")));
        }
        let lines = lines.map(|(index, text)| {
            let line: Line =
                serde_json::from_str(text).map_err(|e| error(index + 1, e.to_string()))?;
            Ok((index + 1, line))
        });
        Ok(Recording {
            version: header.version,
            source: header.source,
            lines: lines.collect::<Result<_, _>>()?,
            whole_bytes,
            torn_bytes,
        })
    }
}

impl Line {
    /// As text, with its end.
    pub(crate) fn text(&self) -> String {
        let text = serde_json::to_string(self).unwrap_or_else(|e| unreachable!("{e}"));
        text + "\n"
    }
}
