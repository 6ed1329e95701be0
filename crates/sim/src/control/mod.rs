//! Simple pilots: from where a ship is to what her rudder, engine, thrusters and tugs should do. They read
//! states and write demands; what comes of a demand is the actuators' and the water's business.

mod allocation;
mod assist;
mod course;
mod station;
mod thrust;

pub use allocation::{LateralDevice, allocate};
pub use assist::{Asked, Handling, TOUCH_MPS, Task, assist};
pub use course::{CoursePilot, SpeedPilot};
pub use station::{Demand, Gains, StationPilot};
pub use thrust::{Reach, Sway, ThrustDevice, allocate_thrust, bias_pairs};

/// The smallest turn from one heading to another, −π to π (rad).
#[must_use]
pub fn turn_to(from_rad: f64, to_rad: f64) -> f64 {
    libm::remainder(to_rad - from_rad, 2.0 * core::f64::consts::PI)
}
