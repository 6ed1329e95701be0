//! Wake at the propeller, and how it changes in a turn.

use crate::hydro::quantities::Velocity;

/// Effective wake fraction w by Yasukawa & Yoshimura (2015): (1 − w)/(1 − w₀) = 1 + (1 − e^{−C₁|β_P|})(C₂ − 1), with
/// the inflow angle β_P = β − x'_P r'.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wake {
    /// Wake fraction w₀ of a ship that goes straight ahead.
    pub straight: f64,
    /// Coefficient C₁ of the wake's change in a turn; 0 if the wake does not change.
    pub rate: f64,
    /// Coefficient C₂ of the wake's change in a turn, for an inflow angle β_P below and above 0.
    pub limits: [f64; 2],
    /// Position x'_P of the propeller, divided by the ship's length L.
    pub place: f64,
}

impl Wake {
    /// The factor 1 − w in the speed of advance u_P = u(1 − w). When the ship goes astern, the propeller is in open
    /// water, without wake.
    pub fn remaining(&self, velocity: &Velocity, length_m: f64) -> f64 {
        // The computed square of a very small speed is 0.
        let speed_mps = velocity.speed_mps();
        if velocity.surge_mps <= 0.0 || speed_mps == 0.0 {
            return 1.0;
        }
        let straight = 1.0 - self.straight;
        if self.rate == 0.0 {
            return straight;
        }
        let yaw = velocity.yaw_radps * length_m / speed_mps;
        let angle_rad = velocity.drift_rad() - self.place * yaw;
        let limit = self.limits[usize::from(angle_rad > 0.0)];
        straight * (1.0 + (1.0 - libm::exp(-self.rate * angle_rad.abs())) * (limit - 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The wrench was not a number for a ship that a soft seabed had nearly stopped.
    #[test]
    fn the_wake_of_a_ship_that_has_all_but_stopped_is_a_number() {
        let wake = Wake { straight: 0.4, limits: [1.6, 1.1], rate: 4.0, place: -0.5 };
        for surge_mps in [1e-150, 1e-162, 1e-170, 1e-300, 5e-324] {
            for yaw_radps in [0.0, 1e-160, 1.0] {
                let velocity = Velocity { surge_mps, sway_mps: 0.0, yaw_radps };
                let remaining = wake.remaining(&velocity, 200.0);
                assert!((0.0..=1.0).contains(&remaining), "{surge_mps}, {yaw_radps}: {remaining}");
            }
        }
    }
}
