//! A session as lines of JSON: the first tells where it began, each later one what was commanded, branched or
//! reached, and the last that it ended. Lines are only ever added, so that a file of them loses nothing when its writer
//! is killed but what was torn off its last line.
//!
//! Every line ends with a check sum of itself and all lines before it (`sealed`): a line that was changed, removed,
//! repeated or put elsewhere is found. What a line may say after those before it is checked too (`shape`), before
//! anything is played.

mod copy;
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
pub use error::{Fault, RecordingError};
pub use outline::{Ending, Outline};
pub use reader::RecordingReader;
pub(crate) use sealed::Chain;
pub(crate) use writer::Writer;

/// The format's number; a file with another one is refused.
const FORMAT: u32 = 3;
/// What a recording begins with, up to the format's number.
const BEGINNING: &str = "{\"fenderline_session\":";

/// The first line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
        /// When, by the server's clock (ms since 1970); the replay does not ask for it.
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
    /// The session was ended, or saved: nothing follows.
    End {},
}

impl Line {
    /// As JSON, without a check sum.
    fn json(&self) -> String {
        serde_json::to_string(self).unwrap_or_else(|e| unreachable!("{e}"))
    }
}

/// Does a file begin as a recording does?
#[must_use]
pub fn begins_recording(bytes: &[u8]) -> bool {
    bytes.starts_with(BEGINNING.as_bytes())
}
