//! Simple pilots: from where a ship is to what her rudder, engine, thrusters and tugs should do. They read
//! states and write demands; what comes of a demand is the actuators' and the water's business.

mod allocation;
mod course;
mod station;

pub use allocation::{LateralDevice, allocate};
pub use course::{CoursePilot, SpeedPilot};
pub use station::{Demand, Gains, StationPilot};

/// The smallest turn from one heading to another, −π to π [rad].
#[must_use]
pub fn turn_to(from_rad: f64, to_rad: f64) -> f64 {
    libm::remainder(to_rad - from_rad, 2.0 * core::f64::consts::PI)
}
