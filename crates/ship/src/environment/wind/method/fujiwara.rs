//! Wind coefficients by Fujiwara et al. (1998), who give them as Fourier series in the wind angle.

use crate::environment::wind::above_water::AboveWater;
use crate::environment::wind::coefficients::WindCoefficients;
use crate::range::{OutOfRange, within};

/// The method of Fujiwara, Ueno & Nimura, "Estimation of wind forces and moments acting on ships", Journal of the
/// Society of Naval Architects of Japan 183 (1998): CX in cos γ, cos 3γ, cos 5γ; CY in sin γ, sin 3γ, sin 5γ; CN in sin
/// γ, sin 2γ, sin 3γ. Each Fourier coefficient comes from a regression over ships with a superstructure.
///
/// The coefficients were found in a public code of the Esso Osaka free-running model, which prints all of them and says
/// they are Fujiwara's; the paper was not read. In a head wind the result of Fujiwara's method of 1998 differs by 5 %
/// from the later formula of ISO 15016 for the Esso Osaka, but is 20 to 36 % larger for a loaded container ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fujiwara {
    /// Lateral projected area A_OD of superstructures, tanks and containers on the deck (m²).
    pub on_deck_m2: f64,
    /// Distance forward of midship of the centroid of the area A_OD on deck (m).
    pub on_deck_forward_m: f64,
    /// Height H_BR of the top of the superstructure above the waterline (m).
    pub top_height_m: f64,
}

impl Fujiwara {
    /// Checks that the area on deck is at most the lateral area, and that its centroid is within the length of the
    /// ship.
    pub(super) fn check(&self, ship: &AboveWater) -> Result<(), OutOfRange> {
        within("lateral area on deck [m²]", self.on_deck_m2, 1e-4, ship.lateral_m2)?;
        let half_m = 0.5 * ship.length_m;
        within("centroid of the area on deck [m]", self.on_deck_forward_m, -half_m, half_m)?;
        within("height of the superstructure [m]", self.top_height_m, 1e-3, 300.0)?;
        Ok(())
    }

    /// Wind coefficients by Fujiwara at an angle from 0 to π.
    #[rustfmt::skip]
    pub(super) fn coefficients(&self, ship: &AboveWater, angle_rad: f64) -> WindCoefficients {
        let (l, b) = (ship.length_m, ship.beam_m);
        let (at, al, aod) = (ship.frontal_m2, ship.lateral_m2, self.on_deck_m2);
        let (xl, zl) = (ship.centroid_forward_m, ship.centroid_height_m);
        let (xod, h) = (self.on_deck_forward_m, self.top_height_m);

        let x0 = -0.330 + 0.293 * b * h / at + 0.0193 * xl / zl + 0.682 * aod / (l * l);
        let x1 = -1.353 + 1.700 * al / (l * b) + 2.870 * l * zl / al - 0.463 * l * h / al
            - 0.570 * aod / al - 6.640 * at / (l * b) - 0.0123 * l * l / at + 0.0202 * l / zl;
        let x3 = 0.830 - 0.413 * al / (l * h) - 0.0827 * al / at - 0.563 * l * zl / al
            + 0.804 * aod / al - 5.670 * aod / (l * l) + 0.0401 * xl / zl - 0.132 * xod / l;
        let x5 = 0.0372 - 0.0075 * al / aod - 0.103 * xod / l + 0.0921 * al / (l * b);

        let y1 = 0.684 + 0.717 * xod / l - 3.220 * xl / l + 0.0281 * al / aod + 0.0661 * xl / zl
            + 0.298 * at / (b * h);
        let y3 = -0.400 + 0.282 * al / (l * b) + 0.307 * l * zl / al + 0.0519 * xod / l
            + 0.0526 * b / h - 0.0814 * aod / al + 0.0582 * at / (b * h);
        let y5 = 0.122 - 0.166 * al / (l * b) - 0.0054 * l / h - 0.0481 * xod / l
            - 0.0136 * b * b / at + 0.0864 * xl / l - 0.0297 * l * zl / al;

        let n1 = 0.299 + 1.710 * xl / l + 0.183 * l * zl / al - 1.090 * at / al - 0.0442 * xl / zl
            - 0.289 * al / (l * b) + 4.240 * at / (l * l) - 0.0646 * b * b / at + 0.0306 * xod / l;
        let n2 = 0.117 + 0.123 * xod / l - 0.323 * xl / l + 0.0041 * al / aod - 0.166 * at / (b * b)
            - 0.0109 * l / h + 0.174 * at / (b * h) + 0.214 * al / (l * b) - 1.060 * al / (l * l);
        let n3 = 0.0230 + 0.0385 * xod / l - 0.0339 * at / (b * h) + 0.0023 * al / at;

        let (sin, cos) = (libm::sin, libm::cos);
        let a = angle_rad;
        WindCoefficients {
            surge: x0 + x1 * cos(a) + x3 * cos(3.0 * a) + x5 * cos(5.0 * a),
            sway: y1 * sin(a) + y3 * sin(3.0 * a) + y5 * sin(5.0 * a),
            yaw: n1 * sin(a) + n2 * sin(2.0 * a) + n3 * sin(3.0 * a),
        }
    }
}
