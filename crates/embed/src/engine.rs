//! The contact engine with its states and loads in one object.

use std::sync::Arc;

use fenderline_contact::{
    BodyId, BodyState, CoSimHost, DirectHost, HostWorkspace, MaterialId, Memory, Model, Pair,
    StepError, Workspace, Wrench,
};
use fenderline_scenario::Scenario;
use fenderline_sim::{Integrator, Method, PairSetup, Setup};

use crate::error::EngineError;
use crate::recording::Recording;
use crate::results::{Results, Saved, of_cosim, of_direct, of_paper};
use crate::settings::{CoriolisTerms, Host, MAX_DELAY_STEPS, Settings};

/// The contact engine with its model, its memory, and the states and loads that the host has set. Cloning an engine
/// branches the run; the clones share the model.
#[derive(Clone, Debug)]
pub struct Engine {
    pub(crate) plan: Arc<Plan>,
    pub(crate) core: Core,
    pub(crate) spare: Core,
    /// The states for the next step, one per body.
    pub(crate) states: Vec<BodyState>,
    /// For each body, whether the host has set its state; a fixed body's state need not be set.
    pub(crate) is_set: Vec<bool>,
    /// The loads for the next step, one per body; `None` if the host has set no loads.
    pub(crate) loads: Option<Vec<Wrench>>,
    pub(crate) latest: Latest,
    /// Zero loads, for a direct host that has set no loads.
    pub(crate) no_loads: Vec<Wrench>,
    /// The recording of the last steps, if [`Engine::record`] asked for one.
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

/// The part of an engine that steps change, with its buffers. An engine has two cores: a step runs on a copy of the
/// first core in the second, and the two cores are swapped when the step succeeds.
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

/// Where an engine keeps the results of its latest step.
#[derive(Clone, Debug)]
pub(crate) enum Latest {
    Nowhere,
    InWorkspace,
    Saved(Box<Saved>),
}

impl Engine {
    /// Makes an engine for the bodies, fenders, materials and pairs of a scenario. The host computes all other forces
    /// on the bodies (loads, wind, propellers, lines, tugs): [`Engine::notices`] names the parts of the scenario that
    /// the host must compute.
    ///
    /// # Errors
    /// Fails for settings that conflict with each other or with the scenario.
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
                return Err(EngineError::Settings(
                    "a host may pass states that are at most 1000 steps old",
                ));
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

    /// Makes an engine before its first step.
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

    /// The scenario's title; empty for an engine made by calls.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.plan.title
    }

    /// The engine's model: bodies, materials and fenders, with their names and masses.
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

    /// The scenario's notices, and the parts of the scenario that are left to the host, with one line for each.
    #[must_use]
    pub fn notices(&self) -> &[String] {
        &self.plan.notices
    }

    /// The bodies' states at the start, from the scenario or the builder.
    #[must_use]
    pub fn initial_states(&self) -> &[BodyState] {
        &self.plan.initial
    }

    /// The states for the next step: the states that were set last, or the initial states.
    #[must_use]
    pub fn states(&self) -> &[BodyState] {
        &self.states
    }

    /// The loads that the host has set; `None` if it has set no loads.
    #[must_use]
    pub fn loads(&self) -> Option<&[Wrench]> {
        self.loads.as_deref()
    }

    /// Finds the index of the body with the given name.
    ///
    /// # Errors
    /// [`EngineError::NoSuchName`].
    pub fn body_named(&self, name: &str) -> Result<usize, EngineError> {
        let found = self.plan.model.bodies().iter().position(|body| body.name == name);
        found.ok_or_else(|| EngineError::NoSuchName { what: "body", name: name.to_owned() })
    }

    /// Finds the index of the fender with the given name.
    ///
    /// # Errors
    /// [`EngineError::NoSuchName`].
    pub fn fender_named(&self, name: &str) -> Result<usize, EngineError> {
        let found = self.plan.model.fenders().iter().position(|fender| fender.name == name);
        found.ok_or_else(|| EngineError::NoSuchName { what: "fender", name: name.to_owned() })
    }

    /// Sets the state of one body for the next step.
    ///
    /// # Errors
    /// Fails if the body does not exist, or if a number is not finite or out of range; the error names body and field.
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

    /// Sets the states of all bodies for the next step, in the order of the model.
    ///
    /// # Errors
    /// Fails as [`Engine::set_state`], or for a wrong number of states. After an error no state is set.
    pub fn set_states(&mut self, states: &[BodyState]) -> Result<(), EngineError> {
        self.check_states(states)?;
        self.states.copy_from_slice(states);
        self.is_set.fill(true);
        Ok(())
    }

    /// Marks a body as teleported: the state of the body in the next step is a new position, not the result of motion.
    /// A teleported body's contacts start anew, no load is observed from the jump, and if the body overlaps another
    /// body, it is pushed out slowly ([`fenderline_contact::EventKind::PlacedInOverlap`]). Without the mark, the engine
    /// detects a teleport only if the body's new position differs from what its velocities explain by more than a tenth
    /// of the body's radius.
    ///
    /// # Errors
    /// Fails if the body does not exist.
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

    /// Sets the loads: all forces on each body except contact, about the centre of gravity and earth-fixed, in the
    /// order of the model. The loads hold until the host sets loads again. Loads of `None`, as at the start, mean zero
    /// loads for a direct host; a co-simulation host's loads are then observed.
    ///
    /// # Errors
    /// Fails as [`Engine::set_states`], and with the paper's method, which has no loads.
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

    /// The results of the engine's last step.
    ///
    /// # Errors
    /// Fails if no step was taken yet.
    pub fn results(&self) -> Result<Results<'_>, EngineError> {
        match &self.latest {
            Latest::Nowhere => Err(EngineError::NoStepYet),
            Latest::Saved(saved) => Ok(saved.view()),
            Latest::InWorkspace => Ok(self.core.results()),
        }
    }

    pub(crate) fn check_states(&self, states: &[BodyState]) -> Result<(), EngineError> {
        self.check_count(states.len())?;
        for (body, state) in states.iter().enumerate() {
            self.plan.model.check_state(body, state)?;
        }
        Ok(())
    }

    pub(crate) fn check_loads(&self, loads: &[Wrench]) -> Result<(), EngineError> {
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
    /// The results of the core's last step.
    pub(crate) fn results(&self) -> Results<'_> {
        match self {
            Core::Paper { work, .. } => of_paper(work),
            Core::Direct { work, .. } => of_direct(work),
            Core::CoSimulation { work, .. } => of_cosim(work),
        }
    }
}

/// Notices that name the parts of a scenario, other than contact, whose forces the host must compute.
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
        1 => Some(format!("the engine leaves to the host: 1 {what} of the scenario")),
        _ => Some(format!(
            "the engine leaves to the host: {count} parts of the scenario of the kind \"{what}\""
        )),
    };
    parts.into_iter().filter_map(notice).collect()
}
