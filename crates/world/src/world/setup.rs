//! The constant part of what surrounds the bodies: vessels, tugs, lines, anchors, environment and orders.

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
use crate::overhead::OverheadSetup;
use fenderline_ship::passing::FlowSetup;

/// Everything around the bodies of a [`crate::setup::Setup`]. The default has nothing around the bodies.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorldSetup {
    /// Wind, current and water.
    pub environment: Environment,
    /// Bodies that are vessels.
    pub vessels: Vec<VesselSetup>,
    /// Orders with the times at which they are given.
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
    /// How line handlers bring lines to the bollards.
    pub line_handling: LineHandling,
    /// Passing ships, and vessels that act on each other through the flow around the vessels.
    pub flow: FlowSetup,
    /// Statistics of motions, and limits on the results.
    pub statistics: StatisticsSetup,
    /// Programs that give forces on bodies.
    pub providers: Vec<ProviderSetup>,
    /// The chart that pages draw behind the bodies. The chart has no effect on forces.
    pub chart: Chart,
    /// Bridges and cables over the water, and the air draughts of the vessels.
    pub overhead: OverheadSetup,
    /// The user's partial factors.
    pub factors: PartialFactors,
}

impl WorldSetup {
    /// True if the set-up has anything that changes in a run.
    pub fn changes(&self) -> bool {
        !(self.vessels.is_empty() && self.lines.is_empty())
    }
}

/// A program that gives a force on a body in each step; see [`crate::external`].
#[derive(Clone, Debug, PartialEq)]
pub struct ProviderSetup {
    /// Index of the body in [`crate::setup::Setup::bodies`].
    pub body: usize,
    /// The program and its arguments.
    pub command: Vec<String>,
    /// Greatest time that a step waits for the program's reply (s).
    pub timeout_s: f64,
    /// Greatest time that the last force and moment continue to act if the program does not reply (s).
    pub hold_s: f64,
}
