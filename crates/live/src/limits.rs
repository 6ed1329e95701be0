//! What a session and its recording may be at most. One set of numbers for both: who writes a recording stops at them,
//! and who reads one refuses beyond them, so that whatever was recorded can be replayed.

use std::fmt;

/// The largest recording (bytes). All that the limits below allow comes to some 300 MiB.
pub const LARGEST_RECORDING_BYTES: u64 = 512 << 20;
/// The longest first line (bytes): a scenario with all the files that it names.
pub(crate) const LONGEST_HEADER_BYTES: u64 = 64 << 20;
/// The longest line of the others (bytes); a page's message is a quarter of that at most.
pub(crate) const LONGEST_LINE_BYTES: u64 = 64 << 10;
/// The most commands that a session takes: ten a second for a day.
pub(crate) const MOST_COMMANDS: usize = 864_000;
/// The most branches.
pub(crate) const MOST_BRANCHES: usize = 1000;
/// The most ticks of all branches together: at 0.1 s eleven days.
pub(crate) const MOST_TICKS: u64 = 10_000_000;
/// Ticks from one `reached` line of a branch to the next; between two lines of a branch there are never more, so that
/// a short text cannot ask for a long run.
pub(crate) const MARKS: u64 = 10;

/// The session has come to a limit: it can be looked at, rewound and saved, and goes on no more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Full {
    /// Of the recording's size.
    Bytes,
    /// Of ticks.
    Ticks,
}

impl fmt::Display for Full {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Full::Bytes => {
                let mib = LARGEST_RECORDING_BYTES >> 20;
                write!(f, "the recording has come to its limit of {mib} MiB")
            }
            Full::Ticks => write!(f, "the session has come to its limit of {MOST_TICKS} ticks"),
        }
    }
}

impl std::error::Error for Full {}
