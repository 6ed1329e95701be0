//! The results of a run: tables, events, totals, verdicts and `summary.json`. This crate reads and writes no files.
//!
//! [`Tables`] makes the rows of every step, or of every interval of several steps. A [`Medium`] decides how a table is
//! kept: the program writes files, [`InMemory`] keeps columns in memory. [`reference()`] lists every column with its
//! unit and meaning. [`Outcome`] is a run at its end; [`summary()`] and the report are made from the outcome.
//!
//! ```
//! # let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/paper/experiment_2_4kn.toml");
//! # let scenario = fenderline_scenario::Scenario::load(file.as_ref(), &[])?;
//! use fenderline_results::{InMemory, Tables};
//! let mut simulation = fenderline_sim::Simulation::new(scenario.setup)?;
//! let energy = simulation.energy();
//! let mut tables = Tables::start(&InMemory, simulation.setup(), energy, &scenario.output)?;
//! while !simulation.is_done() {
//!     tables.write(&simulation.step()?)?;
//! }
//! let tables = tables.finish()?;
//! assert_eq!((tables[0].name, tables[0].rows()), ("bodies", 2 * 200));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

mod accuracy;
mod branch;
mod columns;
mod events;
mod interval;
mod json;
mod medium;
mod memory;
mod outcome;
mod provider_notices;
mod quantities;
mod recorded_session;
mod row;
mod run_events;
mod summary;
mod tables;
mod touched;
mod verdict;
mod world_tables;
mod world_totals;

pub use accuracy::{ACCURACY, EstimateError, accuracy, accuracy_json, source_json};
pub use branch::{BranchOutcome, WayPoint};
pub use columns::{Column, ColumnReference, List, Names, TableReference, Value, reference};
pub use events::{event_key, world_event_key};
pub use json::{Json, NumberNotFinite, ToJson};
pub use medium::{Medium, Table};
pub use memory::{InMemory, KeptColumn, KeptTable, KeptValues, NotFinite, TableInMemory};
pub use outcome::{Interrupted, Outcome, WrittenFile};
pub use provider_notices::{ProviderNotice, ProviderNotices, provider_event_key};
pub use quantities::{
    ANCHORS, Amount, CHAINS, Catalogue, DOLPHINS, Digits, FENDERS, LINES, PAIRS, Printed, Quantity,
    Reported, Scale, Shown, TUGS, Taken, VESSELS, number, scales,
};
pub use recorded_session::{LogKind, LogLine, RecordedSession};
pub use run_events::{Events, is_plain};
pub use summary::{integrator_text, method_text, summary};
pub use tables::Tables;
pub use touched::{TouchedFender, add_parts, touched};
pub use verdict::{FenderVerdict, worst_first};
pub use world_totals::{
    AnchorTotals, AnchorVerdict, LineTotals, LineVerdict, PassingTotals, Peak, TugTotals,
    VesselTotals, Who, WorldEvents, WorldTotals,
};
