//! A hull's main particulars, which are checked once.

use super::error::{HydroError, within};

/// Main particulars. Main particulars of a hull; [`Particulars::check`] rejects values out of range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particulars {
    /// Length between perpendiculars L (m).
    pub length_m: f64,
    /// Moulded beam B (m).
    pub beam_m: f64,
    /// Mean draught d (m).
    pub draught_m: f64,
    /// Displaced volume ∇ (m³).
    pub volume_m3: f64,
    /// Distance xG of the centre of gravity forward of midship (m).
    pub centre_of_gravity_m: f64,
    /// Radius of gyration in yaw about the centre of gravity, divided by the length L.
    pub yaw_gyradius_ratio: f64,
}

impl Particulars {
    /// Makes particulars from a block coefficient instead of a volume. The made particulars have the centre of gravity
    /// amidships and the gyradius 0.25 L (the usual assumption of the MMG method).
    ///
    /// # Errors
    /// See [`Particulars::check`].
    pub fn from_block(
        length_m: f64,
        beam_m: f64,
        draught_m: f64,
        block_coefficient: f64,
    ) -> Result<Particulars, HydroError> {
        within("block coefficient", block_coefficient, 0.1, 1.0)?;
        Particulars {
            length_m,
            beam_m,
            draught_m,
            volume_m3: block_coefficient * length_m * beam_m * draught_m,
            centre_of_gravity_m: 0.0,
            yaw_gyradius_ratio: 0.25,
        }
        .check()
    }

    /// Checks the particulars and returns them.
    ///
    /// # Errors
    /// Fails with [`HydroError::OutOfRange`], which names the first value out of range: dimensions that are not
    /// positive, a block coefficient outside 0.1 to 1, a beam above the length, a centre of gravity outside the ship, a
    /// gyradius outside 0.05 to 0.6 L.
    pub fn check(self) -> Result<Particulars, HydroError> {
        within("length between perpendiculars [m]", self.length_m, 0.1, 5000.0)?;
        within("beam [m]", self.beam_m, 0.01, self.length_m)?;
        within("draught [m]", self.draught_m, 0.001, self.length_m)?;
        within("displaced volume [m³]", self.volume_m3, 0.0, f64::MAX)?;
        within("block coefficient", self.block_coefficient(), 0.1, 1.0)?;
        let half_m = 0.5 * self.length_m;
        within(
            "centre of gravity forward of midship [m]",
            self.centre_of_gravity_m,
            -half_m,
            half_m,
        )?;
        within("yaw gyradius over length", self.yaw_gyradius_ratio, 0.05, 0.6)?;
        Ok(self)
    }

    /// Block coefficient Cb = ∇/(L B d).
    pub fn block_coefficient(&self) -> f64 {
        self.volume_m3 / (self.length_m * self.beam_m * self.draught_m)
    }

    /// The factor ½ L² d (m³) of MMG mass coefficients, without the density.
    pub fn mass_unit_m3(&self) -> f64 {
        0.5 * self.length_m * self.length_m * self.draught_m
    }

    /// The factor ½ L⁴ d (m⁵) of MMG coefficients of moments of inertia, without the density.
    pub fn inertia_unit_m5(&self) -> f64 {
        self.mass_unit_m3() * self.length_m * self.length_m
    }

    /// Moment of inertia in yaw about the centre of gravity, divided by the density (m⁵).
    pub fn yaw_inertia_m5(&self) -> f64 {
        let gyradius_m = self.yaw_gyradius_ratio * self.length_m;
        self.volume_m3 * gyradius_m * gyradius_m
    }
}
