//! The contact engine alone.

use std::sync::Arc;

use fenderline_contact::{BodyState, HostIntegration, HostSettings, Mobility, Wrench};
use fenderline_embed::{self as embed, CoriolisTerms, EngineError, Host, Settings};
use fenderline_sim::Method;
use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::arrays::{
    ReadOnly, STATE, Shared, WRENCH, read_states, read_wrenches, write_states, write_wrenches,
};
use crate::contacts::{StepEvent, contact_event, contacts_array};
use crate::errors;
use crate::scenario::Scenario;
use crate::whole;

/// The contact engine for a simulator that moves its bodies itself: write `states` and, if you know them, `loads`;
/// call `step`; add `wrenches` to your forces.
///
/// `method` is `"coupled"` or `"paper"`; by default the method of the scenario. With `host="direct"` you give the
/// states at the start of each step and all loads; `coriolis` says whether the `"engine"` adds the Coriolis terms or
/// your `"loads"` include them. With `host="cosimulation"` you move the bodies with the wrenches by `integration`
/// (`"semi_implicit"` or `"forward_euler"`); states may be `delay_steps` old, and loads need not be given.
///
/// An engine can be copied and pickled: the copy goes on with the same bits.
///
/// >>> import fenderline
/// >>> tug_at_speed = fenderline.example("tug_4kn").with_set({"contact.method": "coupled"})
/// >>> engine = fenderline.Engine(tug_at_speed, host="cosimulation")
/// >>> engine.bodies
/// ['ship', 'tug']
/// >>> engine.states[1, 1] = -38.5  # half a metre into the ship's side
/// >>> engine.step(0.1)
/// >>> bool(engine.wrenches[1, 1] < -1e5), len(engine.contacts)
/// (True, 1)
#[pyclass(module = "fenderline")]
pub(crate) struct Engine {
    engine: embed::Engine,
    origin: Arc<Origin>,
    bodies: Vec<String>,
    fenders: Vec<String>,
    uses_loads: bool,
    states: Shared,
    loads: Shared,
    wrenches: ReadOnly,
    peak_wrenches: ReadOnly,
    states_after: ReadOnly,
    /// Buffers of a step.
    state_rows: Vec<BodyState>,
    load_rows: Vec<Wrench>,
}

/// Contents of an engine's pickle: version, arguments of `Engine(...)`, whether steps use loads, and the bytes that
/// `save` gave.
type Parts<'py> = (&'static str, Bound<'py, PyDict>, bool, Bound<'py, PyBytes>);

/// The arguments of `Engine(...)` with which an engine was made.
struct Origin {
    scenario: Py<Scenario>,
    method: Option<String>,
    host: String,
    coriolis: Option<String>,
    delay_steps: u32,
    integration: String,
}

#[pymethods]
impl Engine {
    #[new]
    #[pyo3(signature = (
        scenario, *, method=None, host="direct", coriolis=None, delay_steps=0,
        integration="semi_implicit",
    ))]
    fn new(
        py: Python<'_>,
        scenario: Py<Scenario>,
        method: Option<&str>,
        host: &str,
        coriolis: Option<&str>,
        #[pyo3(from_py_with = whole::delay_steps)] delay_steps: u32,
        integration: &str,
    ) -> PyResult<Engine> {
        let origin = Origin {
            scenario: scenario.clone_ref(py),
            method: method.map(str::to_owned),
            host: host.to_owned(),
            coriolis: coriolis.map(str::to_owned),
            delay_steps,
            integration: integration.to_owned(),
        };
        let method = match method {
            None => None,
            Some("coupled") => Some(Method::Coupled),
            Some("paper") => Some(Method::Paper),
            Some(other) => return Err(unknown_choice("method", other, "coupled, paper")),
        };
        let coriolis = match coriolis {
            None => None,
            Some("engine") => Some(CoriolisTerms::ByEngine),
            Some("loads") => Some(CoriolisTerms::InLoads),
            Some(other) => return Err(unknown_choice("coriolis", other, "engine, loads")),
        };
        let integration = match integration {
            "semi_implicit" => HostIntegration::SemiImplicit,
            "forward_euler" => HostIntegration::ForwardEuler,
            other => {
                return Err(unknown_choice("integration", other, "semi_implicit, forward_euler"));
            }
        };
        let host = match host {
            "direct" if delay_steps == 0 => Host::Direct { coriolis },
            "direct" => {
                return Err(errors::bad_argument("delay_steps is for host=\"cosimulation\""));
            }
            "cosimulation" if coriolis.is_none() => {
                Host::CoSimulation(HostSettings { delay_steps, integration })
            }
            "cosimulation" => {
                return Err(errors::bad_argument("coriolis is for host=\"direct\""));
            }
            other => return Err(unknown_choice("host", other, "direct, cosimulation")),
        };
        let settings = Settings { method, host };
        let checked = (*scenario.get().checked).clone();
        let engine = embed::Engine::from_scenario(checked, &settings)
            .map_err(|error| errors::of_engine(py, &error))?;
        Engine::around(py, engine, Arc::new(origin))
    }

    /// Takes a step of `step_s` seconds from `states`, with `loads` if `uses_loads` is true: fills `wrenches`, and
    /// `states_after` if the engine moves the bodies. Steps may have any length; a step of 0 s is a pause and changes
    /// nothing.
    fn step(
        &mut self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole::step_s)] step_s: f64,
    ) -> PyResult<()> {
        let Engine { engine, state_rows, load_rows, .. } = self;
        self.states.read(py, |numbers| read_states(numbers, state_rows))??;
        let loads = match self.uses_loads {
            true => {
                self.loads.read(py, |numbers| read_wrenches(numbers, load_rows))??;
                Some(load_rows.as_slice())
            }
            false => None,
        };
        engine.advance(state_rows, loads, step_s).map_err(|error| errors::of_engine(py, &error))?;
        self.show(py)
    }

    /// Marks a body, by its name, as placed anew: its next state is a new position, not the result of motion. The
    /// body's contacts start anew, and a body that is placed in another one is pressed out slowly (event
    /// `placed_in_overlap`).
    fn mark_teleported(&mut self, py: Python<'_>, body: &str) -> PyResult<()> {
        let Engine { engine, .. } = self;
        let placed = engine.body_named(body).and_then(|index| engine.mark_teleported(index));
        placed.map_err(|error| errors::of_engine(py, &error))
    }

    /// States at the start of the next step, one row per body: north and east (m), heading (rad), velocity north and
    /// east (m/s), rate of turn (rad/s). Write into this array.
    #[getter]
    fn states(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.states.array(py)
    }

    /// Loads on each body other than contact forces, one row per body: force north and east (N), moment about the
    /// centre of gravity (N·m). Write into this array; a step uses it if `uses_loads` is true.
    #[getter]
    fn loads(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.loads.array(py)
    }

    /// Whether each step uses the array `loads`.
    #[getter]
    fn uses_loads(&self) -> bool {
        self.uses_loads
    }

    #[setter]
    fn set_uses_loads(&mut self, py: Python<'_>, uses_loads: bool) -> PyResult<()> {
        if uses_loads && self.engine.method() == Method::Paper {
            let error = EngineError::NotAvailable("the paper's method has no loads");
            return Err(errors::of_engine(py, &error));
        }
        if !uses_loads {
            let unset = self.engine.set_loads(None);
            unset.map_err(|error| errors::of_engine(py, &error))?;
        }
        self.uses_loads = uses_loads;
        Ok(())
    }

    /// The wrench to add to each body's forces for the step: force north and east (N), moment (N·m); means over the
    /// step. The array is read-only; each step overwrites it.
    #[getter]
    fn wrenches(&self, py: Python<'_>) -> Py<PyAny> {
        self.wrenches.view(py)
    }

    /// The largest contact wrench on each body within the step, in rows as in `wrenches`. Use this largest wrench to
    /// size fenders; move the bodies by `wrenches`, which are means over the step. The peak force of each contact is in
    /// `contacts["peak_normal_force_n"]`. The array is read-only; each step overwrites it.
    #[getter]
    fn peak_wrenches(&self, py: Python<'_>) -> Py<PyAny> {
        self.peak_wrenches.view(py)
    }

    /// The states of the bodies at the end of the step, as the engine computed them, in rows as in `states`. They
    /// exist only for `host="direct"` with `method="coupled"`. As in a leapfrog scheme, velocities are half a step
    /// older than positions (half of the last sub-step, if contacts needed several): pass them back unchanged. The
    /// array is read-only; each step overwrites it.
    #[getter]
    fn states_after(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        if self.engine.method() == Method::Coupled
            && matches!(self.engine.host(), Host::Direct { .. })
        {
            return Ok(self.states_after.view(py));
        }
        let why = "the engine has no states after a step, because the host moves the bodies itself";
        Err(errors::of_engine(py, &EngineError::NotAvailable(why)))
    }

    /// The contact patches of the last step, as a new structured array.
    #[getter]
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let results = self.engine.results().map_err(|error| errors::of_engine(py, &error))?;
        contacts_array(py, results.contacts)
    }

    /// The events of the last step.
    #[getter]
    fn events(&self, py: Python<'_>) -> PyResult<Vec<StepEvent>> {
        let results = self.engine.results().map_err(|error| errors::of_engine(py, &error))?;
        let named = |event| contact_event(event, &self.bodies, &self.fenders);
        Ok(results.events.iter().map(named).collect())
    }

    /// Names of the bodies, in the order of the arrays' rows.
    #[getter]
    fn bodies(&self) -> Vec<String> {
        self.bodies.clone()
    }

    /// Names of the fenders; `contacts["fender"]` is an index into this list.
    #[getter]
    fn fenders(&self) -> Vec<String> {
        self.fenders.clone()
    }

    /// The contact method: `coupled` or `paper`.
    #[getter]
    fn method(&self) -> &'static str {
        match self.engine.method() {
            Method::Coupled => "coupled",
            Method::Paper => "paper",
        }
    }

    /// Notices about the scenario, and about the parts of the scenario that are left to the host.
    #[getter]
    fn notices(&self) -> Vec<String> {
        self.engine.notices().to_vec()
    }

    /// Whether each body is fixed, in the order of the arrays' rows.
    #[getter]
    fn fixed(&self) -> Vec<bool> {
        let bodies = self.engine.model().bodies().iter();
        bodies.map(|body| body.mobility == Mobility::Fixed).collect()
    }

    /// Returns the engine to the start: forgets contacts and loads, and takes the scenario's states again.
    fn reset(&mut self, py: Python<'_>) -> PyResult<()> {
        self.engine.reset();
        self.states.write(py, |rows| write_states(self.engine.initial_states(), rows))?;
        self.loads.write(py, |rows| rows.fill(0.0))?;
        self.show(py)?;
        self.states_after.write(py, |rows| write_states(self.engine.initial_states(), rows))
    }

    /// Returns the whole state of the engine that can change, as bytes.
    fn save<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        // Values written into the arrays since the last step are saved too.
        let Engine { engine, state_rows, load_rows, .. } = self;
        self.states.read(py, |numbers| read_states(numbers, state_rows))??;
        let refused = |error: EngineError| errors::of_engine(py, &error);
        engine.set_states(state_rows).map_err(refused)?;
        if self.uses_loads {
            self.loads.read(py, |numbers| read_wrenches(numbers, load_rows))??;
            engine.set_loads(Some(load_rows)).map_err(refused)?;
        }
        Ok(PyBytes::new(py, &engine.save()))
    }

    /// Restores the state that `save` returned from an engine of the same scenario and settings. Bytes that `save` has
    /// not returned are refused.
    fn restore(&mut self, py: Python<'_>, saved: &[u8]) -> PyResult<()> {
        self.engine.restore(saved).map_err(|error| errors::of_engine(py, &error))?;
        self.uses_loads = self.engine.loads().is_some();
        self.show_all(py)
    }

    /// A copy of the engine that continues independently.
    fn copy(&mut self, py: Python<'_>) -> PyResult<Engine> {
        let saved = self.save(py)?;
        let mut engine = self.engine.clone();
        engine.restore(saved.as_bytes()).map_err(|error| errors::of_engine(py, &error))?;
        let mut copy = Engine::around(py, engine, Arc::clone(&self.origin))?;
        copy.uses_loads = self.uses_loads;
        copy.show_all(py)?;
        Ok(copy)
    }

    fn __copy__(&mut self, py: Python<'_>) -> PyResult<Engine> {
        self.copy(py)
    }

    fn __deepcopy__(&mut self, py: Python<'_>, _memo: &Bound<'_, PyAny>) -> PyResult<Engine> {
        self.copy(py)
    }

    fn __reduce__<'py>(&mut self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Parts<'py>)> {
        let saved = self.save(py)?;
        let Origin { scenario, method, host, coriolis, delay_steps, integration } = &*self.origin;
        let arguments = PyDict::new(py);
        arguments.set_item("scenario", scenario)?;
        arguments.set_item("method", method)?;
        arguments.set_item("host", host)?;
        arguments.set_item("coriolis", coriolis)?;
        arguments.set_item("delay_steps", delay_steps)?;
        arguments.set_item("integration", integration)?;
        let made = py.import("fenderline._pickling")?.getattr("engine")?;
        let version = env!("CARGO_PKG_VERSION");
        Ok((made, (version, arguments, self.uses_loads, saved)))
    }

    fn __repr__(&self) -> String {
        format!("<fenderline.Engine of {}>", self.bodies.join(", "))
    }
}

impl Engine {
    fn around(py: Python<'_>, engine: embed::Engine, origin: Arc<Origin>) -> PyResult<Engine> {
        let model = engine.model();
        let bodies: Vec<String> = model.bodies().iter().map(|body| body.name.clone()).collect();
        let fenders = model.fenders().iter().map(|fender| fender.name.clone()).collect();
        let count = bodies.len();
        let direct = matches!(engine.host(), Host::Direct { .. });
        let made = Engine {
            uses_loads: direct && engine.method() == Method::Coupled,
            states: Shared::zeros(py, count, STATE),
            loads: Shared::zeros(py, count, WRENCH),
            wrenches: ReadOnly::zeros(py, count, &[WRENCH])?,
            peak_wrenches: ReadOnly::zeros(py, count, &[WRENCH])?,
            states_after: ReadOnly::zeros(py, count, &[STATE])?,
            state_rows: engine.initial_states().to_vec(),
            load_rows: vec![Wrench::default(); count],
            engine,
            origin,
            bodies,
            fenders,
        };
        made.states.write(py, |rows| write_states(made.engine.initial_states(), rows))?;
        made.states_after.write(py, |rows| write_states(made.engine.initial_states(), rows))?;
        Ok(made)
    }

    /// Copies the results of the engine's last step into Python's arrays.
    fn show(&self, py: Python<'_>) -> PyResult<()> {
        let Ok(results) = self.engine.results() else {
            self.peak_wrenches.write(py, |rows| rows.fill(0.0))?;
            return self.wrenches.write(py, |rows| rows.fill(0.0));
        };
        self.peak_wrenches.write(py, |rows| write_wrenches(results.peak_wrenches, rows))?;
        self.wrenches.write(py, |rows| write_wrenches(results.wrenches, rows))?;
        self.states_after.write(py, |rows| write_states(results.states_after, rows))
    }

    /// Copies states, loads and results of the engine into Python's arrays.
    fn show_all(&self, py: Python<'_>) -> PyResult<()> {
        self.states.write(py, |rows| write_states(self.engine.states(), rows))?;
        self.loads.write(py, |rows| match self.engine.loads() {
            Some(loads) => write_wrenches(loads, rows),
            None => rows.fill(0.0),
        })?;
        self.show(py)
    }
}

fn unknown_choice(what: &str, given: &str, known: &str) -> PyErr {
    errors::bad_argument(format!("{what} is {given:?}, but must be one of: {known}"))
}

/// Time (s) that `count` steps of a copy of an engine take without Python; for the benchmark `bench.py`.
#[pyfunction]
pub(crate) fn seconds_of_steps(
    engine: &Engine,
    #[pyo3(from_py_with = whole::step_s)] step_s: f64,
    #[pyo3(from_py_with = whole::count)] count: u64,
) -> PyResult<f64> {
    let mut own = engine.engine.clone();
    let states = own.states().to_vec();
    let loads = engine.uses_loads.then_some(engine.load_rows.as_slice());
    let start = std::time::Instant::now();
    for _ in 0..count {
        let taken = own.advance(&states, loads, step_s);
        taken.map_err(|error| errors::bad_argument(error.to_string()))?;
    }
    Ok(start.elapsed().as_secs_f64())
}
