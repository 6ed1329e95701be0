//! Records the time series of vessels, tugs and mooring lines for the report.

use fenderline_contact::{BodyState, Pose, Rotation, Vec2};
use fenderline_sim::tug::TugOrder;
use fenderline_sim::{Setup, StepRecord, VesselState};

use super::docking::{Berth, DockingTrace};
use super::plan::PlanTrace;
use crate::plot::Decimator;

/// Largest number of vessels, of tugs and of mooring lines whose time series are recorded; the tables of the report
/// contain all of them.
const FOLLOWED: usize = 16;

/// Time series of the world's parts (vessels, tugs, mooring lines, anchors), in the order of the set-up.
pub(in crate::run_page) struct WorldTrace {
    pub(in crate::run_page) vessels: Vec<VesselTrace>,
    pub(in crate::run_page) tugs: Vec<TugTrace>,
    /// Tension of each mooring line (N); 0 while the line is not made fast.
    pub(in crate::run_page) lines: Vec<Decimator>,
    pub(in crate::run_page) anchors: Vec<AnchorTrace>,
    step_s: f64,
}

/// Time series of one vessel, in SI units.
pub(in crate::run_page) struct VesselTrace {
    body: usize,
    /// Speed of the vessel over ground, ahead and to starboard (m/s).
    pub(in crate::run_page) along_mps: Decimator,
    pub(in crate::run_page) across_mps: Decimator,
    pub(in crate::run_page) heading_rad: Decimator,
    /// Position of the centre of gravity relative to the start: ahead and to starboard, by the heading at the start
    /// (m).
    pub(in crate::run_page) place_m: [Decimator; 2],
    first: Option<Pose>,
    pub(in crate::run_page) turn_radps: Decimator,
    /// Ordered and actual value of rudder angle and propeller revolutions.
    pub(in crate::run_page) rudder_rad: [Decimator; 2],
    pub(in crate::run_page) shaft_rps: [Decimator; 2],
    /// Ordered and actual power of each thruster, from −1 to 1.
    pub(in crate::run_page) thrusters: Vec<[Decimator; 2]>,
    pub(in crate::run_page) azimuths: Vec<AzimuthTrace>,
    /// Roll and pitch of the vessel with waves (rad), and heave (m).
    pub(in crate::run_page) roll_rad: Decimator,
    pub(in crate::run_page) pitch_rad: Decimator,
    pub(in crate::run_page) heave_m: Decimator,
    /// Squat (m).
    pub(in crate::run_page) squat_m: Decimator,
    /// Under-keel clearance (m); empty in deep water.
    pub(in crate::run_page) under_keel_m: Decimator,
    /// Surge force, sway force and yaw moment by passing ships (N, N, N·m); empty if no ships pass.
    pub(in crate::run_page) passing: [Decimator; 3],
    /// Distances of the vessel's ends from a row of fenders, if there is such a row.
    pub(in crate::run_page) docking: Option<DockingTrace>,
    /// Her way along her passage plan, if she has one.
    pub(in crate::run_page) plan: Option<PlanTrace>,
}

/// Ordered and actual values of one azimuth unit.
#[derive(Default)]
pub(in crate::run_page) struct AzimuthTrace {
    /// Thrust of the unit divided by its thrust at rest and full power.
    pub(in crate::run_page) power: [Decimator; 2],
    /// Direction of the unit's thrust from the bow (rad), positive to starboard, from −π to π.
    pub(in crate::run_page) direction_rad: [Decimator; 2],
}

/// Ordered and actual force of one tug (N).
#[derive(Default)]
pub(in crate::run_page) struct TugTrace {
    pub(in crate::run_page) ordered_n: Decimator,
    pub(in crate::run_page) force_n: Decimator,
}

/// Tension of an anchor chain, and holding force of anchor and chain (N).
#[derive(Default)]
pub(in crate::run_page) struct AnchorTrace {
    pub(in crate::run_page) tension_n: Decimator,
    pub(in crate::run_page) holding_n: Decimator,
}

/// A tug at one time, for a plan view.
#[derive(Clone, Copy, Debug)]
pub(in crate::run_page) struct TugMark {
    /// Index of the tug among the set-up's tugs.
    pub(in crate::run_page) tug: usize,
    /// Point where the tug's force acts (m).
    pub(in crate::run_page) at_m: Vec2,
    /// Force of the tug on the ship, earth-fixed (N).
    pub(in crate::run_page) force_n: Vec2,
    pub(in crate::run_page) on_line: bool,
}

/// The positions and forces of the tugs in a time step, with the ships in the given states.
pub(in crate::run_page) fn tug_marks(
    setup: &Setup,
    step: &StepRecord<'_>,
    states: &[BodyState],
) -> Vec<TugMark> {
    let tugs = step.tugs.iter().zip(&setup.world.tugs).enumerate();
    let marks = tugs.map(|(tug, (now, of))| {
        let vessel = &setup.world.vessels[of.vessel];
        let ahead_m = vessel.ship.particulars.centre_of_gravity_m;
        let pose = states[vessel.body].pose();
        let own = fenderline_contact::vec2(now.force.surge_n, now.force.sway_n);
        TugMark {
            tug,
            at_m: pose.apply(now.at_m - fenderline_contact::vec2(ahead_m, 0.0)),
            force_n: pose.rotation.apply(own),
            on_line: now.state.on_line,
        }
    });
    marks.collect()
}

impl WorldTrace {
    pub(super) fn new(setup: &Setup) -> WorldTrace {
        let berth = Berth::of(setup);
        let world = &setup.world;
        let vessels = world.vessels.iter().take(FOLLOWED).map(|vessel| {
            let docking = berth.filter(|berth| berth.body != vessel.body);
            let hull = &setup.bodies[vessel.body].outline;
            VesselTrace {
                body: vessel.body,
                along_mps: Decimator::new(),
                across_mps: Decimator::new(),
                heading_rad: Decimator::new(),
                place_m: Default::default(),
                first: None,
                turn_radps: Decimator::new(),
                rudder_rad: Default::default(),
                shaft_rps: Default::default(),
                thrusters: vessel.thrusters.iter().map(|_| Default::default()).collect(),
                azimuths: vessel.azimuths.iter().map(|_| Default::default()).collect(),
                roll_rad: Decimator::new(),
                pitch_rad: Decimator::new(),
                heave_m: Decimator::new(),
                squat_m: Decimator::new(),
                under_keel_m: Decimator::new(),
                passing: Default::default(),
                docking: docking.map(|berth| DockingTrace::new(berth, hull)),
                plan: vessel.plan.as_ref().map(|plan| PlanTrace::new(plan, vessel)),
            }
        });
        WorldTrace {
            vessels: vessels.collect(),
            tugs: world.tugs.iter().take(FOLLOWED).map(|_| TugTrace::default()).collect(),
            lines: world.lines.iter().take(FOLLOWED).map(|_| Decimator::new()).collect(),
            anchors: world.anchors.iter().take(FOLLOWED).map(|_| AnchorTrace::default()).collect(),
            step_s: setup.step_s,
        }
    }

    pub(super) fn push(&mut self, step: &StepRecord<'_>) {
        for (index, trace) in self.vessels.iter_mut().enumerate() {
            trace.push(step.t_s, self.step_s, step.states, &step.vessels[index]);
            if let Some(plan) = &mut trace.plan {
                let (squat_m, soundings) = (step.vessels[index].squat_m, &step.soundings[index]);
                plan.push(step.t_s, &step.states[trace.body], squat_m, soundings);
            }
            let force = &step.vessel_forces[index].passing;
            let parts = [force.surge_n, force.sway_n, force.yaw_nm];
            for (trace, part) in trace.passing.iter_mut().zip(parts) {
                trace.push(step.t_s, part);
            }
        }
        for (trace, now) in self.tugs.iter_mut().zip(step.tugs) {
            let ordered_n = match now.state.order {
                TugOrder::StandBy => 0.0,
                TugOrder::Push { force_n, .. } | TugOrder::Pull { force_n, .. } => force_n,
            };
            trace.ordered_n.push(step.t_s, ordered_n);
            trace.force_n.push(step.t_s, libm::hypot(now.force.surge_n, now.force.sway_n));
        }
        for (trace, now) in self.lines.iter_mut().zip(step.lines) {
            trace.push(step.t_s, now.load.tension_n);
        }
        for (trace, now) in self.anchors.iter_mut().zip(step.anchors) {
            trace.tension_n.push(step.t_s, now.load.tension_n);
            trace.holding_n.push(step.t_s, now.load.holding_n);
        }
    }
}

impl VesselTrace {
    fn push(&mut self, t_s: f64, step_s: f64, states: &[BodyState], now: &VesselState) {
        let state = &states[self.body];
        let own = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
        self.along_mps.push(t_s, own.x);
        self.across_mps.push(t_s, own.y);
        self.heading_rad.push(t_s, state.heading_rad);
        let first = *self.first.get_or_insert(state.pose());
        let place = first.apply_inverse(state.position_m);
        self.place_m[0].push(t_s, place.x);
        self.place_m[1].push(t_s, place.y);
        self.turn_radps.push(t_s, state.yaw_rate_radps);
        let push = |two: &mut [Decimator; 2], order: f64, actual: f64| {
            two[0].push(t_s, order);
            two[1].push(t_s, actual);
        };
        push(&mut self.rudder_rad, now.orders.rudder_rad, now.rudder.value);
        push(&mut self.shaft_rps, now.orders.shaft * now.shaft.stop, now.shaft.value);
        let thrusters = now.orders.thrusters.iter().zip(&now.thrusters);
        for (trace, (order, lag)) in self.thrusters.iter_mut().zip(thrusters) {
            push(trace, *order, lag.value);
        }
        let azimuths = now.orders.azimuths.iter().zip(&now.azimuths);
        for (trace, (order, unit)) in self.azimuths.iter_mut().zip(azimuths) {
            push(&mut trace.power, order.power, unit.power.value);
            let ordered_rad = libm::remainder(order.direction_rad, core::f64::consts::TAU);
            push(&mut trace.direction_rad, ordered_rad, unit.direction.angle_rad);
        }
        // Attitude belongs to the end of the step.
        let end_s = t_s + step_s;
        let [_, _, heave_m, roll_rad, pitch_rad, _] = now.wave_motion.motion;
        self.squat_m.push(t_s, now.squat_m);
        if let Some(clearance_m) = now.under_keel_m {
            self.under_keel_m.push(t_s, clearance_m);
        }
        self.heave_m.push(end_s, now.attitude.heave.value + heave_m);
        self.roll_rad.push(end_s, now.attitude.roll.value + roll_rad);
        self.pitch_rad.push(end_s, now.attitude.pitch.value + pitch_rad);
        if let Some(docking) = &mut self.docking {
            docking.push(t_s, states, state);
        }
    }
}
