//! Effects of shallow water: corrections of hull, added mass, propeller and rudder; the drag of a ship at her berth;
//! squat.
//!
//! A correction for shallow water is a factor on the ship's value in deep water. The factors of a set belong together:
//! the derivative N_v, which makes a ship unstable, increases as much as the damping. A part of a set of factors alone
//! would describe a different ship.
//!
//! | set | linear terms | other terms |
//! |---|---|---|
//! | [`CorrectionSet::Combined`], the default | derivatives Y_v and N_v by the effective aspect ratio (`aspect_ratio.rs`); Y_r by Ankudinov (`ankudinov.rs`); N_r by the mean of both | nonlinear terms and added mass by Ankudinov; resistance, wake, thrust deduction and flow straightening as in `stern.rs` |
//! | [`CorrectionSet::EffectiveAspectRatio`] | by the effective aspect ratio | as the default |
//! | [`CorrectionSet::Ankudinov`] | by Ankudinov | as the default |
//! | [`CorrectionSet::Taimuri`] | all factors by Taimuri et al. (2020) | all by Taimuri et al., wake included |
//!
//! The default set was chosen by comparison with the derivatives of a tanker of 190 000 dwt which was tested in shallow
//! water (van Berlekom & Goddard, Transactions of SNAME 80, 1972, as in the public MSS toolbox), and with turning
//! circles and zig-zags of tankers and container ships in shallow water. `fenderline validate`, chapter "Shallow
//! water", has both comparisons for all four sets.
//!
//! - For Y_v and N_v, the published factors agree within a tenth for ships like this tanker.
//! - For N_r at h/T 1.2, the effective aspect ratio gives a factor of 1.40, Ankudinov 2.68, and the tanker has 2.02.
//!   For N_r at h/T 1.5, the effective aspect ratio and Ankudinov give factors of 1.21 and 1.51, and the tanker has
//!   1.41. For N_r, the mean of the effective aspect ratio and Ankudinov is within 4 % of the tanker's value at both
//!   depths. For N_r, Kijima's power (`taimuri.rs`) gives a factor of 2.29 for the tanker, but 3.4 to 5.7 for ships
//!   with a smaller ratio of draught to length. With Kijima's factor the turning circles of these ships would be three
//!   times as wide, so it is not used.
//! - For Y_r, the tanker has a factor of 4.9, Ankudinov gives 2.4 and the effective aspect ratio 1.9. For Y_r,
//!   Ankudinov's factor is nearer to the tanker's, and is used.
//! - Taimuri's set of factors has cubics in T/h that were fitted to tankers, and gives useless factors for broad ships.
//!
//! Two things in the default set are our own: the mean for N_r, and the extrapolation to shallower water. Ankudinov's
//! factors are used down to [`PUBLISHED_RATIO`] draughts of water only, because their fifth power of T/(h − T) would
//! triple the factors between [`PUBLISHED_RATIO`] and [`SHALLOWEST_RATIO`] draughts. Between these two depths
//! Ankudinov's factors continue along their tangent, linear in T/(h − T), the draught divided by the clearance. The
//! derivatives of the tanker are linear in T/(h − T). In water shallower than [`SHALLOWEST_RATIO`] draughts all factors
//! are constant.

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
    barrass_channel_squat_m, barrass_squat_m, eryuzlu_squat_m, icorels_channel_squat_m,
    icorels_squat_m, width_of_blockage_m, width_of_influence_m,
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
    /// The linear terms are by the effective aspect ratio of Hirano et al. (1985) and Kijima & Nakiri.
    EffectiveAspectRatio,
    /// The linear terms are those of Ankudinov (1990).
    Ankudinov,
    /// Taimuri et al. (2020).
    Taimuri,
}

impl Corrections {
    /// Gives the corrections of a set for a ship in water of a depth (m), which may be infinite. The corrections for
    /// shallow water are constant below [`SHALLOWEST_RATIO`] draughts.
    ///
    /// # Panics
    /// Panics if the depth is NaN.
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
