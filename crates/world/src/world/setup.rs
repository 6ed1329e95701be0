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
    /// How line handlers bring lines to a bollard.
    pub line_handling: LineHandling,
    /// Passing ships, and vessels that act on each other through the flow about them.
    pub flow: FlowSetup,
    /// Statistics of motions, and limits.
    pub statistics: StatisticsSetup,
    /// Programs that give forces on bodies.
    pub providers: Vec<ProviderSetup>,
    /// The chart that is drawn behind the bodies. It exerts no force.
    pub chart: Chart,
    /// The user's partial factors.
    pub factors: PartialFactors,
}

impl WorldSetup {
    /// True if the set-up has anything with a state.
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
    /// How long a step waits for the program's reply (s).
    pub timeout_s: f64,
    /// How long the last wrench is held when the program does not reply (s).
    pub hold_s: f64,
}
