//! Simple pilots: they turn a ship's state into orders for rudder, engine, thrusters and tugs. The pilots only give
//! orders and demand forces; actuators and water decide what the ship then does.

mod allocation;
mod assist;
mod course;
mod station;
mod thrust;

pub use allocation::{LateralDevice, allocate};
pub use assist::{AssistDemand, Handling, TOUCH_MPS, Task, UnitUse, assist};
pub use course::{CoursePilot, SpeedPilot};
pub use station::{Demand, Gains, StationPilot};
pub use thrust::{Reach, Sway, ThrustDevice, ThrustShares};

/// The smallest turn from one heading to another, −π to π (rad).
#[must_use]
pub fn turn_to(from_rad: f64, to_rad: f64) -> f64 {
    libm::remainder(to_rad - from_rad, 2.0 * core::f64::consts::PI)
}
