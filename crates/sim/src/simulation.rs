//! A run: states, contact memory, ledger and summaries, stepped together.

use fenderline_contact::{
    self as contact, Body, BodyId, BodyState, Contact, Fender, MaterialId, Memory, Model, Pair,
    Vec2, Workspace, Wrench,
};

use crate::berthing::{BerthingError, BerthingOutcome, Study, StudyStep};
use crate::environment::current::Current;
use crate::environment::wind::Wind;
use crate::error::{SetupError, SimError};
use crate::fender::{FenderSetup, FenderSummaries, FenderSummary};
use crate::fixed_order::sort_loads;
use crate::gain::{EnergyGain, REPORTED_GAIN};
use crate::gather::{add_external, gather, gather_loads};
use crate::integrate::{Rate, euler, semi_implicit};
use crate::ledger::{ContactTotals, Ledger, MeanVelocity, WorkBy};
use crate::load_work::LoadedStep;
use crate::order::{Action, LineAction, Order, OrderError, VesselAction, check_order};
use crate::record::{Energy, StepRecord};
use crate::rigid_body::{Inertia, initial_state};
use crate::setup::{Integrator, Load, Method, Setup};
use crate::summary::{PairSummary, Summaries};
use crate::turning::{Turns, turning_wrench};
use crate::world::{
    Assist, Faults, Job, LineEnd, Mooring, TugAtWork, VesselState, World, mass_matrix,
};

/// Weights of the four stages of classical Runge–Kutta.
const RUNGE_KUTTA: [f64; 4] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0];

/// A simulation under way. Cloning it branches the run.
#[derive(Clone, Debug)]
pub struct Simulation {
    setup: Setup,
    model: Model,
    inertias: Vec<Inertia>,
    steps_total: u64,
    index: u64,
    /// The set-up's loads in the order in which they are added up.
    loads: Vec<Load>,
    states: Vec<BodyState>,
    memory: Memory,
    work: Workspace,
    ledger: Ledger,
    contact_totals: ContactTotals,
    summaries: Summaries,
    fender_summaries: FenderSummaries,
    study: Option<Study>,
    world: World,
    buffers: Buffers,
}

/// Buffers of a step.
#[derive(Clone, Debug)]
struct Buffers {
    loads: Vec<Wrench>,
    /// Those of them that are no part of the world.
    others: Vec<Wrench>,
    /// What turns each body's momentum over the step, where the engine does not.
    turning: Vec<Wrench>,
    /// What the host puts on each body in the next step.
    external: Vec<Wrench>,
    sums: Vec<Wrench>,
    rates: [Vec<Rate>; 4],
    trial: Vec<BodyState>,
    before: Vec<BodyState>,
    mean: Vec<MeanVelocity>,
    /// The stream that each body is in (m/s).
    streams_mps: Vec<Vec2>,
    /// Contacts of the later stages of Runge–Kutta, and what they need.
    stage_contacts: [Vec<Contact>; 3],
    probe: Memory,
    probe_work: Workspace,
    /// The memory before the step, should a later stage fail.
    backup: Memory,
}

impl Simulation {
    /// Checks the set-up and makes ready for the first step.
    ///
    /// # Errors
    /// [`SetupError`], naming what is wrong.
    pub fn new(setup: Setup) -> Result<Simulation, SetupError> {
        let steps_total = count_steps(&setup)?;
        setup.loads.iter().try_for_each(|load| check_load(load, &setup))?;
        let inertias = inertias(&setup)?;
        let model = build_model(&setup, &inertias)?;
        let states = setup.initial_states();
        setup.world.environment.check().map_err(SetupError::Environment)?;
        check_lines(&setup)?;
        let mut loads = setup.loads.clone();
        sort_loads(&mut loads);
        let count = states.len();
        let memory = Memory::new(&model);
        let buffers = Buffers {
            loads: vec![Wrench::default(); count],
            others: vec![Wrench::default(); count],
            turning: vec![Wrench::default(); count],
            external: vec![Wrench::default(); count],
            sums: vec![Wrench::default(); count],
            rates: std::array::from_fn(|_| vec![Rate::default(); count]),
            trial: states.clone(),
            before: states.clone(),
            mean: vec![MeanVelocity::default(); count],
            streams_mps: vec![Vec2::ZERO; count],
            stage_contacts: Default::default(),
            probe: memory.clone(),
            probe_work: Workspace::new(&model),
            backup: memory.clone(),
        };
        let world = World::new(&setup.world, &setup.bodies);
        Ok(Simulation {
            ledger: Ledger::new((&world.order.bodies, &inertias, &states)),
            work: Workspace::new(&model),
            contact_totals: ContactTotals::default(),
            summaries: Summaries::default(),
            fender_summaries: FenderSummaries::new(setup.fenders.len()),
            study: study(&setup)?,
            world,
            index: 0,
            loads,
            setup,
            model,
            inertias,
            steps_total,
            states,
            memory,
            buffers,
        })
    }

    /// The set-up.
    #[must_use]
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// The contact model of the set-up.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Number of steps in the run.
    #[must_use]
    pub fn steps_total(&self) -> u64 {
        self.steps_total
    }

    /// Number of steps taken.
    #[must_use]
    pub fn steps_taken(&self) -> u64 {
        self.index
    }

    /// Number of steps from the start to a time (s), the one in which it lies included.
    #[must_use]
    pub fn steps_until(&self, t_s: f64) -> u64 {
        whole_steps(t_s / self.setup.step_s)
    }

    /// True after the last step.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.index >= self.steps_total
    }

    /// Time reached (s): steps taken times Δt, so that it does not drift.
    #[must_use]
    pub fn time_s(&self) -> f64 {
        self.index as f64 * self.setup.step_s
    }

    /// The time that velocities belong to (s). Where the engine moves the bodies it is the middle of the last step, as a
    /// leapfrog has it (the middle of its last sub-step, where contacts need several), else [`Simulation::time_s`].
    #[must_use]
    pub fn velocity_time_s(&self) -> f64 {
        let leaps = self.setup.integrator == Integrator::SemiImplicit
            && self.setup.method == Method::Coupled;
        if leaps && self.index > 0 {
            (self.index as f64 - 0.5) * self.setup.step_s
        } else {
            self.time_s()
        }
    }

    /// States now, one a body, in the order of the set-up. Velocities belong to [`Simulation::velocity_time_s`].
    #[must_use]
    pub fn states(&self) -> &[BodyState] {
        &self.states
    }

    /// The contact engine's memory now.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// The energy ledger now.
    #[must_use]
    pub fn energy(&self) -> Energy {
        self.ledger.energy
    }

    /// Has the paper's method made energy that a reader must know of? Its forces are explicit, and those of a stiff
    /// spring in a long step push for longer than they should. [`Method::Coupled`] bounds what each contact gives.
    #[must_use]
    pub fn energy_gain(&self) -> Option<EnergyGain> {
        let Energy { contact_taken_j: taken_j, contact_gained_j: gained_j, .. } = self.energy();
        let is_told = self.setup.method == Method::Paper && gained_j > REPORTED_GAIN * taken_j;
        is_told.then_some(EnergyGain { gained_j, taken_j })
    }

    /// What has happened between each pair of bodies that touched, in the order of first touch.
    #[must_use]
    pub fn pair_summaries(&self) -> &[PairSummary] {
        &self.summaries.pairs
    }

    /// What has happened to each fender that was touched, in the order of the set-up.
    pub fn fender_summaries(&self) -> impl Iterator<Item = &FenderSummary> {
        self.fender_summaries.all.iter().flatten()
    }

    /// The vessels now, in the order of the set-up.
    #[must_use]
    pub fn vessels(&self) -> &[VesselState] {
        &self.world.vessels
    }

    /// The tugs now, in the order of the set-up.
    #[must_use]
    pub fn tugs(&self) -> &[TugAtWork] {
        &self.world.tugs
    }

    /// The mooring lines now, in the order of the set-up.
    #[must_use]
    pub fn lines(&self) -> &[Mooring] {
        &self.world.lines
    }

    /// Contact wrenches of the last step, one a body; zero before the first.
    #[must_use]
    pub fn wrenches(&self) -> &[Wrench] {
        self.work.wrenches()
    }

    /// The contacts of the last step.
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        self.work.contacts()
    }

    /// The berthing by formula and as it came out; `None` where the set-up asks for none, or no fender
    /// was touched yet. An error where ship or speed is none that the formulas are for.
    #[must_use]
    pub fn berthing(&self) -> Option<Result<&BerthingOutcome, &BerthingError>> {
        self.study.as_ref()?.outcome.as_ref().map(Result::as_ref)
    }

    /// Sets the wrench that the host itself puts on each body, from the next step on and until it is set
    /// again: forces of another program, of a controller, of a model of its own.
    ///
    /// # Panics
    /// Without one wrench a body, or with one that is not finite.
    pub fn set_external(&mut self, wrenches: &[Wrench]) {
        assert_eq!(wrenches.len(), self.states.len(), "one wrench a body");
        for wrench in wrenches {
            assert!(wrench.force_n.is_finite() && wrench.moment_nm.is_finite(), "a finite wrench");
        }
        self.buffers.external.copy_from_slice(wrenches);
    }

    /// Adds an order to those of the set-up. It is carried out in the step in which its time lies, or in the next step
    /// where that time is past. Orders of one time are carried out in this sequence: the set-up's, then the others as
    /// they were given.
    ///
    /// # Errors
    /// [`SetupError`] for a target, a gear or a name that is not there, or a number out of its limits; no order is then
    /// changed.
    pub fn order(&mut self, order: Order) -> Result<(), SetupError> {
        check_order(&order, &self.setup)?;
        self.world.order(order);
        Ok(())
    }

    /// Whether an order can be carried out as things stand now: no line that was let go, no tug that a station pilot
    /// uses. An order planned ahead is not held to this.
    ///
    /// # Errors
    /// What stands in its way.
    pub fn check_now(&self, action: &Action) -> Result<(), OrderError> {
        let is_there = |line: usize| {
            if !self.world.lines.get(line).is_some_and(|line| line.gone) {
                return Ok(());
            }
            Err(OrderError::LineGone { line: self.setup.world.lines[line].line.name.clone() })
        };
        match action {
            Action::Line(line, LineAction::Winch(_) | LineAction::LetGo) => is_there(*line),
            Action::Vessel(_, VesselAction::Assist(Assist { job: Job::Pull { line, .. }, .. })) => {
                is_there(*line)
            }
            Action::Tug(tug, _) => {
                let Some(tug) = self.setup.world.tugs.get(*tug) else { return Ok(()) };
                if self.world.vessels[tug.vessel].pilots.station.is_none() {
                    return Ok(());
                }
                let ship = self.setup.world.vessels[tug.vessel].body;
                Err(OrderError::TugOfStation { ship: self.setup.bodies[ship].name.clone() })
            }
            Action::Vessel(..) => Ok(()),
        }
    }

    /// Drops the orders that are not carried out yet and for which `keep` is false, the set-up's among them: who takes
    /// a control by hand does not want it moved by a plan.
    pub fn retain_orders(&mut self, keep: impl FnMut(&Order) -> bool) {
        self.world.retain_orders(keep);
    }

    /// Another wind from the next step on; `None`: none. No step in between: a jump is a jump.
    pub fn set_wind(&mut self, wind: Option<Wind>) {
        self.setup.world.environment.wind = wind;
    }

    /// Another current from the next step on; `None`: none. The jump itself accelerates nobody, as a current
    /// that came up in no time would: ships drift into it by their drag.
    pub fn set_current(&mut self, current: Option<Current>) {
        self.setup.world.environment.current = current;
    }

    /// What has failed on a vessel, from the next step on.
    ///
    /// # Errors
    /// [`SetupError::BadBody`] where there is no such vessel.
    pub fn set_faults(&mut self, vessel: usize, faults: Faults) -> Result<(), SetupError> {
        let state = self.world.vessels.get_mut(vessel);
        let state = state.ok_or(SetupError::BadBody { owner: "fault", body: vessel })?;
        state.faults = faults;
        Ok(())
    }

    /// Takes one step; beyond the run's duration it simply goes on.
    ///
    /// # Errors
    /// [`SimError`] when a state has left what the engine takes (a run that blew up). The simulation
    /// stays where it was.
    pub fn step(&mut self) -> Result<StepRecord<'_>, SimError> {
        let (t_s, step_s) = (self.time_s(), self.setup.step_s);
        if self.setup.integrator == Integrator::Rk4 {
            self.buffers.backup.copy_from(&self.memory);
        }
        let world_before = self.setup.world.changes().then(|| self.world.clone());
        // What acts besides contact, and stages 1–5: the contact engine.
        gather_loads(&self.loads, t_s, step_s, &mut self.buffers.loads);
        add_external(&self.buffers.external, &mut self.buffers.loads);
        self.buffers.others.clone_from(&self.buffers.loads);
        let times = (t_s, self.velocity_time_s(), step_s);
        self.world.step(&self.setup.world, &self.states, times, &mut self.buffers.loads);
        self.buffers.before.clone_from(&self.states);
        self.turn_momentum();
        if let Err(cause) = self.contact() {
            if let Some(world) = world_before {
                self.world = world;
            }
            return Err(SimError { t_s, cause });
        }
        // Stages 6 and 7: everything that acts on each body, and the next states.
        match self.setup.integrator {
            // The engine has moved the bodies itself, in its sub-steps.
            Integrator::SemiImplicit if self.setup.method == Method::Coupled => {}
            Integrator::Euler => self.one_stage(euler),
            Integrator::SemiImplicit => self.one_stage(semi_implicit),
            Integrator::Rk4 => {
                if let Err(cause) = self.runge_kutta() {
                    self.memory.copy_from(&self.buffers.backup);
                    if let Some(world) = world_before {
                        self.world = world;
                    }
                    return Err(SimError { t_s, cause });
                }
            }
        }
        let contacts = self.work.contacts();
        let (world, fenders) = (&self.setup.world, &self.setup.fenders);
        self.world.settle(world, fenders, contacts, &self.states, (t_s, step_s));
        // Stage 8: what happened.
        self.book();
        let record = StepRecord {
            index: self.index,
            t_s,
            states: &self.buffers.before,
            states_after: &self.states,
            contacts: self.work.contacts(),
            contact_energies: &self.contact_totals.all,
            wrenches: self.work.wrenches(),
            events: self.work.events(),
            energy: self.ledger.energy,
            vessels: &self.world.vessels,
            vessel_forces: &self.world.forces,
            lines: &self.world.lines,
            tugs: &self.world.tugs,
            world_events: &self.world.events,
        };
        self.summaries.book(&record);
        self.fender_summaries.book(&self.setup.fenders, record.contacts, t_s);
        if let Some(study) = &mut self.study {
            let StepRecord { states, contacts, contact_energies, .. } = record;
            let of_fenders = || contact_energies.iter().filter(|contact| contact.fender.is_some());
            let stored_j = of_fenders().map(|contact| contact.stored_j).sum();
            let hysteresis_j = of_fenders().map(|contact| contact.hysteresis_j).sum();
            let step = StudyStep { t_s, states, contacts, stored_j, hysteresis_j };
            study.book(&self.setup.fenders, &self.inertias, &step);
        }
        self.index += 1;
        Ok(record)
    }

    /// Contact forces of this step by the method of the set-up.
    fn contact(&mut self) -> Result<(), contact::StepError> {
        let step_s = self.setup.step_s;
        match self.setup.method {
            Method::Paper => {
                let (memory, work) = (&mut self.memory, &mut self.work);
                contact::step(&self.model, memory, work, &self.states, step_s)
            }
            Method::Coupled => {
                let Buffers { loads, turning, sums, .. } = &mut self.buffers;
                gather(loads, turning, sums);
                let (model, memory, work) = (&self.model, &mut self.memory, &mut self.work);
                if self.setup.integrator == Integrator::SemiImplicit {
                    contact::advance_in_place(model, memory, work, &mut self.states, sums, step_s)
                } else {
                    contact::advance(model, memory, work, &self.states, sums, step_s)
                }
            }
        }
    }

    /// What turns the bodies' momentum in this step: of vessels over the whole of it, of other bodies as at its
    /// start. Contact is not known yet: that of the last step stands for it, so that who lies against her fenders is
    /// not expected to be blown away.
    fn turn_momentum(&mut self) {
        let Buffers { loads, turning, .. } = &mut self.buffers;
        for ((wrench, inertia), state) in turning.iter_mut().zip(&self.inertias).zip(&self.states) {
            *wrench = inertia.momentum_wrench(state, Vec2::ZERO);
        }
        let step_s = self.setup.step_s;
        let over = match self.setup.integrator {
            Integrator::Euler => Some((step_s, step_s, Turns::Before)),
            // The engine's leapfrog begins with half a kick.
            Integrator::SemiImplicit if self.index == 0 => {
                Some((step_s, 0.5 * step_s, Turns::After))
            }
            Integrator::SemiImplicit => Some((step_s, step_s, Turns::After)),
            // Each of its stages has its own.
            Integrator::Rk4 => None,
        };
        let contact = self.work.wrenches();
        for (vessel, carried) in self.setup.world.vessels.iter().zip(&self.world.carried) {
            let body = vessel.body;
            let (inertia, state) = (&self.inertias[body], &self.states[body]);
            let stream_mps = carried.stream_mps;
            turning[body] = match over {
                Some(over) => {
                    let (load, contact) = (&loads[body], &contact[body]);
                    let acts = Wrench {
                        force_n: load.force_n + contact.force_n,
                        moment_nm: load.moment_nm + contact.moment_nm,
                    };
                    turning_wrench(inertia, state, &acts, stream_mps, over)
                }
                None => inertia.momentum_wrench(state, stream_mps),
            };
        }
    }

    /// Forward and semi-implicit Euler.
    fn one_stage(&mut self, advance: fn(&BodyState, &Rate, f64) -> BodyState) {
        let Buffers { loads, turning, sums, .. } = &mut self.buffers;
        gather(loads, self.work.wrenches(), sums);
        for (sum, turning) in sums.iter_mut().zip(&*turning) {
            sum.force_n += turning.force_n;
            sum.moment_nm += turning.moment_nm;
        }
        for ((state, inertia), sum) in self.states.iter_mut().zip(&self.inertias).zip(&*sums) {
            *state = advance(state, &Rate::of(inertia, state, sum), self.setup.step_s);
        }
    }

    /// Classical Runge–Kutta; each later stage asks the contact engine on a copy of its memory.
    fn runge_kutta(&mut self) -> Result<(), contact::StepError> {
        let step_s = self.setup.step_s;
        let buffers = &mut self.buffers;
        for stream_mps in &mut buffers.streams_mps {
            *stream_mps = Vec2::ZERO;
        }
        for (vessel, carried) in self.setup.world.vessels.iter().zip(&self.world.carried) {
            buffers.streams_mps[vessel.body] = carried.stream_mps;
        }
        let moving = (&*self.inertias, &*buffers.streams_mps);
        let first_contact = self.work.wrenches();
        rates_of(moving, &self.states, &buffers.loads, first_contact, &mut buffers.rates[0]);
        for (stage, elapsed_s) in [(1, 0.5 * step_s), (2, 0.5 * step_s), (3, step_s)] {
            for (body, state) in self.states.iter().enumerate() {
                buffers.trial[body] = euler(state, &buffers.rates[stage - 1][body], elapsed_s);
            }
            let rates = &mut buffers.rates[stage];
            if self.setup.method == Method::Coupled {
                // The mean wrench of the whole step, found with the loads of the step.
                let contact = self.work.wrenches();
                rates_of(moving, &buffers.trial, &buffers.loads, contact, rates);
                continue;
            }
            buffers.probe.copy_from(&self.memory);
            buffers.probe.set_elapsed(elapsed_s);
            let (probe, work) = (&mut buffers.probe, &mut buffers.probe_work);
            contact::step(&self.model, probe, work, &buffers.trial, step_s)?;
            rates_of(moving, &buffers.trial, &buffers.loads, work.wrenches(), rates);
            buffers.stage_contacts[stage - 1].clear();
            buffers.stage_contacts[stage - 1].extend_from_slice(work.contacts());
        }
        let [one, two, three, four] = &buffers.rates;
        for (body, state) in self.states.iter_mut().enumerate() {
            let mean = one[body].runge_kutta(two[body], three[body], four[body]);
            *state = euler(state, &mean, step_s);
            buffers.mean[body] = MeanVelocity::moved(mean.motion());
        }
        Ok(())
    }

    fn book(&mut self) {
        let step_s = self.setup.step_s;
        let buffers = &mut self.buffers;
        let engine_moved = self.setup.integrator == Integrator::SemiImplicit;
        if self.setup.method == Method::Coupled && engine_moved {
            for (mean, motion) in buffers.mean.iter_mut().zip(self.work.displacements()) {
                *mean = MeanVelocity::over(motion, step_s);
            }
        } else if self.setup.method == Method::Coupled && self.setup.integrator == Integrator::Rk4 {
            // As it went: the forces are held over the step, so that their work is force times way.
        } else {
            let states = buffers.before.iter().zip(&self.states);
            for (mean, (before, after)) in buffers.mean.iter_mut().zip(states) {
                *mean = MeanVelocity::of(before, after);
            }
        }
        let contacts = self.work.contacts();
        self.contact_totals.open(contacts);
        let rk4 = self.setup.integrator == Integrator::Rk4;
        let mut add = |contacts, by| self.contact_totals.add(contacts, &buffers.mean, by);
        match self.setup.method {
            Method::Coupled if engine_moved => add(contacts, WorkBy::Engine),
            Method::Paper if rk4 => {
                let [one, later @ ..] = RUNGE_KUTTA;
                add(contacts, WorkBy::Motion(one * step_s));
                for (contacts, weight) in buffers.stage_contacts.iter().zip(later) {
                    add(contacts, WorkBy::Motion(weight * step_s));
                }
            }
            Method::Coupled | Method::Paper => add(contacts, WorkBy::Motion(step_s)),
        }
        self.contact_totals.close();
        let loaded = LoadedStep {
            inertias: &self.inertias,
            before: &buffers.before,
            after: &self.states,
            mean: &buffers.mean,
            others: &buffers.others,
            world: &self.setup.world,
            forces: &self.world.forces,
            carried: &self.world.carried,
            tugs: &self.world.tugs,
            lines: &self.world.lines,
            order: &self.world.order,
            step_s,
        };
        let moved = (&*self.world.order.bodies, &*self.inertias, &*self.states);
        self.ledger.book(moved, &loaded.works(), &self.contact_totals);
    }
}

impl Setup {
    /// The contact problem of these bodies alone, without the world around them: for hosts that move their
    /// bodies by themselves and show them to the contact engine. The method and the integrator decide what
    /// a body's mass is: the engine turns her momentum where it moves her itself, by the coupled method
    /// with the semi-implicit integrator.
    ///
    /// # Errors
    /// [`SetupError`], naming what is wrong.
    pub fn contact_model(&self) -> Result<Model, SetupError> {
        build_model(self, &inertias(self)?)
    }

    /// The states that the bodies start from, in the order of the set-up.
    #[must_use]
    pub fn initial_states(&self) -> Vec<BodyState> {
        self.bodies.iter().map(initial_state).collect()
    }
}

/// Rates of bodies in their streams under loads and contact.
fn rates_of(
    (inertias, streams_mps): (&[Inertia], &[Vec2]),
    states: &[BodyState],
    loads: &[Wrench],
    contact: &[Wrench],
    into: &mut [Rate],
) {
    for (body, rate) in into.iter_mut().enumerate() {
        let turning = inertias[body].momentum_wrench(&states[body], streams_mps[body]);
        let sum = Wrench {
            force_n: loads[body].force_n + contact[body].force_n + turning.force_n,
            moment_nm: loads[body].moment_nm + contact[body].moment_nm + turning.moment_nm,
        };
        *rate = Rate::of(&inertias[body], &states[body], &sum);
    }
}

/// A time over Δt, rounded up; a ratio within 1e-9 of a whole number is that number, so that
/// "20 s" of "0.1 s" is 200 steps.
fn whole_steps(ratio: f64) -> u64 {
    let whole = libm::round(ratio);
    let steps = if (ratio - whole).abs() <= 1e-9 * whole { whole } else { libm::ceil(ratio) };
    steps as u64
}

/// Steps of the run's duration, at least one.
fn count_steps(setup: &Setup) -> Result<u64, SetupError> {
    let positive = |field, value: f64| {
        if value > 0.0 && value.is_finite() {
            return Ok(());
        }
        Err(SetupError::OutOfRange { field, value })
    };
    positive("the time step", setup.step_s)?;
    positive("the duration", setup.duration_s)?;
    let ratio = setup.duration_s / setup.step_s;
    if ratio > 1e12 {
        return Err(SetupError::OutOfRange { field: "the number of steps", value: ratio });
    }
    Ok(whole_steps(ratio).max(1))
}

fn check_load(load: &Load, setup: &Setup) -> Result<(), SetupError> {
    if setup.bodies.get(load.body).is_none_or(|b| b.mass.is_none()) {
        return Err(SetupError::BadBody { owner: "load", body: load.body });
    }
    for (field, value) in [
        ("a load's north force", load.force_n.x),
        ("a load's east force", load.force_n.y),
        ("a load's moment", load.moment_nm),
    ] {
        if !value.is_finite() {
            return Err(SetupError::OutOfRange { field, value });
        }
    }
    if load.from_s.is_nan() || load.until_s.is_nan() {
        return Err(SetupError::OutOfRange { field: "a load's time", value: f64::NAN });
    }
    Ok(())
}

/// The inertia of each body. A vessel has that of her model.
fn inertias(setup: &Setup) -> Result<Vec<Inertia>, SetupError> {
    let engine_moves =
        setup.method == Method::Coupled && setup.integrator == Integrator::SemiImplicit;
    let of_body = |body: &crate::setup::BodySetup| {
        Inertia::of(body.mass.as_ref(), setup.method, engine_moves)
    };
    let mut inertias: Vec<Inertia> = setup.bodies.iter().map(of_body).collect();
    let density_kgpm3 = setup.world.environment.water_density_kgpm3;
    for vessel in &setup.world.vessels {
        if setup.bodies.get(vessel.body).is_none_or(|body| body.mass.is_none()) {
            return Err(SetupError::BadBody { owner: "vessel", body: vessel.body });
        }
        if setup.method == Method::Paper {
            return Err(SetupError::VesselByPaperMethod { body: vessel.body });
        }
        inertias[vessel.body] = Inertia::of_vessel(&mass_matrix(&vessel.ship, density_kgpm3));
    }
    for tug in &setup.world.tugs {
        if tug.vessel >= setup.world.vessels.len() {
            return Err(SetupError::BadBody { owner: "tug", body: tug.vessel });
        }
        let named = |error| SetupError::Tug { tug: tug.tug.name.clone(), error };
        tug.tug.check().map_err(named)?;
    }
    setup.world.orders.iter().try_for_each(|order| check_order(order, setup))?;
    Ok(inertias)
}

/// Lines between bodies that are there; those that are fast from the start on can be.
fn check_lines(setup: &Setup) -> Result<(), SetupError> {
    for line in &setup.world.lines {
        let far = match line.end {
            LineEnd::OnBody { body, .. } => body,
            LineEnd::Fixed(_) => line.ship,
        };
        for body in [line.ship, far] {
            if body >= setup.bodies.len() {
                return Err(SetupError::BadBody { owner: "line", body });
            }
        }
        if line.from_s <= 0.0 {
            let tide = &setup.world.environment.tide;
            line.check_at_start(&setup.bodies, tide).map_err(SetupError::Line)?;
        }
    }
    Ok(())
}

/// The study of a berthing, its particulars checked.
fn study(setup: &Setup) -> Result<Option<Study>, SetupError> {
    let Some(berthing) = setup.berthing else { return Ok(None) };
    let ship = setup.bodies.get(berthing.ship).and_then(|body| body.mass);
    let Some(mass) = ship else {
        return Err(SetupError::BadBody { owner: "berthing", body: berthing.ship });
    };
    berthing.check().map_err(SetupError::Berthing)?;
    Ok(Some(Study::new(berthing, mass.mass_kg)))
}

fn build_model(setup: &Setup, inertias: &[Inertia]) -> Result<Model, SetupError> {
    let mut builder = Model::builder();
    let keys = keys_of(setup.bodies.iter().map(|body| body.name.as_str()))
        .map_err(|name| SetupError::DuplicateName { what: "bodies", name })?;
    for ((body, inertia), key) in setup.bodies.iter().zip(inertias).zip(keys) {
        builder.body(Body {
            name: body.name.clone(),
            key,
            outline: body.outline.clone(),
            mobility: inertia.mobility(),
        });
    }
    for material in &setup.materials {
        builder.material(material.material);
    }
    let keys = keys_of(setup.fenders.iter().map(|fender| fender.name.as_str()))
        .map_err(|name| SetupError::DuplicateName { what: "fenders", name })?;
    for (fender, key) in setup.fenders.iter().zip(keys) {
        builder.fender(engine_fender(fender, key));
    }
    for pair in &setup.pairs {
        let bodies = pair.bodies.map(|body| BodyId(body as u32));
        builder.pair(Pair { bodies, material: MaterialId(pair.material as u32) });
    }
    if let Some(material) = setup.all_other_pairs {
        builder.all_other_pairs(MaterialId(material as u32));
    }
    Ok(builder.build()?)
}

/// As the engine wants it. Without a rating a fender is made for all of its projection.
fn engine_fender(fender: &FenderSetup, key: u64) -> Fender {
    Fender {
        name: fender.name.clone(),
        key,
        body: BodyId(fender.body as u32),
        position_m: fender.position_m,
        facing_rad: fender.facing_rad,
        width_m: fender.width_m,
        projection_m: fender.projection_m,
        law: fender.law.clone(),
        unloading: fender.unloading.clone(),
        material: MaterialId(fender.material as u32),
        rated_deflection_m: fender.rated.map_or(fender.projection_m, |rated| rated.deflection_m),
        stop: fender.stop,
        factors: fender.factors.clone(),
    }
}

/// The key of each name: its place among the sorted ones, so that the order of bodies and fenders in a
/// scenario changes no bit of a run. The error is the name that stands twice.
fn keys_of<'n>(names: impl Iterator<Item = &'n str>) -> Result<Vec<u64>, String> {
    let names: Vec<&str> = names.collect();
    let mut order: Vec<usize> = (0..names.len()).collect();
    order.sort_by(|&i, &j| names[i].cmp(names[j]));
    if let Some(two) = order.windows(2).find(|two| names[two[0]] == names[two[1]]) {
        return Err(names[two[0]].to_owned());
    }
    let mut keys = vec![0; names.len()];
    for (key, &index) in order.iter().enumerate() {
        keys[index] = key as u64;
    }
    Ok(keys)
}
