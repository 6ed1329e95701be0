//! The constant part of a world.

use super::anchor::AnchorSetup;
use super::bollard::{BollardSetup, LineHandling};
use super::environment::Environment;
use super::line::MooringSetup;
use super::tug::TugSetup;
use super::vessel::VesselSetup;
use crate::change::PlannedChange;
use crate::chart::Chart;
use crate::factors::PartialFactors;
use crate::limit::StatisticsSetup;
use crate::order::Order;
use fenderline_ship::passing::FlowSetup;

/// Everything around the bodies of a [`crate::setup::Setup`]; empty by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorldSetup {
    /// Wind, current and water.
    pub environment: Environment,
    /// Bodies that are vessels.
    pub vessels: Vec<VesselSetup>,
    /// Timed orders.
    pub orders: Vec<Order>,
    /// Changes of weather and faults at times of the run.
    pub planned: Vec<PlannedChange>,
    /// Vector tugs.
    pub tugs: Vec<TugSetup>,
    /// Mooring lines.
    pub lines: Vec<MooringSetup>,
    /// Anchors.
    pub anchors: Vec<AnchorSetup>,
    /// Bollards to which orders send lines.
    pub bollards: Vec<BollardSetup>,
    /// How lines come to a bollard.
    pub line_handling: LineHandling,
    /// Ships that pass, and vessels that act on each other by the flow about them.
    pub flow: FlowSetup,
    /// Statistics of motions, and limits.
    pub statistics: StatisticsSetup,
    /// Programs that give forces on bodies.
    pub providers: Vec<ProviderSetup>,
    /// What is drawn behind the bodies. It exerts no force.
    pub chart: Chart,
    /// Partial factors of the user's own.
    pub factors: PartialFactors,
}

impl WorldSetup {
    /// True if it has anything with a state.
    pub fn changes(&self) -> bool {
        !(self.vessels.is_empty() && self.lines.is_empty())
    }
}

/// A program that gives a force on a body in each step: see [`crate::external`].
#[derive(Clone, Debug, PartialEq)]
pub struct ProviderSetup {
    /// Index of the body in [`crate::setup::Setup::bodies`].
    pub body: usize,
    /// Program and arguments.
    pub command: Vec<String>,
    /// How long a step waits for its reply (s).
    pub timeout_s: f64,
    /// How long its last wrench is held when it does not reply (s).
    pub hold_s: f64,
}
