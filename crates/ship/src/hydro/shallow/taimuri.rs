//! The corrections for shallow water of Taimuri et al. (2020), as printed in the public implementation
//! nikpau/mmgdynamics. The corrections of Taimuri et al. serve to compare with the other sets: powers of 1 − T/h and
//! cubics in T/h after Kijima et al. (1990), the rest after Ankudinov.
//!
//! The cubics of Taimuri's set were fitted to tankers: for a container ship of B/T 5 the factor on N_vrr is −21 at an
//! h/T of 2. The two branches of Taimuri's factor on the flow straightening γ_R do not meet. For these reasons
//! Taimuri's set is not the default.

use fenderline_contact::number::lesser;

use super::ankudinov::Ankudinov;
use super::factors::{Corrections, HullFactors, MassFactors, SternFactors};
use super::limits::DEEPEST_HULL;
use crate::hydro::particulars::Particulars;

/// The whole set of corrections by Taimuri at x = T/h.
pub(super) fn corrections(ship: &Particulars, x: f64) -> Corrections {
    let Ankudinov { g_v, g_nr, f_nr, f_yv, f_nv, .. } = Ankudinov::of(ship, x);
    let (beam_m, draught_m) = (ship.beam_m, ship.draught_m);
    let block = ship.block_coefficient();
    let power = |exponent: f64| libm::pow(1.0 - x, -exponent) - x;
    let full = block * beam_m / draught_m;
    let slim = block * draught_m / beam_m;
    let hull = HullFactors {
        resistance: 1.0,
        x_vv: f_yv,
        // In the source, f_yr applies to X_vr alone, which is a small part of m_y + X_vr.
        x_vr: g_v,
        x_rr: f_nr,
        x_vvvv: f_yv,
        y_v: power(0.4 * full),
        y_r: cubic(
            x,
            [
                full * (26.0 - 5.5 * full) - 31.5,
                full * (37.0 * full - 185.0) + 230.0,
                full * (197.0 - 38.0 * full) - 250.0,
            ],
        ),
        y_vvv: f_yv,
        y_vvr: f_yv,
        y_vrr: f_yv,
        y_rrr: g_nr,
        n_v: f_nv,
        n_r: yaw_damping(ship, x),
        n_vvv: f_yv,
        n_vvr: cubic(x, [91.0 * slim - 25.0, 144.0 - 515.0 * slim, 508.0 * slim - 143.0]),
        n_vrr: cubic(x, [40.0 * full - 88.0, 645.0 - 295.0 * full, 312.0 * full - 678.0]),
        n_rrr: g_nr,
    };
    let mass = MassFactors { surge: 1.0, sway: g_v, yaw: g_nr };
    Corrections { hull, stern: stern(ship, x), mass }
}

/// Factor of shallow water on N_r: (1 − x)^(14.28 T/L − 1.5) − x with x = T/h, by Kijima et al. (1990).
fn yaw_damping(ship: &Particulars, x: f64) -> f64 {
    let slender = lesser(ship.draught_m / ship.length_m, DEEPEST_HULL);
    libm::pow(1.0 - x, 14.28 * slender - 1.5) - x
}

fn stern(ship: &Particulars, x: f64) -> SternFactors {
    let (length_m, beam_m, draught_m) = (ship.length_m, ship.beam_m, ship.draught_m);
    let block = ship.block_coefficient();
    let deep = block * length_m / draught_m;
    let long = block * length_m / beam_m;
    let thick = block * beam_m / length_m;
    let thrust = 29.495 + long * (1.6486 * long - 14.089);
    let shallower =
        1.0 + (-10.258 + thick * (178.207 - 686.25 * thick)) * (-3.854 + x * (13.665 - 10.468 * x));
    let deeper = 1.0 + (-135.25 + thick * (2432.95 - 10_137.7 * thick)) * libm::pow(x, 4.81);
    let is_deeper = x <= 0.581 - 0.332 * draught_m / beam_m;
    SternFactors {
        driving: 1.0 + thrust * (0.004 - 0.035 * x - 0.104 * x * x),
        wake: 1.0 + (-4.932 + deep * (0.6425 - 0.0165 * deep)) * libm::pow(x, 1.655),
        inflow: 1.0,
        straightening: if is_deeper { deeper } else { shallower },
    }
}

/// Computes the cubic 1 + a₁x + a₂x² + a₃x³.
fn cubic(x: f64, [a1, a2, a3]: [f64; 3]) -> f64 {
    1.0 + x * (a1 + x * (a2 + x * a3))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Calculated by hand for KVLCC2 at h/T 1.5: −2/3 + 3^(0.4·0.809744·2.788462), −2/3 + 3^(1.5 − 14.28·0.065).
    #[test]
    fn powers_agree_with_a_calculation_by_hand() {
        let ship = Particulars {
            length_m: 320.0,
            beam_m: 58.0,
            draught_m: 20.8,
            volume_m3: 312_600.0,
            centre_of_gravity_m: 11.2,
            yaw_gyradius_ratio: 0.25,
        };
        let hull = corrections(&ship, 1.0 / 1.5).hull;
        assert!((hull.y_v - 2.0306).abs() < 5e-5, "{}", hull.y_v);
        assert!((hull.n_r - 1.2075).abs() < 5e-5, "{}", hull.n_r);
    }
}
