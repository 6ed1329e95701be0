//! Changes of a running simulation that nobody orders: weather, faults, lines that part, tugs that drop out. They are planned for
//! times of the set-up ([`crate::world::WorldSetup::planned`]), or come from outside (`Simulation::change` of the crate `fenderline-sim`).

mod error;
mod ramp;

pub use self::error::ChangeError;
pub use self::ramp::{Flow, Ramp, Ramps, fog_m};

use crate::setup::Setup;
use crate::world::{Fault, Tripped};
use fenderline_ship::environment::current::Current;
use fenderline_ship::environment::wind::{MeanWind, WindProfile};
use fenderline_ship::range::within;

/// A change of a simulation. Indices are those of [`crate::world::WorldSetup`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// The mean wind 10 m above the water: speed (m/s) and direction from which it comes (rad), at once or over a time (s). Gusts go
    /// on in proportion to it; a time series becomes steady.
    Wind {
        /// Speed (m/s).
        speed_mps: f64,
        /// Direction from which it comes (rad).
        from_rad: f64,
        /// Time of the change (s).
        over_s: f64,
    },
    /// A uniform current in place of the present one: speed (m/s) and direction to which it sets (rad), at once or over a time (s).
    Current {
        /// Speed (m/s).
        speed_mps: f64,
        /// Direction to which it sets (rad).
        to_rad: f64,
        /// Time of the change (s).
        over_s: f64,
        /// The vessel at which a change over a time begins with the present current; `None`: at the origin.
        at: Option<usize>,
    },
    /// How far people see (m), at once or over a time (s); `None`: clear. It exerts no force.
    Visibility {
        /// The distance (m).
        distance_m: Option<f64>,
        /// Time of the change (s).
        over_s: f64,
    },
    /// A fault of a vessel begins or ends.
    Fault {
        /// The vessel.
        vessel: usize,
        /// The fault.
        fault: Fault,
        /// It begins.
        on: bool,
    },
    /// One thruster or azimuth unit of a vessel trips, or comes back.
    Thruster {
        /// The vessel.
        vessel: usize,
        /// Its number: thrusters first, then azimuth units.
        unit: usize,
        /// It trips.
        on: bool,
    },
    /// A line parts.
    PartLine(usize),
    /// A vector tug drops out, or comes back.
    TugOut {
        /// The tug.
        tug: usize,
        /// She drops out.
        on: bool,
    },
}

/// A change at a time of the run. It takes effect in the step that contains its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannedChange {
    /// The time (s).
    pub at_s: f64,
    /// The change.
    pub change: Change,
}

impl Change {
    /// Longest time of a change (s).
    pub const LONGEST_S: f64 = 7200.0;
    /// Least and greatest visibility (m).
    pub const VISIBILITY_M: [f64; 2] = [50.0, 50e3];
    /// Greatest size of an angle that is accepted as a direction (rad).
    const LARGEST_ANGLE_RAD: f64 = 100.0;

    /// Checks numbers and indices.
    ///
    /// # Errors
    /// A number out of its limits; a vessel, thruster, line or tug that does not exist.
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
                let most_rad = Change::LARGEST_ANGLE_RAD;
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

/// What is under way of the changes of a simulation: plain data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changes {
    /// Changes of wind, current and visibility that take time.
    pub ramps: Ramps,
    /// For each planned change of the set-up, whether its time has come.
    pub taken: Vec<bool>,
    /// Lines that parted since the last step by a change.
    pub parted: Vec<usize>,
    /// Lines that should have parted, but were not fast.
    pub not_parted: Vec<usize>,
}
