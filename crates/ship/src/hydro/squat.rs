//! Squat, the sinkage of a ship under way in shallow water.

use crate::constants::STANDARD_GRAVITY_MPS2;
use fenderline_contact::number::{greater, lesser};

use super::error::HydroError;
use super::particulars::Particulars;
use super::shallow::{
    SHALLOWEST_RATIO, barrass_channel_squat_m, barrass_squat_m, eryuzlu_squat_m,
    icorels_channel_squat_m, icorels_squat_m, width_of_blockage_m, width_of_influence_m,
};

/// Depth Froude number above which the squat stays constant, because displacement ships do not go faster in shallow
/// water.
pub const FASTEST_FROUDE: f64 = 0.9;

/// The speed √(gh) of long waves in water of a depth h (m/s).
#[must_use]
pub fn critical_mps(depth_m: f64) -> f64 {
    (STANDARD_GRAVITY_MPS2 * depth_m).sqrt()
}

/// A squat formula (`shallow/squat_formulas.rs`): three for open water, as given by PIANC, and two for channels. The
/// formulas are verified against independent calculations, but not validated against trials.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Squat {
    /// The formula of Barrass for open water, [`barrass_squat_m`]. Barrass' formula does not depend on depth. Barrass'
    /// formula is valid for 1.1 to 1.4 draughts of water.
    Barrass,
    /// ICORELS, [`icorels_squat_m`].
    #[default]
    Icorels,
    /// The formula of Eryuzlu et al. (1994), [`eryuzlu_squat_m`], for 1.1 to 2.5 draughts of water.
    Eryuzlu,
    /// Barrass' formula with the blockage of the water's cross-section by the ship, [`barrass_channel_squat_m`], for
    /// channels and for open water.
    BarrassChannel,
    /// ICORELS with the factor of Huuska for the blockage of the cross-section, [`icorels_channel_squat_m`], in channels
    /// and in open water.
    IcorelsChannel,
}

/// The squat of a formula whose depth and speed are limited to the formula's range.
fn in_range(squat_m: Result<f64, HydroError>) -> f64 {
    squat_m.unwrap_or_else(|error| {
        unreachable!("depth and speed are limited to the formula's range: {error}")
    })
}

impl Squat {
    /// Name of the squat formula, for reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Squat::Barrass => "Barrass",
            Squat::Icorels => "ICORELS",
            Squat::Eryuzlu => "Eryuzlu et al. 1994",
            Squat::BarrassChannel => "Barrass with blockage",
            Squat::IcorelsChannel => "ICORELS with blockage",
        }
    }

    /// Width of the cross-section of the water that the formula looks at (m); `None`: the formula is for open water.
    #[must_use]
    pub fn width_m(self, ship: &Particulars) -> Option<f64> {
        match self {
            Squat::Barrass | Squat::Icorels | Squat::Eryuzlu => None,
            Squat::BarrassChannel => Some(width_of_influence_m(ship)),
            Squat::IcorelsChannel => Some(width_of_blockage_m(ship)),
        }
    }

    /// Range of the ratio of depth to draught for which the squat formula is valid (from memory); `None`: any shallow
    /// depth.
    #[must_use]
    pub fn depth_ratios(self) -> Option<[f64; 2]> {
        match self {
            Squat::Barrass => Some([1.1, 1.4]),
            Squat::Icorels | Squat::BarrassChannel | Squat::IcorelsChannel => None,
            Squat::Eryuzlu => Some([1.1, 2.5]),
        }
    }

    /// Maximum sinkage of the keel (m) in open water at a surge speed through the water (m/s), ahead or astern:
    /// [`Squat::sinkage_in_m`] with the cross-section of open water.
    ///
    /// # Panics
    /// Panics if depth or speed is NaN.
    #[must_use]
    pub fn sinkage_m(self, ship: &Particulars, depth_m: f64, surge_mps: f64) -> f64 {
        self.sinkage_in_m(ship, depth_m, f64::INFINITY, surge_mps)
    }

    /// Maximum sinkage of the keel (m) at a surge speed through the water (m/s), ahead or astern, in water of a depth
    /// (m) and a cross-section (m²), which only formulas for channels use.
    ///
    /// Above a depth Froude number of 0.9 the squat is constant: displacement ships do not go faster there, and ICORELS
    /// is singular at 1. In water shallower than [`SHALLOWEST_RATIO`] draughts, also aground, the squat for that ratio
    /// is used. No squat formula is valid in shallower water, and the squat stays continuous when the ship touches the
    /// bottom.
    ///
    /// # Panics
    /// Panics if depth or speed is NaN.
    #[must_use]
    pub fn sinkage_in_m(
        self,
        ship: &Particulars,
        depth_m: f64,
        section_m2: f64,
        surge_mps: f64,
    ) -> f64 {
        assert!(!depth_m.is_nan() && !surge_mps.is_nan(), "depth and speed are not NaN");
        let depth_m = greater(depth_m, SHALLOWEST_RATIO * ship.draught_m);
        let limit_mps = FASTEST_FROUDE * critical_mps(depth_m);
        let speed_mps = lesser(surge_mps.abs(), limit_mps);
        let formula = match self {
            Squat::Barrass => barrass_squat_m,
            Squat::Icorels => icorels_squat_m,
            Squat::Eryuzlu => eryuzlu_squat_m,
            Squat::BarrassChannel => {
                return barrass_channel_squat_m(ship, depth_m, section_m2, speed_mps);
            }
            Squat::IcorelsChannel => {
                return in_range(icorels_channel_squat_m(ship, depth_m, section_m2, speed_mps));
            }
        };
        in_range(formula(ship, depth_m, speed_mps))
    }
}
