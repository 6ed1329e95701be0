//! Many simulations that take their steps together.

use fenderline_scenario::Override;
use numpy::PyArray2;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::arrays::{ReadOnly, STATE, Shared, write_states};
use crate::errors;
use crate::parallel;
use crate::run::Run;
use crate::scenario::Scenario;
use crate::variants::{self, Common, NoRun};
use crate::whole;

/// Variants of one scenario that take their steps together, on `threads` threads. All variants have the same bodies,
/// fenders and controls as the scenario. Results equal those of simulations that run alone, bit for bit.
///
/// >>> import fenderline
/// >>> speeds = [{"body.ship.velocity.surge": speed} for speed in (0.5, 1.0)]
/// >>> fleet = fenderline.Fleet(fenderline.example("docking"), speeds)
/// >>> fleet.controls[:, 1] = 0.2
/// >>> fleet.step(10)
/// >>> fleet.states.shape, fleet.times_s.tolist()
/// ((2, 2, 6), [10.0, 10.0])
#[pyclass(module = "fenderline")]
pub(crate) struct Fleet {
    common: Common,
    runs: Vec<Run>,
    threads: usize,
    controls: Shared,
    states: ReadOnly,
    times: ReadOnly,
    energy_shares: ReadOnly,
    reactions: ReadOnly,
    failed: ReadOnly,
}

#[pymethods]
impl Fleet {
    #[new]
    #[pyo3(signature = (scenario, variants, *, threads=1))]
    fn new(
        py: Python<'_>,
        scenario: &Scenario,
        variants: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = whole::threads)] threads: usize,
    ) -> PyResult<Fleet> {
        let sets = variants::read(variants)?;
        let common = Common::of(scenario);
        let threads = parallel::threads(Some(threads));
        let runs = new_runs(py, &common, threads, &sets)?;
        let (count, setup) = (runs.len(), &common.base.setup);
        let (bodies, fenders) = (setup.bodies.len(), setup.fenders.len());
        let fleet = Fleet {
            controls: Shared::zeros(py, count, common.controls.len()),
            states: ReadOnly::zeros(py, count, &[bodies, STATE])?,
            times: ReadOnly::zeros(py, count, &[])?,
            energy_shares: ReadOnly::zeros(py, count, &[fenders])?,
            reactions: ReadOnly::zeros(py, count, &[fenders])?,
            failed: ReadOnly::zeros(py, count, &[fenders])?,
            common,
            runs,
            threads,
        };
        fleet.controls.write(py, |rows| rows.fill(f64::NAN))?;
        fleet.show(py)?;
        Ok(fleet)
    }

    /// Takes `steps` steps in every simulation with the controls as they are set.
    #[pyo3(signature = (steps=1))]
    fn step(
        &mut self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole::steps)] steps: u64,
    ) -> PyResult<()> {
        let wanted = self.runs.len() * self.common.controls.len();
        let values = self.controls.read(py, <[f64]>::to_vec)?;
        if values.len() != wanted {
            return Err(errors::bad_argument("the array of controls has a wrong shape"));
        }
        if let Some(reason) = Run::refused(&self.common.controls, &values) {
            return Err(errors::refused(py, reason));
        }
        let Fleet { runs, threads, common, .. } = self;
        let each = common.controls.len();
        let step = |index: usize, run: &mut Run| {
            run.order(&values[index * each..][..each], |_, _| ());
            (0..steps).try_for_each(|_| run.step().map(|_| ()))
        };
        let done = py.detach(|| parallel::each_mut(runs, *threads, step));
        self.show(py)?;
        let failed =
            done.into_iter().enumerate().find_map(|(index, done)| Some((index, done.err()?)));
        match failed {
            None => Ok(()),
            Some((index, error)) => {
                Err(variants::numbered(py, index, errors::of_simulation(py, &error)))
            }
        }
    }

    /// Restarts some of the simulations, each as a variant of the scenario; the controls of these simulations are NaN
    /// again.
    fn reset(
        &mut self,
        py: Python<'_>,
        indices: &Bound<'_, PyAny>,
        variants: &Bound<'_, PyAny>,
    ) -> PyResult<()> {
        let sets = variants::read(variants)?;
        let indices = whole::indices(indices, "simulation", self.runs.len() as u64)?;
        if sets.len() != indices.len() {
            return Err(errors::bad_argument("there must be as many variants as indices"));
        }
        let Fleet { common, runs, threads, .. } = self;
        let made = py
            .detach(|| parallel::each(sets.len(), *threads, |index| common.variant(&sets[index])));
        // All of them, before the first simulation changes.
        let variants = all_made(py, made)?;
        for (&index, variant) in indices.iter().zip(variants) {
            let begun = variant.begin_in(common, &mut runs[index]);
            begun.map_err(|error| variants::exception(py, index, &error))?;
        }
        let each = self.common.controls.len();
        self.controls.write(py, |rows| {
            for &index in &indices {
                rows[index * each..][..each].fill(f64::NAN);
            }
        })?;
        self.show(py)
    }

    /// Values of the controls, an array (simulations, controls); NaN leaves a control to the scenario's orders and
    /// pilots. Write into this array.
    #[getter]
    fn controls(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.controls.array(py)
    }

    /// Present states of the bodies, an array (simulations, bodies, 6) with rows as in `Simulation.states`. The array
    /// is read-only; each step overwrites it.
    #[getter]
    fn states(&self, py: Python<'_>) -> Py<PyAny> {
        self.states.view(py)
    }

    /// Time of each simulation (s). The array is read-only; each step overwrites it.
    #[getter]
    fn times_s(&self, py: Python<'_>) -> Py<PyAny> {
        self.times.view(py)
    }

    /// Largest energy that each fender has stored so far, divided by its rated energy: an array (simulations, fenders);
    /// NaN without a rating. The array is read-only; each step overwrites it.
    #[getter]
    fn fender_energy_shares(&self, py: Python<'_>) -> Py<PyAny> {
        self.energy_shares.view(py)
    }

    /// Reaction of each fender in the last step (N), an array (simulations, fenders). The array is read-only; each step
    /// overwrites it.
    #[getter]
    fn fender_reactions_n(&self, py: Python<'_>) -> Py<PyAny> {
        self.reactions.view(py)
    }

    /// Whether each fender was deflected beyond its travel, an array (simulations, fenders): 1 if so, else 0. The array
    /// is read-only; each step overwrites it.
    #[getter]
    fn fenders_failed(&self, py: Python<'_>) -> Py<PyAny> {
        self.failed.view(py)
    }

    /// Names of the controls, in the order of the columns of `controls`.
    #[getter]
    fn control_names(&self) -> Vec<String> {
        self.common.controls.iter().map(|control| control.name.clone()).collect()
    }

    /// Names of the bodies.
    #[getter]
    fn bodies(&self) -> Vec<String> {
        self.common.base.setup.bodies.iter().map(|body| body.name.clone()).collect()
    }

    /// Names of the fenders.
    #[getter]
    fn fenders(&self) -> Vec<String> {
        self.common.base.setup.fenders.iter().map(|fender| fender.name.clone()).collect()
    }

    /// Length of the scenario's time step (s).
    #[getter]
    fn step_s(&self) -> f64 {
        self.common.base.setup.step_s
    }

    /// A fleet cannot be sent to other processes, because a fleet is used in place of other processes.
    fn __reduce__(&self) -> PyResult<()> {
        Err(PyTypeError::new_err(
            "a Fleet can be neither pickled nor copied: send the scenario and the variants, and \
             make a Fleet of them there; a Simulation can be pickled",
        ))
    }

    fn __len__(&self) -> usize {
        self.runs.len()
    }

    fn __repr__(&self) -> String {
        format!("<fenderline.Fleet of {} \"{}\">", self.runs.len(), self.common.base.title)
    }
}

/// Starts a run of each variant of the scenario.
fn new_runs(
    py: Python<'_>,
    common: &Common,
    threads: usize,
    sets: &[Vec<Override>],
) -> PyResult<Vec<Run>> {
    let run = |index: usize| common.variant(&sets[index])?.begin(common);
    let made = py.detach(|| parallel::each(sets.len(), threads, run));
    all_made(py, made)
}

/// The results for all variants, or the exception for the first variant that failed.
fn all_made<T>(py: Python<'_>, made: Vec<Result<T, NoRun>>) -> PyResult<Vec<T>> {
    let each = made.into_iter().enumerate();
    each.map(|(index, made)| made.map_err(|error| variants::exception(py, index, &error))).collect()
}

impl Fleet {
    fn show(&self, py: Python<'_>) -> PyResult<()> {
        let setup = &self.common.base.setup;
        let (bodies, fenders) = (setup.bodies.len(), setup.fenders.len());
        let simulations = || self.runs.iter().map(|run| &run.simulation);
        self.states.write(py, |rows| {
            for (simulation, rows) in simulations().zip(rows.chunks_exact_mut(bodies * STATE)) {
                write_states(simulation.states(), rows);
            }
        })?;
        self.times.write(py, |rows| {
            for (simulation, time_s) in simulations().zip(rows) {
                *time_s = simulation.time_s();
            }
        })?;
        if fenders == 0 {
            return Ok(());
        }
        let unrated = |fender: usize| setup.fenders[fender].rated.is_none();
        self.energy_shares.write(py, |rows| {
            for (simulation, row) in simulations().zip(rows.chunks_exact_mut(fenders)) {
                for (fender, share) in row.iter_mut().enumerate() {
                    *share = if unrated(fender) { f64::NAN } else { 0.0 };
                }
                for summary in simulation.fender_summaries() {
                    row[summary.fender] = summary.share_of_rated_energy.unwrap_or(f64::NAN);
                }
            }
        })?;
        self.reactions.write(py, |rows| {
            for (simulation, row) in simulations().zip(rows.chunks_exact_mut(fenders)) {
                row.fill(0.0);
                for summary in simulation.fender_summaries() {
                    row[summary.fender] = summary.last_reaction_n;
                }
            }
        })?;
        self.failed.write(py, |rows| {
            for (simulation, row) in simulations().zip(rows.chunks_exact_mut(fenders)) {
                row.fill(0.0);
                for summary in simulation.fender_summaries() {
                    row[summary.fender] = f64::from(u8::from(summary.failed));
                }
            }
        })
    }
}
