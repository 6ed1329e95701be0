//! What shallow water does to a ship: hull, added mass, propeller and rudder as one set of corrections; the drag of a
//! ship at her berth; squat.
//!
//! A correction is a factor on the ship's own number in deep water, 1 there. The factors of a set belong together: the
//! destabilising N_v grows as much as the damping, and who corrects a part of a set gets another ship.
//!
//! | set | linear terms | the rest |
//! |---|---|---|
//! | [`CorrectionSet::Combined`], the default | Y_v and N_v by the effective aspect ratio (`aspect_ratio.rs`); Y_r by Ankudinov (`ankudinov.rs`); N_r by the mean of both | nonlinear terms and added mass by Ankudinov; resistance, wake, thrust deduction and flow straightening as `stern.rs` |
//! | [`CorrectionSet::EffectiveAspectRatio`] | by the effective aspect ratio | as the default |
//! | [`CorrectionSet::Ankudinov`] | by Ankudinov | as the default |
//! | [`CorrectionSet::Taimuri`] | by Taimuri et al. (2020) | theirs, wake and all |
//!
//! How it was chosen: against the derivatives of a tanker of 190 000 dwt that was tested in shallow water (van Berlekom &
//! Goddard, SNAME Trans. 80, 1972, as in the public MSS toolbox), and against what turning circles and zig-zags of
//! tankers and container ships do there; `fenderline validate`, chapter "Shallow water", has both for all four sets.
//! For Y_v and N_v the published factors agree within a tenth for such ships. For N_r the effective aspect ratio has 1.40
//! at h/T 1.2 and Ankudinov 2.68, where the tanker's is 2.02; at 1.5 it is 1.21 and 1.51 beside her 1.41: their mean is
//! hers within 4 % at both depths. Kijima's power (`taimuri.rs`) has 2.29 for her, but 3.4 to 5.7 for ships of less draught
//! beside their length, who by it need three times the room: it is not taken. For Y_r the tanker has 4.9, Ankudinov 2.4
//! and the effective aspect ratio 1.9: the nearer one is taken. Taimuri's set has cubics in T/h that leave their range
//! for broad ships.
//!
//! What is ours in it, besides that mean: Ankudinov's factors end at [`PUBLISHED_RATIO`] draughts of water, as their
//! fifth power triples them between there and [`SHALLOWEST_RATIO`]; in between they go on along their tangent over
//! T/(h − T), the inverse of the clearance, in which that tanker's derivatives are linear. Below [`SHALLOWEST_RATIO`]
//! everything is held.

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

/// Depth over draught below which the factors of shallow water are ours: published tests end here.
pub const PUBLISHED_RATIO: f64 = 1.2;

/// Depth over draught from which on, downwards, every factor of shallow water is held.
pub const SHALLOWEST_RATIO: f64 = 1.1;

/// A set of corrections.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CorrectionSet {
    /// What the program takes.
    #[default]
    Combined,
    /// All linear terms by the effective aspect ratio of Hirano et al. (1985) and Kijima & Nakiri.
    EffectiveAspectRatio,
    /// All linear terms by Ankudinov (1990).
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
    /// On the resistance, ahead and astern.
    pub resistance: f64,
    pub x_vv: f64,
    /// On X_vr *with* the added mass' m_y, whose Coriolis term it takes a part of: (m_y + X_vr).
    pub x_vr: f64,
    pub x_rr: f64,
    pub x_vvvv: f64,
    pub y_v: f64,
    /// On Y_r without the added mass' −m_x.
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

/// What shallow water does to propeller and rudder behind the hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SternFactors {
    /// On 1 − t, of thrust ahead.
    pub driving: f64,
    /// On the wake fraction w.
    pub wake: f64,
    /// On 1 − w, after [`SternFactors::wake`].
    pub inflow: f64,
    /// On γ_R, both sides.
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

/// All that a depth of water does to a ship under way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corrections {
    /// To her hull.
    pub hull: HullFactors,
    /// To propeller and rudder.
    pub stern: SternFactors,
    /// To her added mass.
    pub mass: MassFactors,
}

impl Corrections {
    /// Of a set, for a ship in water of a depth (m), which may be infinite; held below [`SHALLOWEST_RATIO`] draughts.
    ///
    /// # Panics
    /// With a depth that is no number.
    #[must_use]
    pub fn of(set: CorrectionSet, ship: &Particulars, depth_m: f64) -> Corrections {
        assert!(!depth_m.is_nan(), "a depth is a number");
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

/// T/L of the deepest hull, beside her length, that factors of N_r are asked about: by a wide margin those that were
/// tested. Stubbier hulls have the factor of this one, as the formulas would turn negative.
const DEEPEST_HULL: f64 = 0.08;

/// T/h, below 1.
fn draught_over_depth(ship: &Particulars, depth_m: f64) -> Result<f64, HydroError> {
    let draught_m = ship.draught_m;
    if depth_m > draught_m {
        return Ok(draught_m / depth_m);
    }
    Err(HydroError::Aground { depth_m, draught_m })
}
