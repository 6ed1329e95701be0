//! Thrusters: in a tunnel across the ship, and on an azimuth.

use crate::constants::KNOT_MPS;
use fenderline_contact::number::greater;

use super::propeller::Propeller;
use super::quantities::{Force, Velocity, Water, smooth_step};

/// Speed at which a tunnel thruster works worst, and what is left of it there.
const WORST_MPS: f64 = 4.0 * KNOT_MPS;
const WORST: f64 = 0.5;
/// Speed from which it works fully again.
const AGAIN_MPS: f64 = 15.0 * KNOT_MPS;

/// A bow or stern thruster in a tunnel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunnelThruster {
    /// Thrust at rest and full power, the same to both sides (N).
    pub bollard_n: f64,
    /// Its place forward of midship (m).
    pub along_m: f64,
}

impl TunnelThruster {
    /// Force for an order from −1 (full to port) to 1 (full to starboard).
    pub fn force(&self, order: f64, velocity: &Velocity) -> Force {
        let sway_n = self.bollard_n * order * tunnel_effect(velocity.surge_mps);
        Force::at(0.0, sway_n, self.along_m, 0.0)
    }
}

/// What is left of a tunnel thruster's turning moment at a speed (m/s): all at rest, half at 4 knots, all
/// again at 15 (trials of a tanker of 60 000 t, 1967, recalled: the report was not read), by smooth steps between.
pub fn tunnel_effect(surge_mps: f64) -> f64 {
    let speed_mps = surge_mps.abs();
    let lost = 1.0 - WORST;
    if speed_mps <= WORST_MPS {
        return 1.0 - lost * smooth_step(speed_mps / WORST_MPS);
    }
    WORST + lost * smooth_step((speed_mps - WORST_MPS) / (AGAIN_MPS - WORST_MPS))
}

/// A propeller that turns about the vertical.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AzimuthThruster {
    /// The propeller, in open water.
    pub propeller: Propeller,
    /// Its place forward of midship (m).
    pub along_m: f64,
    /// Its place to starboard of the centre line (m).
    pub across_m: f64,
    /// Wake fraction at the unit.
    pub wake: f64,
    /// Thrust deduction, for thrust of either sign.
    pub thrust_deduction: f64,
}

impl AzimuthThruster {
    /// Force for revolutions (1/s) and an azimuth (rad) of the thrust: 0 drives ahead, π/2 to starboard.
    ///
    /// The inflow is the water's motion at the unit along its axis, yaw included: thrust falls with speed
    /// as the propeller's own curve says. Drag of the unit across its axis is not counted.
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

    /// Revolutions (1/s), up to `most_rps`, that give a thrust (N) in a direction at a velocity: the most
    /// where that is not enough, and none where the stream alone gives more.
    pub fn revolutions_at(
        &self,
        thrust_n: f64,
        azimuth_rad: f64,
        velocity: &Velocity,
        water: Water,
        most_rps: f64,
    ) -> f64 {
        let given_n = |shaft_rps: f64| {
            let advance_mps = self.advance_mps(azimuth_rad, velocity);
            (1.0 - self.thrust_deduction) * self.propeller.thrust_n(advance_mps, shaft_rps, water)
        };
        // Thrust rises with revolutions: by halving.
        let (mut low, mut high) = (0.0, most_rps);
        for _ in 0..24 {
            let middle = 0.5 * (low + high);
            if given_n(middle) < thrust_n { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    /// Revolutions (1/s) that give a thrust ahead at rest (N): thrust goes with their square.
    pub fn revolutions_for(&self, thrust_n: f64, water: Water) -> f64 {
        let of_one_n = (1.0 - self.thrust_deduction) * self.propeller.thrust_n(0.0, 1.0, water);
        libm::sqrt(greater(thrust_n, 0.0) / of_one_n)
    }
}
