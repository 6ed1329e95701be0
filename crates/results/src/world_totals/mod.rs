//! Totals of vessels, tugs, mooring lines and anchors over a run. The size of these totals does not grow with the
//! length of the run.

mod anchor;
mod events;
mod line;
mod passing;
mod tug;
mod vessel;

use fenderline_contact::{Pose, Vec2};
use fenderline_sim::{Setup, StepRecord, WorldSetup};

pub use anchor::{AnchorTotals, AnchorVerdict};
pub use events::{Who, WorldEvents};
pub use line::{LineTotals, LineVerdict};
pub use passing::PassingTotals;
pub use tug::TugTotals;
pub use vessel::VesselTotals;

/// The totals of vessels, tugs, mooring lines, anchors and passing ships over a run.
#[derive(Clone, Debug)]
pub struct WorldTotals {
    setup: WorldSetup,
    step_s: f64,
    /// Totals of the vessels, in the order of the set-up.
    pub vessels: Vec<VesselTotals>,
    /// Totals of the tugs, in the order of the set-up.
    pub tugs: Vec<TugTotals>,
    /// Totals of the mooring lines, in the order of the set-up.
    pub lines: Vec<LineTotals>,
    /// Totals of the anchors, in the order of the set-up.
    pub anchors: Vec<AnchorTotals>,
    /// Totals of the passing ships, in the order of the set-up.
    pub passing: Vec<PassingTotals>,
    /// Events of vessels, tugs, mooring lines and anchors.
    pub events: WorldEvents,
    /// Outlines and poses of the vessels, if ships pass.
    hulls: Vec<(Vec<Vec2>, Pose)>,
}

impl WorldTotals {
    /// Makes the totals before the first time step.
    pub fn new(setup: &Setup) -> WorldTotals {
        let world = setup.world.clone();
        WorldTotals {
            vessels: vec![VesselTotals::default(); world.vessels.len()],
            tugs: vec![TugTotals::default(); world.tugs.len()],
            lines: vec![LineTotals::default(); world.lines.len()],
            anchors: world.anchors.iter().map(AnchorTotals::new).collect(),
            passing: vec![PassingTotals::default(); world.flow.passing.len()],
            events: WorldEvents::default(),
            hulls: passing::outlines(setup)
                .into_iter()
                .map(|outline_m| (outline_m, Pose::new(Vec2::ZERO, 0.0)))
                .collect(),
            step_s: setup.step_s,
            setup: world,
        }
    }

    /// Adds one step.
    pub fn add(&mut self, step: &StepRecord<'_>) {
        let WorldTotals { setup, step_s, vessels, tugs, lines, anchors, passing, events, hulls } =
            self;
        let forces = step.vessel_forces;
        for (((totals, vessel), now), forces) in
            vessels.iter_mut().zip(&setup.vessels).zip(step.vessels).zip(forces)
        {
            totals.add_passing(step.t_s, &forces.passing);
            let state = &step.states[vessel.body];
            totals.add_place(step.t_s, vessel.on_plan(state));
            let water = vessel.velocity(state, &setup.environment, step.t_s);
            totals.add(step.t_s, *step_s, state, &water, now);
        }
        if !setup.overhead.structures.is_empty() {
            let level_m = setup.environment.level_m(step.t_s);
            let totals_of = &mut *vessels;
            let vessels = setup.vessels.iter().zip(step.vessels).enumerate();
            for (totals, (index, (vessel, now))) in totals_of.iter_mut().zip(vessels) {
                let state = &step.states[vessel.body];
                if let Some(now) = setup.overhead.over(index, state, level_m, now.squat_m) {
                    totals.add_overhead(step.t_s, &now);
                }
            }
        }
        for (totals, now) in tugs.iter_mut().zip(step.tugs) {
            totals.add(step.t_s, *step_s, now);
        }
        for ((totals, line), now) in lines.iter_mut().zip(&setup.lines).zip(step.lines) {
            totals.add((step.t_s, *step_s), (line, setup.bollards.as_slice()), now);
        }
        for (totals, now) in anchors.iter_mut().zip(step.anchors) {
            totals.add((step.t_s, *step_s), now);
        }
        for ((_, pose), vessel) in hulls.iter_mut().zip(&setup.vessels) {
            *pose = step.states[vessel.body].pose();
        }
        for (totals, ship) in passing.iter_mut().zip(&setup.flow.passing) {
            totals.add(step.t_s, ship, hulls);
        }
        events.add(step);
    }
}

/// A peak: the value with the largest magnitude, and its time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// The peak value, with its sign.
    pub value: f64,
    /// Time of the peak (s).
    pub at_s: f64,
}

impl Peak {
    fn raise(&mut self, value: f64, t_s: f64) {
        if value.abs() > self.value.abs() {
            *self = Peak { value, at_s: t_s };
        }
    }
}

/// A duration: the number of steps times Δt, so that rounding does not accumulate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lasting {
    steps: u32,
    step_s: f64,
}

impl Lasting {
    /// Counts a time step if the condition holds in it.
    fn count(&mut self, is_so: bool, step_s: f64) {
        self.step_s = step_s;
        self.steps += u32::from(is_so);
    }

    /// The duration in seconds.
    pub fn s(self) -> f64 {
        f64::from(self.steps) * self.step_s
    }
}
