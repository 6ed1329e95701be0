//! The engine in one object.

use std::mem;
use std::sync::Arc;

use fenderline_contact::{
    self as contact, BodyId, BodyState, CoSimHost, DirectHost, HostWorkspace, MaterialId, Memory,
    Mobility, Model, Pair, StepError, Workspace, Wrench,
};
use fenderline_scenario::Scenario;
use fenderline_sim::{Integrator, Method, PairSetup, Setup};

use crate::error::EngineError;
use crate::recording::Recording;
use crate::results::{Results, Saved, of_cosim, of_direct, of_paper};
use crate::settings::{CoriolisTerms, Host, MAX_DELAY_STEPS, Settings};

/// The contact engine with its model, its memory, and the states and loads that the host has set. Cloning it
/// branches the run; clones share the model.
#[derive(Clone, Debug)]
pub struct Engine {
    pub(crate) plan: Arc<Plan>,
    pub(crate) core: Core,
    spare: Core,
    /// The input states, one per body.
    pub(crate) states: Vec<BodyState>,
    /// Which of them the host has set; a fixed body's need not be.
    pub(crate) is_set: Vec<bool>,
    /// The loads, one per body; `None` if the host has set no loads.
    pub(crate) loads: Option<Vec<Wrench>>,
    pub(crate) latest: Latest,
    /// Zero loads, for a direct host that has set no loads.
    no_loads: Vec<Wrench>,
    /// The last steps, if [`Engine::record`] asked for a recording.
    pub(crate) recording: Option<Box<Recording>>,
}

/// The constant part.
#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) title: String,
    pub(crate) model: Model,
    pub(crate) initial: Vec<BodyState>,
    pub(crate) method: Method,
    pub(crate) host: Host,
    pub(crate) notices: Vec<String>,
    /// The pairs of the model, in the order in which they were added.
    pub(crate) pairs: Vec<Pair>,
    pub(crate) all_other_pairs: Option<MaterialId>,
}

/// The mutable part, and buffers. An engine has two: a step runs on a copy in the second, and the two are
/// swapped when it succeeds.
#[derive(Clone, Debug)]
pub(crate) enum Core {
    /// For the paper's method.
    Paper {
        memory: Memory,
        work: Box<Workspace>,
    },
    Direct {
        host: DirectHost,
        work: Box<HostWorkspace>,
    },
    CoSimulation {
        host: CoSimHost,
        work: Box<HostWorkspace>,
    },
}

/// Where the latest results are.
#[derive(Clone, Debug)]
pub(crate) enum Latest {
    Nowhere,
    InWorkspace,
    Saved(Box<Saved>),
}

impl Engine {
    /// An engine for the bodies, fenders, materials and pairs of a scenario. The host computes all other forces
    /// on the bodies (loads, wind, propellers, lines, tugs): [`Engine::notices`] names the parts of the scenario
    /// that the host must compute.
    ///
    /// # Errors
    /// [`EngineError`] for settings that conflict with each other or with the scenario.
    pub fn from_scenario(scenario: Scenario, settings: &Settings) -> Result<Engine, EngineError> {
        let Scenario { title, setup, notices, .. } = scenario;
        let mut notices: Vec<String> = notices.iter().map(ToString::to_string).collect();
        notices.extend(left_to_the_host(&setup));
        Engine::from_setup(title, setup, notices, settings)
    }

    pub(crate) fn from_setup(
        title: String,
        mut setup: Setup,
        notices: Vec<String>,
        settings: &Settings,
    ) -> Result<Engine, EngineError> {
        let method = settings.method.unwrap_or(setup.method);
        setup.method = method;
        match settings.host {
            Host::Direct { coriolis: None } => {}
            Host::Direct { coriolis: Some(CoriolisTerms::ByEngine) } => {
                setup.integrator = Integrator::SemiImplicit;
            }
            // The observed loads of a co-simulation host include the Coriolis terms.
            Host::Direct { coriolis: Some(CoriolisTerms::InLoads) } | Host::CoSimulation(_) => {
                setup.integrator = Integrator::Euler;
            }
        }
        if let Host::CoSimulation(host) = settings.host {
            if method == Method::Paper {
                return Err(EngineError::Settings(
                    "the paper's method has no co-simulation host: use the coupled method",
                ));
            }
            if host.delay_steps > MAX_DELAY_STEPS {
                return Err(EngineError::Settings("a host's delay may be at most 1000 steps"));
            }
        }
        let model = setup.contact_model()?;
        let initial = setup.initial_states();
        for (body, state) in initial.iter().enumerate() {
            model.check_state(body, state)?;
        }
        let pair = |pair: &PairSetup| Pair {
            bodies: pair.bodies.map(|body| BodyId(body as u32)),
            material: MaterialId(pair.material as u32),
        };
        let pairs = setup.pairs.iter().map(pair).collect();
        let all_other_pairs = setup.all_other_pairs.map(|index| MaterialId(index as u32));
        let host = settings.host;
        let plan = Plan { title, model, initial, method, host, notices, pairs, all_other_pairs };
        Ok(Engine::new(Arc::new(plan)))
    }

    /// An engine before its first step.
    pub(crate) fn new(plan: Arc<Plan>) -> Engine {
        let model = &plan.model;
        let count = plan.initial.len();
        let core = match plan.host {
            Host::Direct { .. } if plan.method == Method::Paper => {
                Core::Paper { memory: Memory::new(model), work: Box::new(Workspace::new(model)) }
            }
            Host::Direct { .. } => Core::Direct {
                host: DirectHost::new(model),
                work: Box::new(HostWorkspace::new(model)),
            },
            Host::CoSimulation(settings) => Core::CoSimulation {
                host: CoSimHost::new(model, settings),
                work: Box::new(HostWorkspace::new(model)),
            },
        };
        Engine {
            spare: core.clone(),
            core,
            states: plan.initial.clone(),
            is_set: vec![false; count],
            loads: None,
            latest: Latest::Nowhere,
            no_loads: vec![Wrench::default(); count],
            recording: None,
            plan,
        }
    }

    /// Returns to the start: forgets contacts, states and loads. The next step is the first.
    pub fn reset(&mut self) {
        let recording = self.recording.take();
        *self = Engine::new(Arc::clone(&self.plan));
        self.recording = recording;
        self.restart_recording();
    }

    /// The scenario's title; empty for an engine made by calls.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.plan.title
    }

    /// Bodies, materials and fenders, with their names and masses.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.plan.model
    }

    /// The contact method.
    #[must_use]
    pub fn method(&self) -> Method {
        self.plan.method
    }

    /// The kind of host.
    #[must_use]
    pub fn host(&self) -> Host {
        self.plan.host
    }

    /// The scenario's notices, and the parts of the scenario that are left to the host; one line each.
    #[must_use]
    pub fn notices(&self) -> &[String] {
        &self.plan.notices
    }

    /// The bodies' states at the start, from the scenario or the builder.
    #[must_use]
    pub fn initial_states(&self) -> &[BodyState] {
        &self.plan.initial
    }

    /// The states of the next step: the states set last, or the initial states.
    #[must_use]
    pub fn states(&self) -> &[BodyState] {
        &self.states
    }

    /// The loads that were set; `None` without loads.
    #[must_use]
    pub fn loads(&self) -> Option<&[Wrench]> {
        self.loads.as_deref()
    }

    /// Index of the body with this name.
    ///
    /// # Errors
    /// [`EngineError::NoSuchName`].
    pub fn body_named(&self, name: &str) -> Result<usize, EngineError> {
        let found = self.plan.model.bodies().iter().position(|body| body.name == name);
        found.ok_or_else(|| EngineError::NoSuchName { what: "body", name: name.to_owned() })
    }

    /// Index of the fender with this name.
    ///
    /// # Errors
    /// [`EngineError::NoSuchName`].
    pub fn fender_named(&self, name: &str) -> Result<usize, EngineError> {
        let found = self.plan.model.fenders().iter().position(|fender| fender.name == name);
        found.ok_or_else(|| EngineError::NoSuchName { what: "fender", name: name.to_owned() })
    }

    /// Sets the state of one body.
    ///
    /// # Errors
    /// There is no such body, or a number is not finite or out of range: body and field are named.
    pub fn set_state(&mut self, body: usize, state: &BodyState) -> Result<(), EngineError> {
        let count = self.states.len();
        if body >= count {
            return Err(EngineError::NoSuch { what: "body", index: body, count });
        }
        self.plan.model.check_state(body, state)?;
        self.states[body] = *state;
        self.is_set[body] = true;
        Ok(())
    }

    /// Sets the states of all bodies, in the order of the model.
    ///
    /// # Errors
    /// As [`Engine::set_state`], or a wrong number of states. After an error none is set.
    pub fn set_states(&mut self, states: &[BodyState]) -> Result<(), EngineError> {
        self.check_states(states)?;
        self.states.copy_from_slice(states);
        self.is_set.fill(true);
        Ok(())
    }

    /// Marks a body as teleported: the state of the body in the next step is a new position, not the result of
    /// motion. The body's contacts start anew, no load is observed from the jump, and if the body overlaps
    /// another body, it is pressed out slowly ([`fenderline_contact::EventKind::PlacedInOverlap`]). Without the
    /// mark, the engine detects a teleport only if the new position differs from the position by the velocities
    /// by more than a tenth of the body's radius.
    ///
    /// # Errors
    /// There is no such body.
    pub fn mark_teleported(&mut self, body: usize) -> Result<(), EngineError> {
        let count = self.states.len();
        if body >= count {
            return Err(EngineError::NoSuch { what: "body", index: body, count });
        }
        let (model, id) = (&self.plan.model, BodyId(body as u32));
        match &mut self.core {
            Core::Paper { memory, .. } => memory.mark_teleported(model, id),
            Core::Direct { host, .. } => host.mark_teleported(model, id),
            Core::CoSimulation { host, .. } => host.mark_teleported(model, id),
        }
        if let Some(recording) = &mut self.recording {
            recording.mark_teleported(id);
        }
        Ok(())
    }

    /// Sets the loads: all forces on each body except contact, about the centre of gravity and earth-fixed, in
    /// the order of the model. The loads hold until they are set again. `None`, as at the start, means zero
    /// loads for a direct host; the loads of a co-simulation host are observed.
    ///
    /// # Errors
    /// As [`Engine::set_states`]; with the paper's method, which has no loads.
    pub fn set_loads(&mut self, loads: Option<&[Wrench]>) -> Result<(), EngineError> {
        let Some(loads) = loads else {
            self.loads = None;
            return Ok(());
        };
        self.check_loads(loads)?;
        match &mut self.loads {
            Some(own) => own.copy_from_slice(loads),
            none => *none = Some(loads.to_vec()),
        }
        Ok(())
    }

    /// One step of `step_s` seconds, from the states set last. A step of 0 s, of a paused host, changes
    /// nothing: the results of the last step remain, without events and without the work of contacts.
    ///
    /// # Errors
    /// The state of a floating body was never set, or a step that is neither 0 nor from 1e-9 s to 1e6 s.
    pub fn step(&mut self, step_s: f64) -> Result<(), EngineError> {
        let mut bodies = self.plan.model.bodies().iter().zip(&self.is_set);
        let unset = bodies.find(|(body, is_set)| !**is_set && body.mobility != Mobility::Fixed);
        if let Some((body, _)) = unset {
            return Err(EngineError::StateNotSet { body: body.name.clone() });
        }
        self.make_room_in_recording();
        let Engine { plan, core, spare, states, is_set, loads, no_loads, recording, .. } = self;
        if let Some(recording) = recording {
            recording.begin_step(states, is_set, loads.as_deref(), step_s);
        }
        let done = spare.take_step(core, plan, states, loads.as_deref(), no_loads, step_s);
        if let (Some(recording), Err(_)) = (recording, &done) {
            recording.refuse_step();
        }
        done?;
        mem::swap(core, spare);
        self.keep_results(step_s);
        self.end_step_of_recording();
        Ok(())
    }

    /// [`Engine::set_states`], [`Engine::set_loads`] if loads are given, and [`Engine::step`] in one call; returns
    /// the wrenches. If one of them fails, nothing changes.
    ///
    /// # Errors
    /// Those of the three calls.
    pub fn advance(
        &mut self,
        states: &[BodyState],
        loads: Option<&[Wrench]>,
        step_s: f64,
    ) -> Result<&[Wrench], EngineError> {
        self.check_states(states)?;
        if let Some(loads) = loads {
            self.check_loads(loads)?;
        }
        self.make_room_in_recording();
        let step_loads = loads.or(self.loads.as_deref());
        let Engine { plan, core, spare, no_loads, recording, .. } = self;
        if let Some(recording) = recording {
            recording.begin_step(states, &[], step_loads, step_s);
        }
        let done = spare.take_step(core, plan, states, step_loads, no_loads, step_s);
        if let (Some(recording), Err(_)) = (recording, &done) {
            recording.refuse_step();
        }
        done?;
        mem::swap(core, spare);
        self.states.copy_from_slice(states);
        self.is_set.fill(true);
        if loads.is_some() {
            self.set_loads(loads)?;
        }
        self.keep_results(step_s);
        self.end_step_of_recording();
        Ok(self.results()?.wrenches)
    }

    /// After a step the results are in the workspace. A pause of a restored engine keeps the saved results.
    fn keep_results(&mut self, step_s: f64) {
        match &mut self.latest {
            Latest::Saved(saved) if step_s == 0.0 => saved.pause(&self.states),
            latest => *latest = Latest::InWorkspace,
        }
    }

    /// The results of the last step.
    ///
    /// # Errors
    /// No step was taken yet.
    pub fn results(&self) -> Result<Results<'_>, EngineError> {
        match &self.latest {
            Latest::Nowhere => Err(EngineError::NoStepYet),
            Latest::Saved(saved) => Ok(saved.view()),
            Latest::InWorkspace => Ok(self.core.results()),
        }
    }

    fn check_states(&self, states: &[BodyState]) -> Result<(), EngineError> {
        self.check_count(states.len())?;
        for (body, state) in states.iter().enumerate() {
            self.plan.model.check_state(body, state)?;
        }
        Ok(())
    }

    fn check_loads(&self, loads: &[Wrench]) -> Result<(), EngineError> {
        if self.plan.method == Method::Paper {
            return Err(EngineError::NotAvailable("the paper's method has no loads"));
        }
        self.check_count(loads.len())?;
        for (body, load) in loads.iter().enumerate() {
            self.plan.model.check_load(body, load)?;
        }
        Ok(())
    }

    fn check_count(&self, given: usize) -> Result<(), EngineError> {
        let bodies = self.states.len();
        if given == bodies {
            return Ok(());
        }
        Err(StepError::WrongCount { bodies, states: given }.into())
    }
}

impl Core {
    /// A step from the state of `before`, which stays unchanged. After an error `self` is invalid until the next
    /// step.
    fn take_step(
        &mut self,
        before: &Core,
        plan: &Plan,
        states: &[BodyState],
        loads: Option<&[Wrench]>,
        no_loads: &[Wrench],
        step_s: f64,
    ) -> Result<(), EngineError> {
        let model = &plan.model;
        if step_s == 0.0 {
            // The results of the last step remain.
            self.clone_from(before);
        }
        match (&mut *self, before) {
            (Core::Paper { memory, work }, Core::Paper { memory: now, .. }) => {
                memory.copy_from(now);
                contact::step(model, memory, work, states, step_s)?;
            }
            (Core::Direct { host, work }, Core::Direct { host: now, .. }) => {
                host.copy_from(now);
                host.step(model, work, states, loads.unwrap_or(no_loads), step_s)?;
            }
            (Core::CoSimulation { host, work }, Core::CoSimulation { host: now, .. }) => {
                host.copy_from(now);
                host.step(model, work, states, loads, step_s)?;
            }
            _ => unreachable!("both cores are for the same kind of host"),
        }
        if self.results().are_finite() { Ok(()) } else { Err(EngineError::NotFinite) }
    }

    /// The results of the step.
    fn results(&self) -> Results<'_> {
        match self {
            Core::Paper { work, .. } => of_paper(work),
            Core::Direct { work, .. } => of_direct(work),
            Core::CoSimulation { work, .. } => of_cosim(work),
        }
    }
}

/// Notices of the parts of a set-up, other than contact, that act on bodies.
fn left_to_the_host(setup: &Setup) -> Vec<String> {
    let world = &setup.world;
    let parts = [
        (setup.loads.len(), "load"),
        (world.vessels.len(), "vessel with hull forces"),
        (world.orders.len(), "order"),
        (world.tugs.len(), "tug"),
        (world.lines.len(), "line"),
        (world.providers.len(), "provider of forces"),
    ];
    let notice = |(count, what): (usize, &str)| match count {
        0 => None,
        1 => Some(format!("left to the host: 1 {what}")),
        _ => Some(format!("left to the host: {count} of the kind \"{what}\"")),
    };
    parts.into_iter().filter_map(notice).collect()
}
