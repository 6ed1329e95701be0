//! Estimates by Clarke, Gedling & Hine, "The application of manoeuvring criteria in hull design using linear theory",
//! Transactions of RINA 125 (1983): linear derivatives of a hull by regression, as printed in the public toolbox MSS
//! (`clarke83.m`).

use std::f64::consts::PI;

use crate::hydro::mmg::LinearTerms;
use crate::hydro::particulars::Particulars;

/// Estimates the linear terms of the hull, with a given resistance X'₀.
pub(super) fn linear(ship: &Particulars, ahead: f64) -> LinearTerms {
    let (length_m, beam_m, draught_m) = (ship.length_m, ship.beam_m, ship.draught_m);
    let slender = draught_m / length_m;
    // Clarke's coefficients are divided by ½ρL², the coefficients here by ½ρLd.
    let unit = PI * slender * slender * length_m / draught_m;
    let (broad, thick) = (beam_m / draught_m, beam_m / length_m);
    LinearTerms {
        ahead,
        surge_vr: 0.0,
        sway_v: -unit * (1.0 + 0.40 * ship.block_coefficient() * broad),
        sway_r: -unit * (-0.5 + 2.2 * thick - 0.080 * broad),
        yaw_v: -unit * (0.5 + 2.4 * slender),
        yaw_r: -unit * (0.25 + 0.039 * broad - 0.56 * thick),
    }
}
