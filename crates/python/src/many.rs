//! Many runs in parallel.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use fenderline_contact::BodyState;
use fenderline_results::KeptTable;
use fenderline_sim::{Setup, SimError};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;

use crate::arrays::{STATE, write_states};
use crate::errors;
use crate::parallel::{self, Ended};
use crate::run::Run;
use crate::scenario::Scenario;
use crate::summaries::{Summary, all_tables};
use crate::tables::{self, joined};
use crate::variants::{self, Common, NoRun, Sets};
use crate::whole;

/// The states of the bodies at the end of a run, and the summary of the run.
type Done = (Vec<BodyState>, Summary);

enum Failed {
    NoRun(NoRun),
    Step(SimError),
    /// The user has stopped the runs. This error is not shown to the user.
    Stopped,
}

/// Runs every variant of a scenario to its end, on `threads` threads (by default all threads of the machine). The
/// variants are a sequence of dictionaries, or a dictionary of columns. Returns the final states, an array (runs,
/// bodies, 6), and the tables of the summaries. The results have the same bits for any number of threads. The function
/// `progress` is called now and then with the number of runs that are done.
#[pyfunction]
#[pyo3(signature = (scenario, variants, threads=None, progress=None))]
pub(crate) fn run_variants<'py>(
    py: Python<'py>,
    scenario: &Scenario,
    variants: &Bound<'py, PyAny>,
    #[pyo3(from_py_with = whole::some_threads)] threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    let sets = Sets::read(variants)?;
    let common = Common::of(scenario);
    let one = |own: &mut Option<Run>, index: usize, stop: &AtomicBool| -> Result<Done, Failed> {
        let set = sets.get(index).map_err(|error| Failed::NoRun(NoRun::Scenario(error)))?;
        let variant = common.variant(&set).map_err(Failed::NoRun)?;
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
            return Err(raised.expect("the runs stop only because of an exception"));
        }
    };
    if let Some(progress) = &progress {
        progress.call1(py, (sets.len(),))?;
    }
    let setup = &common.base.setup;
    let (states, kept) = py.detach(|| results_of(setup, done, threads));
    let shape = [sets.len(), setup.bodies.len(), STATE];
    let states = PyArray1::from_vec(py, states).reshape(shape)?.into_any();
    Ok((states, tables::results(py, &common.base.title, kept)?))
}

/// The final states of the runs, one run after the other, and the tables of the runs' summaries. Each thread works on
/// some of the runs.
fn results_of(setup: &Setup, done: Vec<Done>, threads: usize) -> (Vec<f64>, Vec<KeptTable>) {
    // A few pieces per thread, as others may be at work on the machine.
    let count = done.len().clamp(1, threads.saturating_mul(4));
    let size = done.len().div_ceil(count);
    let mut done = done.into_iter();
    let pieces: Vec<Mutex<Vec<Done>>> =
        (0..count).map(|_| Mutex::new(done.by_ref().take(size).collect())).collect();
    let made = parallel::each_elsewhere(count, threads, |piece| {
        // What is taken is also freed here.
        let own = std::mem::take(
            &mut *pieces[piece].lock().expect("each piece of work is locked only once"),
        );
        let (last, summaries): (Vec<Vec<BodyState>>, Vec<Summary>) = own.into_iter().unzip();
        let mut states = vec![0.0; last.len() * setup.bodies.len() * STATE];
        write_states(&last.concat(), &mut states);
        (states, all_tables(setup, piece * size, &summaries))
    });
    let (states, tables): (Vec<Vec<f64>>, Vec<Vec<KeptTable>>) = made.into_iter().unzip();
    (states.concat(), joined(tables))
}
