//! Variants of a scenario: the same bodies, fenders and controls with other numbers.

use std::sync::Arc;

use fenderline_scenario::{self as scenario, Override, ScenarioError};
use fenderline_sim::Setup;
use pyo3::prelude::*;

use crate::controls::{Control, controls};
use crate::errors;
use crate::run::{CannotRun, Run};
use crate::scenario::{Scenario, Source, overrides};
use crate::simulation::cannot_run;

/// A scenario, and the controls that its variants share.
pub(crate) struct Common {
    source: Source,
    pub(crate) base: Arc<scenario::Scenario>,
    pub(crate) controls: Arc<Vec<Control>>,
}

/// The reason why a variant cannot be run.
pub(crate) enum NoRun {
    Scenario(ScenarioError),
    Cannot(CannotRun),
    /// Its bodies, fenders or controls differ from the scenario's.
    Other(&'static str),
}

impl Common {
    pub(crate) fn of(scenario: &Scenario) -> Common {
        let base = Arc::clone(&scenario.checked);
        let controls = Arc::new(controls(&base.setup));
        Common { source: scenario.source.clone(), base, controls }
    }

    /// A run of the variant with these overrides.
    pub(crate) fn run(&self, set: &[Override]) -> Result<Run, NoRun> {
        let varied;
        let scenario = match set {
            [] => &*self.base,
            _ => {
                varied = self.source.check(set).map_err(NoRun::Scenario)?;
                &varied
            }
        };
        let (own, other) = (&self.base.setup, &scenario.setup);
        let bodies =
            |setup: &Setup| setup.bodies.iter().map(|b| b.name.clone()).collect::<Vec<_>>();
        let fenders =
            |setup: &Setup| setup.fenders.iter().map(|f| f.name.clone()).collect::<Vec<_>>();
        if bodies(own) != bodies(other) {
            return Err(NoRun::Other("bodies"));
        }
        if fenders(own) != fenders(other) {
            return Err(NoRun::Other("fenders"));
        }
        if *self.controls != controls(other) {
            return Err(NoRun::Other("controls"));
        }
        Run::new(scenario, Arc::clone(&self.controls)).map_err(NoRun::Cannot)
    }
}

/// The overrides of each variant.
pub(crate) fn read(variants: &Bound<'_, PyAny>) -> PyResult<Vec<Vec<Override>>> {
    variants.try_iter()?.map(|set| overrides(variants.py(), &set?)).collect()
}

/// The exception for a variant, with its number.
pub(crate) fn exception(py: Python<'_>, number: usize, error: &NoRun) -> PyErr {
    let exception = match error {
        NoRun::Scenario(error) => errors::of_scenario(py, error),
        NoRun::Cannot(error) => cannot_run(py, error),
        NoRun::Other(what) => {
            errors::refused(py, format!("the variant has other {what} than its scenario"))
        }
    };
    numbered(py, number, exception)
}

/// Adds a note with the number of the run.
pub(crate) fn numbered(py: Python<'_>, number: usize, error: PyErr) -> PyErr {
    let noted = error.value(py).call_method1("add_note", (format!("in run {number}"),));
    noted.map_or_else(|error| error, |_| error)
}
