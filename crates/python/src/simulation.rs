//! One whole simulation.

use std::sync::Arc;

use fenderline_contact::Wrench;
use fenderline_results::{InMemory, Tables};
use fenderline_scenario::order;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{ReadOnly, STATE, Shared, WRENCH, read_wrenches, write_states, write_wrenches};
use crate::contacts::{StepEvent, contact_event, contacts_array, world_event};
use crate::controls::controls;
use crate::errors;
use crate::journal::{Input, Journal};
use crate::pickled::Pickled;
use crate::run::{CannotRun, Run};
use crate::scenario::{Scenario, toml_of};
use crate::summaries::{Summary, all_tables};
use crate::tables;
use crate::totals::Totals;
use crate::whole;

/// Steps that are taken between two checks for an interrupt by the user.
const STEPS_AT_A_TIME: u64 = 2000;

/// A simulation of a whole scenario, step by step. With `record=True` the simulation records the tables of
/// `fenderline run`.
///
/// A simulation can be copied and pickled. A pickle of a simulation holds the scenario and all inputs since the start:
/// loading the pickle computes the steps again, with the same bits.
///
/// >>> import fenderline
/// >>> simulation = fenderline.Simulation(fenderline.example("docking"))
/// >>> simulation.control_names
/// ['ship.rudder_rad', 'ship.engine', 'ship.thruster.bow', 'ship.thruster.stern']
/// >>> simulation.controls[1] = -0.5
/// >>> simulation.step(60)
/// >>> bool(simulation.states[0, 3] < 1.5)
/// True
#[pyclass(module = "fenderline")]
pub(crate) struct Simulation {
    scenario: Py<Scenario>,
    names: Arc<Names>,
    run: Run,
    journal: Arc<Journal>,
    tables: Option<Tables<InMemory>>,
    totals: Totals,
    notices: Arc<Vec<String>>,
    /// Events since the step that has the number `events_from`.
    events: Vec<StepEvent>,
    events_from: u64,
    controls: Py<PyArray1<f64>>,
    external_wrenches: Shared,
    external_rows: Vec<Wrench>,
    states: ReadOnly,
    wrenches: ReadOnly,
}

/// A saved state of a simulation: see `Simulation.save`. A saved state can be pickled as a simulation can.
#[pyclass(frozen, module = "fenderline")]
pub(crate) struct SimulationState {
    scenario: Py<Scenario>,
    names: Arc<Names>,
    run: Run,
    journal: Arc<Journal>,
    totals: Totals,
    notices: Arc<Vec<String>>,
    events: Vec<StepEvent>,
    events_from: u64,
    controls: Vec<f64>,
    external: Vec<Wrench>,
}

/// Names by index.
struct Names {
    bodies: Vec<String>,
    fenders: Vec<String>,
    vessels: Vec<String>,
    tugs: Vec<String>,
    lines: Vec<String>,
    anchors: Vec<String>,
}

#[pymethods]
impl Simulation {
    #[new]
    #[pyo3(signature = (scenario, *, record=false))]
    pub(crate) fn new(
        py: Python<'_>,
        scenario: Py<Scenario>,
        record: bool,
    ) -> PyResult<Simulation> {
        let own = scenario.get();
        let setup = &own.checked.setup;
        let run = Run::new(&own.checked, Arc::new(controls(setup)));
        let run = run.map_err(|error| cannot_run(py, &error))?;
        let body = |index: usize| setup.bodies[index].name.clone();
        let names = Names {
            bodies: own.bodies(),
            fenders: own.fenders(),
            vessels: setup.world.vessels.iter().map(|vessel| body(vessel.body)).collect(),
            tugs: setup.world.tugs.iter().map(|tug| tug.tug.name.clone()).collect(),
            lines: setup.world.lines.iter().map(|line| line.line.name.clone()).collect(),
            anchors: setup.world.anchors.iter().map(|anchor| anchor.gear.name.clone()).collect(),
        };
        let tables = match record {
            true => {
                let energy = run.simulation.energy();
                let started = Tables::start(&InMemory, setup, energy, &own.checked.output);
                Some(started.map_err(|error| errors::refused(py, error.to_string()))?)
            }
            false => None,
        };
        let notices = own.checked.notices.iter().map(ToString::to_string).collect();
        let totals = Totals::new(&own.checked, &run.simulation);
        Simulation::around(py, scenario, Arc::new(names), (run, totals), Arc::new(notices), tables)
    }

    /// Takes `steps` steps with the controls and external wrenches as they are set.
    #[pyo3(signature = (steps=1))]
    fn step(
        &mut self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole::steps)] steps: u64,
    ) -> PyResult<()> {
        self.read_inputs(py)?;
        self.clear_events();
        self.advance(py, steps)
    }

    /// Runs the simulation to the end of the scenario's duration, or to a given time.
    #[pyo3(signature = (until_s=None))]
    fn run(
        &mut self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole::until_s)] until_s: Option<f64>,
    ) -> PyResult<()> {
        let simulation = &self.run.simulation;
        let end = match until_s {
            None => simulation.steps_total(),
            Some(until_s) if until_s.is_finite() && until_s >= 0.0 => {
                simulation.steps_until(until_s)
            }
            Some(other) => return Err(errors::bad_argument(format!("until_s is {other}"))),
        };
        let left = end.saturating_sub(simulation.steps_taken());
        let most = whole::MOST_STEPS as u64;
        if left > most {
            let why = format!(
                "until_s is {} s, more than {most} steps away",
                until_s.unwrap_or(f64::NAN)
            );
            return Err(errors::argument(py, why));
        }
        self.step(py, left)
    }

    /// Gives an order, with the keys of a scenario's `[[order]]`: `order(vessel="ship", rudder="10 deg")`. Without `at`
    /// the order is carried out in the next step.
    #[pyo3(signature = (**keys))]
    fn order(&mut self, py: Python<'_>, keys: Option<&Bound<'_, PyDict>>) -> PyResult<()> {
        let text = keys.map(|keys| toml_of(keys.as_any())).transpose()?.unwrap_or_default();
        let read = order(&text, "order", self.run.simulation.setup());
        let read = read.map_err(|error| errors::of_scenario(py, &error))?;
        self.run.simulation.order(read).map_err(|error| errors::of_setup(py, &error))?;
        let step = self.run.simulation.steps_taken();
        Arc::make_mut(&mut self.journal).add(step, Input::Order(text));
        Ok(())
    }

    /// The scenario.
    #[getter]
    fn scenario(&self, py: Python<'_>) -> Py<Scenario> {
        self.scenario.clone_ref(py)
    }

    /// Current time (s).
    #[getter]
    fn time_s(&self) -> f64 {
        self.run.simulation.time_s()
    }

    /// Δt (s).
    #[getter]
    fn step_s(&self) -> f64 {
        self.run.simulation.setup().step_s
    }

    /// Number of steps in the scenario's duration.
    #[getter]
    fn steps_total(&self) -> u64 {
        self.run.simulation.steps_total()
    }

    /// Whether the scenario's duration is over; steps can still be taken.
    #[getter]
    fn is_done(&self) -> bool {
        self.run.simulation.is_done()
    }

    /// The scenario's title.
    #[getter]
    fn title(&self) -> &str {
        &self.scenario.get().checked.title
    }

    /// Names of the bodies, in the order of the arrays' rows.
    #[getter]
    fn bodies(&self) -> Vec<String> {
        self.names.bodies.clone()
    }

    /// Names of the fenders.
    #[getter]
    fn fenders(&self) -> Vec<String> {
        self.names.fenders.clone()
    }

    /// Names of the controls, in the order of `controls`.
    #[getter]
    fn control_names(&self) -> Vec<String> {
        self.run.controls.iter().map(|control| control.name.clone()).collect()
    }

    /// Values of the controls. NaN leaves a control to the scenario's orders and pilots; a number takes the control
    /// over from them in the next step. Write into it.
    #[getter]
    fn controls(&self, py: Python<'_>) -> Py<PyArray1<f64>> {
        self.controls.clone_ref(py)
    }

    /// Further forces on each body, one row per body: force north and east (N), moment about the centre of gravity
    /// (N·m). Write into this array; the forces act until they are changed.
    #[getter]
    fn external_wrenches(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.external_wrenches.array(py)
    }

    /// Present states of the bodies, one row per body: north and east (m), heading (rad), velocity north and east
    /// (m/s), rate of turn (rad/s). With the coupled method and the integrator `semi_implicit`, velocities are half a
    /// step older than positions (half of the last sub-step, where contacts needed several). The array is read-only;
    /// each step overwrites it.
    #[getter]
    fn states(&self, py: Python<'_>) -> Py<PyAny> {
        self.states.view(py)
    }

    /// Contact wrenches of the last step, one row per body: force north and east (N), moment (N·m). The array is
    /// read-only; each step overwrites it.
    #[getter]
    fn wrenches(&self, py: Python<'_>) -> Py<PyAny> {
        self.wrenches.view(py)
    }

    /// The contact patches of the last step, as a new structured array.
    #[getter]
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        contacts_array(py, self.run.simulation.contacts())
    }

    /// Events of the steps in the last call of `step` or `run`.
    #[getter]
    fn events(&self) -> Vec<StepEvent> {
        self.events.clone()
    }

    /// The energy ledger of the run up to now (J).
    #[getter]
    fn energy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let e = self.run.simulation.energy();
        let dict = PyDict::new(py);
        for (name, value) in [
            ("kinetic_j", e.kinetic_j),
            ("load_work_j", e.load_work_j),
            ("normal_work_j", e.normal_work_j),
            ("tangential_work_j", e.tangential_work_j),
            ("height_work_j", e.height_work_j),
            ("stored_j", e.stored_j),
            ("shear_stored_j", e.shear_stored_j),
            ("hysteresis_j", e.hysteresis_j),
            ("damping_j", e.damping_j),
            ("restitution_j", e.restitution_j),
            ("friction_j", e.friction_j),
            ("pile_stored_j", e.pile_stored_j),
            ("pile_damping_j", e.pile_damping_j),
            ("pile_yield_j", e.pile_yield_j),
            ("contact_residual_j", e.contact_residual_j),
            ("residual_j", e.residual_j),
        ] {
            dict.set_item(name, value)?;
        }
        for (name, work_j) in e.loads.parts() {
            dict.set_item(format!("{name}_work_j"), work_j)?;
        }
        dict.set_item("exchanged_j", e.exchanged_j())?;
        Ok(dict)
    }

    /// The verdict on the run so far: the worst of the findings in `summary()["findings"]`, such as `all_well`,
    /// `fender_over_rated` or `structure_struck`.
    #[getter]
    fn verdict(&self) -> &'static str {
        self.run.simulation.verdict().key()
    }

    /// Summaries of the run so far: tables `pairs`, `fenders`, `dolphins`, `berthings`, `verdicts` and `findings`.
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let simulation = &self.run.simulation;
        let summary = [Summary::of(simulation)];
        let setup = simulation.setup();
        tables::results(py, self.title(), all_tables(setup, 0, &summary))
    }

    /// The summary of the run so far as a tree of dictionaries and lists, with the contents of `summary.json`: verdict
    /// and findings, fenders, berthing energy, energy ledger, vessels, tugs, lines, anchors and events. Quantities that
    /// are not known have no key in the tree.
    fn summary_tree<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.totals.tree(py, self.title(), &self.notices, &self.run.simulation)
    }

    /// The berthing energy by the formula and in the run, as a dictionary: `energy_j`, `added_mass`, `eccentricity`,
    /// `fender_energy_j` of the first hit, `later_energy_j` of the largest later hit and others, or `error`. The result
    /// is `None` if the scenario has no `[berthing]`, or before the first touch.
    #[getter]
    fn berthing<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        if self.run.simulation.berthing().is_none() {
            return Ok(None);
        }
        Ok(Some(self.summary_tree(py)?.get_item("berthing")?))
    }

    /// Ends the recording and returns its tables: those that `fenderline run` writes, with the same numbers.
    fn results<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let Some(recorded) = self.tables.take() else {
            let message = "the simulation has no recording: create the simulation with record=True, and call \
                           results() once".to_owned();
            return Err(errors::refused(py, message));
        };
        let kept = recorded.finish().map_err(|error| errors::refused(py, error.to_string()))?;
        tables::results(py, self.title(), kept)
    }

    /// Saves the present state of the simulation, for `restore`.
    fn save(&self, py: Python<'_>) -> PyResult<SimulationState> {
        self.refuse_recording(py, "saved")?;
        let mut external = self.external_rows.clone();
        self.external_wrenches.read(py, |numbers| read_wrenches(numbers, &mut external))??;
        Ok(SimulationState {
            scenario: self.scenario.clone_ref(py),
            names: Arc::clone(&self.names),
            run: self.run.clone(),
            journal: Arc::clone(&self.journal),
            totals: self.totals.clone(),
            notices: Arc::clone(&self.notices),
            events: self.events.clone(),
            events_from: self.events_from,
            controls: self.controls.bind(py).try_readonly()?.as_slice()?.to_vec(),
            external,
        })
    }

    /// Restores a state that `save` returned, of this simulation or of another simulation of an equal scenario.
    fn restore(&mut self, py: Python<'_>, state: &SimulationState) -> PyResult<()> {
        self.refuse_recording(py, "restored")?;
        let (own, other) = (&self.scenario.get().source, &state.scenario.get().source);
        if !Arc::ptr_eq(own, other) && own != other {
            let message = "the saved state belongs to another scenario".to_owned();
            return Err(errors::refused(py, message));
        }
        self.take_over(py, state)
    }

    /// A copy of the simulation that continues independently. The copy of a simulation that is recorded computes its
    /// steps again.
    fn copy(&self, py: Python<'_>) -> PyResult<Simulation> {
        if self.tables.is_some() {
            return Simulation::of_pickled(py, &self.pickled(py)?);
        }
        self.save(py)?.simulation(py)
    }

    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyAny>, (&'static str, Pickled))> {
        let made = py.import("fenderline._pickling")?.getattr("simulation")?;
        Ok((made, (env!("CARGO_PKG_VERSION"), self.pickled(py)?)))
    }

    fn __copy__(&self, py: Python<'_>) -> PyResult<Simulation> {
        self.copy(py)
    }

    fn __deepcopy__(&self, py: Python<'_>, _memo: &Bound<'_, PyAny>) -> PyResult<Simulation> {
        self.copy(py)
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("fenderline._html")?.getattr("simulation")?.call1((slf,))
    }

    fn __repr__(&self) -> String {
        format!("<fenderline.Simulation \"{}\" at {} s>", self.title(), self.time_s())
    }
}

#[pymethods]
impl SimulationState {
    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyAny>, (&'static str, Pickled))> {
        let made = py.import("fenderline._pickling")?.getattr("simulation_state")?;
        let pickled = Pickled {
            scenario: self.scenario.clone_ref(py),
            is_recorded: false,
            inputs: self.journal.inputs.clone(),
            steps: self.run.simulation.steps_taken(),
            events_from: self.events_from,
            controls: self.controls.clone(),
            external: self.external.clone(),
        };
        Ok((made, (env!("CARGO_PKG_VERSION"), pickled)))
    }

    fn __repr__(&self) -> String {
        let title = &self.scenario.get().checked.title;
        format!("<fenderline.SimulationState \"{title}\" at {} s>", self.run.simulation.time_s())
    }
}

impl SimulationState {
    /// A simulation that goes on from the saved state.
    fn simulation(&self, py: Python<'_>) -> PyResult<Simulation> {
        let run = (self.run.clone(), self.totals.clone());
        let (names, notices) = (Arc::clone(&self.names), Arc::clone(&self.notices));
        let scenario = self.scenario.clone_ref(py);
        let mut made = Simulation::around(py, scenario, names, run, notices, None)?;
        made.take_over(py, self)?;
        Ok(made)
    }
}

/// Why steps of a simulation failed.
enum Stopped {
    Step(fenderline_sim::SimError),
    NotFinite(fenderline_results::NotFinite),
}

impl Stopped {
    fn exception(&self, py: Python<'_>) -> PyErr {
        match self {
            Stopped::Step(error) => errors::of_simulation(py, error),
            Stopped::NotFinite(error) => errors::refused(py, error.to_string()),
        }
    }
}

impl Simulation {
    fn around(
        py: Python<'_>,
        scenario: Py<Scenario>,
        names: Arc<Names>,
        (run, totals): (Run, Totals),
        notices: Arc<Vec<String>>,
        tables: Option<Tables<InMemory>>,
    ) -> PyResult<Simulation> {
        let count = names.bodies.len();
        let controls = PyArray1::from_vec(py, vec![f64::NAN; run.controls.len()]).unbind();
        let made = Simulation {
            scenario,
            names,
            run,
            journal: Arc::new(Journal::new(count)),
            tables,
            totals,
            notices,
            events: Vec::new(),
            events_from: 0,
            controls,
            external_wrenches: Shared::zeros(py, count, WRENCH),
            external_rows: vec![Wrench::default(); count],
            states: ReadOnly::zeros(py, count, &[STATE])?,
            wrenches: ReadOnly::zeros(py, count, &[WRENCH])?,
        };
        made.show(py)?;
        Ok(made)
    }

    /// Reads controls and external wrenches from Python's arrays.
    fn read_inputs(&mut self, py: Python<'_>) -> PyResult<()> {
        let controls = self.controls.bind(py).try_readonly()?;
        let values = controls.as_slice()?;
        if values.len() != self.run.controls.len() {
            return Err(errors::bad_argument("the array of controls has a wrong length"));
        }
        if let Some(reason) = Run::refused(&self.run.controls, values) {
            return Err(errors::refused(py, reason));
        }
        let rows = &mut self.external_rows;
        let is_finite = |w: &Wrench| w.force_n.is_finite() && w.moment_nm.is_finite();
        self.external_wrenches.read(py, |numbers| read_wrenches(numbers, rows))??;
        if let Some(body) = rows.iter().position(|wrench| !is_finite(wrench)) {
            let body = &self.names.bodies[body];
            return Err(errors::refused(
                py,
                format!("the external wrench on {body} is not finite"),
            ));
        }
        let step = self.run.simulation.steps_taken();
        self.run.simulation.set_external(rows);
        let Simulation { run, journal, external_rows, .. } = self;
        // A journal is shared with the states that were saved: it is copied where it changes.
        if journal.differs(external_rows) {
            Arc::make_mut(journal).add_external(step, external_rows);
        }
        run.order(values, |control, value| {
            Arc::make_mut(journal).add(step, Input::Control(control, value));
        });
        Ok(())
    }

    fn clear_events(&mut self) {
        self.events.clear();
        self.events_from = self.run.simulation.steps_taken();
    }

    /// Takes steps of the simulation, and stops for an interrupt by the user.
    fn advance(&mut self, py: Python<'_>, steps: u64) -> PyResult<()> {
        let mut left = steps;
        while left > 0 {
            let now = left.min(STEPS_AT_A_TIME);
            left -= now;
            let taken = match now {
                // Letting other threads run costs more than a step.
                1 => self.steps(1),
                _ => py.detach(|| self.steps(now)),
            };
            if let Err(why) = taken {
                self.show(py)?;
                return Err(why.exception(py));
            }
            // Update the arrays before a possible interrupt.
            self.show(py)?;
            if left > 0 {
                py.check_signals()?;
            }
        }
        Ok(())
    }

    /// What a pickle holds.
    fn pickled(&self, py: Python<'_>) -> PyResult<Pickled> {
        let mut external = self.external_rows.clone();
        self.external_wrenches.read(py, |numbers| read_wrenches(numbers, &mut external))??;
        Ok(Pickled {
            scenario: self.scenario.clone_ref(py),
            is_recorded: self.tables.is_some(),
            inputs: self.journal.inputs.clone(),
            steps: self.run.simulation.steps_taken(),
            events_from: self.events_from,
            controls: self.controls.bind(py).try_readonly()?.as_slice()?.to_vec(),
            external,
        })
    }

    /// A simulation that has taken all the steps of the pickled simulation.
    pub(crate) fn of_pickled(py: Python<'_>, pickled: &Pickled) -> PyResult<Simulation> {
        let mut made = Simulation::new(py, pickled.scenario.clone_ref(py), pickled.is_recorded)?;
        made.replay(py, pickled)?;
        Ok(made)
    }

    /// Repeats the inputs and steps of a pickled simulation from its start.
    fn replay(&mut self, py: Python<'_>, pickled: &Pickled) -> PyResult<()> {
        let mut external = vec![Wrench::default(); self.external_rows.len()];
        for (step, input) in &pickled.inputs {
            self.advance_to(py, *step)?;
            match input {
                Input::Control(index, value) => {
                    if *index >= self.run.controls.len() {
                        return Err(errors::bad_argument(
                            "the pickle sets a control that the scenario does not have",
                        ));
                    }
                    self.run.order_one(*index, *value);
                }
                Input::External(body, wrench) => {
                    let row = external.get_mut(*body);
                    let refused = || {
                        errors::bad_argument(
                            "the pickle sets a wrench on a body that the scenario \
                                                           does not have",
                        )
                    };
                    *row.ok_or_else(refused)? = *wrench;
                    self.run.simulation.set_external(&external);
                }
                Input::Order(text) => {
                    let read = order(text, "order", self.run.simulation.setup());
                    let read = read.map_err(|error| errors::of_scenario(py, &error))?;
                    let given = self.run.simulation.order(read);
                    given.map_err(|error| errors::of_setup(py, &error))?;
                }
            }
        }
        self.advance_to(py, pickled.events_from)?;
        self.clear_events();
        self.advance_to(py, pickled.steps)?;
        let mut journal = Journal::new(external.len());
        journal.inputs.clone_from(&pickled.inputs);
        journal.external = external;
        self.journal = Arc::new(journal);
        self.set_arrays(py, &pickled.controls, &pickled.external)?;
        self.show(py)
    }

    fn advance_to(&mut self, py: Python<'_>, step: u64) -> PyResult<()> {
        let left = step.saturating_sub(self.run.simulation.steps_taken());
        self.advance(py, left)
    }

    fn set_arrays(
        &mut self,
        py: Python<'_>,
        controls: &[f64],
        external: &[Wrench],
    ) -> PyResult<()> {
        let mut array = self.controls.bind(py).try_readwrite()?;
        let values = array.as_slice_mut()?;
        if values.len() != controls.len() {
            return Err(errors::bad_argument("the array of controls has a wrong length"));
        }
        values.copy_from_slice(controls);
        self.external_wrenches.write(py, |rows| write_wrenches(external, rows))
    }

    fn steps(&mut self, count: u64) -> Result<(), Stopped> {
        for _ in 0..count {
            let record = self.run.step().map_err(Stopped::Step)?;
            self.totals.add(&record);
            let Names { bodies, fenders, vessels, tugs, lines, anchors } = &*self.names;
            let contact = record.events.iter().map(|event| contact_event(event, bodies, fenders));
            self.events.extend(contact);
            let of = [vessels.as_slice(), tugs, lines, anchors];
            self.events.extend(record.world_events.iter().map(|event| world_event(event, of)));
            if let Some(tables) = &mut self.tables {
                tables.write(&record).map_err(Stopped::NotFinite)?;
            }
            self.totals.mark(&self.run.simulation);
        }
        Ok(())
    }

    fn show(&self, py: Python<'_>) -> PyResult<()> {
        self.states.write(py, |rows| write_states(self.run.simulation.states(), rows))?;
        self.wrenches.write(py, |rows| write_wrenches(self.run.simulation.wrenches(), rows))
    }

    fn take_over(&mut self, py: Python<'_>, state: &SimulationState) -> PyResult<()> {
        self.set_arrays(py, &state.controls, &state.external)?;
        self.run = state.run.clone();
        self.totals.clone_from(&state.totals);
        self.journal = Arc::clone(&state.journal);
        self.events.clone_from(&state.events);
        self.events_from = state.events_from;
        self.show(py)
    }

    fn refuse_recording(&self, py: Python<'_>, what: &str) -> PyResult<()> {
        match self.tables {
            None => Ok(()),
            Some(_) => {
                Err(errors::refused(py, format!("a simulation that is recorded cannot be {what}")))
            }
        }
    }
}

/// Makes the exception for a run that cannot start.
pub(crate) fn cannot_run(py: Python<'_>, error: &CannotRun) -> PyErr {
    match error {
        CannotRun::Setup(error) => errors::of_setup(py, error),
        CannotRun::Providers => errors::refused(py, error.to_string()),
    }
}
