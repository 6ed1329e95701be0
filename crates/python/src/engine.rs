//! The contact engine alone.

use fenderline_contact::{BodyState, HostIntegration, HostSettings, Mobility, Wrench};
use fenderline_embed::{self as embed, CoriolisTerms, EngineError, Host, Settings};
use fenderline_sim::Method;
use numpy::PyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::arrays::{
    STATE, Shared, Shown, WRENCH, read_states, read_wrenches, write_states, write_wrenches,
};
use crate::contacts::{StepEvent, contact_event, contacts_array};
use crate::errors;
use crate::scenario::Scenario;

/// The contact engine for a simulator that moves its own bodies: write `states` and, where there are any, `loads`,
/// call `step`, add `wrenches` to your forces.
///
/// `method` is `"coupled"` or `"paper"` (the scenario's where not given). `host="direct"` shows the states of the
/// step's beginning and tells its loads; `coriolis` then says whose a body's Coriolis terms are, `"engine"` or
/// `"loads"`. `host="cosimulation"` moves its bodies with the wrenches by `integration` (`"semi_implicit"` or
/// `"forward_euler"`), may show states that are `delay_steps` old, and need not tell loads.
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
    bodies: Vec<String>,
    fenders: Vec<String>,
    uses_loads: bool,
    states: Shared,
    loads: Shared,
    wrenches: Shown,
    peak_wrenches: Shown,
    states_after: Shown,
    /// Buffers of a step.
    state_rows: Vec<BodyState>,
    load_rows: Vec<Wrench>,
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
        scenario: &Scenario,
        method: Option<&str>,
        host: &str,
        coriolis: Option<&str>,
        delay_steps: u32,
        integration: &str,
    ) -> PyResult<Engine> {
        let method = match method {
            None => None,
            Some("coupled") => Some(Method::Coupled),
            Some("paper") => Some(Method::Paper),
            Some(other) => return Err(no_choice("method", other, "coupled, paper")),
        };
        let coriolis = match coriolis {
            None => None,
            Some("engine") => Some(CoriolisTerms::ByEngine),
            Some("loads") => Some(CoriolisTerms::InLoads),
            Some(other) => return Err(no_choice("coriolis", other, "engine, loads")),
        };
        let integration = match integration {
            "semi_implicit" => HostIntegration::SemiImplicit,
            "forward_euler" => HostIntegration::ForwardEuler,
            other => {
                return Err(no_choice("integration", other, "semi_implicit, forward_euler"));
            }
        };
        let host = match host {
            "direct" if delay_steps == 0 => Host::Direct { coriolis },
            "direct" => {
                return Err(PyValueError::new_err("delay_steps is for host=\"cosimulation\""));
            }
            "cosimulation" if coriolis.is_none() => {
                Host::CoSimulation(HostSettings { delay_steps, integration })
            }
            "cosimulation" => {
                return Err(PyValueError::new_err("coriolis is for host=\"direct\""));
            }
            other => return Err(no_choice("host", other, "direct, cosimulation")),
        };
        let settings = Settings { method, host };
        let checked = (*scenario.checked).clone();
        let engine = embed::Engine::from_scenario(checked, &settings)
            .map_err(|error| errors::of_engine(py, &error))?;
        Engine::around(py, engine)
    }

    /// One step of `step_s` seconds from `states`, under `loads` where `uses_loads`: fills `wrenches`, and
    /// `states_after` where the engine moves the bodies. Steps may be of any lengths; in one of 0 s, a pause, nothing
    /// goes on.
    fn step(&mut self, py: Python<'_>, step_s: f64) -> PyResult<()> {
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

    /// Says that you have put the body of a name where `states` has it in the next step, rather than moved it there:
    /// its contacts start afresh, and where it lies within another one it is pressed out slowly (event `placed_in_overlap`).
    fn mark_teleported(&mut self, py: Python<'_>, body: &str) -> PyResult<()> {
        let Engine { engine, .. } = self;
        let placed = engine.body_named(body).and_then(|index| engine.mark_teleported(index));
        placed.map_err(|error| errors::of_engine(py, &error))
    }

    /// States that the next step begins from, one row a body: north and east (m), heading (rad), velocity north
    /// and east (m/s), rate of turn (rad/s). Write into it.
    #[getter]
    fn states(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.states.array(py)
    }

    /// All that acts on each body besides contact, one row a body: force north and east (N), moment about the
    /// centre of gravity (N·m). Write into it; it counts where `uses_loads`.
    #[getter]
    fn loads(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.loads.array(py)
    }

    /// Whether `loads` is told to the engine in each step.
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
            let untold = self.engine.set_loads(None);
            untold.map_err(|error| errors::of_engine(py, &error))?;
        }
        self.uses_loads = uses_loads;
        Ok(())
    }

    /// What to add to each body's forces for the step: force north and east (N), moment (N·m); means over the step.
    /// Read-only, and filled anew by each step.
    #[getter]
    fn wrenches(&self, py: Python<'_>) -> Py<PyAny> {
        self.wrenches.view(py)
    }

    /// The greatest contact wrench on each body within the step, in rows as `wrenches`: size fenders by it, and move the
    /// bodies by `wrenches`, which are means over the step. `contacts["peak_normal_force_n"]` has that of each contact.
    /// Read-only, and filled anew by each step.
    #[getter]
    fn peak_wrenches(&self, py: Python<'_>) -> Py<PyAny> {
        self.peak_wrenches.view(py)
    }

    /// Where the engine brought the bodies by the end of the step, in rows as `states`. Read-only, filled anew by
    /// each step. By the coupled method for a host of the present. Velocities are those of half a step before its end (of
    /// half of the last sub-step, where contacts needed several): show them again as they are.
    #[getter]
    fn states_after(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        if self.engine.method() == Method::Coupled
            && matches!(self.engine.host(), Host::Direct { .. })
        {
            return Ok(self.states_after.view(py));
        }
        let why = "the host moves the bodies itself: there are no states after";
        Err(errors::of_engine(py, &EngineError::NotAvailable(why)))
    }

    /// The touching patches of the last step: a structured array of its own.
    #[getter]
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let results = self.engine.results().map_err(|error| errors::of_engine(py, &error))?;
        contacts_array(py, results.contacts)
    }

    /// What happened in the last step.
    #[getter]
    fn events(&self, py: Python<'_>) -> PyResult<Vec<StepEvent>> {
        let results = self.engine.results().map_err(|error| errors::of_engine(py, &error))?;
        let told = |event| contact_event(event, &self.bodies, &self.fenders);
        Ok(results.events.iter().map(told).collect())
    }

    /// Names of the bodies, in the order of the rows.
    #[getter]
    fn bodies(&self) -> Vec<String> {
        self.bodies.clone()
    }

    /// Names of the fenders; `contacts["fender"]` counts them.
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

    /// The scenario's notices, and what of the scenario is left to the host.
    #[getter]
    fn notices(&self) -> Vec<String> {
        self.engine.notices().to_vec()
    }

    /// Which bodies are fixed, in the order of the rows.
    #[getter]
    fn fixed(&self) -> Vec<bool> {
        let bodies = self.engine.model().bodies().iter();
        bodies.map(|body| body.mobility == Mobility::Fixed).collect()
    }

    /// Forgets all that happened; states are the scenario's again.
    fn reset(&mut self, py: Python<'_>) -> PyResult<()> {
        self.engine.reset();
        self.states.write(py, |rows| write_states(self.engine.initial_states(), rows))?;
        self.loads.write(py, |rows| rows.fill(0.0))?;
        self.show(py)?;
        self.states_after.write(py, |rows| write_states(self.engine.initial_states(), rows))
    }

    /// All that can change, as bytes.
    fn save<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        // What was written into the arrays since the last step is saved too.
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

    /// Becomes what `save` saved, of an engine of the same scenario and settings. Any bytes may be given.
    fn restore(&mut self, py: Python<'_>, saved: &[u8]) -> PyResult<()> {
        self.engine.restore(saved).map_err(|error| errors::of_engine(py, &error))?;
        self.uses_loads = self.engine.loads().is_some();
        self.follow(py)
    }

    /// Another engine that goes on from here.
    fn copy(&mut self, py: Python<'_>) -> PyResult<Engine> {
        let saved = self.save(py)?;
        let mut engine = self.engine.clone();
        engine.restore(saved.as_bytes()).map_err(|error| errors::of_engine(py, &error))?;
        let mut copy = Engine::around(py, engine)?;
        copy.uses_loads = self.uses_loads;
        copy.follow(py)?;
        Ok(copy)
    }

    fn __copy__(&mut self, py: Python<'_>) -> PyResult<Engine> {
        self.copy(py)
    }

    fn __deepcopy__(&mut self, py: Python<'_>, _memo: &Bound<'_, PyAny>) -> PyResult<Engine> {
        self.copy(py)
    }

    fn __repr__(&self) -> String {
        format!("<fenderline.Engine of {}>", self.bodies.join(", "))
    }
}

impl Engine {
    fn around(py: Python<'_>, engine: embed::Engine) -> PyResult<Engine> {
        let model = engine.model();
        let bodies: Vec<String> = model.bodies().iter().map(|body| body.name.clone()).collect();
        let fenders = model.fenders().iter().map(|fender| fender.name.clone()).collect();
        let count = bodies.len();
        let present = matches!(engine.host(), Host::Direct { .. });
        let made = Engine {
            uses_loads: present && engine.method() == Method::Coupled,
            states: Shared::zeros(py, count, STATE),
            loads: Shared::zeros(py, count, WRENCH),
            wrenches: Shown::zeros(py, count, &[WRENCH])?,
            peak_wrenches: Shown::zeros(py, count, &[WRENCH])?,
            states_after: Shown::zeros(py, count, &[STATE])?,
            state_rows: engine.initial_states().to_vec(),
            load_rows: vec![Wrench::default(); count],
            engine,
            bodies,
            fenders,
        };
        made.states.write(py, |rows| write_states(made.engine.initial_states(), rows))?;
        made.states_after.write(py, |rows| write_states(made.engine.initial_states(), rows))?;
        Ok(made)
    }

    /// Shows the results of the last step.
    fn show(&self, py: Python<'_>) -> PyResult<()> {
        let Ok(results) = self.engine.results() else {
            self.peak_wrenches.write(py, |rows| rows.fill(0.0))?;
            return self.wrenches.write(py, |rows| rows.fill(0.0));
        };
        self.peak_wrenches.write(py, |rows| write_wrenches(results.peak_wrenches, rows))?;
        self.wrenches.write(py, |rows| write_wrenches(results.wrenches, rows))?;
        self.states_after.write(py, |rows| write_states(results.states_after, rows))
    }

    /// Shows states, loads and results of the engine.
    fn follow(&self, py: Python<'_>) -> PyResult<()> {
        self.states.write(py, |rows| write_states(self.engine.states(), rows))?;
        self.loads.write(py, |rows| match self.engine.loads() {
            Some(loads) => write_wrenches(loads, rows),
            None => rows.fill(0.0),
        })?;
        self.show(py)
    }
}

fn no_choice(what: &str, given: &str, known: &str) -> PyErr {
    PyValueError::new_err(format!("{what} is {given:?}: there are {known}"))
}

/// Seconds that so many steps of a copy of an engine take without Python: for the bench.
#[pyfunction]
pub(crate) fn seconds_of_steps(engine: &Engine, step_s: f64, count: u64) -> PyResult<f64> {
    let mut own = engine.engine.clone();
    let states = own.states().to_vec();
    let loads = engine.uses_loads.then_some(engine.load_rows.as_slice());
    let start = std::time::Instant::now();
    for _ in 0..count {
        let taken = own.advance(&states, loads, step_s);
        taken.map_err(|error| PyValueError::new_err(error.to_string()))?;
    }
    Ok(start.elapsed().as_secs_f64())
}
