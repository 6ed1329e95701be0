//! A run when it is done, as summary, report and terminal see it.

use fenderline_contact::BodyState;
use fenderline_sim::berthing::{BerthingError, BerthingOutcome};
use fenderline_sim::{Energy, FenderSummary, PairSummary, Setup};

use super::Events;
use crate::provider::ProviderNotices;
use crate::world::WorldTotals;

/// A run when it is done.
#[derive(Clone, Debug)]
pub(crate) struct Outcome<'a> {
    /// The scenario's title.
    pub(crate) title: &'a str,
    /// Name of the scenario file, without its folder.
    pub(crate) scenario_file: &'a str,
    /// The set-up.
    pub(crate) setup: &'a Setup,
    /// Notices of the scenario.
    pub(crate) notices: &'a [String],
    /// Number of steps.
    pub(crate) steps: u64,
    /// States at the end, one a body.
    pub(crate) states: &'a [BodyState],
    /// Pairs that touched.
    pub(crate) pairs: &'a [PairSummary],
    /// The ledger at the end.
    pub(crate) energy: Energy,
    /// What happened.
    pub(crate) events: &'a Events,
    /// Fenders that were touched, in the order of the scenario.
    pub(crate) fenders: &'a [FenderSummary],
    /// The berthing by formula and in the run, where the scenario asks for it and a fender was touched.
    pub(crate) berthing: Option<Result<&'a BerthingOutcome, &'a BerthingError>>,
    /// Vessels, tugs and lines.
    pub(crate) world: &'a WorldTotals,
    /// What happened to the programs that put forces on bodies.
    pub(crate) providers: &'a ProviderNotices,
}
