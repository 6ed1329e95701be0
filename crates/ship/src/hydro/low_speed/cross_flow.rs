//! Cross-flow drag: each section of the hull has the drag of a plate in the local lateral flow.

use crate::hydro::quantities::{Force, Velocity, Water};

/// Drag coefficient of a section over the ratio B/2T, by Hoerner's curve as digitised in Fossen's MSS toolbox (the
/// points in its file Hoerner.m, after Leite et al., Applied Ocean Research 20, 1998).
const HOERNER: [[f64; 2]; 20] = [
    [0.0109, 1.9661],
    [0.1766, 1.9657],
    [0.3530, 1.8976],
    [0.4519, 1.7872],
    [0.4728, 1.5837],
    [0.4929, 1.2786],
    [0.4933, 1.2108],
    [0.5585, 1.0836],
    [0.6464, 0.9986],
    [0.8336, 0.8796],
    [0.9880, 0.8284],
    [1.3081, 0.7599],
    [1.6392, 0.6914],
    [1.8600, 0.6571],
    [2.3129, 0.6307],
    [2.6000, 0.5962],
    [3.0088, 0.5868],
    [3.4508, 0.5859],
    [3.7379, 0.5599],
    [4.0031, 0.5593],
];

/// Drag coefficient of a midship section by its beam and draught (m), linear between the points of Hoerner's curve, and
/// constant beyond the ends of the curve.
pub fn hoerner_drag_coefficient(beam_m: f64, draught_m: f64) -> f64 {
    let ratio = 0.5 * beam_m / draught_m;
    let [first, .., last] = HOERNER;
    if ratio <= first[0] {
        return first[1];
    }
    for pair in HOERNER.windows(2) {
        let [[x0, y0], [x1, y1]] = [pair[0], pair[1]];
        if ratio <= x1 {
            return y0 + (y1 - y0) * (ratio - x0) / (x1 - x0);
        }
    }
    last[1]
}

/// Cross-flow drag on a hull seen as a box of length L and draught T about midship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrossFlow {
    /// Drag coefficient C_D.
    pub drag_coefficient: f64,
    /// Factor C on the yaw rate in the cross-flow force; 1 for rigid-body flow.
    pub yaw_gain_force: f64,
    /// Factor C on the yaw rate in the cross-flow moment.
    pub yaw_gain_moment: f64,
}

impl CrossFlow {
    /// Computes Y = −½ρT C_D ∫|v + C r x|(v + C r x)dx and N = −½ρT C_D ∫|v + C r x|(v + C r x)x dx over the length.
    ///
    /// The integrals of the cross-flow drag are computed in closed form.
    pub fn force(&self, velocity: &Velocity, length_m: f64, draught_m: f64, water: Water) -> Force {
        let v_mps = velocity.sway_mps;
        let tip_mps = velocity.yaw_radps * length_m;
        let area = 0.5 * water.density_kgpm3 * draught_m * self.drag_coefficient * length_m;
        Force {
            surge_n: 0.0,
            sway_n: -area * square_mean(v_mps, self.yaw_gain_force * tip_mps),
            yaw_nm: -area * length_m * square_moment(v_mps, self.yaw_gain_moment * tip_mps),
        }
    }
}

/// Computes ∫|a + bξ|(a + bξ)dξ over ξ from −½ to ½.
fn square_mean(a: f64, b: f64) -> f64 {
    let half = 0.5 * b.abs();
    if a.abs() >= half {
        return (a * a + b * b / 12.0).copysign(a);
    }
    half * a + a * a * a / (3.0 * half)
}

/// Computes ∫|a + bξ|(a + bξ)ξ dξ over ξ from −½ to ½.
fn square_moment(a: f64, b: f64) -> f64 {
    let half = 0.5 * b.abs();
    if a.abs() >= half {
        return a.abs() * b / 6.0;
    }
    let divisor = 24.0 * half * half;
    if divisor == 0.0 {
        // The squares of both are too small to be represented.
        return 0.0;
    }
    let a2 = a * a;
    (half * half / 8.0 + a2 / 4.0 - a2 * a2 / divisor).copysign(b)
}
