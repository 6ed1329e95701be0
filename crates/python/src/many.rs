//! Many runs in parallel.

use std::sync::atomic::{AtomicBool, Ordering};

use fenderline_contact::BodyState;
use fenderline_sim::SimError;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;

use crate::arrays::{STATE, write_states};
use crate::errors;
use crate::parallel::{self, Ended};
use crate::run::Run;
use crate::scenario::Scenario;
use crate::summaries::{Summary, all_tables};
use crate::tables;
use crate::variants::{self, Common, NoRun};

/// The states of the bodies at the end of a run, and its summary.
type Done = (Vec<BodyState>, Summary);

enum Failed {
    NoRun(NoRun),
    Step(SimError),
    /// By the user; nobody sees it.
    Stopped,
}

/// Runs every variant of a scenario to its end, on `threads` threads (by default all of the machine). Returns the final
/// states (runs, bodies, 6) and the tables of the summaries. The bits do not depend on the number of threads. `progress` is called
/// now and then with the number of runs that are done.
#[pyfunction]
#[pyo3(signature = (scenario, variants, threads=None, progress=None))]
pub(crate) fn run_variants<'py>(
    py: Python<'py>,
    scenario: &Scenario,
    variants: &Bound<'py, PyAny>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    let sets = variants::read(variants)?;
    let common = Common::of(scenario);
    let one = |own: &mut Option<Run>, index: usize, stop: &AtomicBool| -> Result<Done, Failed> {
        let variant = common.variant(&sets[index]).map_err(Failed::NoRun)?;
        if let Some(run) = own {
            variant.begin_in(&common, run).map_err(Failed::NoRun)?;
        } else {
            *own = Some(variant.begin(&common).map_err(Failed::NoRun)?);
        }
        let run = own.as_mut().expect("a run was begun");
        while !run.simulation.is_done() {
            if stop.load(Ordering::Relaxed) {
                return Err(Failed::Stopped);
            }
            run.step().map_err(Failed::Step)?;
        }
        Ok((run.simulation.states().to_vec(), Summary::of(&run.simulation)))
    };
    let threads = parallel::threads(threads);
    // An interrupt by the user, or an exception of `progress`.
    let mut raised = None;
    let mut shown = 0;
    let mut watch = |finished: usize| {
        if raised.is_some() {
            return false;
        }
        Python::attach(|py| {
            let mut look = || {
                py.check_signals()?;
                if finished != shown
                    && let Some(progress) = &progress
                {
                    shown = finished;
                    progress.call1(py, (finished,))?;
                }
                Ok(())
            };
            raised = look().err();
        });
        raised.is_none()
    };
    let ended = py.detach(|| parallel::each_watched(sets.len(), threads, || None, one, &mut watch));
    let done = match ended {
        Ok(done) => done,
        Err(Ended::Failed(index, Failed::NoRun(error))) => {
            return Err(variants::exception(py, index, &error));
        }
        Err(Ended::Failed(index, Failed::Step(error))) => {
            return Err(variants::numbered(py, index, errors::of_simulation(py, &error)));
        }
        Err(Ended::Failed(_, Failed::Stopped) | Ended::Stopped) => {
            return Err(raised.expect("the runs were stopped by an exception"));
        }
    };
    if let Some(progress) = &progress {
        progress.call1(py, (sets.len(),))?;
    }
    let bodies = common.base.setup.bodies.len();
    let mut states = vec![0.0; sets.len() * bodies * STATE];
    let mut summaries = Vec::with_capacity(sets.len());
    for (index, (last, summary)) in done.into_iter().enumerate() {
        write_states(&last, &mut states[index * bodies * STATE..][..bodies * STATE]);
        summaries.push(summary);
    }
    let states = PyArray1::from_vec(py, states).reshape([sets.len(), bodies, STATE])?.into_any();
    let setup = &common.base.setup;
    let kept = all_tables(setup, &summaries);
    Ok((states, tables::results(py, &common.base.title, kept)?))
}
