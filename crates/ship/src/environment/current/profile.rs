//! Current by depth.

use fenderline_contact::Vec2;

use super::check_velocity;
use crate::environment::error::EnvironmentError;
use crate::environment::table::{check_axis, place};
use crate::range::within;

/// Velocity of the current by depth: linear between points, constant above the first point and below the last.
#[derive(Clone, Debug, PartialEq)]
pub struct CurrentProfile {
    /// Points of the profile, by increasing depth: depth below the surface (m) and velocity of the current (m/s).
    points: Vec<(f64, Vec2)>,
}

impl CurrentProfile {
    /// Makes a profile of the current from points: depth (m), velocity north and east (m/s).
    ///
    /// # Errors
    /// Fails if there is no point, a negative depth, depths that do not increase, or a current above 15 m/s.
    pub fn new(points: Vec<(f64, Vec2)>) -> Result<CurrentProfile, EnvironmentError> {
        check_axis("depths of the current [m]", points.iter().map(|p| p.0), 1)?;
        for (depth_m, velocity_mps) in &points {
            within("depth of a current [m]", *depth_m, 0.0, 12_000.0)?;
            check_velocity(*velocity_mps)?;
        }
        Ok(CurrentProfile { points })
    }

    /// Velocity of the current at a depth (m/s).
    #[must_use]
    pub fn at(&self, depth_m: f64) -> Vec2 {
        let at = place(self.points.len(), |i| self.points[i].0, depth_m);
        let (low, high) = (self.points[at.low].1, self.points[at.high].1);
        low + (high - low) * at.share
    }

    /// Mean velocity of the current from the surface to a draught (m/s), the exact integral of the profile. For a
    /// draught of zero the mean velocity is the velocity at the surface.
    #[must_use]
    pub fn mean_over(&self, draught_m: f64) -> Vec2 {
        if draught_m.is_nan() || draught_m <= 0.0 {
            return self.at(0.0);
        }
        let inner = self.points.iter().map(|p| p.0).filter(|d| *d > 0.0 && *d < draught_m);
        let (mut above_m, mut above, mut sum) = (0.0, self.at(0.0), Vec2::ZERO);
        for depth_m in inner.chain([draught_m]) {
            let below = self.at(depth_m);
            sum += (above + below) * (0.5 * (depth_m - above_m));
            (above_m, above) = (depth_m, below);
        }
        sum * (1.0 / draught_m)
    }
}
