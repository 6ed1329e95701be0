//! The berthing energy, and the factors of the energy that are chosen by category.

use super::check::{DISPLACEMENT, Range, SPEED};
use super::error::BerthingError;

/// Cs, softness factor: the share of the energy that the hull does not absorb.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Softness {
    /// Soft fender: the hull absorbs no energy.
    Soft,
    /// Hard fender: the hull absorbs a tenth of the energy.
    Hard,
}

impl Softness {
    /// Cs, 1.0 or 0.9. Source of the factor: found (public fender design manuals).
    #[must_use]
    pub fn factor(self) -> f64 {
        match self {
            Softness::Soft => 1.0,
            Softness::Hard => 0.9,
        }
    }
}

/// Cc, configuration factor, which accounts for the cushion of water between hull and berth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Configuration {
    /// A solid quay.
    SolidQuay,
    /// A partly open structure.
    SemiOpen,
    /// A jetty on open piles, with no water cushion between hull and berth.
    OpenPiles,
}

impl Configuration {
    /// The configuration factor Cc: 0.8, 0.9 or 1.0. Source of the factor: found (public fender design manuals).
    #[must_use]
    pub fn factor(self) -> f64 {
        match self {
            Configuration::SolidQuay => 0.8,
            Configuration::SemiOpen => 0.9,
            Configuration::OpenPiles => 1.0,
        }
    }
}

/// The displacement and speed of a berthing ship, and the four factors of her berthing energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BerthingEnergy {
    /// Displacement M of the ship without added mass (kg).
    pub displacement_kg: f64,
    /// Speed V of the ship square to the berth at the moment of contact (m/s).
    pub speed_mps: f64,
    /// Cm, 1 or more.
    pub added_mass: f64,
    /// Ce, 0 to 1.
    pub eccentricity: f64,
    /// Cs, 0 to 1.
    pub softness: f64,
    /// Cc, 0 to 1.
    pub configuration: f64,
}

static ADDED_MASS: Range = Range::new("added mass factor Cm", 1.0, 10.0);
static ECCENTRICITY: Range = Range::new("eccentricity factor Ce", 0.0, 1.0);
static SOFTNESS: Range = Range::new("softness factor Cs", 0.0, 1.0);
static CONFIGURATION: Range = Range::new("configuration factor Cc", 0.0, 1.0);
static ABNORMAL: Range = Range::new("abnormal berthing factor", 1.25, 2.0);
static ENERGY: Range = Range::new("energy [J]", 0.0, 1e16);

impl BerthingEnergy {
    /// Energy of a normal berthing, ½ M V² Cm Ce Cs Cc (J). Source of the formula: found (PIANC 2002's kinetic method
    /// as public manuals print it).
    ///
    /// # Errors
    /// Returns the first quantity that is out of range.
    pub fn normal_j(&self) -> Result<f64, BerthingError> {
        let mass_kg = DISPLACEMENT.check(self.displacement_kg)?;
        let speed_mps = SPEED.check(self.speed_mps)?;
        let factors = ADDED_MASS.check(self.added_mass)?
            * ECCENTRICITY.check(self.eccentricity)?
            * SOFTNESS.check(self.softness)?
            * CONFIGURATION.check(self.configuration)?;
        Ok(0.5 * mass_kg * speed_mps * speed_mps * factors)
    }
}

/// Energy of an abnormal berthing (J): the energy of a normal berthing times a factor of 1.25 to 2.0 by type and size
/// of ship. Source of the formula: found, as [`crate::berthing`] explains this word. We know the table of factors by type
/// of ship only from memory, so the user gives the factor.
///
/// # Errors
/// Fails if the factor or the energy is out of range.
pub fn abnormal_energy_j(normal_j: f64, factor: f64) -> Result<f64, BerthingError> {
    Ok(ENERGY.check(normal_j)? * ABNORMAL.check(factor)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::berthing::{ContactPoint, gyradius_m, ueda_added_mass};

    /// The case study of PIANC WG 33, as a public calculator's tests print it: 39 000 t, L_BP 170 m, B 26.4 m, D 10.9
    /// m, 0.1 m/s, 5°, quarter-point, Cm by Ueda, abnormal factor 1.75. The result is 351 kN·m; the calculator's tests
    /// allow a difference of 5. Cs and Cc are 1 there.
    #[test]
    fn the_whole_chain_gives_the_published_case_study() {
        let (length_bp_m, beam_m, draught_m) = (170.0, 26.4, 10.9);
        let block = 39e6 / (1025.0 * length_bp_m * beam_m * draught_m);
        let contact = ContactPoint { along_m: 0.25 * length_bp_m, beam_m };
        let gyradius_m = gyradius_m(block, length_bp_m).unwrap();
        let berthing = BerthingEnergy {
            displacement_kg: 39e6,
            speed_mps: 0.1,
            added_mass: ueda_added_mass(draught_m, beam_m, block).unwrap(),
            eccentricity: contact.eccentricity(gyradius_m, 5.0_f64.to_radians()).unwrap(),
            softness: Softness::Soft.factor(),
            configuration: Configuration::OpenPiles.factor(),
        };
        let abnormal_j = abnormal_energy_j(berthing.normal_j().unwrap(), 1.75).unwrap();
        assert!((abnormal_j - 351e3).abs() < 5e3, "{abnormal_j}");
        let quay = BerthingEnergy {
            softness: Softness::Hard.factor(),
            configuration: Configuration::SolidQuay.factor(),
            ..berthing
        };
        let ratio = quay.normal_j().unwrap() / berthing.normal_j().unwrap();
        assert!((ratio - 0.9 * 0.8).abs() < 1e-12);
        assert_eq!(Configuration::SemiOpen.factor(), 0.9);
    }

    #[test]
    fn impossible_berthings_are_refused_by_name() {
        let good = BerthingEnergy {
            displacement_kg: 39e6,
            speed_mps: 0.1,
            added_mass: 1.84,
            eccentricity: 0.5,
            softness: 1.0,
            configuration: 1.0,
        };
        let refused = |bad: BerthingEnergy, name: &str| {
            let error = bad.normal_j().unwrap_err().to_string();
            assert!(error.starts_with(name), "{error}");
        };
        refused(BerthingEnergy { displacement_kg: -1.0, ..good }, "displacement [kg]");
        refused(BerthingEnergy { speed_mps: f64::NAN, ..good }, "berthing speed [m/s]");
        refused(BerthingEnergy { added_mass: 0.9, ..good }, "added mass factor Cm");
        refused(BerthingEnergy { eccentricity: 1.1, ..good }, "eccentricity factor Ce");
        refused(BerthingEnergy { softness: -0.1, ..good }, "softness factor Cs");
        refused(BerthingEnergy { configuration: 2.0, ..good }, "configuration factor Cc");
        assert!(abnormal_energy_j(1e6, 1.0).is_err());
        assert!(abnormal_energy_j(f64::INFINITY, 1.5).is_err());
    }
}
