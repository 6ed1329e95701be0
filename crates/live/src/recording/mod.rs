//! Recordings: a session as lines of JSON. The first line has the scenario. The last line ends the session. Each line
//! in between is a command, a new branch or a mark of progress. Lines are only appended: if the writer is killed, at
//! most the last line is lost.
//!
//! Every line ends with a check sum of itself and all lines before it (`sealed`). The check sum reveals lines that were
//! changed, removed, repeated or moved. The sequence of lines is also checked (`shape`) before anything is replayed.

mod copy;
mod ending;
mod error;
mod outline;
mod reader;
mod sealed;
mod shape;
mod writer;

use serde::{Deserialize, Serialize};

use crate::action::Action;
use crate::source::Source;

pub use copy::{CopyError, copy_kept};
pub use ending::Ending;
pub use error::{Fault, RecordingError};
pub use outline::Outline;
pub use reader::RecordingReader;
pub(crate) use sealed::Chain;
pub(crate) use writer::Writer;

/// Number of the format. A file with another number is refused.
const FORMAT: u32 = 3;
/// The beginning of a recording, up to the number of the format.
const BEGINNING: &str = "{\"fenderline_session\":";

/// The first line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Header {
    fenderline_session: u32,
    /// Version of the program that recorded the session. Other versions may compute other bits.
    version: String,
    source: Source,
}

/// Any line except the first.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "line", rename_all = "snake_case", deny_unknown_fields)]
pub enum Line {
    /// A command.
    Command {
        /// The branch in which it was given.
        branch: usize,
        /// The tick from which it takes effect.
        tick: u64,
        /// Who gave it.
        who: String,
        /// Time of the server's clock (ms since 1970). A replay does not use it.
        at_ms: u64,
        /// The command.
        action: Action,
    },
    /// A branch began.
    Branch {
        /// Number of the new branch: one more than that of the last branch.
        id: usize,
        /// The branch from which the new branch begins.
        parent: usize,
        /// First tick of the new branch.
        from_tick: u64,
    },
    /// A branch has reached a tick.
    Reached {
        /// The branch.
        branch: usize,
        /// The tick.
        tick: u64,
        /// Fingerprint of the state before the commands of that tick, in hexadecimal.
        bits: String,
    },
    /// The session ended or was saved. No line follows.
    End {},
}

impl Line {
    /// The JSON of the line, without a check sum.
    fn json(&self) -> String {
        serde_json::to_string(self).unwrap_or_else(|e| unreachable!("{e}"))
    }
}

/// True if a file begins like a recording.
#[must_use]
pub fn begins_recording(bytes: &[u8]) -> bool {
    bytes.starts_with(BEGINNING.as_bytes())
}
