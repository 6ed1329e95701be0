//! Wind coefficients by Blendermann (1994), who gives each type of ship a few parameters.

use core::f64::consts::FRAC_PI_2;

use crate::environment::wind::above_water::AboveWater;
use crate::environment::wind::coefficients::WindCoefficients;
use crate::range::{OutOfRange, within};

/// The method of Blendermann, "Parameter identification of wind loads on ships", Journal of Wind Engineering and
/// Industrial Aerodynamics 51 (1994).
///
/// The formulas are, with CDl = CDlAF·A_F/A_L and den = 1 − ½δ(1 − CDl/CDt) sin²2γ: CX = −CDlAF·cosγ/den (on A_F), CY =
/// CDt·sinγ/den, CN = (s_L/L − 0.18(γ − π/2))·CY. Blendermann's formulas were found in Fossen's toolbox, which prints
/// them with the table of ship types. Fossen's toolbox uses γ − π/2 also for negative γ, so that its results for port
/// and starboard differ. Our code uses |γ| and mirrors the result, so that port and starboard are alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blendermann {
    /// Blendermann's parameters for the type of ship.
    pub kind: BlendermannType,
}

/// Blendermann's parameters of one type of ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlendermannType {
    /// Name of the type.
    pub name: &'static str,
    /// CDt, transverse drag coefficient.
    pub across: f64,
    /// Longitudinal drag coefficient CDlAF on the frontal area, for wind from forward of the beam.
    pub along_from_ahead: f64,
    /// Longitudinal drag coefficient CDlAF on the frontal area, for wind from abaft the beam.
    pub along_from_astern: f64,
    /// δ, cross-force parameter.
    pub cross_force: f64,
    /// κ, rolling-moment factor.
    pub roll_factor: f64,
}

const fn kind(name: &'static str, p: [f64; 5]) -> BlendermannType {
    BlendermannType {
        name,
        across: p[0],
        along_from_ahead: p[1],
        along_from_astern: p[2],
        cross_force: p[3],
        roll_factor: p[4],
    }
}

/// Blendermann's table of ship types with CDt, CDlAF(0), CDlAF(π), δ and κ. Blendermann's table was found in Fossen's
/// toolbox; the original was not read. The values CDlAF of the drilling vessel are means of the range that the table
/// gives.
pub static BLENDERMANN_TYPES: [BlendermannType; 17] = [
    kind("car carrier", [0.95, 0.55, 0.60, 0.80, 1.2]),
    kind("cargo vessel, loaded", [0.85, 0.65, 0.55, 0.40, 1.7]),
    kind("cargo vessel, container on deck", [0.85, 0.55, 0.50, 0.40, 1.4]),
    kind("container ship, loaded", [0.90, 0.55, 0.55, 0.40, 1.4]),
    kind("destroyer", [0.85, 0.60, 0.65, 0.65, 1.1]),
    kind("diving support vessel", [0.90, 0.60, 0.80, 0.55, 1.7]),
    kind("drilling vessel", [1.00, 0.85, 0.925, 0.10, 1.7]),
    kind("ferry", [0.90, 0.45, 0.50, 0.80, 1.1]),
    kind("fishing vessel", [0.95, 0.70, 0.70, 0.40, 1.1]),
    kind("gas tanker", [0.70, 0.60, 0.65, 0.50, 1.1]),
    kind("offshore supply vessel", [0.90, 0.55, 0.80, 0.55, 1.2]),
    kind("passenger liner", [0.90, 0.40, 0.40, 0.80, 1.2]),
    kind("research vessel", [0.85, 0.55, 0.65, 0.60, 1.4]),
    kind("speed boat", [0.90, 0.55, 0.60, 0.60, 1.1]),
    kind("tanker, loaded", [0.70, 0.90, 0.55, 0.40, 3.1]),
    kind("tanker, in ballast", [0.70, 0.75, 0.55, 0.40, 2.2]),
    kind("tender", [0.85, 0.55, 0.55, 0.65, 1.1]),
];

impl Blendermann {
    /// Finds the parameters of a type of ship in [`BLENDERMANN_TYPES`]; `None` if there is no such type.
    #[must_use]
    pub fn of_type(name: &str) -> Option<Blendermann> {
        let kind = BLENDERMANN_TYPES.iter().find(|kind| kind.name == name)?;
        Some(Blendermann { kind: *kind })
    }

    pub(super) fn check(&self) -> Result<(), OutOfRange> {
        let k = &self.kind;
        within("transverse wind drag CDt", k.across, 0.1, 3.0)?;
        within("longitudinal wind drag CDl from ahead", k.along_from_ahead, 0.0, 3.0)?;
        within("longitudinal wind drag CDl from astern", k.along_from_astern, 0.0, 3.0)?;
        within("cross-force parameter δ", k.cross_force, 0.0, 1.0)?;
        within("rolling-moment factor κ", k.roll_factor, 0.0, 10.0)?;
        Ok(())
    }

    /// Wind coefficients by Blendermann at an angle from 0 to π. The coefficient CDlAF changes at 90°, but the force is
    /// continuous there, as cos γ and sin 2γ are zero.
    pub(super) fn coefficients(&self, ship: &AboveWater, angle_rad: f64) -> WindCoefficients {
        let k = &self.kind;
        let along = if angle_rad <= FRAC_PI_2 { k.along_from_ahead } else { k.along_from_astern };
        let along_on_lateral = along * ship.frontal_m2 / ship.lateral_m2;
        let double = libm::sin(2.0 * angle_rad);
        let den = 1.0 - 0.5 * k.cross_force * (1.0 - along_on_lateral / k.across) * double * double;
        let sway = k.across * libm::sin(angle_rad) / den;
        let arm = ship.centroid_forward_m / ship.length_m - 0.18 * (angle_rad - FRAC_PI_2);
        WindCoefficients { surge: -along * libm::cos(angle_rad) / den, sway, yaw: arm * sway }
    }
}
