//! Tunnel thrusters and azimuth thrusters.

use crate::constants::KNOT_MPS;
use fenderline_contact::number::greater;

use super::propeller::Propeller;
use super::quantities::{Force, Velocity, Water, smooth_step};

/// Speed at which a tunnel thruster is least effective.
const WORST_MPS: f64 = 4.0 * KNOT_MPS;
/// Its effectiveness at that speed.
const WORST: f64 = 0.5;
/// Speed from which on it is fully effective again.
const AGAIN_MPS: f64 = 15.0 * KNOT_MPS;

/// A bow or stern thruster in a tunnel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunnelThruster {
    /// Thrust at rest and full power, equal to both sides (N).
    pub bollard_n: f64,
    /// Position forward of midship (m).
    pub along_m: f64,
}

impl TunnelThruster {
    /// Force for an order from −1 (full to port) to 1 (full to starboard).
    pub fn force(&self, order: f64, velocity: &Velocity) -> Force {
        let sway_n = self.bollard_n * order * tunnel_effect(velocity.surge_mps);
        Force::at(0.0, sway_n, self.along_m, 0.0)
    }
}

/// Effectiveness of a tunnel thruster's turning moment at a speed (m/s): 1 at rest, 0.5 at 4 knots, 1 again at 15 knots,
/// with smooth steps between (trials of a tanker of 60 000 t, 1967, recalled: the report was not read).
pub fn tunnel_effect(surge_mps: f64) -> f64 {
    let speed_mps = surge_mps.abs();
    let lost = 1.0 - WORST;
    if speed_mps <= WORST_MPS {
        return 1.0 - lost * smooth_step(speed_mps / WORST_MPS);
    }
    WORST + lost * smooth_step((speed_mps - WORST_MPS) / (AGAIN_MPS - WORST_MPS))
}

/// A propeller that turns about a vertical axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AzimuthThruster {
    /// The propeller, in open water.
    pub propeller: Propeller,
    /// Position forward of midship (m).
    pub along_m: f64,
    /// Position to starboard of the centre line (m).
    pub across_m: f64,
    /// Wake fraction at the unit.
    pub wake: f64,
    /// Thrust deduction, for thrust of either sign.
    pub thrust_deduction: f64,
}

impl AzimuthThruster {
    /// Force for revolutions (1/s) and an azimuth (rad) of the thrust: 0 drives ahead, π/2 to starboard.
    ///
    /// The speed of advance is the velocity of the water at the unit along its axis, yaw included. Drag of the unit across its
    /// axis is neglected.
    pub fn force(
        &self,
        shaft_rps: f64,
        azimuth_rad: f64,
        velocity: &Velocity,
        water: Water,
    ) -> Force {
        let (sin, cos) = libm::sincos(azimuth_rad);
        let advance_mps = self.advance_mps(azimuth_rad, velocity);
        let thrust_n =
            (1.0 - self.thrust_deduction) * self.propeller.thrust_n(advance_mps, shaft_rps, water);
        Force::at(thrust_n * cos, thrust_n * sin, self.along_m, self.across_m)
    }

    fn advance_mps(&self, azimuth_rad: f64, velocity: &Velocity) -> f64 {
        let (sin, cos) = libm::sincos(azimuth_rad);
        let along_mps = velocity.surge_mps - velocity.yaw_radps * self.across_m;
        let across_mps = velocity.sway_mps + velocity.yaw_radps * self.along_m;
        (1.0 - self.wake) * (along_mps * cos + across_mps * sin)
    }

    /// Revolutions (1/s) that give a thrust (N) in a direction at a velocity of the ship: at most `max_rps`, and zero if the
    /// inflow alone gives more thrust.
    pub fn revolutions_at(
        &self,
        thrust_n: f64,
        azimuth_rad: f64,
        velocity: &Velocity,
        water: Water,
        max_rps: f64,
    ) -> f64 {
        let thrust_at_n = |shaft_rps: f64| {
            let advance_mps = self.advance_mps(azimuth_rad, velocity);
            (1.0 - self.thrust_deduction) * self.propeller.thrust_n(advance_mps, shaft_rps, water)
        };
        // Thrust increases with revolutions: bisection.
        let (mut low, mut high) = (0.0, max_rps);
        for _ in 0..24 {
            let middle = 0.5 * (low + high);
            if thrust_at_n(middle) < thrust_n { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    /// Revolutions (1/s) that give a thrust ahead at rest (N): thrust is proportional to their square.
    pub fn revolutions_for(&self, thrust_n: f64, water: Water) -> f64 {
        let of_one_n = (1.0 - self.thrust_deduction) * self.propeller.thrust_n(0.0, 1.0, water);
        libm::sqrt(greater(thrust_n, 0.0) / of_one_n)
    }
}
