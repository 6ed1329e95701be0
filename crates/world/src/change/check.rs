//! Checks that a change is possible in a set-up.

use super::{Change, ChangeError};
use crate::setup::Setup;
use crate::world::Tripped;
use fenderline_ship::environment::current::Current;
use fenderline_ship::environment::wind::{MeanWind, WindProfile};
use fenderline_ship::range::within;

/// Greatest size of an angle that is accepted as a direction (rad).
const LARGEST_ANGLE_RAD: f64 = 100.0;

impl Change {
    /// Checks the numbers and indices of a change.
    ///
    /// # Errors
    /// Fails if a number is out of its limits, or if a vessel, thruster, line or tug does not exist.
    pub fn check(&self, setup: &Setup) -> Result<(), ChangeError> {
        let time = |over_s| within("time of the change [s]", over_s, 0.0, Change::LONGEST_S);
        let world = &setup.world;
        match *self {
            Change::Wind { speed_mps, from_rad, over_s } => {
                time(over_s)?;
                MeanWind { speed_mps, from_rad, profile: WindProfile::Uniform }.check()?;
            }
            Change::Current { speed_mps, to_rad, over_s, at } => {
                within("speed of the current [m/s]", speed_mps, 0.0, Current::FASTEST_MPS)?;
                let most_rad = LARGEST_ANGLE_RAD;
                within("direction of the current [rad]", to_rad, -most_rad, most_rad)?;
                time(over_s)?;
                if at.is_some_and(|vessel| vessel >= world.vessels.len()) {
                    return Err(ChangeError::NotThere("vessel"));
                }
            }
            Change::Visibility { distance_m, over_s } => {
                time(over_s)?;
                if let Some(distance_m) = distance_m {
                    let [least_m, most_m] = Change::VISIBILITY_M;
                    within("visibility [m]", distance_m, least_m, most_m)?;
                }
            }
            Change::Fault { vessel, .. } => {
                world.vessels.get(vessel).ok_or(ChangeError::NotThere("vessel"))?;
            }
            Change::Thruster { vessel, unit, .. } => {
                let vessel = world.vessels.get(vessel).ok_or(ChangeError::NotThere("vessel"))?;
                let units = vessel.thrusters.len() + vessel.azimuths.len();
                if unit >= units || unit >= Tripped::MOST {
                    return Err(ChangeError::NotThere("thruster"));
                }
            }
            Change::PartLine(line) => {
                world.lines.get(line).ok_or(ChangeError::NotThere("line"))?;
            }
            Change::TugOut { tug, .. } => {
                world.tugs.get(tug).ok_or(ChangeError::NotThere("tug"))?;
            }
        }
        Ok(())
    }
}
