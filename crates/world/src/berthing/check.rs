//! Checks that the particulars of a berthing are within their ranges.

use super::error::BerthingError;
use fenderline_ship::range::{OutOfRange, within};

/// Name, unit and range of a particular. Each range covers more than any real ship, and excludes overflow and division
/// by zero.
pub(super) struct Range {
    name: &'static str,
    low: f64,
    high: f64,
}

impl Range {
    pub(super) const fn new(name: &'static str, low: f64, high: f64) -> Range {
        Range { name, low, high }
    }

    /// Returns the value if it is within the range; NaN is never within a range.
    pub(super) fn check(&self, value: f64) -> Result<f64, BerthingError> {
        let Range { name, low, high } = *self;
        within(name, value, low, high).map_err(|OutOfRange { quantity, .. }| {
            BerthingError::OutOfRange { quantity, value, low, high }
        })
    }
}

pub(super) static BEAM: Range = Range::new("beam [m]", 0.1, 1000.0);
pub(super) static DRAUGHT: Range = Range::new("draught [m]", 0.01, 100.0);
pub(super) static UNDER_KEEL_CLEARANCE: Range =
    Range::new("under-keel clearance [m]", 0.0, 20_000.0);
pub(super) static BLOCK_COEFFICIENT: Range = Range::new("block coefficient", 0.1, 1.0);
pub(super) static LENGTH: Range = Range::new("length between perpendiculars [m]", 0.1, 5000.0);
pub(super) static GYRADIUS: Range = Range::new("radius of gyration [m]", 0.01, 5000.0);
pub(super) static ARM: Range = Range::new("lever arm [m]", -5000.0, 5000.0);
pub(super) static ANGLE: Range =
    Range::new("angle [rad]", -core::f64::consts::PI, core::f64::consts::PI);
pub(super) static BERTHING_ANGLE: Range =
    Range::new("berthing angle [rad]", -core::f64::consts::FRAC_PI_2, core::f64::consts::FRAC_PI_2);
pub(super) static DISPLACEMENT: Range = Range::new("displacement [kg]", 1.0, 1e12);
pub(super) static SPEED: Range = Range::new("berthing speed [m/s]", 0.0, 50.0);
