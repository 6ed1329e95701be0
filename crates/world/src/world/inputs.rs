//! What a step of the world reads, by name.

use fenderline_contact::BodyState;
use fenderline_ship::environment::wind::ShipGusts;
use fenderline_ship::hydro::Velocity;
use fenderline_ship::step_time::StepTime;

use super::environment::Environment;
use super::soundings::Soundings;

/// The times of a step of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepTimes {
    /// Start of the step, to which positions belong (s).
    pub t_s: f64,
    /// The time to which velocities belong (s).
    pub velocity_t_s: f64,
    /// Length of the step (s).
    pub step_s: f64,
    /// The time for which the loads of this step act (s).
    pub acts_s: f64,
}

impl StepTimes {
    /// Start and length of the step.
    #[must_use]
    pub fn step(self) -> StepTime {
        StepTime { t_s: self.t_s, step_s: self.step_s }
    }
}

/// The bodies of a set-up at the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct MovingBodies<'a> {
    /// The states of the bodies.
    pub states: &'a [BodyState],
    /// For each body, the time from the time of its velocity to the start of the step (s).
    pub lags_s: &'a [f64],
}

/// A vessel's body, and the motion of the vessel through the water.
#[derive(Clone, Copy, Debug)]
pub struct Moving<'a> {
    /// State of the vessel's body.
    pub state: &'a BodyState,
    /// Velocity of the vessel through the water.
    pub velocity: &'a Velocity,
}

/// Water and air around one vessel.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings<'a> {
    /// Water, wind, waves and banks.
    pub environment: &'a Environment,
    /// The gusts of the wind over the vessel.
    pub gusts: Option<&'a ShipGusts>,
    /// The depths under the vessel.
    pub soundings: &'a Soundings,
}
