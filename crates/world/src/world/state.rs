//! The state of vessels, tugs, lines and anchors, and how a step changes this state.

use std::borrow::Cow;
use std::sync::Arc;

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Contact, Rotation, Wrench, vec2};

use super::abilities::Abilities;
use super::afloat::{Afloat, Lever};
use super::anchor::{AnchorAtWork, AnchoredShip};
use super::azimuth_pilot::{self, Steered, Stream};
use super::environment::NoDepth;
use super::event::{WorldEvent, WorldEventKind};
use super::grounding;
use super::inputs::{Moving, MovingBodies, StepTimes, Surroundings};
use super::line::{LineWorld, Mooring, MooringLines};
use super::line_work::{self, Sending};
use super::passing;
use super::pilot::{self, PilotWork};
use super::seaway::{Given, Seaway, SeawayTimes};
use super::setup::WorldSetup;
use super::shore::Shore;
use super::soundings::Soundings;
use super::tug::TugAtWork;
use super::vessel::{VesselForces, VesselSetup, VesselState, WaterInertia, mass_matrix};
use crate::fender::FenderSetup;
use crate::fixed_order::SumOrder;
use crate::hull::{Heights, HullTouch, place_m};
use crate::order::{Action, LineAction, Order, OrderError};
use crate::setup::body::BodySetup;
use fenderline_seakeeping::{Motion, SubSteps};
use fenderline_ship::anchor::AnchorEvent;
use fenderline_ship::attitude::AttitudeLoad;
use fenderline_ship::environment::wind::{ShipGusts, Wind};
use fenderline_ship::hydro::Force;
use fenderline_ship::step_time::StepTime;

/// The variable state of vessels, tugs, lines and anchors: plain data, and values that each step calculates anew.
#[derive(Clone, Debug)]
pub struct World {
    /// The states of the vessels, in the order of the set-up.
    pub vessels: Vec<VesselState>,
    /// The forces on each vessel in the last step.
    pub forces: Vec<VesselForces>,
    /// The inertia of the water that moves with each vessel.
    pub water_inertia: Vec<WaterInertia>,
    /// The depths under each vessel at the start of the step: [`World::sound`].
    pub soundings: Vec<Soundings>,
    /// The depths for the next step, which replace `soundings` if the depth is known under all vessels.
    sounded: Vec<Soundings>,
    /// Forces of passing ships and of other vessels on each vessel; computed anew in each step.
    passing: Vec<Force>,
    /// Forces of banks by images on each vessel. Each step calculates these forces anew.
    banks: Vec<Force>,
    /// For each vessel, the constant part of the motion by hydrodynamic data.
    seaways: Vec<Option<Seaway>>,
    /// For each vessel, the mass matrix with which the engine moves the vessel, for surge, sway and yaw (kg, kg·m,
    /// kg·m²).
    masses: Vec<[[f64; 3]; 3]>,
    /// The states of the bodies between which lines pull; see [`World::look_ahead`]. The list is empty if no vessel has
    /// hydrodynamic data.
    ahead: Vec<BodyState>,
    /// For each body, the attitude of the body afloat. The list is empty if no vessel has hydrodynamic data.
    afloat: Vec<Option<Afloat>>,
    /// The mooring lines.
    pub lines: Vec<Mooring>,
    /// The anchors.
    pub anchors: Vec<AnchorAtWork>,
    /// The vector tugs.
    pub tugs: Vec<TugAtWork>,
    /// The events of the last step.
    pub events: Vec<WorldEvent>,
    abilities: Vec<Abilities>,
    /// The gusts of the set-up at each vessel.
    gusts: Vec<Option<ShipGusts>>,
    /// Orders sorted by time, and the number of orders that the world has already carried out.
    orders: Vec<Order>,
    pub(super) taken: usize,
    /// For each vessel, true if an order was beyond a stop in the last step, so that there is only one event.
    pub(super) clamped: Vec<bool>,
    pilots: PilotWork,
    /// The order of summation.
    pub order: SumOrder,
    /// For each body, true if the body is fixed: the tide rises and falls around such a body.
    fixed: Vec<bool>,
}

impl World {
    /// The world at the start of a run.
    pub fn new(
        setup: &WorldSetup,
        bodies: &[BodySetup],
        states: &[BodyState],
        motions: &[Option<Arc<Motion>>],
        step_s: f64,
    ) -> World {
        let water = setup.environment.density();
        let seaways: Vec<Option<Seaway>> = setup
            .vessels
            .iter()
            .zip(motions)
            .map(|(vessel, motion)| {
                Seaway::new(vessel, motion.as_ref()?, &setup.environment, step_s)
            })
            .collect();
        let masses = setup.vessels.iter().zip(motions).map(|(vessel, motion)| match motion {
            Some(motion) => *motion.plane_mass(),
            None => mass_matrix(&vessel.ship, setup.environment.water_density_kgpm3),
        });
        let mut orders = setup.orders.clone();
        orders.sort_by(|one, other| one.at_s.total_cmp(&other.at_s));
        World {
            vessels: start_vessels(setup, &seaways, states).collect(),
            afloat: Vec::new(),
            forces: vec![VesselForces::default(); setup.vessels.len()],
            water_inertia: vec![WaterInertia::default(); setup.vessels.len()],
            soundings: vec![Soundings::default(); setup.vessels.len()],
            sounded: Vec::with_capacity(setup.vessels.len()),
            passing: vec![Force::default(); setup.vessels.len()],
            banks: vec![Force::default(); setup.vessels.len()],
            masses: masses.collect(),
            ahead: Vec::new(),
            seaways,
            lines: setup.lines.iter().map(Mooring::new).collect(),
            anchors: setup.anchors.iter().map(AnchorAtWork::new).collect(),
            tugs: setup.tugs.iter().map(TugAtWork::new).collect(),
            events: Vec::new(),
            abilities: setup.vessels.iter().map(|v| Abilities::of(v, water)).collect(),
            gusts: setup.vessels.iter().map(|v| v.gusts(&setup.environment)).collect(),
            orders,
            taken: 0,
            clamped: vec![false; setup.vessels.len()],
            pilots: PilotWork::default(),
            order: SumOrder::new(setup, bodies),
            fixed: bodies.iter().map(BodySetup::is_fixed).collect(),
        }
    }

    /// Resets the world to the start of another run with this set-up. Of this set-up, only the wind and the current may
    /// have changed.
    pub fn restart(&mut self, setup: &WorldSetup, states: &[BodyState]) {
        for (own, new) in self.vessels.iter_mut().zip(start_vessels(setup, &self.seaways, states)) {
            *own = new;
        }
        self.forces.fill(VesselForces::default());
        self.water_inertia.fill(WaterInertia::default());
        for (own, setup) in self.lines.iter_mut().zip(&setup.lines) {
            *own = Mooring::new(setup);
        }
        for (own, setup) in self.anchors.iter_mut().zip(&setup.anchors) {
            *own = AnchorAtWork::new(setup);
        }
        for (own, setup) in self.tugs.iter_mut().zip(&setup.tugs) {
            *own = TugAtWork::new(setup);
        }
        self.renew_gusts(setup);
        self.events.clear();
        self.orders.clone_from(&setup.orders);
        self.orders.sort_by(|one, other| one.at_s.total_cmp(&other.at_s));
        self.taken = 0;
        self.clamped.fill(false);
    }

    /// Takes the gusts of the set-up again, because the wind of the set-up may have changed.
    pub fn renew_gusts(&mut self, setup: &WorldSetup) {
        let gusts = setup.environment.wind.as_ref().and_then(Wind::gusts);
        for (own, vessel) in self.gusts.iter_mut().zip(&setup.vessels) {
            let is_same = match (&*own, gusts) {
                (Some(own), Some(gusts)) => own.are_of(gusts),
                (own, gusts) => own.is_none() && gusts.is_none(),
            };
            if !is_same {
                *own = vessel.gusts(&setup.environment);
            }
        }
    }

    /// Finds the depths under each vessel at a time, for the step that begins at this time. An error changes nothing.
    ///
    /// # Errors
    /// Returns the first vessel with a station at which no depth is known, by her index, and the place of this station.
    pub fn sound(
        &mut self,
        setup: &WorldSetup,
        states: &[BodyState],
        t_s: f64,
    ) -> Result<(), (usize, NoDepth)> {
        self.sounded.clear();
        for (index, vessel) in setup.vessels.iter().enumerate() {
            let sounded = vessel.soundings(&states[vessel.body], &setup.environment, t_s);
            self.sounded.push(sounded.map_err(|error| (index, error))?);
        }
        std::mem::swap(&mut self.soundings, &mut self.sounded);
        Ok(())
    }

    /// Adds the forces of vessels, tugs, lines and anchors in the step that begins at the states of `bodies` to the loads
    /// of the bodies. The velocities belong to the time `velocity_t_s`. The velocities of the water are taken at the same
    /// time; otherwise a ship that drifts with the water would have a drag, because of the difference of the two times.
    /// [`World::sound`] must have been called for the start of the step.
    pub fn step(
        &mut self,
        setup: &WorldSetup,
        bodies: MovingBodies<'_>,
        times: StepTimes,
        loads: &mut [Wrench],
    ) {
        self.events.clear();
        self.take_orders(setup, bodies.states, times.step());
        if setup.vessels.is_empty() && setup.lines.is_empty() {
            return; // tugs and anchors are of vessels
        }
        self.load_flow(setup, bodies.states, times.t_s);
        for index in 0..setup.vessels.len() {
            let stream = self.steer(setup, index, bodies.states, times);
            self.sink(setup, index, bodies.states, times.t_s);
            self.load_vessel(setup, index, bodies.states, &stream, times, loads);
        }
        self.load_tugs(setup, bodies.states, times.step(), loads);
        self.find_afloat(setup, bodies.states.len());
        self.look_ahead(setup, bodies, times.step_s);
        self.load_lines(setup, bodies.states, times.step(), loads);
        self.load_anchors(setup, bodies.states, times.step(), loads);
        self.press_on_bottom(setup, bodies, times, loads);
        self.load_seaways(setup, bodies, times, loads);
    }

    /// Computes the forces of passing ships, of other vessels and of banks by images on each vessel.
    fn load_flow(&mut self, setup: &WorldSetup, states: &[BodyState], t_s: f64) {
        let vessels = passing::Vessels { setups: &setup.vessels, states };
        let (environment, soundings) = (&setup.environment, self.soundings.as_slice());
        passing::act(&setup.flow, vessels, environment, soundings, t_s, &mut self.passing);
        passing::act_of_banks(&setup.flow, vessels, environment, soundings, t_s, &mut self.banks);
    }

    /// Lets the pilots of a vessel set their orders, and moves rudder, shaft, thrusters and azimuth units. Returns the
    /// velocity of the vessel through the water.
    fn steer(
        &mut self,
        setup: &WorldSetup,
        index: usize,
        states: &[BodyState],
        times: StepTimes,
    ) -> Stream {
        let vessel = &setup.vessels[index];
        let (state, own) = (&states[vessel.body], &mut self.vessels[index]);
        let abilities = &self.abilities[index];
        let serves = |tug: &&usize| setup.tugs[**tug].vessel == index;
        let work = &mut self.pilots;
        let helpers = self.order.tugs.iter().filter(serves);
        work.helpers.clear();
        work.helpers.extend(helpers.map(|&tug| setup.tugs[tug].device(vessel)));
        let stream = Stream {
            velocity: vessel.velocity(state, &setup.environment, times.velocity_t_s),
            water: setup.environment.density(),
        };
        let steered = Steered { setup: vessel, abilities, stream: &stream };
        pilot::pilot(own, steered, state, work, times.step_s);
        let last = &self.forces[index];
        azimuth_pilot::under_way(own, &mut work.shares, steered, last, state, times.step_s);
        let lines = MooringLines { setups: &setup.lines, now: &self.lines };
        azimuth_pilot::assist(own, &mut work.shares, steered, last, states, lines, times.step_s);
        let tugs = self.order.tugs.iter().filter(serves);
        for (&tug, &starboard_n) in tugs.zip(&work.helpers_n) {
            self.tugs[tug].push_or_pull(&setup.tugs[tug], times.t_s, starboard_n);
        }
        let clamped = own.act(times.step_s);
        if clamped && !self.clamped[index] {
            self.events.push(WorldEvent { who: index, kind: WorldEventKind::OrderClamped });
        }
        self.clamped[index] = clamped;
        stream
    }

    /// Finds squat and under-keel clearance of a vessel, and whether she is aground.
    fn sink(&mut self, setup: &WorldSetup, index: usize, states: &[BodyState], t_s: f64) {
        let (vessel, own) = (&setup.vessels[index], &mut self.vessels[index]);
        let soundings = &self.soundings[index];
        own.squat_m = vessel.squat_m(&states[vessel.body], &setup.environment, soundings, t_s);
        own.under_keel_m = vessel.under_keel_m(own.squat_m, soundings);
        let held = vessel.is_held(soundings);
        if held && !own.held {
            self.events.push(WorldEvent { who: index, kind: WorldEventKind::ShallowHeld });
        }
        own.held = held;
        let aground = VesselSetup::is_aground(own);
        if aground && !own.aground {
            self.events.push(WorldEvent { who: index, kind: WorldEventKind::Aground });
        }
        own.aground = aground;
    }

    /// Adds a vessel's forces of hull, propulsion, wind, waves, banks and passing ships to the load of her body.
    fn load_vessel(
        &mut self,
        setup: &WorldSetup,
        index: usize,
        states: &[BodyState],
        stream: &Stream,
        times: StepTimes,
        loads: &mut [Wrench],
    ) {
        let (vessel, own) = (&setup.vessels[index], &mut self.vessels[index]);
        let state = &states[vessel.body];
        let moving = Moving { state, velocity: &stream.velocity };
        let around = Surroundings {
            environment: &setup.environment,
            gusts: self.gusts[index].as_ref(),
            soundings: &self.soundings[index],
        };
        let mut forces = vessel.forces(own, moving, around, times);
        forces.passing = self.passing[index];
        forces.banks = forces.banks + self.banks[index];
        let step = StepTime { t_s: times.velocity_t_s, step_s: times.step_s };
        let water_inertia =
            vessel.water_inertia(moving, &setup.environment, &self.masses[index], step);
        let wrench = vessel.wrench(&forces, &water_inertia, state);
        loads[vessel.body].force_n += wrench.force_n;
        loads[vessel.body].moment_nm += wrench.moment_nm;
        (self.forces[index], self.water_inertia[index]) = (forces, water_inertia);
    }

    /// Adds the forces of the vector tugs to the loads of the vessels' bodies.
    fn load_tugs(
        &mut self,
        setup: &WorldSetup,
        states: &[BodyState],
        step: StepTime,
        loads: &mut [Wrench],
    ) {
        for &index in &self.order.tugs {
            let tug = &setup.tugs[index];
            let vessel = &setup.vessels[tug.vessel];
            let (state, ship) = (&states[vessel.body], &vessel.ship.particulars);
            let now = &mut self.tugs[index];
            let was_limited = now.limited;
            let wrench = now.step(tug, ship, state, &setup.environment, step);
            if now.limited && !was_limited {
                self.events.push(WorldEvent { who: index, kind: WorldEventKind::TugLimited });
            }
            loads[vessel.body].force_n += wrench.force_n;
            loads[vessel.body].moment_nm += wrench.moment_nm;
        }
    }

    /// Adds the forces of the mooring lines to the loads of the bodies at both ends.
    fn load_lines(
        &mut self,
        setup: &WorldSetup,
        states: &[BodyState],
        step: StepTime,
        loads: &mut [Wrench],
    ) {
        let level_m = setup.environment.level_m(step.t_s);
        let shore = Shore { fixed: &self.fixed, level_m, afloat: &self.afloat };
        let met = if self.ahead.is_empty() { states } else { self.ahead.as_slice() };
        line_work::take_lines(&mut self.lines, setup, met, shore, step.t_s);
        let ends = LineWorld { bollards: &setup.bollards, states, met, shore };
        for &index in &self.order.lines {
            let (mooring, line) = (&mut self.lines[index], &setup.lines[index]);
            mooring.step(index, line, ends, step, loads, &mut self.events);
        }
    }

    /// Adds the pulls of the anchors' chains to the loads of the ships.
    fn load_anchors(
        &mut self,
        setup: &WorldSetup,
        states: &[BodyState],
        step: StepTime,
        loads: &mut [Wrench],
    ) {
        let level_m = setup.environment.level_m(step.t_s);
        let shore = Shore { fixed: &self.fixed, level_m, afloat: &self.afloat };
        for &index in &self.order.anchors {
            let anchor = &setup.anchors[index];
            let ship = AnchoredShip {
                body: setup.vessels[anchor.vessel].body,
                states,
                shore,
                environment: &setup.environment,
                under_m: self.soundings[anchor.vessel].mean_m,
            };
            self.anchors[index].step(index, anchor, ship, step, loads, &mut self.events);
        }
    }

    /// Adds the force of the bottom on vessels over a bottom that is not level. All other forces except contact must
    /// already be in `loads`.
    fn press_on_bottom(
        &mut self,
        setup: &WorldSetup,
        bodies: MovingBodies<'_>,
        times: StepTimes,
        loads: &mut [Wrench],
    ) {
        for (index, vessel) in setup.vessels.iter().enumerate() {
            if self.soundings[index].is_level {
                continue;
            }
            let (state, load) = (&bodies.states[vessel.body], &mut loads[vessel.body]);
            let axes = Rotation::from_angle(state.heading_rad);
            let own = axes.apply_inverse(load.force_n);
            let step = grounding::Step {
                mass: self.masses[index],
                given: [own.x, own.y, load.moment_nm],
                acts_s: times.acts_s,
                lag_s: greater(bodies.lags_s[vessel.body], 0.0),
            };
            let squat_m = self.vessels[index].squat_m;
            let force = vessel.on_slope(state, &setup.environment, squat_m, times.t_s, &step);
            if force == Force::default() {
                continue;
            }
            let ahead_m = vessel.ship.particulars.centre_of_gravity_m;
            load.force_n += axes.apply(vec2(force.surge_n, force.sway_n));
            load.moment_nm += force.yaw_nm - ahead_m * force.sway_n;
            self.forces[index].bottom = force;
        }
    }

    /// Finds the attitude afloat of the bodies with hydrodynamic data.
    fn find_afloat(&mut self, setup: &WorldSetup, bodies: usize) {
        if self.seaways.iter().all(Option::is_none) {
            return;
        }
        self.afloat.clear();
        self.afloat.resize(bodies, None);
        for (vessel, state) in setup.vessels.iter().zip(&self.vessels) {
            self.afloat[vessel.body] = Afloat::of(vessel, state);
        }
    }

    /// Calculates where the bodies with hydrodynamic data are in the middle of the time for which loads act; see
    /// [`fenderline_seakeeping::SubSteps`]. Lines pull at these places.
    fn look_ahead(
        &mut self,
        setup: &WorldSetup,
        MovingBodies { states, lags_s }: MovingBodies<'_>,
        step_s: f64,
    ) {
        self.ahead.clear();
        if self.seaways.iter().all(Option::is_none) {
            return;
        }
        self.ahead.extend_from_slice(states);
        for (vessel, seaway) in setup.vessels.iter().zip(&self.seaways) {
            if seaway.is_none() {
                continue;
            }
            let state = &mut self.ahead[vessel.body];
            let ahead_s = SubSteps::of(step_s, lags_s[vessel.body]).ahead_s;
            state.position_m += state.velocity_mps * ahead_s;
            state.heading_rad += state.yaw_rate_radps * ahead_s;
        }
    }

    /// Replaces the load of vessels with hydrodynamic data by the load that gives the motion of the vessel in six
    /// degrees of freedom.
    fn load_seaways(
        &mut self,
        setup: &WorldSetup,
        MovingBodies { states, lags_s }: MovingBodies<'_>,
        StepTimes { t_s, step_s, acts_s, .. }: StepTimes,
        loads: &mut [Wrench],
    ) {
        for index in 0..setup.vessels.len() {
            let Some(seaway) = &self.seaways[index] else { continue };
            let (vessel, own) = (&setup.vessels[index], &mut self.vessels[index]);
            let Some(float) = &vessel.float else { continue };
            let (body, forces) = (&states[vessel.body], &mut self.forces[index]);
            let Some(afloat) = &self.afloat[vessel.body] else { continue };
            let upright = AttitudeLoad::default();
            let mut given = Given { load: &loads[vessel.body], upright, moved_nm: 0.0 };
            given.add_own(afloat, vessel.forces_by_height(forces, float));
            for &line in &self.order.lines {
                let (of, mooring) = (&setup.lines[line], &self.lines[line]);
                for (body_of, lever, force_n) in of.pulls(mooring, &setup.bollards) {
                    if body_of == vessel.body {
                        given.add_force(body.heading_rad, lever, force_n);
                    }
                }
            }
            for &anchor in &self.order.anchors {
                if setup.anchors[anchor].vessel == index {
                    let AnchorAtWork { load, lever, .. } = &self.anchors[anchor];
                    given.add_force(body.heading_rad, *lever, load.on_ship_n);
                }
            }
            let ahead_m = vessel.ship.particulars.centre_of_gravity_m;
            for &tug in &self.order.tugs {
                let (of, at_work) = (&setup.tugs[tug], &self.tugs[tug]);
                if of.vessel == index {
                    let at_m = at_work.at_m - vec2(ahead_m, 0.0);
                    let lever = afloat.lever(at_m, of.above_water_m);
                    let Force { surge_n, sway_n, .. } = at_work.force;
                    given.add_at(at_m, lever, vec2(surge_n, sway_n));
                }
            }
            let stream_mps = self.water_inertia[index].current_mps;
            let sub_steps = SubSteps::of(step_s, lags_s[vessel.body]);
            let times = SeawayTimes { t_s, acts_s, sub_steps };
            loads[vessel.body] =
                seaway.load((vessel, own, forces), body, &given, stream_mps, times);
        }
    }

    /// The lines as they will be after the orders that wait for the step at this time. If two orders are for the same
    /// step, the check of the second order must take the first order into account.
    pub fn lines_after_orders(&self, setup: &WorldSetup, step: StepTime) -> Cow<'_, [Mooring]> {
        line_work::after_orders(&self.lines, setup, self.waiting(step), step.t_s)
    }

    /// Checks that an order can send a line to a bollard at a time. `lines` are the lines at this time.
    pub fn may_send(
        &self,
        lines: &[Mooring],
        setup: &WorldSetup,
        states: &[BodyState],
        t_s: f64,
        sending: Sending,
    ) -> Result<(), OrderError> {
        let level_m = setup.environment.level_m(t_s);
        let shore = Shore { fixed: &self.fixed, level_m, afloat: &self.afloat };
        line_work::may_send(lines, setup, states, shore, sending)
    }

    /// An anchor as it will be after the orders that wait for the step at this time. See [`World::lines_after_orders`].
    pub fn anchor_after_orders(
        &self,
        setup: &WorldSetup,
        anchor: usize,
        step: StepTime,
    ) -> AnchorAtWork {
        let mut after = self.anchors[anchor];
        for order in self.waiting(step) {
            if let Action::Anchor(index, action) = order.action
                && index == anchor
                && after.may(&setup.anchors[anchor], action).is_ok()
            {
                after.take(action);
            }
        }
        after
    }

    /// The orders that wait for a step.
    fn waiting(&self, step: StepTime) -> impl Iterator<Item = &Order> {
        self.orders[self.taken..].iter().take_while(move |order| order.at_s < step.end_s())
    }

    /// Adds an order. The world then forgets the orders that it has carried out, so that memory does not grow in a run
    /// of hours.
    pub fn order(&mut self, order: Order) {
        self.orders.drain(..self.taken);
        self.taken = 0;
        let place = self.orders.partition_point(|other| other.at_s <= order.at_s);
        self.orders.insert(place, order);
    }

    /// Removes the pending orders for which `keep` returns false.
    pub fn retain_orders(&mut self, keep: impl FnMut(&Order) -> bool) {
        self.orders.drain(..self.taken);
        self.taken = 0;
        self.orders.retain(keep);
    }

    /// The pending orders, sorted by time.
    pub fn pending_orders(&self) -> &[Order] {
        &self.orders[self.taken..]
    }

    /// Replaces the orders by the pending orders of another world.
    pub fn take_orders_of(&mut self, other: &World) {
        self.orders = other.pending_orders().to_vec();
        self.taken = 0;
    }

    fn take_orders(&mut self, setup: &WorldSetup, states: &[BodyState], step: StepTime) {
        let t_s = step.t_s;
        // An order takes effect in the step that contains its time.
        while let Some(order) = self.orders.get(self.taken).filter(|o| o.at_s < step.end_s()) {
            self.taken += 1;
            match &order.action {
                Action::Vessel(index, action) => {
                    let vessel = &setup.vessels[*index];
                    pilot::take(
                        action,
                        &mut self.vessels[*index],
                        vessel,
                        &self.abilities[*index],
                        &states[vessel.body],
                    );
                }
                Action::Tug(tug, what) => {
                    let of = &setup.tugs[*tug].tug;
                    if of.order(&mut self.tugs[*tug].state, order.at_s, *what).is_err() {
                        let kind = WorldEventKind::TugOrderRefused;
                        self.events.push(WorldEvent { who: *tug, kind });
                    }
                }
                Action::Anchor(anchor, action) => {
                    let own = &mut self.anchors[*anchor];
                    if own.may(&setup.anchors[*anchor], *action).is_ok() {
                        own.take(*action);
                    } else {
                        let kind = WorldEventKind::Anchor(AnchorEvent::OrderRefused);
                        self.events.push(WorldEvent { who: *anchor, kind });
                    }
                }
                Action::Line(line, LineAction::Winch(winch)) => self.lines[*line].order = *winch,
                Action::Line(line, LineAction::LetGo) => {
                    self.lines[*line].let_go(&setup.lines[*line], t_s);
                }
                Action::Line(line, LineAction::Send { bollard }) => {
                    let (line, bollard) = (*line, *bollard);
                    let sending = Sending { line, bollard };
                    if self.may_send(&self.lines, setup, states, t_s, sending).is_ok() {
                        self.lines[line].send(bollard, t_s);
                    } else {
                        let kind = WorldEventKind::LineNotMadeFast;
                        self.events.push(WorldEvent { who: line, kind });
                    }
                }
            }
        }
    }

    /// Water level, heave, roll and pitch in a step. These values give the heights of fenders above the keels.
    pub fn heights<'a>(&'a self, setup: &WorldSetup, step: StepTime) -> Heights<'a> {
        let StepTime { t_s, step_s } = step;
        let level_m = setup.environment.level_m(t_s + 0.5 * step_s);
        let shore = Shore { fixed: &self.fixed, level_m, afloat: &self.afloat };
        Heights { shore, vessels: &self.vessels, t_s, step_s }
    }

    /// Moves the vessels in heave, roll and pitch after a step, under the vessels' own forces and under contact at the
    /// height of the fenders.
    pub fn settle(
        &mut self,
        setup: &WorldSetup,
        fenders: &[FenderSetup],
        contacts: &[Contact],
        touches: &[Option<HullTouch>],
        states: &[BodyState],
        StepTime { t_s, step_s }: StepTime,
    ) {
        if setup.vessels.is_empty() {
            return;
        }
        let level_m = setup.environment.level_m(t_s);
        let shore = Shore { fixed: &self.fixed, level_m, afloat: &self.afloat };
        for (index, vessel) in setup.vessels.iter().enumerate() {
            let state = &states[vessel.body];
            self.vessels[index].wave_motion =
                vessel.wave_motion(state, &setup.environment, t_s + step_s);
            if let Some(pilot) = &mut self.vessels[index].pilots.assist {
                pilot.store_contact(vessel.body, contacts);
            }
            let Some(float) = &vessel.float else { continue };
            let mut load = match &self.seaways[index] {
                // The vessel's own forces and lines were already in the step.
                Some(_) => AttitudeLoad::default(),
                None => vessel.attitude_load(&self.forces[index], float),
            };
            let attitude = Rotation::from_angle(states[vessel.body].heading_rad);
            for (index_of_contact, contact) in contacts.iter().enumerate() {
                let [one, two] = [contact.body_1.0 as usize, contact.body_2.0 as usize];
                let sign = match vessel.body {
                    body if body == one => 1.0,
                    body if body == two => -1.0,
                    _ => continue,
                };
                // Fenders act at their height, outlines at the waterline.
                let fender = contact.fender.map(|id| &fenders[id.0 as usize]);
                let height_m = fender.map_or(0.0, |fender| {
                    let at_m = place_m(contact, fender.body, &states[fender.body]);
                    shore.fender_at_work_m(fender, at_m)
                });
                let own = attitude.apply_inverse(contact.force_on_body_1_n() * sign);
                // Squat and heave lower the vessel's centre of gravity, but not the fender of another body.
                let afloat = self.afloat.get(vessel.body).copied().flatten();
                let sunk_m =
                    self.vessels[index].squat_m + afloat.map_or(0.0, |afloat| afloat.heave_m());
                let gravity_m = float.gravity_above_water_m - sunk_m;
                let Some(touch) = touches.get(index_of_contact).copied().flatten() else {
                    load.add(own.x, own.y, height_m - gravity_m);
                    continue;
                };
                // A side that leans out over the fender is pushed up, and the body that carries the fender is pushed
                // down.
                let up_n = contact.normal_force_n * touch.slope;
                if fender.is_some_and(|fender| fender.body == vessel.body) {
                    load.add(own.x, own.y, height_m - gravity_m);
                    load.add_upward(-up_n, place_m(contact, vessel.body, state));
                } else {
                    let above_water_m = touch.height_m - float.draught_m;
                    let lever = match afloat {
                        Some(afloat) => afloat.lever(touch.place_m, above_water_m),
                        None => Lever {
                            at_m: touch.place_m,
                            above_gravity_m: above_water_m - float.gravity_above_water_m,
                        },
                    };
                    load.add(own.x, own.y, lever.above_gravity_m);
                    load.add_upward(up_n, lever.at_m);
                }
            }
            let state = &mut self.vessels[index];
            if let Some(seaway) = &self.seaways[index] {
                seaway.settle(state, &states[vessel.body], &load, step_s);
                continue;
            }
            state.attitude = state.attitude.after(&float.hydrostatics, &load, step_s);
        }
    }
}

/// For each vessel, the motion by hydrodynamic data in steps of this length (s); `None` for a vessel without
/// hydrodynamic data.
pub fn motions(setup: &WorldSetup, step_s: f64) -> Vec<Option<Arc<Motion>>> {
    let of = |vessel: &VesselSetup| {
        vessel.seakeeping.as_ref().map(|ship| Arc::new(Motion::new(ship, step_s)))
    };
    setup.vessels.iter().map(of).collect()
}

/// The states of the vessels at the start of a run.
fn start_vessels<'a>(
    setup: &'a WorldSetup,
    seaways: &'a [Option<Seaway>],
    states: &'a [BodyState],
) -> impl Iterator<Item = VesselState> + 'a {
    setup.vessels.iter().zip(seaways).map(|(vessel, seaway)| {
        let start = seaway.as_ref().map(|seaway| seaway.start(&states[vessel.body]));
        VesselState { seaway: start, ..VesselState::new(vessel) }
    })
}
