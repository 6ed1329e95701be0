//! Makes functional mock-up units (FMUs) for co-simulation: FMI 2.0 and FMI 3.0 from one table of variables.
//!
//! There are two kinds. [`Kind::Engine`] is the contact engine for ships that other FMUs simulate: inputs are the
//! states of the ships, outputs are wrenches and fender data. [`Kind::Simulation`] is a whole scenario: inputs are
//! controls and external forces, outputs are states and forces, with the same bits as `fenderline run`.
//!
//! A [`Bundle`] is a scenario with all files that the scenario names, the only resource of an FMU. The [`Table`] of
//! variables is made from the bundle: it has each variable with unit, start value and meaning. [`pack()`] writes the
//! model description from the table of variables, and packs bundle, description and shared libraries, which
//! [`try_library()`] has tried; an instance reads and writes values by the same table. The C functions (`fmi2`, `fmi3`)
//! are a safe boundary, as in `fenderline-capi`: components and saved states are handles that are looked up and never
//! dereferenced, and no panic crosses the boundary.

#![allow(unsafe_code, reason = "masters give raw pointers; each unsafe block says why it is sound")]

#[cfg(not(panic = "unwind"))]
compile_error!("a panic must become a status: build the library with panic = \"unwind\"");

mod axes;
mod border;
mod bundle;
mod bytes;
mod description;
mod engine;
pub mod fmi2;
pub mod fmi3;
mod hash;
mod input;
mod inputs;
mod instance;
mod library;
mod logger;
mod outputs;
mod pack;
mod parameters;
mod plan;
mod registry;
mod simulation;
mod state;
mod status;
mod table;
mod trial;
mod unit;
mod view;

pub use bundle::{Bundle, BundleError};
pub use library::{
    Platform, STAMP as LIBRARY_STAMP, file_name as library_file_name, is_of_this_version,
};
pub use pack::{PackError, Packed, pack};
pub use plan::{Plan, PlanError};
pub use table::{Causality, Class, Kind, Table, Variable};
pub use trial::{TrialError, try_library, try_library_bytes};
pub use unit::Unit;

/// A version of the FMI standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fmi {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    Three,
}
