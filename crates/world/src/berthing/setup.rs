//! The inputs of the berthing formulas.

use super::added_mass::{
    pianc_2002_added_mass, ueda_added_mass, ufc_added_mass, vasco_costa_added_mass,
};
use super::check::{Range, SPEED};
use super::eccentricity::{ContactPoint, gyradius_m};
use super::energy::{Configuration, Softness, abnormal_energy_j};
use super::error::BerthingError;
use super::formula::{AddedMass, AddedMassFormula};

/// Range of Cm if the scenario gives Cm as a number.
static GIVEN_ADDED_MASS: Range = Range::new("added mass factor Cm", 1.0, 10.0);

/// The inputs of the berthing formulas: particulars of ship and berth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BerthingSetup {
    /// Index of the ship in [`crate::setup::Setup::bodies`].
    pub ship: usize,
    /// Length between perpendiculars (m).
    pub length_bp_m: f64,
    /// Beam of the ship (m).
    pub beam_m: f64,
    /// Draught of the ship (m).
    pub draught_m: f64,
    /// Under-keel clearance (m).
    pub under_keel_clearance_m: f64,
    /// Block coefficient.
    pub block_coefficient: f64,
    /// The added mass factor Cm for the main result and for the abnormal energy.
    pub added_mass: AddedMass,
    /// Cs.
    pub softness: Softness,
    /// Cc.
    pub configuration: Configuration,
    /// Design speed square to the berth (m/s): the speed of the ship's approach, with the factor of an abnormal
    /// berthing if there is one. If the design speed is `None`, the formula uses the speed at the first touch in the
    /// run.
    pub design_speed_mps: Option<f64>,
    /// Abnormal berthing factor; `None` if no abnormal energy is asked for.
    pub abnormal_factor: Option<f64>,
}

impl BerthingSetup {
    /// Checks the particulars against the ranges of the formulas.
    ///
    /// # Errors
    /// Returns the first particular that is outside its range.
    pub fn check(&self) -> Result<(), BerthingError> {
        self.added_masses()?;
        if let AddedMass::Given(factor) = self.added_mass {
            GIVEN_ADDED_MASS.check(factor)?;
        }
        let gyradius_m = gyradius_m(self.block_coefficient, self.length_bp_m)?;
        let contact = ContactPoint { along_m: 0.0, beam_m: self.beam_m };
        contact.eccentricity(gyradius_m, 0.0)?;
        self.design_speed_mps.map_or(Ok(0.0), |speed_mps| SPEED.check(speed_mps))?;
        self.abnormal_factor.map_or(Ok(0.0), |factor| abnormal_energy_j(0.0, factor))?;
        Ok(())
    }

    /// Cm by each formula, in the order of [`AddedMassFormula::ALL`]; `None` if the formula does not apply to the ship.
    pub fn added_masses(&self) -> Result<[Option<f64>; 4], BerthingError> {
        let (draught_m, beam_m, block) = (self.draught_m, self.beam_m, self.block_coefficient);
        let clearance_m = self.under_keel_clearance_m;
        let ufc = ufc_added_mass(clearance_m, draught_m, beam_m, self.length_bp_m, block);
        let is_chosen = self.added_mass == AddedMass::By(AddedMassFormula::Ufc);
        Ok([
            Some(pianc_2002_added_mass(clearance_m, draught_m)?),
            Some(ueda_added_mass(draught_m, beam_m, block)?),
            Some(vasco_costa_added_mass(draught_m, beam_m)?),
            // A barge can be outside the range of the formula's ships. This is an error only if the user asked for the
            // formula.
            if is_chosen { Some(ufc?) } else { ufc.ok() },
        ])
    }
}
