//! Yoshimura & Masumoto, "Hydrodynamic database and manoeuvring prediction method with medium high-speed merchant ships
//! and fishing vessels", MARSIM 2012: regressions for merchant ships by k = 2d/L, Cb B/L, Cb and L/B.
//!
//! The paper of Yoshimura & Masumoto could not be read. The formulas of Yoshimura & Masumoto are in several public
//! programs, among them nikpau/mmgdynamics (up to release 1.0), which differ in some signs. In this file the
//! regressions are written with the drift angle β = −v', and with the signs that agree with the published coefficients
//! of KCS and KVLCC2 (`tests/hydro_estimates.rs`):
//!
//! | term | here | in the public programs, over the drift angle β | KCS | KVLCC2 |
//! |---|---|---|---|---|
//! | Y'βββ | 0.185 L/B + 0.48 | 0.185 L/B − 0.48 | half of hers | a third of hers |
//! | N'βrr | 0.075 (1 − Cb) L/B − 0.098 in this file | 0.075 (1 − Cb) L/B + 0.098 in the programs | five times hers | the other sign |
//! | X'βr − m'y | −1.91 Cb B/L + 0.08 in this file | 1.91 Cb B/L − 0.08 − 2m'y in the programs | twice hers | as hers |
//!
//! In the form over β, the coefficients Y'r and X'βr include −m'x and −m'y. The regressions add the terms m'x and m'y,
//! so that they cancel.

use std::f64::consts::PI;

use crate::hydro::added_mass::AddedMass;
use crate::hydro::mmg::DriftPolynomial;
use crate::hydro::particulars::Particulars;

/// The polynomial of the hull under way, with a given resistance X'₀.
pub(super) fn polynomial(
    ship: &Particulars,
    added: &AddedMass,
    resistance_x_0: f64,
) -> DriftPolynomial {
    let aspect = 2.0 * ship.draught_m / ship.length_m;
    let block = ship.block_coefficient();
    let full = fullness(ship);
    let slender = ship.length_m / ship.beam_m;
    let added_sway = added.sway_m3 / ship.mass_unit_m3();
    let gravity_place = ship.centre_of_gravity_m / ship.length_m;
    DriftPolynomial {
        x_0: resistance_x_0,
        x_bb: 1.15 * full - 0.18,
        x_br: -1.91 * full + 0.08,
        x_rr: -0.085 * full + 0.008 - gravity_place * added_sway,
        x_bbbb: -6.68 * full + 1.1,
        y_b: 0.5 * PI * aspect + 1.4 * full,
        y_r: 0.5 * full,
        y_bbb: 0.185 * slender + 0.48,
        y_bbr: -0.75,
        y_brr: 0.26 * (1.0 - block) * slender + 0.11,
        y_rrr: -0.051,
        n_b: aspect,
        n_r: -0.54 * aspect + aspect * aspect,
        n_bbb: -0.69 * block + 0.66,
        n_bbr: 1.55 * full - 0.76,
        n_brr: 0.075 * (1.0 - block) * slender - 0.098,
        n_rrr: 0.25 * full - 0.056,
    }
}

/// Ratio ε of the wake at the rudder to the wake at the propeller.
pub(super) fn wake_ratio(wake: f64) -> f64 {
    2.26 - 1.82 * (1.0 - wake)
}

/// Share κ of the propeller race's speed that reaches the rudder.
pub(super) fn race_gain(wake_ratio: f64) -> f64 {
    0.55 / wake_ratio
}

/// Flow straightening coefficient γ_R, equal for both sides.
pub(super) fn straightening(ship: &Particulars) -> f64 {
    2.06 * fullness(ship) + 0.14
}

/// Ratio a_H of the lateral force on the hull due to steering to that of the rudder.
pub(super) fn hull_gain(ship: &Particulars) -> f64 {
    3.6 * fullness(ship)
}

/// Effective position l'_R of the rudder.
pub(super) const STRAIGHTENING_PLACE: f64 = -0.9;
/// Steering resistance deduction t_R.
pub(super) const RESISTANCE_DEDUCTION: f64 = 0.39;
/// Position x'_H of the lateral force on the hull due to steering.
pub(super) const HULL_PLACE: f64 = -0.4;

/// The ratio Cb B/L.
fn fullness(ship: &Particulars) -> f64 {
    ship.block_coefficient() * ship.beam_m / ship.length_m
}
