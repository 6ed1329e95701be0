//! The outcome of a run, from which summary, report and terminal text are made.

use fenderline_contact::BodyState;
use fenderline_sim::berthing::{BerthingError, BerthingOutcome};
use fenderline_sim::exercise::Assessment;
use fenderline_sim::statistics::Statistics;
use fenderline_sim::{
    DolphinSummary, Energy, FenderSummary, Finding, PairSummary, Setup, Simulation,
};

use crate::accuracy::EstimateError;
use crate::provider_notices::ProviderNotices;
use crate::recorded_session::RecordedSession;
use crate::run_events::Events;
use crate::world_totals::WorldTotals;

/// The time step and the time at which a run was interrupted.
#[derive(Clone, Debug, PartialEq)]
pub struct Interrupted {
    /// Steps taken.
    pub steps: u64,
    /// Number of time steps of the whole run.
    pub of_steps: u64,
    /// Time reached (s).
    pub at_s: f64,
    /// Length of the whole run (s).
    pub of_s: f64,
}

impl Interrupted {
    /// The step and the time at which a simulation is stopped.
    pub fn of(simulation: &Simulation) -> Interrupted {
        Interrupted {
            steps: simulation.steps_taken(),
            of_steps: simulation.steps_total(),
            at_s: simulation.time_s(),
            of_s: simulation.setup().duration_s,
        }
    }
}

/// The outcome of a run at its end.
#[derive(Clone, Debug)]
pub struct Outcome<'a> {
    /// The scenario's title.
    pub title: &'a str,
    /// Key and text of the lines of the report's title page, such as `client`.
    pub report: &'a [(&'static str, String)],
    /// Name of the scenario file, without its folder.
    pub scenario_file: &'a str,
    /// The recorded session that the run repeats; `None` for a run that nobody steered.
    pub session: Option<&'a RecordedSession>,
    /// The exercise at the end of the run; `None` if the scenario has none.
    pub exercise: Option<&'a Assessment>,
    /// The set-up.
    pub setup: &'a Setup,
    /// Notices of the scenario.
    pub notices: &'a [String],
    /// The step and the time at which the run was interrupted, if it was.
    pub interrupted: Option<Interrupted>,
    /// Number of steps taken.
    pub steps: u64,
    /// State of each body at the end.
    pub states: &'a [BodyState],
    /// Pairs that touched.
    pub pairs: &'a [PairSummary],
    /// The energy ledger at the end.
    pub energy: Energy,
    /// Contact events.
    pub events: &'a Events,
    /// The findings of the run, the worst first.
    pub findings: &'a [Finding],
    /// Fenders that were touched, in the order of the scenario.
    pub fenders: &'a [FenderSummary],
    /// The flexible dolphins, in the order of the scenario.
    pub dolphins: &'a [DolphinSummary],
    /// Berthing energy by formula and in the run; `None` if the scenario does not ask for it or no fender was touched.
    pub berthing: Option<Result<&'a BerthingOutcome, &'a BerthingError>>,
    /// Statistics of motions and mooring lines; `None` if the scenario does not ask for them.
    pub statistics: Option<&'a Statistics>,
    /// For each limit that the scenario sets to motions, lines or fenders: the value that the run reached.
    pub limit_values: &'a [f64],
    /// Vessels, tugs and lines.
    pub world: &'a WorldTotals,
    /// Events of force providers.
    pub providers: &'a ProviderNotices,
    /// Errors of the formulas that estimated vessel data, found on ships with known data; empty if no vessel was
    /// estimated by formulas with known errors.
    pub estimate_errors: &'a [EstimateError],
}

impl Outcome<'_> {
    /// The planned length of the run (s): the duration of the scenario, or the length of the branch of a recorded
    /// session.
    #[must_use]
    pub fn duration_s(&self) -> f64 {
        match (self.session, &self.interrupted) {
            (Some(_), None) => self.steps as f64 * self.setup.step_s,
            (_, _) => self.setup.duration_s,
        }
    }
}

/// A result file of the run and its number of rows, for the summary.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrittenFile {
    /// Name within the folder.
    pub name: String,
    /// Number of rows without the header; `None` if the file is not a table.
    pub rows: Option<u64>,
}
