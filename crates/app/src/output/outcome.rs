//! A run when it has ended, as summary, report and terminal see it.

use fenderline_contact::BodyState;
use fenderline_scenario::printable_number;
use fenderline_sim::berthing::{BerthingError, BerthingOutcome};
use fenderline_sim::{Energy, FenderSummary, PairSummary, Setup, Simulation};

use super::Events;
use crate::provider::ProviderNotices;
use crate::world::WorldTotals;

/// Where a run was interrupted.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Interrupted {
    /// Steps taken.
    steps: u64,
    /// Steps of the whole run.
    of_steps: u64,
    /// Time reached (s).
    at_s: f64,
    /// Length of the whole run (s).
    of_s: f64,
}

impl Interrupted {
    /// A simulation that does not go on.
    pub(crate) fn of(simulation: &Simulation) -> Interrupted {
        Interrupted {
            steps: simulation.steps_taken(),
            of_steps: simulation.steps_total(),
            at_s: simulation.time_s(),
            of_s: simulation.setup().duration_s,
        }
    }

    /// In words.
    pub(crate) fn text(&self) -> String {
        let Interrupted { steps, of_steps, at_s, of_s } = self;
        let (at_s, of_s) = (printable_number(*at_s), printable_number(*of_s));
        format!(
            "ended by its user after {steps} of {of_steps} steps, at {at_s} of {of_s} s; results are those up to there"
        )
    }
}

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
    /// Where it was interrupted, if it was.
    pub(crate) interrupted: Option<Interrupted>,
    /// Number of steps taken.
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
