//! A recording is a session written as lines of JSON. The first line of a recording has the scenario. The last line of
//! a recording ends the session. Each line between the first and the last is a command, a new branch or a mark of
//! progress. Lines are only appended to a recording: if the writer is killed, at most the last line is lost.
//!
//! Every line ends with a check sum of this line and all lines before it (`sealed`). The check sum reveals lines that
//! were changed, removed, repeated or moved. The sequence of lines is also checked (`shape`) before anything of a
//! recording is replayed.

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

/// Number of the format. A recording whose format has another number is refused.
const FORMAT: u32 = 3;
/// The beginning of a recording's text, up to the number of the format.
const BEGINNING: &str = "{\"fenderline_session\":";

/// The first line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Header {
    fenderline_session: u32,
    /// Version of the program that recorded the session. Other versions of the program may compute other bits.
    version: String,
    source: Source,
}

/// Any line of a recording except the first.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "line", rename_all = "snake_case", deny_unknown_fields)]
pub enum Line {
    /// A command.
    Command {
        /// The branch in which the command was given.
        branch: usize,
        /// The tick from which the command takes effect.
        tick: u64,
        /// Who gave it.
        who: String,
        /// Time of the server's clock when the command was given (ms since 1970). A replay does not use the server's
        /// times.
        at_ms: u64,
        /// The command.
        action: Action,
    },
    /// A branch began.
    Branch {
        /// Number of the new branch: one more than that of the last branch.
        id: usize,
        /// Number of the branch from which the new branch begins.
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
        /// Fingerprint, in hexadecimal, of the state before the commands of the reached tick.
        bits: String,
    },
    /// The session ended or was saved as a recording. No line follows.
    End {},
}

impl Line {
    /// The JSON of a line, without its check sum.
    fn json(&self) -> String {
        serde_json::to_string(self).unwrap_or_else(|e| unreachable!("{e}"))
    }
}

/// True if a file begins as a recording does.
#[must_use]
pub fn begins_recording(bytes: &[u8]) -> bool {
    bytes.starts_with(BEGINNING.as_bytes())
}
