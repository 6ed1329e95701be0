//! A recorded session, for the results of a run that repeats it.

use crate::branch::BranchOutcome;

/// A recorded live session that a run repeats. People steered the session; the run repeats one branch of the session.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedSession {
    /// Name of the recording's file, without its folder.
    pub file: String,
    /// Number of the branch.
    pub branch: usize,
    /// Number of branches that the session has.
    pub branches: usize,
    /// What is missing at the end of the recording; `None` for a complete recording.
    pub missing_at_end: Option<String>,
    /// Commands and events, in the order of time.
    pub log: Vec<LogLine>,
    /// All branches for comparison; empty if there is only one branch.
    pub beside: Vec<BranchOutcome>,
}

/// A line of the log of a session.
#[derive(Clone, Debug, PartialEq)]
pub struct LogLine {
    /// Time of the entry, or of its beginning (s).
    pub t_s: f64,
    /// Time at which the entry ended (s); `None` for an entry without a length, and for an alarm whose cause was active
    /// at the end of the session.
    pub until_s: Option<f64>,
    /// Kind of the entry.
    pub kind: LogKind,
    /// Who gave the command, acknowledged the alarm or dropped the note; empty for events.
    pub who: String,
    /// What the entry was.
    pub text: String,
    /// Time at which an alarm was acknowledged (s), and the person; `None` if nobody acknowledged it, and for entries
    /// that are no alarms.
    pub acknowledged: Option<(f64, String)>,
    /// A key that is the same for all alarms of one kind about the same things; empty for entries that are no alarms.
    pub key: String,
}

/// The kind of a line of a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LogKind {
    /// A command of a person.
    Command,
    /// An alarm, which needed action.
    Alarm,
    /// A caution, which needed attention.
    Caution,
    /// Somebody acknowledged an alarm.
    Acknowledgement,
    /// A note for the debriefing.
    Note,
    /// A limit of the exercise was exceeded.
    Deduction,
    /// Any other event.
    Event,
}

impl LogKind {
    /// The word for the kind of entry in results and reports.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            LogKind::Command => "command",
            LogKind::Alarm => "alarm",
            LogKind::Caution => "caution",
            LogKind::Acknowledgement => "acknowledgement",
            LogKind::Note => "note",
            LogKind::Deduction => "deduction",
            LogKind::Event => "event",
        }
    }
}
