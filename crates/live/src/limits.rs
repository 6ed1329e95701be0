//! Limits of a session and of its recording. The writer of a recording stops at the limits, and the reader refuses a
//! recording that is beyond them. Every recording that is written can therefore be replayed.

use std::fmt;

/// The largest recording (bytes). The limits on lines, commands and ticks allow recordings of some 300 MiB.
pub const LARGEST_RECORDING_BYTES: u64 = 512 << 20;
/// The longest first line of a recording (bytes): it holds a scenario with all files that the scenario names.
pub(crate) const LONGEST_HEADER_BYTES: u64 = 64 << 20;
/// The longest line of a recording other than the first (bytes). A message from a page has at most a quarter of this
/// length.
pub(crate) const LONGEST_LINE_BYTES: u64 = 64 << 10;
/// Largest number of commands of a session: ten a second for a day.
pub(crate) const MOST_COMMANDS: usize = 864_000;
/// Largest number of branches.
pub(crate) const MOST_BRANCHES: usize = 1000;
/// Largest number of ticks of all branches together: eleven days at 0.1 s.
pub(crate) const MOST_TICKS: u64 = 10_000_000;
/// Number of ticks from one `reached` line of a branch in a recording to the next. Two lines of a branch in a recording
/// are never more than this number of ticks apart. Because of these `reached` lines, a short recording cannot cause a
/// long run.
pub(crate) const MARKS: u64 = 10;

/// Largest number of orders in a trial, and of orders that a message gives together.
pub(crate) const MOST_TRIAL_ORDERS: usize = 16;

/// Largest number of planned events that may wait for their time.
pub(crate) const MOST_PLANNED: usize = 100;
/// The longest time from now to a planned event (s).
pub(crate) const LONGEST_PLAN_S: f64 = 86_400.0;

/// The longest name of a person (characters).
pub const LONGEST_NAME: usize = 30;

/// The longest note (characters).
pub(crate) const LONGEST_NOTE: usize = 300;
/// Largest number of notes that a branch may have within [`NOTE_TICKS`] ticks.
pub(crate) const MOST_NOTES: usize = 20;
/// The span of ticks in which notes are counted: ten seconds at steps of 0.1 s.
pub(crate) const NOTE_TICKS: u64 = 100;

/// The limit that a session has reached. A session at a limit can still be displayed, rewound and saved, but it cannot
/// go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Full {
    /// Size of the recording.
    Bytes,
    /// Number of ticks.
    Ticks,
}

impl fmt::Display for Full {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Full::Bytes => {
                let mib = LARGEST_RECORDING_BYTES >> 20;
                write!(f, "the recording has reached its limit of {mib} MiB")
            }
            Full::Ticks => write!(f, "the session has reached its limit of {MOST_TICKS} ticks"),
        }
    }
}

impl std::error::Error for Full {}
