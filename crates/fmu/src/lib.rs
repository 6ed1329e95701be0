//! Functional mock-up units (FMUs) for co-simulation: FMI 2.0 and FMI 3.0 from one table of variables.
//!
//! Two kinds. [`Kind::Engine`] is the contact engine for a master whose ships move elsewhere: their states go
//! in, wrenches and what each fender does come out. [`Kind::Simulation`] is a whole scenario: controls and
//! further forces go in, states and forces come out, the same bits as `fenderline run`.
//!
//! [`Bundle`] is a scenario with all that it names, the one resource of an FMU. Of it [`Table`] is made: each
//! variable with its unit, its start value and what it stands for. [`pack()`] writes the model description from
//! the table and puts bundle, description and shared library together; an instance reads and writes values
//! by the same table. The C functions (`fmi2`, `fmi3`) are a border, as in `fenderline-capi`: components and
//! saved states are numbers that are looked up, never followed as pointers, and no panic crosses.

#![allow(unsafe_code, reason = "masters give raw pointers; each block says why it is sound")]

#[cfg(not(panic = "unwind"))]
compile_error!("a panic must become a status: build this with panic = \"unwind\"");

mod border;
mod bundle;
mod bytes;
mod description;
mod engine;
pub mod fmi2;
pub mod fmi3;
mod hash;
mod inputs;
mod instance;
mod library;
mod outputs;
mod pack;
mod parameters;
mod plan;
mod registry;
mod simulation;
mod state;
mod table;
mod unit;

pub use bundle::{Bundle, BundleError};
pub use library::file_name as library_file_name;
pub use pack::{PackError, Packed, pack};
pub use plan::{Plan, PlanError};
pub use table::{Causality, Class, Kind, Table, Variable};
pub use unit::Unit;

/// A version of the standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fmi {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    Three,
}
