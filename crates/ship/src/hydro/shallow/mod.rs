//! Shallow water: corrections of hull, added mass, propeller and rudder; the drag of a ship at her berth; squat.
//!
//! A correction is a factor on the ship's value in deep water. The factors of a set belong together: the destabilising
//! N_v increases as much as the damping. A part of a set alone would describe a different ship.
//!
//! | set | linear terms | other terms |
//! |---|---|---|
//! | [`CorrectionSet::Combined`], the default | Y_v and N_v by the effective aspect ratio (`aspect_ratio.rs`); Y_r by Ankudinov (`ankudinov.rs`); N_r by the mean of both | nonlinear terms and added mass by Ankudinov; resistance, wake, thrust deduction and flow straightening as `stern.rs` |
//! | [`CorrectionSet::EffectiveAspectRatio`] | by the effective aspect ratio | as the default |
//! | [`CorrectionSet::Ankudinov`] | by Ankudinov | as the default |
//! | [`CorrectionSet::Taimuri`] | by Taimuri et al. (2020) | theirs, wake and all |
//!
//! The default was chosen by comparison with the derivatives of a tanker of 190 000 dwt which was tested in shallow
//! water (van Berlekom & Goddard, SNAME Trans. 80, 1972, as in the public MSS toolbox), and with turning circles and
//! zig-zags of tankers and container ships. `fenderline validate`, chapter "Shallow water", has both for all four sets.
//!
//! - Y_v and N_v: the published factors agree within a tenth for such ships.
//! - N_r: at h/T 1.2 the effective aspect ratio gives 1.40, Ankudinov 2.68, and the tanker has 2.02. At h/T 1.5 the two
//!   methods give 1.21 and 1.51, and the tanker has 1.41. The mean of the two is within 4 % of the tanker's value at
//!   both depths. Kijima's power (`taimuri.rs`) gives 2.29 for the tanker, but 3.4 to 5.7 for ships with a smaller
//!   ratio of draught to length. The turning circles of such ships would be three times as wide, so it is not used.
//! - Y_r: the tanker has 4.9, Ankudinov gives 2.4 and the effective aspect ratio 1.9. Ankudinov is nearer, and is used.
//! - Taimuri's set has cubics in T/h that leave their range for broad ships.
//!
//! Besides this mean, the extrapolation is ours. Ankudinov's factors are used down to [`PUBLISHED_RATIO`] draughts of
//! water only, because their fifth power triples them between there and [`SHALLOWEST_RATIO`]. Between these two ratios
//! they continue along their tangent, linear in T/(h − T), the draught over the clearance. The derivatives of the
//! tanker are linear in this quantity. Below [`SHALLOWEST_RATIO`] all values are constant.

mod ankudinov;
mod aspect_ratio;
mod berth;
mod corrected;
mod factors;
mod limits;
mod squat_formulas;
mod stern;
mod taimuri;

pub use berth::{current_abeam_n, shallow_cross_flow_drag};
pub use factors::{Corrections, HullFactors, MassFactors, SternFactors};
pub use limits::{PUBLISHED_RATIO, SHALLOWEST_RATIO};
pub use squat_formulas::{
    barrass_channel_squat_m, barrass_squat_m, eryuzlu_squat_m, icorels_squat_m,
    width_of_influence_m,
};

use fenderline_contact::number::greater;

use super::particulars::Particulars;
use ankudinov::Ankudinov;

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

impl Corrections {
    /// The corrections of a set for a ship in water of a depth (m), which may be infinite. The corrections are constant
    /// below [`SHALLOWEST_RATIO`] draughts.
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
