//! A propeller in all four quadrants of speed of advance and revolutions.
//!
//! With the blade speed vp = 0.7πnD and the speed of advance va, the angle is β_p = atan2(va, vp) and the thrust T = ½ρ
//! c_T(β_p)(va² + vp²) πD²/4. The torque Q has the same form as the thrust, with another factor D. The form of thrust
//! and torque has no division by n or va, so that thrust is continuous through zero revolutions and zero speed.
//!
//! The thrust coefficient c_T is the ship's polynomial K_T = k₀ + k₁J + k₂J² in the measured range (0 ≤ β_p ≤ 30°).
//! Outside the measured range, c_T is the four-quadrant series of a Wageningen B4-70: for β_p < −25°, for β_p > 60°,
//! and for all revolutions astern. Between polynomial and series, c_T is a smooth interpolation, which is our addition.
//! The torque coefficient c_Q is always from the series, because no torque is published with the manoeuvring models.

use std::f64::consts::PI;

use super::propeller_series::{B4_70_PITCH_0_8, B4_70_PITCH_1_0, Harmonics};
use super::quantities::{Water, smooth_step};

/// Sine of β_p at the ends of the lower transition from the series to the polynomial (−25° to 0°).
const OWN_FROM: [f64; 2] = [-0.422_618_261_740_699_44, 0.0];
/// Sine of β_p at the ends of the upper transition from the polynomial to the series (30° to 60°).
const OWN_TO: [f64; 2] = [0.5, 0.866_025_403_784_438_6];

/// The propeller whose series is used in the quadrants without measurements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Series {
    /// Propeller Wageningen B4-70 with a pitch ratio of 0.8.
    B4Pitch08,
    /// Propeller Wageningen B4-70 with a pitch ratio of 1.0.
    B4Pitch10,
}

impl Series {
    fn harmonics(self) -> &'static Harmonics {
        match self {
            Series::B4Pitch08 => &B4_70_PITCH_0_8,
            Series::B4Pitch10 => &B4_70_PITCH_1_0,
        }
    }
}

/// A fixed-pitch propeller in open water.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Propeller {
    /// Diameter D (m).
    pub diameter_m: f64,
    /// Polynomial of the thrust coefficient K_T in J, [k₀, k₁, k₂], for the first quadrant; `None` to use the series.
    pub thrust_polynomial: Option<[f64; 3]>,
    /// The propeller series for the second to the fourth quadrant, and for the torque.
    pub series: Series,
}

impl Propeller {
    /// Thrust of the propeller (N), positive ahead, at a speed of advance (m/s) and revolutions (1/s) of either sign.
    pub fn thrust_n(&self, advance_mps: f64, shaft_rps: f64, water: Water) -> f64 {
        let flow = self.flow(advance_mps, shaft_rps);
        if flow.speed_squared == 0.0 {
            return 0.0;
        }
        self.pressure_area(&flow, water) * self.thrust_coefficient(flow.cos, flow.sin)
    }

    /// Torque of the propeller's shaft (N m), at a speed of advance (m/s) and revolutions (1/s).
    pub fn torque_nm(&self, advance_mps: f64, shaft_rps: f64, water: Water) -> f64 {
        let flow = self.flow(advance_mps, shaft_rps);
        if flow.speed_squared == 0.0 {
            return 0.0;
        }
        let torque = series_torque(self.series, flow.cos, flow.sin);
        self.pressure_area(&flow, water) * self.diameter_m * torque
    }

    /// The dynamic pressure times the disc area, ½ρ (va² + vp²) πD²/4 (N).
    fn pressure_area(&self, flow: &Flow, water: Water) -> f64 {
        let disc_m2 = 0.25 * PI * self.diameter_m * self.diameter_m;
        0.5 * water.density_kgpm3 * flow.speed_squared * disc_m2
    }

    fn flow(&self, advance_mps: f64, shaft_rps: f64) -> Flow {
        let blade_mps = 0.7 * PI * shaft_rps * self.diameter_m;
        let speed_squared = advance_mps * advance_mps + blade_mps * blade_mps;
        let speed_mps = speed_squared.sqrt();
        Flow { speed_squared, cos: blade_mps / speed_mps, sin: advance_mps / speed_mps }
    }

    /// Thrust coefficient c_T at an angle β_p, which is given by its cosine and sine.
    fn thrust_coefficient(&self, cos: f64, sin: f64) -> f64 {
        let Some(polynomial) = self.thrust_polynomial else {
            return series_thrust(self.series, cos, sin);
        };
        let own = own_weight(cos, sin);
        // The series costs thirty times as much as the polynomial, and most steps do not need it.
        if own == 1.0 {
            return polynomial_coefficient(polynomial, cos, sin);
        }
        let series = series_thrust(self.series, cos, sin);
        if own == 0.0 {
            return series;
        }
        own * polynomial_coefficient(polynomial, cos, sin) + (1.0 - own) * series
    }
}

struct Flow {
    speed_squared: f64,
    cos: f64,
    sin: f64,
}

/// Weight of the ship's polynomial in the thrust coefficient. The weight of the ship's polynomial is a smooth function
/// of β_p.
fn own_weight(cos: f64, sin: f64) -> f64 {
    if cos <= 0.0 {
        return 0.0;
    }
    let rise = smooth_step((sin - OWN_FROM[0]) / (OWN_FROM[1] - OWN_FROM[0]));
    let fall = smooth_step((sin - OWN_TO[0]) / (OWN_TO[1] - OWN_TO[0]));
    rise * (1.0 - fall)
}

/// The thrust coefficient c_T = 8K_T/(π(J² + (0.7π)²)), which is a quadratic form in cos β_p and sin β_p, because J =
/// 0.7π tan β_p.
fn polynomial_coefficient([k0, k1, k2]: [f64; 3], cos: f64, sin: f64) -> f64 {
    let revolutions = cos / (0.7 * PI);
    8.0 / PI * (k0 * revolutions * revolutions + k1 * revolutions * sin + k2 * sin * sin)
}

/// c_T of the series.
fn series_thrust(series: Series, cos: f64, sin: f64) -> f64 {
    1e-2 * series_sum(series.harmonics(), 0, cos, sin)
}

/// c_Q of the series.
fn series_torque(series: Series, cos: f64, sin: f64) -> f64 {
    -1e-3 * series_sum(series.harmonics(), 2, cos, sin)
}

/// The sum Σ A cos kβ + B sin kβ of the series, with A in one column and B in the next. The harmonics of the series
/// follow from a recurrence by 2β: even and odd harmonics are separate chains, which the processor computes in
/// parallel.
fn series_sum(harmonics: &Harmonics, column: usize, cos: f64, sin: f64) -> f64 {
    let (cos_2, sin_2) = (cos * cos - sin * sin, 2.0 * sin * cos);
    let turned = |(c, s): (f64, f64)| (c * cos_2 - s * sin_2, s * cos_2 + c * sin_2);
    let term = |row: &[f64; 4], (c, s): (f64, f64)| row[column] * c + row[column + 1] * s;
    let (mut even, mut odd) = ((1.0, 0.0), (cos, sin));
    let (mut even_sum, mut odd_sum) = (0.0, 0.0);
    let (pairs, last) = harmonics.as_chunks::<2>();
    for [even_row, odd_row] in pairs {
        even_sum += term(even_row, even);
        odd_sum += term(odd_row, odd);
        (even, odd) = (turned(even), turned(odd));
    }
    last.iter().fold(even_sum + odd_sum, |sum, row| sum + term(row, even))
}
