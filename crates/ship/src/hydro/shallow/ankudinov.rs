//! Ankudinov's factors on added mass and derivatives (1990), as printed in a public implementation of Taimuri et al.
//! (2020) (nikpau/mmgdynamics). Ankudinov's factors are sums of K₀, K₁ and K₂, which are polynomials in T/(h − T),
//! weighted by block coefficient and beam.
//!
//! We made two corrections to the public program. For ships broader than four draughts, our K₂ has T/B where the public
//! program has B/T: the program's factor would jump by a factor of 16 at B/T = 4. Also, our code does not use
//! Ankudinov's factors beyond [`super::PUBLISHED_RATIO`].

use super::factors::{Corrections, HullFactors, MassFactors};
use super::limits::PUBLISHED_RATIO;
use super::stern;
use crate::hydro::particulars::Particulars;

/// Coefficients of Ankudinov's polynomial K₀ for the powers 2, 3 and 5 of T/(h − T).
const K0: [f64; 3] = [0.0775, -0.0110, 0.000_068];
/// Coefficients of Ankudinov's polynomial K₁ for the powers 1, 2, 3 and 5 of T/(h − T).
const K1: [f64; 4] = [-0.0643, 0.0724, -0.0113, 0.000_076_7];
/// Ankudinov's K₂ divided by T/(h − T).
const K2: f64 = 0.0342;
/// Ankudinov's K₂ divided by T/(h − T) and by T/B, for ships broader than four draughts.
const K2_BROAD: f64 = 0.137;

/// Ankudinov's factors for a ship, by their names in the source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ankudinov {
    pub(super) g_v: f64,
    pub(super) g_nr: f64,
    pub(super) f_yr: f64,
    pub(super) f_nr: f64,
    pub(super) f_yv: f64,
    pub(super) f_nv: f64,
}

impl Ankudinov {
    /// Ankudinov's factors for a ship at the given ratio T/h.
    pub(super) fn of(ship: &Particulars, share: f64) -> Ankudinov {
        let inverse_clearance = share / (1.0 - share);
        let factor = |linear, square| factor(ship, inverse_clearance, linear, square);
        let f_nr = factor(1.0 / 2.0, 1.0 / 3.0);
        Ankudinov {
            g_v: factor(2.0 / 3.0, 8.0 / 15.0),
            g_nr: factor(8.0 / 15.0, 40.0 / 105.0),
            f_yr: factor(2.0 / 5.0, 24.0 / 105.0),
            f_nr,
            f_yv: 1.5 * f_nr - 0.5,
            f_nv: factor(1.0, 1.0),
        }
    }

    /// The whole set of corrections by Ankudinov. The sum (m_y + X_vr) has the factor of m_y: for the tanker of van
    /// Berlekom & Goddard (1972) both increase at the same rate with T/(h − T). We chose the factor of m_y also for the
    /// added mass m_x in surge; m_x must suit Y_r, because Y_r u r acts against (m + m_x) u r. For comparison,
    /// Ankudinov's factors on the added mass in surge of the tanker of van Berlekom & Goddard are 3 at h/T 1.5 and 6 at
    /// 1.2. The formula of Li & Wu for the added mass in surge gives factors of 2.4 and 5.7 for KVLCC2, but a negative
    /// added mass for the container ship of Moreno et al. (2023).
    pub(super) fn corrections(&self, ship: &Particulars, share: f64) -> Corrections {
        let Ankudinov { g_v, g_nr, f_yr, f_nr, f_yv, f_nv } = *self;
        let hull = HullFactors {
            resistance: stern::resistance(share),
            x_vv: f_yv,
            x_vr: g_v,
            x_rr: f_nr,
            x_vvvv: f_yv,
            y_v: f_yv,
            y_r: f_yr,
            y_vvv: f_yv,
            y_vvr: f_yv,
            y_vrr: f_yv,
            y_rrr: g_nr,
            n_v: f_nv,
            n_r: f_nr,
            n_vvv: f_yv,
            n_vvr: f_nr,
            n_vrr: f_nr,
            n_rrr: g_nr,
        };
        let mass = MassFactors { surge: g_v, sway: g_v, yaw: g_nr };
        Corrections { hull, stern: stern::factors(ship, share), mass }
    }
}

/// A factor from K₀ + linear·K₁ b + square·K₂ b², b = Cb (B/T)(1 + B/L)², over z = T/(h − T); beyond the z of
/// [`PUBLISHED_RATIO`] the function continues along its tangent.
fn factor(ship: &Particulars, z: f64, linear: f64, square: f64) -> f64 {
    let broad = ship.beam_m / ship.draught_m;
    let wide = 1.0 + ship.beam_m / ship.length_m;
    let fullness = ship.block_coefficient() * broad * wide * wide;
    let k2 = if broad <= 4.0 { K2 } else { K2_BROAD / broad };
    let [a2, a3, a5] = K0;
    let [b1, b2, b3, b5] = K1.map(|k| k * linear * fullness);
    let c1 = b1 + k2 * square * fullness * fullness;
    let (c2, c3, c5) = (a2 + b2, a3 + b3, a5 + b5);
    let at = |z: f64| 1.0 + z * (c1 + z * (c2 + z * (c3 + z * z * c5)));
    let last = 1.0 / (PUBLISHED_RATIO - 1.0);
    if z <= last {
        return at(z);
    }
    let slope = c1 + last * (2.0 * c2 + last * (3.0 * c3 + last * last * 5.0 * c5));
    at(last) + slope * (z - last)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The expected factors were calculated independently, for KVLCC2 at h/T 1.5 and 1.2.
    #[test]
    fn factors_agree_with_a_calculation_by_hand() {
        let ship = Particulars {
            length_m: 320.0,
            beam_m: 58.0,
            draught_m: 20.8,
            volume_m3: 312_600.0,
            centre_of_gravity_m: 11.2,
            yaw_gyradius_ratio: 0.25,
        };
        let close = |ours: f64, theirs: f64| assert!((ours - theirs).abs() < 0.005, "{ours}");
        let half = Ankudinov::of(&ship, 1.0 / 1.5);
        close(half.g_v, 1.74);
        close(half.f_nv, 2.13);
        close(half.f_nr, 1.57);
        let fifth = Ankudinov::of(&ship, 1.0 / 1.2);
        close(fifth.g_v, 3.34);
        close(fifth.g_nr, 2.95);
        close(fifth.f_yr, 2.56);
        close(fifth.f_yv, 3.76);
        close(fifth.f_nv, 4.47);
    }
}
