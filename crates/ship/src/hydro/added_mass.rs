//! Added mass in surge, sway and yaw from main particulars.
//!
//! All added masses of this module are estimates, and reports call them estimates. Clarke's formula was read in a
//! public toolbox; the regression on Motora's charts was read in public programs. `fenderline validate` compares
//! Clarke's formula and the regression on Motora's charts with potential flow (validation/added_mass.toml).

use std::f64::consts::PI;

use super::error::HydroError;
use super::particulars::Particulars;

/// Added mass in surge, sway and yaw divided by the density of the water, about midship.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AddedMass {
    /// mx/ρ (m³).
    pub surge_m3: f64,
    /// my/ρ (m³).
    pub sway_m3: f64,
    /// Jz/ρ (m⁵).
    pub yaw_m5: f64,
}

impl AddedMass {
    /// Makes added mass from MMG coefficients: masses divided by ½ρL²d, moment of inertia divided by ½ρL⁴d.
    pub fn from_mmg(ship: &Particulars, surge: f64, sway: f64, yaw: f64) -> AddedMass {
        AddedMass {
            surge_m3: surge * ship.mass_unit_m3(),
            sway_m3: sway * ship.mass_unit_m3(),
            yaw_m5: yaw * ship.inertia_unit_m5(),
        }
    }

    /// Multiplies each component of this added mass by a factor, as is done for shallow water.
    pub fn scaled(&self, surge: f64, sway: f64, yaw: f64) -> AddedMass {
        AddedMass {
            surge_m3: self.surge_m3 * surge,
            sway_m3: self.sway_m3 * sway,
            yaw_m5: self.yaw_m5 * yaw,
        }
    }
}

/// Regression of Zhou, Sheng & Feng (1983) on Motora's charts, as printed in several public programs, which agree (sway
/// and yaw: nikpau/mmgdynamics). The paper of Zhou, Sheng & Feng was not read.
///
/// # Errors
/// Fails with [`HydroError::NegativeAddedMass`] if the hull is outside the range of the charts.
pub fn zhou_added_mass(ship: &Particulars) -> Result<AddedMass, HydroError> {
    let block = ship.block_coefficient();
    let (length_m, beam_m, draught_m) = (ship.length_m, ship.beam_m, ship.draught_m);
    let slender = length_m / beam_m;
    let depth = draught_m / beam_m;
    let cross = draught_m * length_m / (beam_m * beam_m);
    let surge = (0.398 + 11.97 * block * (1.0 + 3.73 * depth)
        - 2.89 * block * slender * (1.0 + 1.13 * depth)
        + 0.175 * block * slender * slender * (1.0 + 0.541 * depth)
        - 1.107 * cross)
        / 100.0;
    let sway = 0.882 - 0.54 * block * (1.0 - 1.6 * depth) - 0.156 * (1.0 - 0.673 * block) * slender
        + 0.826 * cross * (1.0 - 0.678 * depth)
        - 0.638 * block * cross * (1.0 - 0.669 * depth);
    let gyradius_m = length_m / 100.0
        * (33.0 - 76.85 * block * (1.0 - 0.784 * block) + 3.43 * slender * (1.0 - 0.63 * block));
    positive("the Zhou regression", "surge added mass over mass", surge)?;
    positive("the Zhou regression", "sway added mass over mass", sway)?;
    positive("the Zhou regression", "yaw radius of added inertia [m]", gyradius_m)?;
    Ok(AddedMass {
        surge_m3: surge * ship.volume_m3,
        sway_m3: sway * ship.volume_m3,
        yaw_m5: ship.volume_m3 * gyradius_m * gyradius_m,
    })
}

/// Added mass in sway (m³) and in yaw (m⁵) by Clarke, Gedling & Hine (1983), read in clarke83.m of the MSS toolbox,
/// both divided by the density: −Y'v̇ = π(T/L)²[1 + 0.16 Cb B/T − 5.1 (B/L)²] by ½ρL³ and −N'ṙ = π(T/L)²[1/12 + 0.017
/// Cb B/T − 0.33 B/L] by ½ρL⁵.
///
/// # Errors
/// Fails with [`HydroError::NegativeAddedMass`] for a stubby hull, for which the formula turns negative.
pub fn clarke_added_mass(ship: &Particulars) -> Result<(f64, f64), HydroError> {
    let (length_m, beam_m) = (ship.length_m, ship.beam_m);
    let depth = ship.draught_m / length_m;
    let stubby = beam_m / length_m;
    let full = ship.block_coefficient() * beam_m / ship.draught_m;
    let sway = PI * depth * depth * (1.0 + 0.16 * full - 5.1 * stubby * stubby);
    let yaw = PI * depth * depth * (1.0 / 12.0 + 0.017 * full - 0.33 * stubby);
    positive("Clarke's formula", "sway added mass", sway)?;
    positive("Clarke's formula", "yaw added inertia", yaw)?;
    let cube_m3 = length_m * length_m * length_m;
    Ok((0.5 * cube_m3 * sway, 0.5 * cube_m3 * length_m * length_m * yaw))
}

fn positive(
    formula: &'static str,
    coefficient: &'static str,
    value: f64,
) -> Result<(), HydroError> {
    if value > 0.0 {
        return Ok(());
    }
    Err(HydroError::NegativeAddedMass { formula, coefficient, value })
}
