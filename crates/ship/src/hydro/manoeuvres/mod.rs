//! Standard manoeuvres on [`Model3`], with the measures of ITTC and IMO resolution MSC.137(76).
//!
//! All standard manoeuvres start on a straight course north, at a speed, with the revolutions that maintain this speed.
//! Time and position of a manoeuvre are measured from the order. The propeller's revolutions are constant unless the
//! manoeuvre orders otherwise.

mod steady;
mod stop;
mod turning;
mod zig_zag;

pub use steady::{Crabbing, bollard_pull_n, crabbing, self_propulsion_rps};
pub use stop::{CrashStop, crash_stop, crash_stop_observed};
pub use turning::{SteadyTurn, TurningCircle, turning_circle, turning_circle_observed};
pub use zig_zag::{ZigZag, zig_zag, zig_zag_observed};

use std::fmt;

use super::actuator::RateLimited;
use super::model3::{Model3, Motion};
use super::quantities::{Controls, Force, Velocity};

/// Error of a manoeuvre that could not be completed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ManoeuvreError {
    /// The ship has no propeller.
    NoPropeller,
    /// No revolutions within the propeller's range maintain the ordered speed.
    NoBalance {
        /// The speed (m/s).
        speed_mps: f64,
    },
    /// The end of the manoeuvre was not reached within the time limit.
    NotReached {
        /// The state of the ship that the manoeuvre did not reach, in words, such as `a stop`.
        what: &'static str,
        /// Time limit (s).
        after_s: f64,
    },
}

impl fmt::Display for ManoeuvreError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ManoeuvreError::NoPropeller => write!(f, "the ship has no propeller"),
            ManoeuvreError::NoBalance { speed_mps } => {
                write!(f, "no revolutions of the propeller maintain a speed of {speed_mps} m/s")
            }
            ManoeuvreError::NotReached { what, after_s } => {
                write!(f, "the ship did not reach {what} within {after_s} s")
            }
        }
    }
}

impl std::error::Error for ManoeuvreError {}

/// Initial conditions and time step of a manoeuvre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// Speed (m/s).
    pub speed_mps: f64,
    /// Revolutions (1/s).
    pub shaft_rps: f64,
    /// The rudder, which is amidships at the start, with its rate and stop.
    pub steering: RateLimited,
    /// Time step (s).
    pub step_s: f64,
}

impl Approach {
    /// Makes an approach at a speed, with the revolutions that maintain this speed.
    ///
    /// # Errors
    /// See [`self_propulsion_rps`].
    pub fn at(
        model: &Model3,
        speed_mps: f64,
        steering: RateLimited,
        step_s: f64,
    ) -> Result<Approach, ManoeuvreError> {
        let shaft_rps = self_propulsion_rps(model, speed_mps)?;
        Ok(Approach { speed_mps, shaft_rps, steering, step_s })
    }
}

/// The state of a ship in a manoeuvre after a step. Tracks of a manoeuvre are drawn from its states.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Time since the order of the manoeuvre (s).
    pub time_s: f64,
    /// Position, heading and velocity of the ship; north is the approach course.
    pub motion: Motion,
    /// Rudder angle and shaft revolutions of the ship.
    pub controls: Controls,
}

/// State and controls of a ship during a manoeuvre.
struct Trial<'a> {
    model: &'a Model3,
    observe: &'a mut dyn FnMut(&Moment),
    motion: Motion,
    steering: RateLimited,
    shaft: RateLimited,
    step_s: f64,
    time_s: f64,
}

impl<'a> Trial<'a> {
    fn new(
        model: &'a Model3,
        approach: &Approach,
        observe: &'a mut dyn FnMut(&Moment),
    ) -> Trial<'a> {
        let mut trial = Trial {
            model,
            observe,
            motion: Motion {
                velocity: Velocity { surge_mps: approach.speed_mps, ..Velocity::default() },
                ..Motion::default()
            },
            steering: approach.steering,
            shaft: RateLimited { value: approach.shaft_rps, rate_per_s: 0.0, stop: f64::INFINITY },
            step_s: approach.step_s,
            time_s: 0.0,
        };
        trial.report();
        trial
    }

    /// Calls the observer.
    fn report(&mut self) {
        let controls = Controls { shaft_rps: self.shaft.value, rudder_rad: self.steering.value };
        (self.observe)(&Moment { time_s: self.time_s, motion: self.motion, controls });
    }

    /// Takes one step of the ship under an order of rudder (rad) and revolutions (1/s). For a step, rudder and
    /// revolutions are taken at the middle of the step.
    fn advance(&mut self, rudder_rad: f64, shaft_rps: f64) {
        let half_s = 0.5 * self.step_s;
        self.steering.step(rudder_rad, half_s);
        self.shaft.step(shaft_rps, half_s);
        let controls = Controls { shaft_rps: self.shaft.value, rudder_rad: self.steering.value };
        self.motion =
            self.model.runge_kutta(&self.motion, &controls, Force::default(), self.step_s);
        self.steering.step(rudder_rad, half_s);
        self.shaft.step(shaft_rps, half_s);
        self.time_s += self.step_s;
        self.report();
    }
}
