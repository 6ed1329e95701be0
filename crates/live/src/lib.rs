//! A simulation that people steer: a deterministic session without clock, threads, sockets or files.
//!
//! A [`Session`] consists of a scenario ([`Source`]) and a log of commands, each with its tick and its author. The
//! scenario and the log of commands determine every state of the session, bit for bit. A session can therefore be
//! rewound, branched from any tick, recorded line by line ([`RecordingReader`]) and replayed ([`Replay`]). This crate
//! also makes the messages that pages of the browser get ([`message`]) and reads the requests of pages ([`Request`]).
//!
//! When the session is over, a [`Repeat`] steps through one of its branches from the start and keeps the log: commands,
//! alarms, acknowledgements, notes and events.
//!
//! [`Watched`] makes the same messages to pages for a run that nobody steers.
//!
//! The owner of a session decides when the session takes a step. `fenderline serve` paces the session to wall time.
#![forbid(unsafe_code)]

mod action;
mod alarm_book;
mod approach;
mod berth;
mod bits;
mod carry_out;
mod cast;
mod chart_info;
mod checkpoints;
mod exercise;
mod frame;
mod frozen;
mod ghost;
mod happening;
mod info;
mod library_info;
mod limits;
mod manual_control;
pub mod message;
mod named_order;
mod now;
mod order_info;
mod outlook;
mod pair;
mod past;
mod place;
mod plan;
mod prediction;
mod present;
mod recording;
mod refusal;
mod repeat;
mod replay;
mod request;
mod script;
mod session;
mod shown;
mod source;
mod speeds;
mod trial;
#[cfg(test)]
mod typescript;
mod watched;
mod word;
mod world_change;

pub use action::{Action, AnchorFault, COMMAND_LIMITS, CommandLimits, OtherAction};
pub use alarm_book::{Alarm, AlarmBook, Level};
pub use approach::{ApproachLimit, Light};
pub use berth::berth_info;
pub use cast::{Cast, Helm};
pub use fenderline_sim::Fault;
pub use ghost::{Ghost, GhostError};
pub use info::Info;
pub use library_info::library_info;
pub use limits::{Full, LARGEST_RECORDING_BYTES, LONGEST_NAME};
pub use named_order::NamedOrder;
pub use order_info::order_infos;
pub use outlook::Outlook;
pub use prediction::{MOST_PATHS, Prediction};
pub use present::{INTO_A_SESSION, PresentFile};
pub use recording::{
    CopyError, Ending, Fault as RecordingFault, Line, Outline, RecordingError, RecordingReader,
    begins_recording, copy_kept,
};
pub use refusal::Refusal;
pub use repeat::{
    LoggedAcknowledgement, LoggedAlarm, LoggedCommand, LoggedNote, Repeat, SessionLog,
};
pub use replay::{Replay, ReplayError, Replayed};
pub use request::{Conduct, Control, Creation, Request};
pub use session::{Branch, Session, SessionError, StepError};
pub use shown::Shown;
pub use source::Source;
pub use speeds::Speeds;
pub use trial::Trial;
pub use watched::Watched;
