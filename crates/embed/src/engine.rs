//! The engine in one object.

use std::mem;
use std::sync::Arc;

use fenderline_contact::{
    self as contact, BodyId, BodyState, CoSimHost, DirectHost, HostWorkspace, Memory, Mobility,
    Model, StepError, Workspace, Wrench,
};
use fenderline_scenario::Scenario;
use fenderline_sim::{Integrator, Method, Setup};

use crate::error::EngineError;
use crate::results::{Results, Saved, of_cosim, of_direct, of_paper};
use crate::settings::{CoriolisTerms, Host, MAX_DELAY_STEPS, Settings};

/// The contact engine with its model, its memory and what the host has shown and told. Cloning it branches
/// the run; clones share the model.
#[derive(Clone, Debug)]
pub struct Engine {
    pub(crate) plan: Arc<Plan>,
    pub(crate) core: Core,
    spare: Core,
    /// What the host has shown, one a body.
    pub(crate) states: Vec<BodyState>,
    /// Which of them it has shown; fixed bodies need not be.
    pub(crate) shown: Vec<bool>,
    /// The loads told, one a body; `None` where none were.
    pub(crate) loads: Option<Vec<Wrench>>,
    pub(crate) latest: Latest,
    /// Zero loads, for hosts of the present that have told none.
    no_loads: Vec<Wrench>,
}

/// The constant part.
#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) title: String,
    pub(crate) model: Model,
    pub(crate) initial: Vec<BodyState>,
    pub(crate) method: Method,
    pub(crate) host: Host,
    notices: Vec<String>,
}

/// The mutable part, and buffers. There are two: a step is taken on a copy of the one in the other, and counts
/// when it is good.
#[derive(Clone, Debug)]
pub(crate) enum Core {
    /// By the paper's method.
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
    /// An engine for the bodies, fenders, materials and pairs of a scenario. What else acts on the bodies
    /// (loads, wind, vessels' propellers, lines, tugs) is the host's: [`Engine::notices`] names what of
    /// the scenario is left to it.
    ///
    /// # Errors
    /// [`EngineError`] for settings that do not go together or do not fit the scenario.
    pub fn from_scenario(scenario: Scenario, settings: &Settings) -> Result<Engine, EngineError> {
        let Scenario { title, setup, notices } = scenario;
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
            // What a following host's loads are observed to be holds the turning terms.
            Host::Direct { coriolis: Some(CoriolisTerms::InLoads) } | Host::CoSimulation(_) => {
                setup.integrator = Integrator::Euler;
            }
        }
        if let Host::CoSimulation(host) = settings.host {
            if method == Method::Paper {
                return Err(EngineError::Settings(
                    "the paper's method cannot follow a host: take the coupled method",
                ));
            }
            if host.delay_steps > MAX_DELAY_STEPS {
                return Err(EngineError::Settings("a host may be at most 1000 steps late"));
            }
        }
        let model = setup.contact_model()?;
        let initial = setup.initial_states();
        for (body, state) in initial.iter().enumerate() {
            model.check_state(body, state)?;
        }
        let plan = Plan { title, model, initial, method, host: settings.host, notices };
        Ok(Engine::of(Arc::new(plan)))
    }

    /// An engine of which nothing has been asked yet.
    fn of(plan: Arc<Plan>) -> Engine {
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
            shown: vec![false; count],
            loads: None,
            latest: Latest::Nowhere,
            no_loads: vec![Wrench::default(); count],
            plan,
        }
    }

    /// Forgets all that happened, was shown and was told: the next step is the first.
    pub fn reset(&mut self) {
        *self = Engine::of(Arc::clone(&self.plan));
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

    /// The scenario's notices, and what of the scenario is left to the host; one line each.
    #[must_use]
    pub fn notices(&self) -> &[String] {
        &self.plan.notices
    }

    /// The states that the scenario or the builder gives the bodies at the start.
    #[must_use]
    pub fn initial_states(&self) -> &[BodyState] {
        &self.plan.initial
    }

    /// The states of the next step: what was shown last, else the initial ones.
    #[must_use]
    pub fn states(&self) -> &[BodyState] {
        &self.states
    }

    /// The loads that were told; `None` where none were.
    #[must_use]
    pub fn loads(&self) -> Option<&[Wrench]> {
        self.loads.as_deref()
    }

    /// Index of the body of a name.
    ///
    /// # Errors
    /// [`EngineError::NoSuchName`].
    pub fn body_named(&self, name: &str) -> Result<usize, EngineError> {
        let found = self.plan.model.bodies().iter().position(|body| body.name == name);
        found.ok_or_else(|| EngineError::NoSuchName { what: "body", name: name.to_owned() })
    }

    /// Index of the fender of a name.
    ///
    /// # Errors
    /// [`EngineError::NoSuchName`].
    pub fn fender_named(&self, name: &str) -> Result<usize, EngineError> {
        let found = self.plan.model.fenders().iter().position(|fender| fender.name == name);
        found.ok_or_else(|| EngineError::NoSuchName { what: "fender", name: name.to_owned() })
    }

    /// Shows the state of one body.
    ///
    /// # Errors
    /// There is no such body, or a number that is not finite or out of range: body and field are named.
    pub fn set_state(&mut self, body: usize, state: &BodyState) -> Result<(), EngineError> {
        let count = self.states.len();
        if body >= count {
            return Err(EngineError::NoSuch { what: "body", index: body, count });
        }
        self.plan.model.check_state(body, state)?;
        self.states[body] = *state;
        self.shown[body] = true;
        Ok(())
    }

    /// Shows the states of all bodies, in the order of the model.
    ///
    /// # Errors
    /// As [`Engine::set_state`], or another number of states; then none is taken.
    pub fn set_states(&mut self, states: &[BodyState]) -> Result<(), EngineError> {
        self.check_states(states)?;
        self.states.copy_from_slice(states);
        self.shown.fill(true);
        Ok(())
    }

    /// Says that the host has put a body where it shows it in the next step, rather than moved it there: its contacts
    /// start afresh, no load is read from it, and where it lies within another body it is pressed out slowly
    /// ([`fenderline_contact::EventKind::PlacedInOverlap`]). Without it the engine finds out where the way is longer than
    /// the body's velocities lead it, by a tenth of its radius.
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
        Ok(())
    }

    /// Tells all that acts on each body in the steps to come except contact, about its centre of gravity and
    /// earth-fixed, until it is told again; in the order of the model. `None`: not told, as at the start. A
    /// host of the present has no loads then; those of a following host are observed.
    ///
    /// # Errors
    /// As [`Engine::set_states`]; by the paper's method, which knows no loads.
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

    /// One step of `step_s` seconds, from the states shown last. In a step of 0 s, of a host that is paused, nothing
    /// goes on: results are those of the last step, but for events and the contacts' work.
    ///
    /// # Errors
    /// A floating body was never shown, or a step that is neither 0 nor from 1e-9 s to 1e6 s.
    pub fn step(&mut self, step_s: f64) -> Result<(), EngineError> {
        let mut bodies = self.plan.model.bodies().iter().zip(&self.shown);
        let unseen = bodies.find(|(body, shown)| !**shown && body.mobility != Mobility::Fixed);
        if let Some((body, _)) = unseen {
            return Err(EngineError::StateNotSet { body: body.name.clone() });
        }
        let Engine { plan, core, spare, states, loads, no_loads, .. } = self;
        spare.take_step(core, plan, states, loads.as_deref(), no_loads, step_s)?;
        mem::swap(core, spare);
        self.keep_results(step_s);
        Ok(())
    }

    /// In one call: [`Engine::set_states`], [`Engine::set_loads`] where there are some, [`Engine::step`];
    /// gives the wrenches. Nothing is changed where any of it fails.
    ///
    /// # Errors
    /// As these.
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
        let told = loads.or(self.loads.as_deref());
        let Engine { plan, core, spare, no_loads, .. } = self;
        spare.take_step(core, plan, states, told, no_loads, step_s)?;
        mem::swap(core, spare);
        self.states.copy_from_slice(states);
        self.shown.fill(true);
        if loads.is_some() {
            self.set_loads(loads)?;
        }
        self.keep_results(step_s);
        Ok(self.results()?.wrenches)
    }

    /// After a step: its results are in the workspace, or in a pause, where an engine was restored, as they were
    /// saved.
    fn keep_results(&mut self, step_s: f64) {
        match &mut self.latest {
            Latest::Saved(saved) if step_s == 0.0 => saved.pause(&self.states),
            latest => *latest = Latest::InWorkspace,
        }
    }

    /// What the last step found.
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
            return Err(EngineError::NotAvailable("the paper's method knows no loads"));
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
    /// A step from where `before` is. Where it fails this is of no use but for the next step; `before` is as
    /// it was.
    fn take_step(
        &mut self,
        before: &Core,
        plan: &Plan,
        states: &[BodyState],
        told: Option<&[Wrench]>,
        no_loads: &[Wrench],
        step_s: f64,
    ) -> Result<(), EngineError> {
        let model = &plan.model;
        if step_s == 0.0 {
            // What it tells is what the last step found.
            self.clone_from(before);
        }
        match (&mut *self, before) {
            (Core::Paper { memory, work }, Core::Paper { memory: now, .. }) => {
                memory.copy_from(now);
                contact::step(model, memory, work, states, step_s)?;
            }
            (Core::Direct { host, work }, Core::Direct { host: now, .. }) => {
                host.copy_from(now);
                host.step(model, work, states, told.unwrap_or(no_loads), step_s)?;
            }
            (Core::CoSimulation { host, work }, Core::CoSimulation { host: now, .. }) => {
                host.copy_from(now);
                host.step(model, work, states, told, step_s)?;
            }
            _ => unreachable!("both are of the engine's kind of host"),
        }
        if self.results().are_finite() { Ok(()) } else { Err(EngineError::NotFinite) }
    }

    /// What the step found.
    fn results(&self) -> Results<'_> {
        match self {
            Core::Paper { work, .. } => of_paper(work),
            Core::Direct { work, .. } => of_direct(work),
            Core::CoSimulation { work, .. } => of_cosim(work),
        }
    }
}

/// What of a set-up acts on bodies and is no contact.
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
    let tell = |(count, what): (usize, &str)| match count {
        0 => None,
        1 => Some(format!("left to the host: 1 {what}")),
        _ => Some(format!("left to the host: {count} of the kind \"{what}\"")),
    };
    parts.into_iter().filter_map(tell).collect()
}
