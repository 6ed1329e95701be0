//! Thrusters of a vessel in a run: tunnel thrusters, and azimuth units with their own order, lag and rate of
//! turn.

use fenderline_contact::number::bounded;

use crate::hydro::actuator::{Lag, Order, Slewing};
use crate::hydro::{AzimuthThruster, Force, TunnelThruster, Velocity, Water};

/// A tunnel thruster of a vessel.
#[derive(Clone, Debug, PartialEq)]
pub struct ThrusterSetup {
    /// Her name for it.
    pub name: String,
    /// The thruster.
    pub tunnel: TunnelThruster,
    /// Time constant (s).
    pub lag_s: f64,
}

/// An azimuth unit of a vessel.
#[derive(Clone, Debug, PartialEq)]
pub struct AzimuthSetup {
    /// Her name for it.
    pub name: String,
    /// The unit.
    pub unit: AzimuthThruster,
    /// Thrust at rest and full power (N).
    pub bollard_n: f64,
    /// Time constant of the thrust (s).
    pub lag_s: f64,
    /// Rate of turn (rad/s).
    pub rate_radps: f64,
    /// How far it turns to either side of ahead (rad); `None`: all the way round.
    pub stop_rad: Option<f64>,
}

/// What an azimuth unit is ordered to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AzimuthOrder {
    /// Thrust over that at rest and full power, 0 to 1.
    pub power: f64,
    /// Direction of the thrust from the bow, positive to starboard (rad).
    pub direction_rad: f64,
}

/// An azimuth unit during a run: plain data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AzimuthState {
    /// Thrust over that at rest and full power; at speed there is less for it.
    pub power: Lag,
    /// Where its thrust points.
    pub direction: Slewing,
    /// Its force on the vessel in the last step, about midship.
    pub force: Force,
}

impl AzimuthState {
    /// At rest, pointing ahead.
    pub(crate) fn new(setup: &AzimuthSetup) -> AzimuthState {
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

    /// Moves towards an order; true where it was beyond a stop.
    pub(crate) fn act(&mut self, order: &AzimuthOrder, step_s: f64) -> bool {
        let power =
            if order.power.is_nan() { self.power.value } else { bounded(order.power, 0.0, 1.0) };
        self.power.step(power, step_s);
        let turned = self.direction.step(order.direction_rad, step_s);
        power != order.power || turned == Order::Clamped
    }

    /// The force of a step, for a vessel that moves like this through the water.
    pub(crate) fn push(
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
