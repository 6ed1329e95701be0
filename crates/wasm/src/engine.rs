//! The contact engine, with its input and its results as arrays of numbers.

use fenderline_contact::{BodyState, Wrench};
use fenderline_embed::Engine;
use serde_json::json;

use crate::numbers::{Rows, of_contact, of_state, of_wrench, state_of, wrench_of};
use crate::problem::Problem;
use crate::run::{Source, parse};

/// A contact engine with the arrays of its input and of its last results.
pub struct HostedEngine {
    engine: Engine,
    states: Rows,
    loads: Rows,
    wrenches: Rows,
    peak_wrenches: Rows,
    states_after: Rows,
    contacts: Rows,
    /// The input in the form that the engine takes; the memory is kept, so that a step allocates nothing.
    input: (Vec<BodyState>, Vec<Wrench>),
}

impl HostedEngine {
    /// Makes an engine for the bodies, fenders and materials of a scenario.
    ///
    /// # Errors
    /// Fails for a mistake in the scenario or in the settings.
    pub fn from_scenario(source: &Source<'_>, settings: &str) -> Result<HostedEngine, Problem> {
        let settings = crate::model::settings(settings)?;
        Ok(HostedEngine::new(Engine::from_scenario(parse(source)?, &settings)?))
    }

    /// Makes an engine of a model in JSON.
    ///
    /// # Errors
    /// Fails for a mistake in the model or in the settings.
    pub fn from_model(model: &str, settings: &str) -> Result<HostedEngine, Problem> {
        Ok(HostedEngine::new(crate::model::engine(model, settings)?))
    }

    fn new(engine: Engine) -> HostedEngine {
        let count = engine.initial_states().len();
        let mut made = HostedEngine {
            engine,
            states: Rows::default(),
            loads: Rows::default(),
            wrenches: Rows::default(),
            peak_wrenches: Rows::default(),
            states_after: Rows::default(),
            contacts: Rows::default(),
            input: (Vec::with_capacity(count), Vec::with_capacity(count)),
        };
        made.show_start();
        made
    }

    /// Fills the arrays with the values before the first step. The arrays stay at the same addresses in memory, because
    /// JavaScript's views need this.
    fn show_start(&mut self) {
        let initial = self.engine.initial_states();
        self.states.set(initial.iter().map(of_state));
        for rows in [&mut self.loads, &mut self.wrenches, &mut self.peak_wrenches] {
            rows.set_zero(3 * initial.len());
        }
        for rows in [&mut self.states_after, &mut self.contacts] {
            rows.set_zero(0);
        }
    }

    /// Takes one step of `step_s` seconds from the states in the array, with the loads in the array if `with_loads` is
    /// true.
    ///
    /// # Errors
    /// Fails for a state, a load or a step that the engine refuses; nothing changes then.
    pub fn advance(&mut self, step_s: f64, with_loads: bool) -> Result<(), Problem> {
        let (states, loads) = &mut self.input;
        states.clear();
        states.extend(self.states.numbers().chunks_exact(6).map(state_of));
        loads.clear();
        loads.extend(self.loads.numbers().chunks_exact(3).map(wrench_of));
        self.engine.advance(states, with_loads.then_some(loads), step_s)?;
        self.show()
    }

    /// Fills the arrays of results anew.
    fn show(&mut self) -> Result<(), Problem> {
        let results = self.engine.results()?;
        self.wrenches.set(results.wrenches.iter().map(of_wrench));
        self.peak_wrenches.set(results.peak_wrenches.iter().map(of_wrench));
        self.states_after.set(results.states_after.iter().map(of_state));
        self.contacts.set(results.contacts.iter().map(of_contact));
        Ok(())
    }

    /// Tells the engine that a body is put at a new place instead of moving there: see [`Engine::mark_teleported`].
    ///
    /// # Errors
    /// Fails if no body has the index `body`.
    pub fn mark_teleported(&mut self, body: usize) -> Result<(), Problem> {
        Ok(self.engine.mark_teleported(body)?)
    }

    /// Returns to the start.
    pub fn reset(&mut self) {
        self.engine.reset();
        self.show_start();
    }

    /// The engine as bytes.
    #[must_use]
    pub fn save(&self) -> Vec<u8> {
        self.engine.save()
    }

    /// Restores what [`HostedEngine::save`] gave.
    ///
    /// # Errors
    /// Fails for bytes that are not a saved engine of the same model and settings; nothing changes then.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), Problem> {
        self.engine.restore(bytes)?;
        self.states.set(self.engine.states().iter().map(of_state));
        if self.engine.results().is_ok() { self.show() } else { Ok(()) }
    }

    /// Names of bodies and fenders, and the notices, as JSON.
    #[must_use]
    pub fn description(&self) -> String {
        let model = self.engine.model();
        let bodies: Vec<&str> = model.bodies().iter().map(|body| &*body.name).collect();
        let fenders: Vec<&str> = model.fenders().iter().map(|fender| &*fender.name).collect();
        json!({ "bodies": bodies, "fenders": fenders, "notices": self.engine.notices() })
            .to_string()
    }

    /// Input array: the states at the step's start, [`crate::numbers::STATE_FIELDS`] of each body.
    #[must_use]
    pub fn states(&self) -> &[f64] {
        self.states.numbers()
    }

    /// Input array: the loads on the bodies, [`crate::numbers::WRENCH_FIELDS`] of each body.
    #[must_use]
    pub fn loads(&self) -> &[f64] {
        self.loads.numbers()
    }

    /// Result array: the contact wrenches for the host program, [`crate::numbers::WRENCH_FIELDS`] of each body.
    #[must_use]
    pub fn wrenches(&self) -> &[f64] {
        self.wrenches.numbers()
    }

    /// Result array: the largest wrench on each body within the step.
    #[must_use]
    pub fn peak_wrenches(&self) -> &[f64] {
        self.peak_wrenches.numbers()
    }

    /// Result array: the engine's states at the step's end; empty if the host program moves the bodies.
    #[must_use]
    pub fn states_after(&self) -> &[f64] {
        self.states_after.numbers()
    }

    /// Result array: the contacts, [`crate::numbers::CONTACT_FIELDS`] of each contact.
    #[must_use]
    pub fn contacts(&self) -> &[f64] {
        self.contacts.numbers()
    }
}
