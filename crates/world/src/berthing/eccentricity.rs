//! Ce, the eccentricity factor: the share of the ship's energy that a contact away from midship absorbs. The rest of
//! the ship's energy remains as rotation of the ship.

use core::f64::consts::FRAC_PI_2;

use super::check::{ANGLE, ARM, BEAM, BERTHING_ANGLE, BLOCK_COEFFICIENT, GYRADIUS, LENGTH};
use super::error::BerthingError;

/// Radius of gyration about the vertical, K = (0.19·Cb + 0.11)·L_BP (m).
///
/// Source of the formula: found (public fender design manuals that cite PIANC 2002).
///
/// # Errors
/// Fails if a particular of the ship is out of range.
pub fn gyradius_m(block_coefficient: f64, length_bp_m: f64) -> Result<f64, BerthingError> {
    let block = BLOCK_COEFFICIENT.check(block_coefficient)?;
    Ok((0.19 * block + 0.11) * LENGTH.check(length_bp_m)?)
}

/// Ce = (K² + R² cos²γ)/(K² + R²), with the radius of gyration K (m), the distance R of the point of contact from the
/// centre of mass (m), and the angle γ between R and the velocity (rad).
///
/// Source of the formula: found (a part of PIANC 2002's kinetic method as public manuals print it). Mechanics gives the
/// same Ce for a ship without spin whose point of contact stops dead, without sliding and rebound; `tests/identities.rs`
/// compares the contact engine with this formula.
///
/// # Errors
/// Fails if a radius or an angle is out of range.
pub fn eccentricity_factor(
    gyradius_m: f64,
    radius_m: f64,
    velocity_angle_rad: f64,
) -> Result<f64, BerthingError> {
    let k = GYRADIUS.check(gyradius_m)?;
    let r = ARM.check(radius_m)?;
    let cos = libm::cos(ANGLE.check(velocity_angle_rad)?);
    Ok((k * k + r * r * cos * cos) / (k * k + r * r))
}

/// K²/(K² + a²): the part of the energy *along the normal* that a frictionless contact without rebound takes. Here a is
/// the lever arm of the normal force about the centre of mass (m).
///
/// Source of the formula: mechanics; `tests/identities.rs` compares the contact engine with this formula. PIANC's Ce is
/// for a contact that does not slide. The share of energy for a fender with a low-friction facing lies between Ce and
/// this factor.
///
/// # Errors
/// Fails if a radius or a lever arm is out of range.
pub fn frictionless_factor(gyradius_m: f64, arm_m: f64) -> Result<f64, BerthingError> {
    let k = GYRADIUS.check(gyradius_m)?;
    let a = ARM.check(arm_m)?;
    Ok(k * k / (k * k + a * a))
}

/// The point of contact on the parallel side of a ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPoint {
    /// Distance along the hull from the centre of mass, positive forward (m): L/4 for a quarter-point berthing, L/6 for
    /// a third-point berthing.
    pub along_m: f64,
    /// Beam of the ship (m); the point of contact lies half the beam off the centre line.
    pub beam_m: f64,
}

impl ContactPoint {
    /// Distance of the point of contact from the centre of mass (m): R = √(y² + (B/2)²).
    ///
    /// # Errors
    /// Fails if the point of contact is out of range.
    pub fn radius_m(&self) -> Result<f64, BerthingError> {
        let (along_m, beam_m) = (ARM.check(self.along_m)?, BEAM.check(self.beam_m)?);
        Ok(libm::hypot(along_m, 0.5 * beam_m))
    }

    /// Angle between R and the velocity (rad): γ = 90° − α − asin(B/2R), for a ship that moves square to the berth with
    /// her bow turned in by α. The arc sine is taken in the quadrant of the point of contact, so that γ is also right
    /// for a point aft of midships.
    ///
    /// # Errors
    /// Fails if the point of contact is out of range, or if the angle is beyond 90°.
    pub fn velocity_angle_rad(&self, berthing_angle_rad: f64) -> Result<f64, BerthingError> {
        let (along_m, beam_m) = (ARM.check(self.along_m)?, BEAM.check(self.beam_m)?);
        let angle_rad = BERTHING_ANGLE.check(berthing_angle_rad)?;
        Ok(FRAC_PI_2 - angle_rad - libm::atan2(0.5 * beam_m, along_m))
    }

    /// Ce of a berthing at this point of contact: [`eccentricity_factor`] with [`ContactPoint::radius_m`] and
    /// [`ContactPoint::velocity_angle_rad`].
    ///
    /// # Errors
    /// Fails like [`ContactPoint::radius_m`] and [`ContactPoint::velocity_angle_rad`].
    pub fn eccentricity(
        &self,
        gyradius_m: f64,
        berthing_angle_rad: f64,
    ) -> Result<f64, BerthingError> {
        // Aft of midships γ may lie beyond −180°; Ce depends only on its cosine squared.
        let gamma_rad =
            libm::remainder(self.velocity_angle_rad(berthing_angle_rad)?, core::f64::consts::PI);
        eccentricity_factor(gyradius_m, self.radius_m()?, gamma_rad)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand from the formula: Cb 0.796, L 236 m, B 43 m, third-point, 5°.
    #[test]
    fn the_published_example() {
        let contact = ContactPoint { along_m: 236.0 / 6.0, beam_m: 43.0 };
        let gyradius_m = gyradius_m(0.796, 236.0).unwrap();
        let ce = contact.eccentricity(gyradius_m, 5.0_f64.to_radians()).unwrap();
        assert!((ce - 0.760).abs() < 5e-4, "{ce}");
    }

    /// Closed forms: a hit in line with the centre of mass loses all energy, and Ce with γ = 90° equals the
    /// frictionless factor with a = R.
    #[test]
    fn the_limits_of_ce() {
        assert_eq!(eccentricity_factor(50.0, 40.0, 0.0), Ok(1.0));
        assert_eq!(eccentricity_factor(50.0, 0.0, 1.0), Ok(1.0));
        let square = eccentricity_factor(50.0, 40.0, FRAC_PI_2).unwrap();
        assert!((square - frictionless_factor(50.0, 40.0).unwrap()).abs() < 1e-15);
        assert_eq!(frictionless_factor(50.0, 50.0), Ok(0.5));
    }

    /// cos γ is the share of the velocity along the arm, wherever the point of contact lies.
    #[test]
    fn the_angle_is_that_between_arm_and_velocity() {
        for along_m in [-60.0, -10.0, 0.0, 25.0] {
            for angle_deg in [-80.0_f64, -10.0, 0.0, 5.0, 30.0, 85.0] {
                let contact = ContactPoint { along_m, beam_m: 30.0 };
                let angle_rad = angle_deg.to_radians();
                let gamma_rad = contact.velocity_angle_rad(angle_rad).unwrap();
                let along = (along_m * libm::sin(angle_rad) + 15.0 * libm::cos(angle_rad))
                    / contact.radius_m().unwrap();
                assert!((libm::cos(gamma_rad) - along).abs() < 1e-14, "{along_m} {angle_deg}");
                let ce = contact.eccentricity(30.0, angle_rad).unwrap();
                assert!((0.0..=1.0).contains(&ce));
            }
        }
    }

    #[test]
    fn impossible_particulars_are_refused_by_name() {
        let beamless = ContactPoint { along_m: 10.0, beam_m: 0.0 };
        assert!(beamless.radius_m().unwrap_err().to_string().starts_with("beam [m]"));
        let contact = ContactPoint { along_m: f64::INFINITY, beam_m: 30.0 };
        assert!(contact.eccentricity(30.0, 0.1).is_err());
        let contact = ContactPoint { along_m: 10.0, beam_m: 30.0 };
        assert!(contact.eccentricity(0.0, 0.1).unwrap_err().to_string().contains("gyration"));
        assert!(contact.eccentricity(30.0, 2.0).unwrap_err().to_string().contains("angle"));
        assert!(gyradius_m(1.2, 200.0).is_err());
    }
}
