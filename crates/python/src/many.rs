//! Many runs in parallel.

use fenderline_contact::BodyState;
use fenderline_sim::SimError;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;

use crate::arrays::{STATE, write_states};
use crate::errors;
use crate::parallel;
use crate::scenario::Scenario;
use crate::summaries::{Summary, all_tables};
use crate::tables;
use crate::variants::{self, Common, NoRun};

/// Runs between two checks for an interrupt by the user.
const RUNS_AT_A_TIME: usize = 1000;

enum Failed {
    NoRun(NoRun),
    Step(SimError),
}

/// Runs every variant of a scenario to its end, on `threads` threads (by default all of the machine). Returns the final
/// states (runs, bodies, 6) and the tables `pairs` and `fenders`. The bits do not depend on the number of threads.
#[pyfunction]
#[pyo3(signature = (scenario, variants, threads=None))]
pub(crate) fn run_variants<'py>(
    py: Python<'py>,
    scenario: &Scenario,
    variants: &Bound<'py, PyAny>,
    threads: Option<usize>,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    let sets = variants::read(variants)?;
    let common = Common::of(scenario);
    let one = |index: usize| -> Result<(Vec<BodyState>, Summary), Failed> {
        let mut run = common.run(&sets[index]).map_err(Failed::NoRun)?;
        while !run.simulation.is_done() {
            run.step().map_err(Failed::Step)?;
        }
        Ok((run.simulation.states().to_vec(), Summary::of(&run.simulation)))
    };
    let threads = parallel::threads(threads);
    let mut done = Vec::with_capacity(sets.len());
    while done.len() < sets.len() {
        let first = done.len();
        let count = RUNS_AT_A_TIME.min(sets.len() - first);
        done.extend(py.detach(|| parallel::each(count, threads, |index| one(first + index))));
        py.check_signals()?;
    }
    let bodies = common.base.setup.bodies.len();
    let mut states = vec![0.0; sets.len() * bodies * STATE];
    let mut summaries = Vec::with_capacity(sets.len());
    for (index, done) in done.into_iter().enumerate() {
        let (last, summary) = done.map_err(|failed| match failed {
            Failed::NoRun(error) => variants::exception(py, index, &error),
            Failed::Step(error) => variants::numbered(py, index, errors::of_simulation(py, &error)),
        })?;
        write_states(&last, &mut states[index * bodies * STATE..][..bodies * STATE]);
        summaries.push(summary);
    }
    let states = PyArray1::from_vec(py, states).reshape([sets.len(), bodies, STATE])?.into_any();
    let setup = &common.base.setup;
    let kept = all_tables(setup, &summaries);
    Ok((states, tables::results(py, &common.base.title, kept)?))
}
