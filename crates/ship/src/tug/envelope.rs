//! The force that a tug can give at speed.

use fenderline_contact::number::greater;

use crate::range::{OutOfRange, within};

/// Limits of the force of a tug that moves with a ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TugEnvelope {
    /// Bollard pull (N).
    pub bollard_pull_n: f64,
    /// Length of the tug on the waterline (m).
    pub length_m: f64,
    /// Beam (m).
    pub beam_m: f64,
    /// Draught of the tug's hull and skeg (m).
    pub draught_m: f64,
    /// Drag coefficient of the tug's hull across the flow; our value for a tug with her side to the flow is 0.73.
    pub drag_coefficient: f64,
}

impl TugEnvelope {
    /// Checks every number.
    ///
    /// # Errors
    /// Fails at the first number of the tug that is out of range, and names it.
    pub fn check(&self) -> Result<(), OutOfRange> {
        within("bollard pull [N]", self.bollard_pull_n, 1.0, 1e8)?;
        within("length of the tug [m]", self.length_m, 1.0, 200.0)?;
        within("beam of the tug [m]", self.beam_m, 0.5, 100.0)?;
        within("draught of the tug [m]", self.draught_m, 0.1, 30.0)?;
        within("drag coefficient of the tug", self.drag_coefficient, 0.0, 5.0)?;
        Ok(())
    }

    /// The greatest force (N) that the tug can give at an angle (rad) from the direction of motion of tug and ship
    /// through the water, at a speed (m/s).
    ///
    /// We derived the formula of the tug's force; it is not validated, because no published envelope was found. In this
    /// formula the tug lies along the direction of her force. The tug's thrust, at most the bollard pull BP, gives the
    /// force F and overcomes her drag D against the motion: |F·e + D·x| = BP. The tug's force is therefore F = √(BP² −
    /// D² sin²θ) − D cos θ. With the tug's side to the motion, her force is F = √(BP² − D²), and 0 if BP < D. The drag
    /// is D = ½ρ Cd T V² (L sin²θ + B cos²θ): the flow meets her side when she pushes across the motion, and her end
    /// when she pushes along it (with the same Cd; our choice). Drag that assists the tug (cos θ < 0) is neglected, so
    /// that the force never exceeds the bollard pull.
    #[must_use]
    pub fn available_n(&self, angle_rad: f64, speed_mps: f64, water_density_kgpm3: f64) -> f64 {
        let (sin, cos) = (libm::sin(angle_rad), libm::cos(angle_rad));
        let side_m = self.length_m * sin * sin + self.beam_m * cos * cos;
        let area_m2 = self.drag_coefficient * self.draught_m * side_m;
        let drag_n = 0.5 * water_density_kgpm3 * area_m2 * speed_mps * speed_mps;
        let across_n = drag_n * sin;
        let along_squared = self.bollard_pull_n * self.bollard_pull_n - across_n * across_n;
        // If this is below 0 the tug cannot keep up with the ship, and gives no force.
        let force_n = greater(along_squared, 0.0).sqrt() - drag_n * greater(cos, 0.0);
        greater(force_n, 0.0)
    }
}
