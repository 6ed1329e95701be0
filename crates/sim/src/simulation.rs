//! One simulation run. [`Simulation::step`] is the whole time step, from top to bottom.
//!
//! | file | content |
//! |---|---|
//! | `simulation.rs` | the state of a run, and the time step |
//! | `simulation/access.rs` | reading a run, and changing it between steps |
//! | `simulation/motion.rs` | integrators, and the Coriolis terms over a step |
//! | `simulation/accounts.rs` | works and energies of a step |
//! | `simulation/model.rs` | set-up to inertias and contact model |
//! | `simulation/check.rs` | checks of a set-up |
//! | `simulation/buffers.rs` | arrays that are reused from step to step |

mod access;
mod accounts;
mod buffers;
mod check;
mod model;
mod motion;

use fenderline_contact::{self as contact, BodyState, Memory, Model, Workspace};

use self::buffers::Buffers;
use self::check::{berthing_study, check_lines, check_load, count_steps};
use self::model::{build_model, inertias};
use crate::berthing::{Study, StudyStep};
use crate::contact_totals::ContactTotals;
use crate::error::{SetupError, SimError};
use crate::fender::FenderSummaries;
use crate::fixed_order::sort_loads;
use crate::gather::{add_external, gather, gather_loads};
use crate::integrate::{euler, semi_implicit};
use crate::ledger::{Bodies, Ledger};
use crate::record::StepRecord;
use crate::rigid_body::Inertia;
use crate::setup::{Integrator, Load, Method, Setup};
use crate::summary::Summaries;
use crate::verdict::{Watch, starts_inside};
use crate::world::World;

/// A simulation run. A clone continues independently from the same state.
#[derive(Clone, Debug)]
pub struct Simulation {
    // Constant.
    setup: Setup,
    model: Model,
    inertias: Vec<Inertia>,
    steps_total: u64,
    /// The loads of the set-up, in the order of summation.
    loads: Vec<Load>,
    // State.
    index: u64,
    states: Vec<BodyState>,
    memory: Memory,
    world: World,
    // Results of the last step, and totals of the run.
    work: Workspace,
    ledger: Ledger,
    contact_totals: ContactTotals,
    summaries: Summaries,
    fender_summaries: FenderSummaries,
    watch: Watch,
    study: Option<Study>,
    buffers: Buffers,
}

impl Simulation {
    /// Checks the set-up and prepares the first step.
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
        let memory = Memory::new(&model);
        let world = World::new(&setup.world, &setup.bodies);
        let bodies = Bodies { order: &world.order.bodies, inertias: &inertias, states: &states };
        Ok(Simulation {
            ledger: Ledger::new(bodies),
            work: Workspace::new(&model),
            buffers: Buffers::new(&model, &states, &memory),
            contact_totals: ContactTotals::default(),
            summaries: Summaries::default(),
            fender_summaries: FenderSummaries::new(setup.fenders.len()),
            watch: Watch::new(&setup, |is_protected| {
                starts_inside(&setup, &model, &states, is_protected)
            }),
            study: berthing_study(&setup)?,
            world,
            index: 0,
            loads,
            setup,
            model,
            inertias,
            steps_total,
            states,
            memory,
        })
    }

    /// Advances the simulation by one time step. Steps beyond the run's duration are allowed.
    ///
    /// # Errors
    /// [`SimError`] when a state exceeds the limits of the contact engine, as in a run that diverges. The
    /// simulation is then unchanged.
    pub fn step(&mut self) -> Result<StepRecord<'_>, SimError> {
        let t_s = self.time_s();
        let world_before = self.backup();
        self.gather_loads(t_s);
        self.turn_momentum();
        if let Err(cause) = self.advance_bodies() {
            self.restore(world_before);
            return Err(SimError { t_s, cause });
        }
        self.update_world(t_s);
        self.account_energy();
        Ok(self.record(t_s))
    }

    /// Copies what a failing step would leave half-changed. The world is copied only if steps change it.
    fn backup(&mut self) -> Option<World> {
        if self.setup.integrator == Integrator::Rk4 {
            self.buffers.backup.copy_from(&self.memory);
        }
        self.setup.world.changes().then(|| self.world.clone())
    }

    /// Restores the state before a step that failed.
    fn restore(&mut self, world_before: Option<World>) {
        if self.setup.integrator == Integrator::Rk4 {
            self.memory.copy_from(&self.buffers.backup);
        }
        if let Some(world) = world_before {
            self.world = world;
        }
    }

    /// Sums everything but contact on each body: loads of the set-up and of the host, vessels, tugs, lines.
    fn gather_loads(&mut self, t_s: f64) {
        let (step_s, velocity_time_s) = (self.setup.step_s, self.velocity_time_s());
        let Buffers { loads, plain_loads, external, before, .. } = &mut self.buffers;
        gather_loads(&self.loads, t_s, step_s, loads);
        add_external(external, loads);
        plain_loads.clone_from(loads);
        let times = (t_s, velocity_time_s, step_s);
        self.world.step(&self.setup.world, &self.states, times, loads);
        before.clone_from(&self.states);
    }

    /// Contact forces and the new states. With the coupled method and the semi-implicit integrator the contact
    /// engine moves the bodies itself, in its sub-steps.
    fn advance_bodies(&mut self) -> Result<(), contact::StepError> {
        self.contact_forces()?;
        match self.setup.integrator {
            Integrator::SemiImplicit if self.setup.method == Method::Coupled => Ok(()),
            Integrator::SemiImplicit => {
                self.one_stage(semi_implicit);
                Ok(())
            }
            Integrator::Euler => {
                self.one_stage(euler);
                Ok(())
            }
            Integrator::Rk4 => self.runge_kutta(),
        }
    }

    /// Contact forces of this step, by the method of the set-up.
    fn contact_forces(&mut self) -> Result<(), contact::StepError> {
        let step_s = self.setup.step_s;
        let (model, memory, work) = (&self.model, &mut self.memory, &mut self.work);
        match self.setup.method {
            Method::Paper => contact::step(model, memory, work, &self.states, step_s),
            Method::Coupled => {
                let Buffers { loads, turning, sums, .. } = &mut self.buffers;
                gather(loads, turning, sums);
                if self.setup.integrator == Integrator::SemiImplicit {
                    contact::advance_in_place(model, memory, work, &mut self.states, sums, step_s)
                } else {
                    contact::advance(model, memory, work, &self.states, sums, step_s)
                }
            }
        }
    }

    /// Updates what depends on the contact forces and the new states: heel and trim of the vessels.
    fn update_world(&mut self, t_s: f64) {
        let contacts = self.work.contacts();
        let (world, fenders) = (&self.setup.world, &self.setup.fenders);
        self.world.settle(world, fenders, contacts, &self.states, (t_s, self.setup.step_s));
    }

    /// Adds the step to the summaries of the run, and gives its record.
    fn record(&mut self, t_s: f64) -> StepRecord<'_> {
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
        self.summaries.add(&record);
        self.watch.add(&self.setup, &record);
        self.fender_summaries.add(&self.setup.fenders, record.contacts, t_s);
        if let Some(study) = &mut self.study {
            study.add(&self.setup.fenders, &self.inertias, &StudyStep::of(&record));
        }
        self.index += 1;
        record
    }
}
