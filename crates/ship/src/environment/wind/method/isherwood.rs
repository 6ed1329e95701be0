//! Wind coefficients by Isherwood (1972), from a regression over merchant ships.

use fenderline_contact::number::bounded;

use crate::environment::wind::above_water::AboveWater;
use crate::environment::wind::coefficients::WindCoefficients;
use crate::range::{OutOfRange, within};

/// The method of Isherwood, "Wind resistance of merchant ships", Transactions of RINA 115 (1972).
///
/// The formulas are CX = −(A₀ + A₁·2A_L/L² + A₂·2A_F/B² + A₃·L/B + A₄·S/L + A₅·C/L + A₆·M), CY = B₀ + B₁·2A_L/L² +
/// B₂·2A_F/B² + B₃·L/B + B₄·S/L + B₅·C/L + B₆·A_SS/A_L and CN = C₀ + C₁·2A_L/L² + C₂·2A_F/B² + C₃·L/B + C₄·S/L +
/// C₅·C/L, where C without an index is the distance of the lateral area's centroid from the bow. The tables give the
/// coefficients every 10° of the wind angle, with linear interpolation between. Isherwood's tables were found in
/// Fossen's toolbox, which prints them; the paper was not read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isherwood {
    /// Length S of the perimeter of the lateral projection, without waterline, masts and ventilators (m).
    pub perimeter_m: f64,
    /// Lateral projected area A_SS of the superstructure (m²).
    pub superstructure_m2: f64,
    /// Number M of groups of masts or king posts in the side view.
    pub mast_groups: f64,
}

impl Isherwood {
    /// Checks that the perimeter of the side view is at least the length of the ship, and the superstructure at most
    /// the lateral area.
    pub(super) fn check(&self, ship: &AboveWater) -> Result<(), OutOfRange> {
        let perimeter = "perimeter of the lateral projection [m]";
        within(perimeter, self.perimeter_m, ship.length_m, 10.0 * ship.length_m)?;
        let superstructure = "lateral area of the superstructure [m²]";
        within(superstructure, self.superstructure_m2, 0.0, ship.lateral_m2)?;
        within("number of mast groups", self.mast_groups, 0.0, 50.0)?;
        Ok(())
    }

    /// Wind coefficients by Isherwood at an angle from 0 to π.
    pub(super) fn coefficients(&self, ship: &AboveWater, angle_rad: f64) -> WindCoefficients {
        let (l, b) = (ship.length_m, ship.beam_m);
        let from_bow_m = 0.5 * l - ship.centroid_forward_m;
        let terms = [
            1.0,
            2.0 * ship.lateral_m2 / (l * l),
            2.0 * ship.frontal_m2 / (b * b),
            l / b,
            self.perimeter_m / l,
            from_bow_m / l,
        ];
        let sum = |row: &[f64]| -> f64 { row.iter().zip(&terms).map(|(c, t)| c * t).sum() };
        let at = |k: usize| WindCoefficients {
            surge: -(sum(&CX[k][..6]) + CX[k][6] * self.mast_groups),
            sway: sum(&CY[k][..6]) + CY[k][6] * self.superstructure_m2 / ship.lateral_m2,
            yaw: sum(&CN[k]),
        };
        let tens = bounded(angle_rad.to_degrees() / 10.0, 0.0, 18.0);
        let low = (tens as usize).min(17);
        let share = tens - low as f64;
        let (one, two) = (at(low), at(low + 1));
        let mix = |a: f64, b: f64| a + share * (b - a);
        WindCoefficients {
            surge: mix(one.surge, two.surge),
            sway: mix(one.sway, two.sway),
            yaw: mix(one.yaw, two.yaw),
        }
    }
}

/// Isherwood's coefficients A₀ to A₆ of the longitudinal force at 0°, 10° … 180°.
#[rustfmt::skip]
#[allow(clippy::approx_constant, reason = "the 3.14 in the table is a coefficient, not π")]
static CX: [[f64; 7]; 19] = [
    [ 2.152, -5.00,  0.243, -0.164,  0.0,    0.0,   0.0],
    [ 1.714, -3.33,  0.145, -0.121,  0.0,    0.0,   0.0],
    [ 1.818, -3.97,  0.211, -0.143,  0.0,    0.0,   0.033],
    [ 1.965, -4.81,  0.243, -0.154,  0.0,    0.0,   0.041],
    [ 2.333, -5.99,  0.247, -0.190,  0.0,    0.0,   0.042],
    [ 1.726, -6.54,  0.189, -0.173,  0.348,  0.0,   0.048],
    [ 0.913, -4.68,  0.0,   -0.104,  0.482,  0.0,   0.052],
    [ 0.457, -2.88,  0.0,   -0.068,  0.346,  0.0,   0.043],
    [ 0.341, -0.91,  0.0,   -0.031,  0.0,    0.0,   0.032],
    [ 0.355,  0.0,   0.0,    0.0,   -0.247,  0.0,   0.018],
    [ 0.601,  0.0,   0.0,    0.0,   -0.372,  0.0,  -0.020],
    [ 0.651,  1.29,  0.0,    0.0,   -0.582,  0.0,  -0.031],
    [ 0.564,  2.54,  0.0,    0.0,   -0.748,  0.0,  -0.024],
    [-0.142,  3.58,  0.0,    0.047, -0.700,  0.0,  -0.028],
    [-0.677,  3.64,  0.0,    0.069, -0.529,  0.0,  -0.032],
    [-0.723,  3.14,  0.0,    0.064, -0.475,  0.0,  -0.032],
    [-2.148,  2.56,  0.0,    0.081,  0.0,    1.27, -0.027],
    [-2.707,  3.97, -0.175,  0.126,  0.0,    1.81,  0.0],
    [-2.529,  3.76, -0.174,  0.128,  0.0,    1.55,  0.0],
];

/// Isherwood's coefficients B₀ to B₆ of the lateral force at 0°, 10° … 180°.
#[rustfmt::skip]
static CY: [[f64; 7]; 19] = [
    [0.0,   0.0,  0.0,    0.0,    0.0,    0.0,  0.0],
    [0.096, 0.22, 0.0,    0.0,    0.0,    0.0,  0.0],
    [0.176, 0.71, 0.0,    0.0,    0.0,    0.0,  0.0],
    [0.225, 1.38, 0.0,    0.023,  0.0,   -0.29, 0.0],
    [0.329, 1.82, 0.0,    0.043,  0.0,   -0.59, 0.0],
    [1.164, 1.26, 0.121,  0.0,   -0.242, -0.95, 0.0],
    [1.163, 0.96, 0.101,  0.0,   -0.177, -0.88, 0.0],
    [0.916, 0.53, 0.069,  0.0,    0.0,   -0.65, 0.0],
    [0.844, 0.55, 0.082,  0.0,    0.0,   -0.54, 0.0],
    [0.889, 0.0,  0.138,  0.0,    0.0,   -0.66, 0.0],
    [0.799, 0.0,  0.155,  0.0,    0.0,   -0.55, 0.0],
    [0.797, 0.0,  0.151,  0.0,    0.0,   -0.55, 0.0],
    [0.996, 0.0,  0.184,  0.0,   -0.212, -0.66, 0.34],
    [1.014, 0.0,  0.191,  0.0,   -0.280, -0.69, 0.44],
    [0.784, 0.0,  0.166,  0.0,   -0.209, -0.53, 0.38],
    [0.536, 0.0,  0.176, -0.029, -0.163,  0.0,  0.27],
    [0.251, 0.0,  0.106, -0.022,  0.0,    0.0,  0.0],
    [0.125, 0.0,  0.046, -0.012,  0.0,    0.0,  0.0],
    [0.0,   0.0,  0.0,    0.0,    0.0,    0.0,  0.0],
];

/// Isherwood's coefficients C₀ to C₅ of the yaw moment at 0°, 10° … 180°.
#[rustfmt::skip]
static CN: [[f64; 6]; 19] = [
    [ 0.0,    0.0,    0.0,    0.0,    0.0,     0.0],
    [ 0.0596, 0.061,  0.0,    0.0,    0.0,    -0.074],
    [ 0.1106, 0.204,  0.0,    0.0,    0.0,    -0.170],
    [ 0.2258, 0.245,  0.0,    0.0,    0.0,    -0.380],
    [ 0.2017, 0.457,  0.0,    0.0067, 0.0,    -0.472],
    [ 0.1759, 0.573,  0.0,    0.0118, 0.0,    -0.523],
    [ 0.1925, 0.480,  0.0,    0.0115, 0.0,    -0.546],
    [ 0.2133, 0.315,  0.0,    0.0081, 0.0,    -0.526],
    [ 0.1827, 0.254,  0.0,    0.0053, 0.0,    -0.443],
    [ 0.2627, 0.0,    0.0,    0.0,    0.0,    -0.508],
    [ 0.2102, 0.0,   -0.0195, 0.0,    0.0335, -0.492],
    [ 0.1567, 0.0,   -0.0258, 0.0,    0.0497, -0.457],
    [ 0.0801, 0.0,   -0.0311, 0.0,    0.0740, -0.396],
    [-0.0189, 0.0,   -0.0488, 0.0101, 0.1128, -0.420],
    [ 0.0256, 0.0,   -0.0422, 0.0100, 0.0889, -0.463],
    [ 0.0552, 0.0,   -0.0381, 0.0109, 0.0689, -0.476],
    [ 0.0881, 0.0,   -0.0306, 0.0091, 0.0366, -0.415],
    [ 0.0851, 0.0,   -0.0122, 0.0025, 0.0,    -0.220],
    [ 0.0,    0.0,    0.0,    0.0,    0.0,     0.0],
];
