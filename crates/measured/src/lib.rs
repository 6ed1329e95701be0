//! Measured berthings: from the logs of docking systems, tracks and AIS to the state of each ship at her first touch of
//! a fender, with uncertainties, and to a run from the measured state.
//!
//! [`read_log`] reads a log by a [`Mapping`]; [`berthings`] finds the berthings in logs; [`table()`] gives a row a
//! berthing, and [`page()`] the report. All functions are pure: no files, no clock.
//!
//! | step | module |
//! |---|---|
//! | keys of the mapping file | [`Mapping`] |
//! | tables and sentences become rows in SI units | `log` |
//! | rows become stretches of one ship without a pause | `stretch` |
//! | stretches become three channels over time, on a clock without jumps | `estimate/channels.rs` |
//! | the first touch is found | `estimate/find.rs` |
//! | parabolas through the readings before the touch | [`Parabola`] |
//! | state at the touch, with standard deviations | `estimate/touch.rs` |
//! | distances compared with the log's own speeds and angle | `estimate/checks.rs` |
//! | a track for a live session, without a run | [`ghost()`] |
//! | the run that starts some metres off, driven by nothing but the water | `run` |
#![forbid(unsafe_code)]

mod berthing;
mod curves;
mod estimate;
mod flag;
mod geometry;
mod ghost;
mod log;
mod mapping;
mod page;
mod remark;
mod run;
mod stretch;
mod table;

pub use berthing::{Berth, BerthError, BerthFor, Berthing, Berthings, berthings};
pub use curves::{Curves, Line};
pub use estimate::Uncertain;
pub use estimate::parabola::{FEWEST, Parabola};
pub use estimate::touch::Touch;
pub use flag::Flag;
pub use geometry::{BerthAxes, Lie, Motion, Nearest};
pub use ghost::{GhostError, GhostTrack, GhostWanted, ghost};
pub use log::{Log, LogKind, LogRow, LogsRead, Quantity, read_log};
pub use mapping::{Mapping, Sensor, ShipOfLog, mapping_schema};
pub use page::{Page, page};
pub use remark::{Remark, Weight};
pub use run::{FenderUse, Followed, Rerun};
pub use table::{table, time_text};
