//! Logs: tables of docking systems and tracks, and sentences of instruments and AIS receivers.

mod clock;
mod column;
mod columns;
mod read;
mod row;
mod sentences;
mod table;

pub use read::read_log;
pub use row::{Log, LogKind, LogRow, LogsRead, Quantity};
