//! Steady states of a ship: self-propulsion, bollard pull, crabbing.

use super::ManoeuvreError;
use crate::hydro::model3::{Model3, Motion};
use crate::hydro::quantities::{Controls, Force, Velocity};

/// Number of bisections for the revolutions: enough for all bits of a double.
const HALVINGS: usize = 60;

/// Revolutions (1/s) at which thrust and resistance balance on a straight course at a speed.
///
/// # Errors
/// Fails with [`ManoeuvreError::NoPropeller`], or with [`ManoeuvreError::NoBalance`] if thrust and resistance balance
/// at no revolutions between 0 and 20 V/D.
pub fn self_propulsion_rps(model: &Model3, speed_mps: f64) -> Result<f64, ManoeuvreError> {
    let propulsion = model.ship().propulsion.as_ref().ok_or(ManoeuvreError::NoPropeller)?;
    let velocity = Velocity { surge_mps: speed_mps, ..Velocity::default() };
    let surplus_n = |shaft_rps: f64| {
        let controls = Controls { shaft_rps, rudder_rad: 0.0 };
        model.ship().forces(&velocity, &controls, model.water()).surge_n
    };
    let (mut low, mut high) = (0.0, 20.0 * speed_mps / propulsion.propeller.diameter_m);
    let balanced = surplus_n(low) <= 0.0 && surplus_n(high) >= 0.0;
    if !balanced {
        return Err(ManoeuvreError::NoBalance { speed_mps });
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if surplus_n(middle) < 0.0 { low = middle } else { high = middle }
    }
    Ok(0.5 * (low + high))
}

/// Pull (N) on a line to a bollard at the given revolutions (1/s): the propeller's force ahead at rest, less thrust
/// deduction.
///
/// # Errors
/// [`ManoeuvreError::NoPropeller`].
pub fn bollard_pull_n(model: &Model3, shaft_rps: f64) -> Result<f64, ManoeuvreError> {
    if model.ship().propulsion.is_none() {
        return Err(ManoeuvreError::NoPropeller);
    }
    let controls = Controls { shaft_rps, rudder_rad: 0.0 };
    Ok(model.ship().forces(&Velocity::default(), &controls, model.water()).surge_n)
}

/// The motion of a ship under a steady side force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crabbing {
    /// Speed of the ship across, to starboard (m/s).
    pub sway_mps: f64,
    /// Resulting speed ahead (m/s).
    pub surge_mps: f64,
    /// Rate of turn that results from the side force (rad/s).
    pub yaw_radps: f64,
    /// Time until the ship has 90 % of the final speed across (s).
    pub rise_s: f64,
}

/// Pushes a ship at rest with a force at midship for `duration_s`, with the engine stopped. The side force stands for
/// thrusters or tugs that crab the ship.
///
/// # Errors
/// Fails with [`ManoeuvreError::NotReached`] if the ship's lateral speed still changes by more than 1 % in the last
/// tenth of the time.
pub fn crabbing(
    model: &Model3,
    push: Force,
    duration_s: f64,
    step_s: f64,
) -> Result<Crabbing, ManoeuvreError> {
    let steps = (duration_s / step_s).ceil() as usize;
    let mut motion = Motion::default();
    let mut sways_mps = Vec::new();
    for _ in 0..steps {
        motion = model.runge_kutta(&motion, &Controls::default(), push, step_s);
        sways_mps.push(motion.velocity.sway_mps);
    }
    let sway_mps = motion.velocity.sway_mps;
    let before_mps = sways_mps.iter().rev().nth(steps / 10).copied().unwrap_or(0.0);
    let settled = (sway_mps - before_mps).abs() <= 0.01 * sway_mps.abs();
    if !settled {
        let what = "a steady speed across";
        return Err(ManoeuvreError::NotReached { what, after_s: duration_s });
    }
    let risen = sways_mps.iter().position(|v| v.abs() >= 0.9 * sway_mps.abs()).unwrap_or(0);
    Ok(Crabbing {
        sway_mps,
        surge_mps: motion.velocity.surge_mps,
        yaw_radps: motion.velocity.yaw_radps,
        rise_s: (risen + 1) as f64 * step_s,
    })
}
