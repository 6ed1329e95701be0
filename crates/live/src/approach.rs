//! The limit of the closing speed towards a berth, for the alarms and the docking board.

use fenderline_contact::number::greater;
use serde::Serialize;

/// Deceleration that the limit of the closing speed assumes on the way to the fenders (m/s²).
const SLOWING_MPS2: f64 = 0.002;
/// A closing speed above this share of the limit is a caution.
const CAUTION_SHARE: f64 = 2.0 / 3.0;

/// The limit of the closing speed of a ship towards the berth. At a distance d from the fenders the limit is √(v₀² +
/// 2ad): the speed of a ship that slows down by a = 0.002 m/s² and touches the fenders at v₀. The limit is our choice;
/// it comes from no port's rule and no standard. Pilot and instructor may set another speed v₀ at the fenders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ApproachLimit {
    /// The limit v₀ of the closing speed at the fenders (m/s).
    pub at_fenders_mps: f64,
}

/// A signal of the docking board.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Light {
    /// Green.
    Ok,
    /// Amber.
    Caution,
    /// Red.
    Alarm,
}

impl Default for ApproachLimit {
    /// Design tables give a large ship in a sheltered berth about 0.15 m/s (a number from memory, not read there).
    fn default() -> ApproachLimit {
        ApproachLimit { at_fenders_mps: 0.15 }
    }
}

impl ApproachLimit {
    /// The least and the greatest limit v₀ that can be set (m/s).
    pub const LIMITS_MPS: [f64; 2] = [0.05, 1.0];

    /// The limit of the closing speed at a distance from the fenders (m/s).
    #[must_use]
    pub fn at_mps(self, off_m: f64) -> f64 {
        let v0 = self.at_fenders_mps;
        libm::sqrt(v0 * v0 + 2.0 * SLOWING_MPS2 * greater(off_m, 0.0))
    }

    /// The board's signal for a closing speed at a distance from the fenders. A ship that moves away from the berth is
    /// never too fast.
    #[must_use]
    pub fn light(self, closing_mps: f64, off_m: f64) -> Light {
        let limit_mps = self.at_mps(off_m);
        if closing_mps > limit_mps {
            Light::Alarm
        } else if closing_mps > CAUTION_SHARE * limit_mps {
            Light::Caution
        } else {
            Light::Ok
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_increases_with_the_distance() {
        let limit = ApproachLimit::default();
        assert_eq!(limit.light(0.16, 0.0), Light::Alarm);
        assert_eq!(limit.light(0.16, 5.0), Light::Caution);
        assert_eq!(limit.light(0.16, 10.0), Light::Ok);
        assert_eq!(limit.light(-1.0, 0.0), Light::Ok);
        assert!((limit.at_mps(0.0) - 0.15).abs() < 1e-15);
    }
}
