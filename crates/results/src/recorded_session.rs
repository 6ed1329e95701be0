//! A recorded session, for the results of a run that repeats it.

use crate::branch::BranchOutcome;

/// What a run repeats: a branch of a session that people steered.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedSession {
    /// Name of the recording's file, without its folder.
    pub file: String,
    /// Number of the branch.
    pub branch: usize,
    /// Number of branches that the session has.
    pub branches: usize,
    /// What is missing at the end of the recording; `None` for a complete one.
    pub missing_at_end: Option<String>,
    /// What was done and what happened, in the order of time.
    pub log: Vec<LogLine>,
    /// All branches beside each other; empty where there is only one.
    pub beside: Vec<BranchOutcome>,
}

/// A line of the log of a session.
#[derive(Clone, Debug, PartialEq)]
pub struct LogLine {
    /// When the entry was, or began (s).
    pub t_s: f64,
    /// When the entry ended (s); `None` for what has no length, and for an alarm whose cause was active at
    /// the end.
    pub until_s: Option<f64>,
    /// Kind of the entry.
    pub kind: LogKind,
    /// Who gave the command, acknowledged or dropped the note; empty for what happened.
    pub who: String,
    /// What the entry was.
    pub text: String,
    /// When an alarm was acknowledged (s), and by whom; `None` if nobody did, and for all else.
    pub acknowledged: Option<(f64, String)>,
    /// Equal for alarms of one kind about the same things; empty for all else.
    pub key: String,
}

/// The kind of a line of a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LogKind {
    /// A command of a person.
    Command,
    /// An alarm: it needed action.
    Alarm,
    /// A caution: it needed attention.
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
    /// The word of results and reports.
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
