//! The constant part of a world.

use super::environment::Environment;
use super::line::MooringSetup;
use super::tug::TugSetup;
use super::vessel::VesselSetup;
use crate::order::Order;

/// What surrounds the bodies of a [`crate::Setup`]; empty by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorldSetup {
    /// Wind, current and water.
    pub environment: Environment,
    /// Bodies that are vessels.
    pub vessels: Vec<VesselSetup>,
    /// Timed orders to the vessels.
    pub orders: Vec<Order>,
    /// Vector tugs.
    pub tugs: Vec<TugSetup>,
    /// Mooring lines.
    pub lines: Vec<MooringSetup>,
    /// Programs that put forces on bodies.
    pub providers: Vec<ProviderSetup>,
}

impl WorldSetup {
    /// Has it anything that changes in a step?
    pub(crate) fn changes(&self) -> bool {
        !(self.vessels.is_empty() && self.lines.is_empty())
    }
}

/// A program that puts a force on a body each step: see [`crate::external`].
#[derive(Clone, Debug, PartialEq)]
pub struct ProviderSetup {
    /// Index of the body in [`crate::Setup::bodies`].
    pub body: usize,
    /// Program and arguments.
    pub command: Vec<String>,
    /// How long a step waits for its answer (s).
    pub timeout_s: f64,
    /// How long its last wrench is held when it falls silent (s).
    pub hold_s: f64,
}
