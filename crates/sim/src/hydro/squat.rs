//! Squat: how much deeper a ship under way sits in shallow water.

use crate::constants::STANDARD_GRAVITY_MPS2;
use fenderline_contact::number::{greater, lesser};

use super::particulars::Particulars;
use super::shallow::{SHALLOWEST_RATIO, barrass_squat_m, eryuzlu_squat_m, icorels_squat_m};

/// Froude number of depth up to which a displacement ship goes in shallow water, and from which on squat is held.
const FASTEST_FROUDE: f64 = 0.9;

/// A formula for squat, as PIANC has it for open water (`shallow/squat_formulas.rs`); held against numbers that were
/// calculated apart, not against trials.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Squat {
    /// Barrass in open water, [`barrass_squat_m`]: the same at every depth, made for 1.1 to 1.4 draughts.
    Barrass,
    /// ICORELS, [`icorels_squat_m`].
    #[default]
    Icorels,
    /// Eryuzlu et al. 1994, [`eryuzlu_squat_m`]: made for 1.1 to 2.5 draughts.
    Eryuzlu,
}

impl Squat {
    /// Its name, for a reader.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Squat::Barrass => "Barrass",
            Squat::Icorels => "ICORELS",
            Squat::Eryuzlu => "Eryuzlu et al. 1994",
        }
    }

    /// Depths over the draught that it was made for, as they are handed on: recalled. `None`: any in shallow water.
    #[must_use]
    pub fn depth_ratios(self) -> Option<[f64; 2]> {
        match self {
            Squat::Barrass => Some([1.1, 1.4]),
            Squat::Icorels => None,
            Squat::Eryuzlu => Some([1.1, 2.5]),
        }
    }

    /// Largest sinkage of her keel (m) at a speed along her own axis through the water (m/s), ahead or astern.
    /// From a Froude number of depth of 0.9 on it is held: no displacement ship goes faster there, and
    /// ICORELS ends at 1. Below [`SHALLOWEST_RATIO`] draughts, on the bottom too, it is that of this depth: no
    /// formula is made for less, and it does not jump where she touches.
    ///
    /// # Panics
    /// With a depth or a speed that is no number.
    #[must_use]
    pub fn sinkage_m(self, ship: &Particulars, depth_m: f64, surge_mps: f64) -> f64 {
        assert!(!depth_m.is_nan() && !surge_mps.is_nan(), "depth and speed are numbers");
        let depth_m = greater(depth_m, SHALLOWEST_RATIO * ship.draught_m);
        let fastest_mps = FASTEST_FROUDE * (STANDARD_GRAVITY_MPS2 * depth_m).sqrt();
        let speed_mps = lesser(surge_mps.abs(), fastest_mps);
        let formula = match self {
            Squat::Barrass => barrass_squat_m,
            Squat::Icorels => icorels_squat_m,
            Squat::Eryuzlu => eryuzlu_squat_m,
        };
        formula(ship, depth_m, speed_mps)
            .unwrap_or_else(|error| unreachable!("depth and speed are held: {error}"))
    }
}
