//! Wake at the propeller, and how it changes in a turn.

use crate::hydro::quantities::Velocity;

/// Effective wake by Yasukawa & Yoshimura (2015):
/// (1 − w)/(1 − w₀) = 1 + (1 − e^{−C₁|β_P|})(C₂ − 1), β_P = β − x'_P r'.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wake {
    /// w₀, straight ahead.
    pub straight: f64,
    /// C₁; 0 if the wake does not change in a turn.
    pub rate: f64,
    /// C₂ for β_P below and above 0.
    pub limits: [f64; 2],
    /// x'_P, over L.
    pub place: f64,
}

impl Wake {
    /// 1 − w: u_P = u(1 − w). Astern the propeller is in open water, without wake.
    pub fn remaining(&self, velocity: &Velocity, length_m: f64) -> f64 {
        if velocity.surge_mps <= 0.0 {
            return 1.0;
        }
        let straight = 1.0 - self.straight;
        if self.rate == 0.0 {
            return straight;
        }
        let yaw = velocity.yaw_radps * length_m / velocity.speed_mps();
        let angle_rad = velocity.drift_rad() - self.place * yaw;
        let limit = self.limits[usize::from(angle_rad > 0.0)];
        straight * (1.0 + (1.0 - libm::exp(-self.rate * angle_rad.abs())) * (limit - 1.0))
    }
}
