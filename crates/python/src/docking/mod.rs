//! The docking environment: many ships that come to a berth, with observation, reward and end of each episode. The
//! package's Python code draws the starts of the episodes and has Gymnasium's interface.

mod berth;
mod episode;

use fenderline_contact::vec2;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2};
use pyo3::prelude::*;

use self::berth::Berth;
use self::episode::{Drawn, Episode, Lever, Outcome, SEEN, SHIP_ORDERS};
use crate::arrays::{STATE, write_states};
use crate::errors;
use crate::parallel;
use crate::scenario::Scenario;
use crate::variants::{self, Common};
use crate::whole;

/// Number of values of an episode's start: position north and east, heading, velocity ahead and to starboard, speed and
/// origin of the wind, speed and direction of the current.
const START: usize = 9;

/// What a step returns for each episode: observation, reward, how the episode ended, and whether it was cut off.
type Stepped<'py> = (
    Bound<'py, PyArray2<f32>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<i8>>,
    Bound<'py, PyArray1<bool>>,
);

/// What `shown` returns: orders to the ship, wind along the quay and towards the quay (m/s), steps taken, and the
/// largest share of its rated energy that a fender has stored.
type Shown = ([f64; SHIP_ORDERS], (f64, f64), u32, f64);

/// Episodes of `fenderline.docking` that go in parallel, on `threads` threads. `levers` names the controls that the
/// numbers of an action set, and gives for each the value that a number 1 sets; the first four controls are the ship's.
/// All methods return new arrays.
#[pyclass(module = "fenderline._native")]
pub(crate) struct Docking {
    berth: Berth,
    levers: Vec<Lever>,
    episodes: Vec<Episode>,
    threads: usize,
}

#[pymethods]
impl Docking {
    #[new]
    fn new(
        py: Python<'_>,
        scenario: &Scenario,
        #[pyo3(from_py_with = whole::episodes)] count: usize,
        #[pyo3(from_py_with = whole::threads)] threads: usize,
        #[pyo3(from_py_with = whole::levers)] levers: Vec<(String, f64)>,
        #[pyo3(from_py_with = whole::berthed_within_m)] berthed_within_m: f64,
    ) -> PyResult<Docking> {
        let common = Common::of(scenario);
        let other = || {
            errors::bad_argument(
                "the docking environment needs a scenario of a ship at a berth, but this scenario has another form",
            )
        };
        let berth = Berth::of(&common.base, berthed_within_m).ok_or_else(other)?;
        if !common.base.setup.restarts_in_place() {
            return Err(other());
        }
        let lever = |(name, full): &(String, f64)| {
            let control = common.controls.iter().position(|control| control.name == *name);
            let unknown = || errors::bad_argument(format!("the scenario has no control {name}"));
            Ok(Lever { control: control.ok_or_else(unknown)?, full: *full })
        };
        let levers = levers.iter().map(lever).collect::<PyResult<Vec<_>>>()?;
        if levers.len() < SHIP_ORDERS {
            return Err(errors::bad_argument("the first four controls must be those of the ship"));
        }
        // Clones of one simulation share its contact model: a thousand of them wait for memory most of the time.
        let first = common.run(&[]).map_err(|error| variants::exception(py, 0, &error))?;
        let episodes = (0..count).map(|_| Episode::new(first.clone())).collect();
        Ok(Docking { berth, levers, episodes, threads: parallel::threads(Some(threads)) })
    }

    /// Starts some of the episodes, each with its row of `starts`: position north and east, heading, velocity ahead and
    /// to starboard, speed of the wind and where it comes from, speed of the current and where it goes to. Returns
    /// their observations.
    fn begin<'py>(
        &mut self,
        py: Python<'py>,
        which: &Bound<'_, PyAny>,
        starts: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let which = whole::indices(which, "episode", self.episodes.len() as u64)?;
        let numbers = starts.as_slice()?;
        if numbers.len() != which.len() * START {
            return Err(errors::bad_argument("the array of starts has a wrong shape"));
        }
        let mut seen = Vec::with_capacity(which.len() * SEEN);
        for (&index, row) in which.iter().zip(numbers.chunks_exact(START)) {
            let episode = &mut self.episodes[index];
            let drawn = Drawn {
                position_m: vec2(row[0], row[1]),
                heading_rad: row[2],
                velocity_mps: vec2(row[3], row[4]),
                wind_mps: row[5],
                wind_from_rad: row[6],
                current_mps: row[7],
                current_towards_rad: row[8],
            };
            let begun = episode.begin(&drawn, &self.berth);
            seen.extend(begun.map_err(|error| errors::refused(py, error.to_string()))?);
        }
        PyArray1::from_vec(py, seen).reshape([which.len(), SEEN])
    }

    /// Takes one step of each episode with its row of `actions`, which are numbers from −1 to 1. Returns for each
    /// episode the observation, the reward, how it ended and whether it was cut off.
    fn step<'py>(
        &mut self,
        py: Python<'py>,
        actions: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Stepped<'py>> {
        let Docking { berth, levers, episodes, threads } = self;
        let (actions, each) = (actions.as_slice()?, levers.len());
        if actions.len() != episodes.len() * each {
            return Err(errors::bad_argument("the array of actions has a wrong shape"));
        }
        if actions.iter().any(|number| number.is_nan()) {
            return Err(errors::bad_argument("an action is not a finite number"));
        }
        let step = |index: usize, episode: &mut Episode| {
            episode.step(&actions[index * each..][..each], levers, berth)
        };
        let done = match episodes.as_mut_slice() {
            // Letting other threads run costs more than a step.
            [only] => vec![step(0, only)],
            several => py.detach(|| parallel::each_mut(several, *threads, step)),
        };
        let count = done.len();
        let (mut seen, mut rewards) = (Vec::with_capacity(count * SEEN), Vec::with_capacity(count));
        let (mut ended, mut truncated) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for (index, outcome) in done.into_iter().enumerate() {
            let failed = |error| variants::numbered(py, index, errors::of_simulation(py, &error));
            let Outcome { seen: own, reward, ended: how, is_truncated } =
                outcome.map_err(failed)?;
            seen.extend(own);
            rewards.push(reward);
            ended.push(how as i8);
            truncated.push(is_truncated);
        }
        let seen = PyArray1::from_vec(py, seen).reshape([count, SEEN])?;
        let rewards = PyArray1::from_vec(py, rewards);
        let (ended, truncated) = (PyArray1::from_vec(py, ended), PyArray1::from_vec(py, truncated));
        Ok((seen, rewards, ended, truncated))
    }

    /// The states of the ships, an array (episodes, 6) with rows as in `Simulation.states`.
    #[getter]
    fn states<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let count = self.episodes.len();
        let mut rows = vec![0.0; count * STATE];
        for (episode, row) in self.episodes.iter().zip(rows.chunks_exact_mut(STATE)) {
            let state = episode.run.simulation.states()[self.berth.ship];
            write_states(&[state], row);
        }
        PyArray1::from_vec(py, rows).reshape([count, STATE])
    }

    /// Shows one episode: the ship's orders, wind along the quay and towards it (m/s), steps taken, and the largest
    /// share of its rated energy that a fender has stored.
    fn shown(&self, index: &Bound<'_, PyAny>) -> PyResult<Shown> {
        let index = whole::index(index, "episode", self.episodes.len() as u64)?;
        let episode = &self.episodes[index as usize];
        let [along_mps, towards_mps, _] = episode.weather_mps;
        Ok((episode.orders, (along_mps, towards_mps), episode.steps, episode.share))
    }

    fn __len__(&self) -> usize {
        self.episodes.len()
    }
}
