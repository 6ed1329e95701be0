//! Shallow water: corrections of hull, added mass, propeller and rudder; the drag of a ship at her berth; squat.
//!
//! A correction is a factor on the ship's value in deep water. The factors of a set belong together: the destabilising N_v
//! increases as much as the damping, so that a part of a set alone gives a different ship.
//!
//! | set | linear terms | other terms |
//! |---|---|---|
//! | [`CorrectionSet::Combined`], the default | Y_v and N_v by the effective aspect ratio (`aspect_ratio.rs`); Y_r by Ankudinov (`ankudinov.rs`); N_r by the mean of both | nonlinear terms and added mass by Ankudinov; resistance, wake, thrust deduction and flow straightening as `stern.rs` |
//! | [`CorrectionSet::EffectiveAspectRatio`] | by the effective aspect ratio | as the default |
//! | [`CorrectionSet::Ankudinov`] | by Ankudinov | as the default |
//! | [`CorrectionSet::Taimuri`] | by Taimuri et al. (2020) | theirs, wake and all |
//!
//! The default was chosen by comparison with the derivatives of a tanker of 190 000 dwt that was tested in shallow water (van
//! Berlekom & Goddard, SNAME Trans. 80, 1972, as in the public MSS toolbox), and with turning circles and zig-zags of tankers
//! and container ships. `fenderline validate`, chapter "Shallow water", has both for all four sets.
//!
//! - Y_v and N_v: the published factors agree within a tenth for such ships.
//! - N_r: at h/T 1.2 the effective aspect ratio gives 1.40 and Ankudinov 2.68, where the tanker has 2.02; at 1.5 they give 1.21
//!   and 1.51, where she has 1.41. Their mean is within 4 % of hers at both depths. Kijima's power (`taimuri.rs`) gives 2.29 for
//!   her, but 3.4 to 5.7 for ships with a smaller ratio of draught to length, whose turning circles would be three times as
//!   wide: it is not used.
//! - Y_r: the tanker has 4.9, Ankudinov 2.4 and the effective aspect ratio 1.9: Ankudinov, the nearer one, is used.
//! - Taimuri's set has cubics in T/h that leave their range for broad ships.
//!
//! Besides that mean, the extrapolation is ours. Ankudinov's factors are used down to [`PUBLISHED_RATIO`] draughts of water,
//! because their fifth power triples them between there and [`SHALLOWEST_RATIO`]. In between they are linear, along their
//! tangent, in T/(h − T), the inverse of the clearance, in which that tanker's derivatives are linear. Below
//! [`SHALLOWEST_RATIO`] all values are constant.

mod ankudinov;
mod aspect_ratio;
mod berth;
mod corrected;
mod squat_formulas;
mod stern;
mod taimuri;

pub use berth::{current_abeam_n, shallow_cross_flow_drag};
pub use squat_formulas::{barrass_squat_m, eryuzlu_squat_m, icorels_squat_m};

use fenderline_contact::number::greater;

use super::error::HydroError;
use super::particulars::Particulars;
use ankudinov::Ankudinov;

/// Depth over draught at which published tests end. Below it the factors are our extrapolation.
pub const PUBLISHED_RATIO: f64 = 1.2;

/// Depth over draught below which every factor is constant.
pub const SHALLOWEST_RATIO: f64 = 1.1;

/// A set of corrections.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CorrectionSet {
    /// The default.
    #[default]
    Combined,
    /// Linear terms by the effective aspect ratio of Hirano et al. (1985) and Kijima & Nakiri.
    EffectiveAspectRatio,
    /// Linear terms by Ankudinov (1990).
    Ankudinov,
    /// Taimuri et al. (2020).
    Taimuri,
}

/// Factors on the derivatives of a hull, each named as in [`super::SwayPolynomial`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(
    missing_docs,
    reason = "each is named as in the method: its index is its powers of v' and r'"
)]
pub struct HullFactors {
    /// Factor on the resistance, ahead and astern.
    pub resistance: f64,
    pub x_vv: f64,
    /// Factor on (m_y + X_vr): X_vr with the Coriolis term of the added mass.
    pub x_vr: f64,
    pub x_rr: f64,
    pub x_vvvv: f64,
    pub y_v: f64,
    /// Factor on Y_r without the −m_x of the added mass.
    pub y_r: f64,
    pub y_vvv: f64,
    pub y_vvr: f64,
    pub y_vrr: f64,
    pub y_rrr: f64,
    pub n_v: f64,
    pub n_r: f64,
    pub n_vvv: f64,
    pub n_vvr: f64,
    pub n_vrr: f64,
    pub n_rrr: f64,
}

/// Factors on propeller and rudder behind the hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SternFactors {
    /// Factor on 1 − t, for thrust ahead.
    pub driving: f64,
    /// Factor on the wake fraction w.
    pub wake: f64,
    /// Factor on 1 − w, applied after [`SternFactors::wake`].
    pub inflow: f64,
    /// Factor on γ_R, both sides.
    pub straightening: f64,
}

/// Factors on the added mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassFactors {
    /// In surge.
    pub surge: f64,
    /// In sway.
    pub sway: f64,
    /// In yaw.
    pub yaw: f64,
}

/// All corrections for a depth of water.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corrections {
    /// Hull.
    pub hull: HullFactors,
    /// Propeller and rudder.
    pub stern: SternFactors,
    /// Added mass.
    pub mass: MassFactors,
}

impl Corrections {
    /// The corrections of a set for a ship in water of a depth (m), which may be infinite. They are constant below
    /// [`SHALLOWEST_RATIO`] draughts.
    ///
    /// # Panics
    /// If the depth is NaN.
    #[must_use]
    pub fn of(set: CorrectionSet, ship: &Particulars, depth_m: f64) -> Corrections {
        assert!(!depth_m.is_nan(), "the depth is not NaN");
        let share = ship.draught_m / greater(depth_m, SHALLOWEST_RATIO * ship.draught_m);
        if set == CorrectionSet::Taimuri {
            return taimuri::corrections(ship, share);
        }
        let rest = Ankudinov::of(ship, share).corrections(ship, share);
        if set == CorrectionSet::Ankudinov {
            return rest;
        }
        let [y_v, mut y_r, n_v, mut n_r] = aspect_ratio::linear(ship, share);
        if set == CorrectionSet::Combined {
            y_r = rest.hull.y_r;
            n_r = 0.5 * (n_r + rest.hull.n_r);
        }
        Corrections { hull: HullFactors { y_v, y_r, n_v, n_r, ..rest.hull }, ..rest }
    }
}

/// Largest T/L for factors of N_r, much greater than those that were tested. Hulls with a greater T/L have the factors of this one,
/// because the formulas would become negative.
const DEEPEST_HULL: f64 = 0.08;

/// T/h, below 1.
fn draught_over_depth(ship: &Particulars, depth_m: f64) -> Result<f64, HydroError> {
    let draught_m = ship.draught_m;
    if depth_m > draught_m {
        return Ok(draught_m / depth_m);
    }
    Err(HydroError::Aground { depth_m, draught_m })
}
