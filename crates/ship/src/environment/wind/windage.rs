//! Wind force on a ship, from the coefficients of a method.

use core::f64::consts::{PI, TAU};

use fenderline_contact::number::lesser;

use super::above_water::AboveWater;
use super::admittance::WindFront;
use super::coefficients::WindCoefficients;
use super::method::WindMethod;
use super::relative::RelativeWind;
use crate::range::{OutOfRange, within};

/// Wind areas of a ship, and the method for the ship's wind coefficients.
#[derive(Clone, Debug, PartialEq)]
pub struct ShipWindage {
    /// Length overall (m).
    pub length_m: f64,
    /// Beam (m).
    pub beam_m: f64,
    /// Frontal projected area of the ship above the water (m²).
    pub frontal_m2: f64,
    /// Lateral projected area of the ship above the water (m²).
    pub lateral_m2: f64,
    /// Distance of the lateral area's centroid forward of midship (m).
    pub centroid_forward_m: f64,
    /// Height of the lateral area's centroid above the waterline (m).
    pub centroid_height_m: f64,
    /// Method for the coefficients.
    pub method: WindMethod,
}

impl ShipWindage {
    /// Checks every number.
    ///
    /// Fails at the first number that is out of range. The number out of range may be a wind coefficient, if a
    /// regression is used far outside the range of ships from which it was derived.
    pub fn check(&self) -> Result<(), OutOfRange> {
        within("length overall [m]", self.length_m, 0.1, 2000.0)?;
        within("beam [m]", self.beam_m, 0.05, 500.0)?;
        within("frontal wind area [m²]", self.frontal_m2, 1e-4, 1e6)?;
        within("lateral wind area [m²]", self.lateral_m2, 1e-4, 1e6)?;
        let half_m = 0.5 * self.length_m;
        let forward_m = self.centroid_forward_m;
        within("centroid of the lateral area forward of midship [m]", forward_m, -half_m, half_m)?;
        within("height of the lateral area's centroid [m]", self.centroid_height_m, 1e-3, 200.0)?;
        self.method.check(&self.above_water())?;
        for ten in 0..=18 {
            let c = self.coefficients(f64::from(ten) * PI / 18.0);
            within(
                "coefficient of the longitudinal wind force for these particulars",
                c.surge,
                -3.0,
                3.0,
            )?;
            within(
                "coefficient of the lateral wind force for these particulars",
                c.sway,
                -3.0,
                3.0,
            )?;
            within("coefficient of the wind's yaw moment for these particulars", c.yaw, -1.0, 1.0)?;
        }
        Ok(())
    }

    /// The ship's wind coefficients at an angle γ (rad). The wind coefficients are computed for |γ| from 0 to π and
    /// mirrored, so that port and starboard agree at every angle, 180° included. A user's table that has both sides is
    /// used as it is, without mirroring.
    #[must_use]
    pub fn coefficients(&self, angle_rad: f64) -> WindCoefficients {
        let wrapped_rad = libm::remainder(angle_rad, TAU);
        let ship = self.above_water();
        if let WindMethod::Own(_) = self.method {
            return self.method.coefficients(&ship, wrapped_rad);
        }
        let from_port = self.method.coefficients(&ship, wrapped_rad.abs());
        // A wind from straight ahead or astern has no side force.
        let side =
            if wrapped_rad == 0.0 || wrapped_rad.abs() >= PI { 0.0 } else { wrapped_rad.signum() };
        WindCoefficients { sway: side * from_port.sway, yaw: side * from_port.yaw, ..from_port }
    }

    /// The data of the ship that the wind methods need.
    fn above_water(&self) -> AboveWater {
        AboveWater {
            length_m: self.length_m,
            beam_m: self.beam_m,
            frontal_m2: self.frontal_m2,
            lateral_m2: self.lateral_m2,
            centroid_forward_m: self.centroid_forward_m,
            centroid_height_m: self.centroid_height_m,
        }
    }

    /// The front that the ship turns to a wind at an angle γ (rad). The width of the front is L |sin γ| + B |cos γ|
    /// with the ship's length L and beam B; the height is A_L/L, the mean height of her side.
    #[must_use]
    pub fn front(&self, angle_rad: f64) -> WindFront {
        let across_m = self.length_m * libm::sin(angle_rad).abs();
        WindFront {
            width_m: across_m + self.beam_m * libm::cos(angle_rad).abs(),
            height_m: self.lateral_m2 / self.length_m,
        }
    }

    /// The least and the greatest width of [`ShipWindage::front`] (m): L |sin γ| + B |cos γ| is least with the wind
    /// ahead or abeam, and greatest in between.
    pub(super) fn widths_m(&self) -> [f64; 2] {
        let (length_m, beam_m) = (self.length_m, self.beam_m);
        [lesser(length_m, beam_m), libm::hypot(length_m, beam_m)]
    }

    /// Force and moment of the wind about midship, [X, Y, N] in (N, N, N·m), in air of a density (kg/m³), which is
    /// 1.224 at 15 °C. The relative wind for the force is the wind at [`ShipWindage::reference_height_m`].
    #[must_use]
    pub fn force(&self, relative: &RelativeWind, air_density_kgpm3: f64) -> [f64; 3] {
        let c = self.coefficients(relative.angle_rad);
        let pressure_npm2 = 0.5 * air_density_kgpm3 * relative.speed_mps * relative.speed_mps;
        [
            pressure_npm2 * c.surge * self.frontal_m2,
            pressure_npm2 * c.sway * self.lateral_m2,
            pressure_npm2 * c.yaw * self.lateral_m2 * self.length_m,
        ]
    }

    /// Height above the water at which the wind speed is to be taken for the coefficients (m). The reference height of
    /// the wind is 10 m, to which the methods refer (from memory), or the height that the user's table states.
    #[must_use]
    pub fn reference_height_m(&self) -> f64 {
        match &self.method {
            WindMethod::Own(table) => table.reference_height_m,
            WindMethod::Isherwood(_) | WindMethod::Blendermann(_) | WindMethod::Fujiwara(_) => 10.0,
        }
    }

    /// Heeling moment of the wind about the waterline for a side force Y, positive to starboard (N·m): K = κ·s_H·Y,
    /// with the height s_H of the lateral area's centroid. The factor κ is a parameter of Blendermann's method, and 1
    /// for the other methods.
    #[must_use]
    pub fn roll_moment_nm(&self, sway_n: f64) -> f64 {
        self.method.roll_factor() * self.centroid_height_m * sway_n
    }
}
