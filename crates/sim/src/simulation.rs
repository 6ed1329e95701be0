//! One simulation run. [`Simulation::step`] computes a whole time step, from start to end.
//!
//! | file | content |
//! |---|---|
//! | `simulation.rs` | the state of a run, and the time step |
//! | `simulation/access.rs` | functions that read a run, and change it between steps |
//! | `simulation/motion.rs` | integrators, and the Coriolis terms over a step |
//! | `simulation/accounts.rs` | works and energies of each step |
//! | `simulation/check.rs` | checks of a set-up |
//! | `simulation/buffers.rs` | arrays that are reused from step to step |
//! | `simulation/changes.rs` | changes of weather and faults during a run |
//! | `simulation/place.rs` | places bodies before the first step |
//! | `simulation/restart.rs` | starts a simulation again in the same memory |

mod access;
mod accounts;
mod buffers;
mod changes;
mod check;
mod motion;
mod place;
mod restart;

use std::sync::Arc;

use fenderline_contact::{
    self as contact, BodyState, Contact, Memory, Model, Rotation, Vec2, Workspace,
};

use self::buffers::Buffers;
use self::check::{
    berthing_study, check_anchors, check_depths, check_flow, check_lines, check_load,
    check_planned, count_steps,
};
use crate::gather::{add_external, gather, gather_loads};
use crate::integrate::{euler, semi_implicit};
use fenderline_assess::berthing::{Study, StudyStep};
use fenderline_assess::statistics::Statistics;
use fenderline_assess::summary::Summaries;
use fenderline_assess::verdict::{Watch, starts_inside};
use fenderline_ship::attitude::Attitude;
use fenderline_ship::step_time::StepTime;
use fenderline_world::change::Changes;
use fenderline_world::contact_totals::ContactTotals;
use fenderline_world::dolphin::Dolphins;
use fenderline_world::error::{NoDepthUnder, SetupError, SimError, StepFault};
use fenderline_world::fender::FenderSummaries;
use fenderline_world::fixed_order::sort_loads;
use fenderline_world::hull::Sides;
use fenderline_world::ledger::{Bodies, Ledger};
use fenderline_world::model::{Fenders, build_model, inertias};
use fenderline_world::record::StepRecord;
use fenderline_world::rigid_body::Inertia;
use fenderline_world::setup::{Integrator, Load, Method, Setup};
use fenderline_world::world::{MovingBodies, StepTimes};
use fenderline_world::world::{NoDepth, VesselSetup, VesselState, World, motions};

/// A simulation run. A clone of a simulation continues independently from the same state.
#[derive(Clone, Debug)]
pub struct Simulation {
    // Constant in a run.
    setup: Setup,
    /// Clones share the contact model until a hull with outlines at several heights changes it. Because clones share
    /// the contact model, the processor's cache needs it only once for a thousand simulations side by side.
    model: Arc<Model>,
    inertias: Vec<Inertia>,
    steps_total: u64,
    /// The loads of the set-up, in the order in which they are summed.
    loads: Vec<Load>,
    // State.
    index: u64,
    states: Vec<BodyState>,
    memory: Memory,
    world: World,
    changes: Changes,
    /// The outlines that fenders meet on hulls with outlines at several heights.
    sides: Sides,
    // Results of the last step, and totals of the run.
    work: Workspace,
    ledger: Ledger,
    contact_totals: ContactTotals,
    summaries: Summaries,
    fender_summaries: FenderSummaries,
    watch: Watch,
    dolphins: Dolphins,
    study: Option<Study>,
    statistics: Option<Statistics>,
    buffers: Buffers,
}

impl Simulation {
    /// Checks the set-up and prepares the first step of the run.
    ///
    /// # Errors
    /// Returns a [`SetupError`], which names what is wrong in the set-up.
    pub fn new(setup: Setup) -> Result<Simulation, SetupError> {
        let steps_total = count_steps(&setup)?;
        setup.loads.iter().try_for_each(|load| check_load(load, &setup))?;
        let motions = motions(&setup.world, setup.step_s);
        let inertias = inertias(&setup, &motions)?;
        let mut model = build_model(&setup, &inertias, Fenders::MeetSlices)?;
        let states = setup.initial_states();
        setup.world.environment.check().map_err(SetupError::Environment)?;
        check_lines(&setup)?;
        check_depths(&setup, &states)?;
        check_anchors(&setup)?;
        check_flow(&setup)?;
        check_planned(&setup)?;
        let mut loads = setup.loads.clone();
        sort_loads(&mut loads);
        let mut memory = Memory::new(&model);
        let world = World::new(&setup.world, &setup.bodies, &states, &motions, setup.step_s);
        let mut sides = Sides::new(&setup);
        let heights = world.heights(&setup.world, StepTime { t_s: 0.0, step_s: setup.step_s });
        sides.renew(&setup, (&mut model, &mut memory), &states, &heights);
        let bodies = Bodies { order: &world.order.bodies, inertias: &inertias, states: &states };
        Ok(Simulation {
            ledger: Ledger::new(bodies),
            work: Workspace::new(&model),
            buffers: Buffers::new(&model, &states, &memory),
            contact_totals: ContactTotals::default(),
            summaries: Summaries::default(),
            fender_summaries: FenderSummaries::new(setup.fenders.len()),
            watch: Watch::new(&setup, |is_protected| {
                let fresh = (&mut Memory::new(&model), &mut Workspace::new(&model));
                starts_inside(&setup, &model, &states, fresh, is_protected)
            }),
            dolphins: Dolphins::new(&setup, &model),
            study: berthing_study(&setup)?,
            statistics: Statistics::new(&setup),
            world,
            changes: Changes::default(),
            sides,
            index: 0,
            loads,
            setup,
            model: Arc::new(model),
            inertias,
            steps_total,
            states,
            memory,
        })
    }

    /// Advances the simulation by one time step. Steps beyond the run's duration are allowed.
    ///
    /// # Errors
    /// Returns a [`SimError`] if the state of a body exceeds the limits of the contact engine, for example in a run
    /// that diverges, or if a vessel is where no depth is known. The simulation is then unchanged.
    pub fn step(&mut self) -> Result<StepRecord<'_>, SimError> {
        let t_s = self.time_s();
        // Changes are rare, so a copy of the whole simulation costs little.
        let before = self.changes_are_due().then(|| Box::new(self.clone()));
        if before.is_some() {
            self.run_changes();
        }
        if let Err(error) = self.sound(t_s) {
            if let Some(before) = before {
                *self = *before;
            }
            return Err(SimError { t_s, cause: StepFault::NoDepth(error) });
        }
        self.backup();
        self.gather_loads(t_s);
        self.report_changes();
        self.cut_hulls(t_s);
        self.turn_momentum();
        if let Err(cause) = self.advance_bodies() {
            self.restore();
            if let Some(before) = before {
                *self = *before;
            }
            return Err(SimError { t_s, cause: StepFault::Engine(cause) });
        }
        self.update_world(t_s);
        self.dolphins.take(self.work.piles());
        self.account_energy();
        self.record(t_s)
    }

    /// Sounds the depths under the vessels.
    fn sound(&mut self, t_s: f64) -> Result<(), NoDepthUnder> {
        let named = |(vessel, place): (usize, NoDepth)| {
            let body = self.setup.world.vessels[vessel].body;
            NoDepthUnder { body: self.setup.bodies[body].name.clone(), place }
        };
        self.world.sound(&self.setup.world, &self.states, t_s).map_err(named)
    }

    /// Copies the parts that a failing step would leave half-changed. The state of vessels, tugs, lines and anchors is
    /// copied only if steps change it.
    fn backup(&mut self) {
        if self.setup.integrator == Integrator::Rk4 || !self.sides.is_empty() {
            self.buffers.backup.copy_from(&self.memory);
        }
        if self.setup.world.changes() {
            self.world.back_up(&mut self.buffers.world);
        }
    }

    /// Restores the state of the simulation before a step that failed.
    fn restore(&mut self) {
        if self.setup.integrator == Integrator::Rk4 || !self.sides.is_empty() {
            self.memory.copy_from(&self.buffers.backup);
        }
        if !self.sides.is_empty() {
            self.sides.restore(Arc::make_mut(&mut self.model));
        }
        if self.setup.world.changes() {
            self.world.put_back(&mut self.buffers.world);
        }
    }

    /// Sums all loads on each body except contact: the loads of the set-up and of the host program, and the forces of
    /// vessels, tugs, lines and anchors.
    fn gather_loads(&mut self, t_s: f64) {
        let (step_s, velocity_t_s) = (self.setup.step_s, self.velocity_time_s());
        let Buffers { loads, plain_loads, external, before, lags_s, .. } = &mut self.buffers;
        if !self.setup.world.vessels.is_empty() {
            self.memory.velocity_lags_into(&self.model, lags_s);
        }
        gather_loads(&self.loads, t_s, step_s, loads);
        add_external(external, loads);
        plain_loads.clone_from(loads);
        // The engine's leapfrog starts with half a step for the velocities.
        let acts_s = if self.index == 0 { 0.5 * step_s } else { step_s };
        let times = StepTimes { t_s, velocity_t_s, step_s, acts_s };
        let bodies = MovingBodies { states: &self.states, lags_s };
        self.world.step(&self.setup.world, bodies, times, loads);
        before.clone_from(&self.states);
    }

    /// The step that begins at a time.
    fn step_time(&self, t_s: f64) -> StepTime {
        StepTime { t_s, step_s: self.setup.step_s }
    }

    /// Renews the outlines that fenders meet on hulls with outlines at several heights.
    fn cut_hulls(&mut self, t_s: f64) {
        if self.sides.is_empty() {
            return;
        }
        let heights = self.world.heights(&self.setup.world, self.step_time(t_s));
        let engine = (Arc::make_mut(&mut self.model), &mut self.memory);
        self.sides.renew(&self.setup, engine, &self.states, &heights);
    }

    /// Computes the contact forces of the step and the new states of the bodies. With the coupled method and the
    /// semi-implicit integrator the contact engine moves the bodies itself, in its sub-steps.
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

    /// Computes the contact forces of this step by the method of the set-up.
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

    /// Updates heel and trim of the vessels, which depend on the contact forces and the new states.
    fn update_world(&mut self, t_s: f64) {
        let contacts = self.work.contacts();
        self.sides.find_touches(&self.setup, &self.model, &self.buffers.before, contacts);
        let (world, fenders) = (&self.setup.world, &self.setup.fenders);
        let (touches, step) = (&self.sides.touches, self.step_time(t_s));
        self.world.settle(world, fenders, contacts, touches, &self.states, step);
    }

    /// Adds the step to the summaries of the run, and returns the record of the step. The record is wrapped in `Ok`
    /// from the start, because it is large and would otherwise be copied.
    #[inline(always)]
    fn record(&mut self, t_s: f64) -> Result<StepRecord<'_>, SimError> {
        self.dolphins.summarise(&self.setup, t_s);
        let (order, inertias) = (&self.world.order.bodies, &self.inertias);
        let bodies = Bodies { order, inertias, states: &self.states };
        let mut result = Ok(StepRecord {
            index: self.index,
            t_s,
            states: &self.buffers.before,
            states_after: &self.states,
            contacts: self.work.contacts(),
            contact_energies: &self.contact_totals.all,
            hull_touches: &self.sides.touches,
            panels: self.work.panels(),
            chains: &[],
            wrenches: self.work.wrenches(),
            events: self.work.events(),
            ledger: (&self.ledger, bodies),
            vessels: &self.world.vessels,
            vessel_forces: &self.world.forces,
            soundings: &self.world.soundings,
            lines: &self.world.lines,
            anchors: &self.world.anchors,
            dolphins: &self.dolphins.motions,
            tugs: &self.world.tugs,
            world_events: &self.world.events,
        });
        let Ok(record) = &mut result else { unreachable!("it was made here") };
        self.summaries.add(record);
        self.watch.add(&self.setup, record, self.ledger.contacts_j());
        if let Some(statistics) = &mut self.statistics {
            statistics.add(&self.setup, record);
        }
        let setups = (self.setup.fenders.as_slice(), self.setup.materials.as_slice());
        let (vessels, now) = (&self.setup.world.vessels, &self.world.vessels);
        let states = record.states;
        let sinking_mps =
            |contact: &Contact, host: usize| sinking_mps(vessels, now, states, contact, host);
        self.fender_summaries.add(setups, record, sinking_mps);
        record.chains = &self.fender_summaries.chains;
        if let Some(study) = &mut self.study {
            study.add(
                &self.setup.fenders,
                &self.inertias,
                &StudyStep::of(record, self.setup.step_s),
            );
        }
        self.index += 1;
        result
    }
}

/// How fast the hull at a contact sinks relative to the fender on the body `host` (m/s). Heave, roll and pitch of the
/// vessels cause this sinking.
fn sinking_mps(
    vessels: &[VesselSetup],
    now: &[VesselState],
    states: &[BodyState],
    contact: &Contact,
    host: usize,
) -> f64 {
    let of_body = |body: usize, arm_m: Vec2| {
        let Some(vessel) = vessels.iter().position(|vessel| vessel.body == body) else {
            return 0.0;
        };
        let Attitude { heave, roll, pitch } = now[vessel].attitude;
        let own_m = Rotation::from_angle(states[body].heading_rad).apply_inverse(arm_m);
        heave.rate + roll.rate * own_m.y - pitch.rate * own_m.x
    };
    let [one, two] = [contact.body_1, contact.body_2].map(|id| id.0 as usize);
    let (one_mps, two_mps) = (of_body(one, contact.arm_1_m), of_body(two, contact.arm_2_m));
    if one == host { two_mps - one_mps } else { one_mps - two_mps }
}
