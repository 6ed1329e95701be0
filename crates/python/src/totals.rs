//! Counts the events of a simulation and adds up totals, for the summary that `Simulation.summary_tree` returns.

use fenderline_results::{Events, Interrupted, Outcome, ProviderNotices, WorldTotals, summary};
use fenderline_scenario::Scenario;
use fenderline_sim::exercise::Assessment;
use fenderline_sim::{FenderSummary, Simulation, StepRecord};
use pyo3::prelude::*;

use crate::errors;

/// Counted events, and totals of vessels, tugs and lines.
#[derive(Clone)]
pub(crate) struct Totals {
    events: Events,
    world: WorldTotals,
    /// The exercise of the scenario, if there is one.
    exercise: Option<Assessment>,
    /// The lines of the title page of the run's report.
    report: Vec<(&'static str, String)>,
}

impl Totals {
    pub(crate) fn new(scenario: &Scenario, simulation: &Simulation) -> Totals {
        let exercise = scenario.exercise.clone();
        Totals {
            events: Events::default(),
            world: WorldTotals::new(&scenario.setup),
            exercise: exercise.map(|setup| Assessment::new(setup, simulation)),
            report: scenario.report.clone(),
        }
    }

    /// Adds one step.
    pub(crate) fn add(&mut self, step: &StepRecord<'_>) {
        self.events.count(step);
        self.world.add(step);
    }

    /// Updates the score of the exercise with the state of the simulation after a step.
    pub(crate) fn mark(&mut self, simulation: &Simulation) {
        if let Some(exercise) = &mut self.exercise {
            exercise.update(simulation);
        }
    }

    /// The tree of `summary.json` of a run up to now, without the list of files.
    pub(crate) fn tree<'py>(
        &self,
        py: Python<'py>,
        title: &str,
        notices: &[String],
        simulation: &Simulation,
    ) -> PyResult<Bound<'py, PyAny>> {
        let fenders: Vec<FenderSummary> = simulation.fender_summaries().cloned().collect();
        let findings = simulation.findings();
        let interrupted = (!simulation.is_done()).then(|| Interrupted::of(simulation));
        let outcome = Outcome {
            title,
            report: &self.report,
            scenario_file: "",
            session: None,
            exercise: self.exercise.as_ref(),
            setup: simulation.setup(),
            notices,
            interrupted,
            steps: simulation.steps_taken(),
            states: simulation.states(),
            pairs: simulation.pair_summaries(),
            energy: simulation.energy(),
            events: &self.events,
            findings: &findings,
            fenders: &fenders,
            dolphins: simulation.dolphin_summaries(),
            berthing: simulation.berthing(),
            statistics: simulation.statistics(),
            limit_values: &simulation.limit_values(),
            world: &self.world,
            providers: &ProviderNotices::default(),
            estimate_errors: &[],
        };
        let text =
            summary(&outcome, &[]).map_err(|error| errors::refused(py, error.to_string()))?;
        let tree = py.import("json")?.getattr("loads")?.call1((text,))?;
        // Those of a run that writes files.
        for key in ["files", "scenario_file"] {
            tree.del_item(key)?;
        }
        Ok(tree)
    }
}
