//! Corrects the frictional resistance of a ship from model scale to full scale.
//!
//! The resistance coefficient of a tank model is larger than that of the full-scale ship, because the model's Reynolds
//! number is about a hundred times smaller. The difference in resistance between model and ship matters little in
//! turns, but the stopping distance is inversely proportional to the resistance.

use super::error::{HydroError, within};
use super::mmg::{Mmg, Polynomial};

/// Kinematic viscosity of the fresh water of a model tank at 15 °C (m²/s).
const TANK_M2PS: f64 = 1.139e-6;
/// Kinematic viscosity of sea water at 15 °C (m²/s).
pub(super) const SEA_M2PS: f64 = 1.189e-6;

/// Friction coefficient C_F = 0.075/(log₁₀ Re − 2)² by the ITTC 1957 model-ship correlation line (read in Morrall, NPL
/// Ship Report 142, 1970).
///
/// # Errors
/// Fails for a Reynolds number below 10⁴ or above 10¹¹.
pub fn ittc_1957(reynolds: f64) -> Result<f64, HydroError> {
    let reynolds = within("the Reynolds number", reynolds, 1e4, 1e11)?;
    let excess = libm::log10(reynolds) - 2.0;
    Ok(0.075 / (excess * excess))
}

impl Mmg {
    /// Gives the ship with her full-scale friction, from coefficients that contain a model's resistance. The correction
    /// of friction is the difference of the ITTC 1957 line between model and ship, at the Froude number of a speed
    /// (m/s), on the wetted surface 1.7Ld + ∇/d (UFC 4-159-03, eq. 18 and 19, read). Form factor and roughness
    /// allowance are neglected in the correction; they have opposite effects.
    ///
    /// # Errors
    /// Fails with [`HydroError::OutOfRange`] for a speed or a model length out of range, or if no resistance would be
    /// left.
    pub fn with_ships_friction(
        &self,
        model_length_m: f64,
        speed_mps: f64,
    ) -> Result<Mmg, HydroError> {
        let ship = &self.particulars;
        let scale =
            within("length of the model [m]", model_length_m, 0.1, ship.length_m)? / ship.length_m;
        let model = ittc_1957(speed_mps * scale.sqrt() * model_length_m / TANK_M2PS)?;
        let own = ittc_1957(speed_mps * ship.length_m / SEA_M2PS)?;
        let side_m2 = ship.length_m * ship.draught_m;
        let wetted_m2 = 1.7 * side_m2 + ship.volume_m3 / ship.draught_m;
        let less = (model - own) * wetted_m2 / side_m2;
        let mut changed = *self;
        let left = within("remaining resistance", -self.hull.low_speed.ahead - less, 1e-6, 1.0)?;
        changed.hull.low_speed.ahead = -left;
        changed.hull.low_speed.astern += less;
        match &mut changed.hull.under_way {
            Some(Polynomial::Sway(polynomial)) => polynomial.resistance -= less,
            Some(Polynomial::Drift(polynomial)) => polynomial.x_0 += less,
            Some(Polynomial::CrossFlow(hull)) => {
                hull.ahead += less;
                hull.astern += less;
            }
            None => {}
        }
        Ok(changed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Morrall's worked example: Re 5.62·10⁶, C_F 3.325·10⁻³. The tolerance is half a unit of the last digit of C_F,
    /// plus the same for the rounding of Re.
    #[test]
    fn the_ittc_line_gives_the_published_example() {
        let ours = ittc_1957(5.62e6).expect("in range");
        assert!((ours - 3.325e-3).abs() < 1.0e-6, "{ours}");
        assert!(ittc_1957(10.0).is_err());
    }
}
