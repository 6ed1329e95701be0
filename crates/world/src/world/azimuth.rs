//! Thrusters of a vessel: tunnel thrusters, and azimuth units with order, lag and rate of turn.

use fenderline_contact::number::bounded;

use fenderline_ship::hydro::actuator::{Lag, Order, Slewing};
use fenderline_ship::hydro::{AzimuthThruster, Force, TunnelThruster, Velocity, Water};

/// A tunnel thruster of a vessel.
#[derive(Clone, Debug, PartialEq)]
pub struct ThrusterSetup {
    /// Name.
    pub name: String,
    /// The thruster.
    pub tunnel: TunnelThruster,
    /// Time constant (s).
    pub lag_s: f64,
}

/// An azimuth unit of a vessel.
#[derive(Clone, Debug, PartialEq)]
pub struct AzimuthSetup {
    /// Name.
    pub name: String,
    /// The unit.
    pub unit: AzimuthThruster,
    /// Thrust of the unit at rest and full power (N).
    pub bollard_n: f64,
    /// Time constant with which the thrust follows its order (s).
    pub lag_s: f64,
    /// Rate of turn (rad/s).
    pub rate_radps: f64,
    /// Largest angle to either side of ahead (rad); `None` if the unit turns all the way round.
    pub stop_rad: Option<f64>,
}

/// The order to an azimuth unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AzimuthOrder {
    /// Thrust divided by the thrust at rest and full power, 0 to 1.
    pub power: f64,
    /// Direction of the thrust, measured from the bow, positive to starboard (rad).
    pub direction_rad: f64,
}

/// The state of an azimuth unit, as plain data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AzimuthState {
    /// Thrust divided by the thrust at rest and full power. At speed, the same power gives less thrust.
    pub power: Lag,
    /// Direction of the thrust.
    pub direction: Slewing,
    /// Force of the unit on the vessel in the last step, about midship.
    pub force: Force,
}

impl AzimuthState {
    /// The state of a unit that is stopped and points ahead.
    pub fn new(setup: &AzimuthSetup) -> AzimuthState {
        AzimuthState {
            power: Lag { value: 0.0, time_constant_s: setup.lag_s },
            direction: Slewing {
                angle_rad: 0.0,
                rate_radps: setup.rate_radps,
                stop_rad: setup.stop_rad,
            },
            force: Force::default(),
        }
    }

    /// Moves the unit towards an order. Returns true if the unit limited the order.
    pub fn act(&mut self, order: &AzimuthOrder, step_s: f64) -> bool {
        let power =
            if order.power.is_nan() { self.power.value } else { bounded(order.power, 0.0, 1.0) };
        self.power.step(power, step_s);
        let turned = self.direction.step(order.direction_rad, step_s);
        power != order.power || turned == Order::Clamped
    }

    /// Calculates the force of the unit in a step, at this velocity of the vessel through the water.
    pub fn compute_force(
        &mut self,
        setup: &AzimuthSetup,
        velocity: &Velocity,
        water: Water,
    ) -> Force {
        let shaft_rps = setup.unit.revolutions_for(self.power.value * setup.bollard_n, water);
        self.force = setup.unit.force(shaft_rps, self.direction.angle_rad, velocity, water);
        self.force
    }
}
