//! Heave, roll and pitch oscillators from a ship's particulars.

use crate::constants::STANDARD_GRAVITY_MPS2;
use std::fmt;

use super::oscillator::Oscillator;
use crate::hydro::vessels::{Figure, Source, Standing};

/// The heave, roll and pitch oscillators of a ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hydrostatics {
    /// Heave.
    pub heave: Oscillator,
    /// Roll.
    pub roll: Oscillator,
    /// Pitch.
    pub pitch: Oscillator,
}

/// Error of a particular with which a ship cannot float upright.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AttitudeError {
    /// Name of the wrong particular, with its unit.
    pub quantity: &'static str,
    /// Value of the wrong particular.
    pub value: f64,
    /// The condition that the particular's value must satisfy.
    pub must: &'static str,
}

impl fmt::Display for AttitudeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} must be {}, but is {}", self.quantity, self.must, self.value)
    }
}

impl std::error::Error for AttitudeError {}

/// A ship's particulars from which heave, roll and pitch are computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HydrostaticParticulars {
    /// Displacement (kg).
    pub mass_kg: f64,
    /// Length (m).
    pub length_m: f64,
    /// Beam (m).
    pub beam_m: f64,
    /// Draught (m).
    pub draught_m: f64,
    /// Waterplane area (m²).
    pub waterplane_m2: f64,
    /// Transverse metacentric height GM of the ship (m).
    pub gm_m: f64,
    /// Density of the water (kg/m³).
    pub water_kgpm3: f64,
}

/// Added mass in heave divided by the displacement, for a ship whose beam is five times her draught (from memory).
const ADDED_HEAVE: f64 = 2.0;
/// Damping ratios of heave, roll and pitch. The damping ratios of roll and pitch are usual for hulls with bilge keels
/// (from memory). The damping ratio of heave is our assumption.
const DAMPING: [f64; 3] = [0.3, 0.15, 0.3];
/// Radius of gyration in roll divided by the beam, added inertia included. ITTC (7.5-02-07-02.1) recommends a roll
/// gyradius of 0.35 to 0.40 of the beam, without added inertia, if nothing is known. HSVA's roll test of KVLCC2 gave a
/// roll gyradius of 0.37 of the beam, with added inertia.
const ROLL_GYRADIUS: f64 = 0.40;
/// Radius of gyration in pitch divided by the length, without added inertia.
const PITCH_GYRADIUS: f64 = 0.25;

impl Hydrostatics {
    /// The oscillators from the particulars: heave has an added mass A₃₃ of twice the mass m, roll a gyradius k = 0.40
    /// B and the height GM, pitch a gyradius k = 0.25 L. The waterplane's longitudinal moment of inertia divided by B
    /// L³ is 0.350 C² − 0.405 C + 0.146, with the waterplane coefficient C (D'Arcangelo, from memory).
    ///
    /// # Errors
    /// Fails if a particular, such as GM, is not positive, or if the waterplane is larger than length times beam.
    pub fn of(ship: &HydrostaticParticulars) -> Result<Hydrostatics, AttitudeError> {
        let positive = [
            ("displacement [kg]", ship.mass_kg),
            ("length [m]", ship.length_m),
            ("beam [m]", ship.beam_m),
            ("draught [m]", ship.draught_m),
            ("waterplane area [m²]", ship.waterplane_m2),
            ("metacentric height GM [m]", ship.gm_m),
            ("density of the water [kg/m³]", ship.water_kgpm3),
        ];
        for (quantity, value) in positive {
            if !(value > 0.0 && value.is_finite()) {
                return Err(AttitudeError { quantity, value, must: "positive" });
            }
        }
        let coefficient = ship.waterplane_m2 / (ship.length_m * ship.beam_m);
        if coefficient > 1.0 {
            let must = "at most length times beam";
            let (quantity, value) = ("waterplane area [m²]", ship.waterplane_m2);
            return Err(AttitudeError { quantity, value, must });
        }
        let (weight_n, specific_npm3) =
            (ship.mass_kg * STANDARD_GRAVITY_MPS2, ship.water_kgpm3 * STANDARD_GRAVITY_MPS2);
        let longitudinal_m4 = (0.350 * coefficient * coefficient - 0.405 * coefficient + 0.146)
            * ship.beam_m
            * ship.length_m
            * ship.length_m
            * ship.length_m;
        let square = |k_m: f64| ship.mass_kg * k_m * k_m;
        let [heave, roll, pitch] = DAMPING;
        Ok(Hydrostatics {
            heave: Oscillator {
                inertia: ship.mass_kg * (1.0 + ADDED_HEAVE),
                restoring: specific_npm3 * ship.waterplane_m2,
                damping: heave,
            },
            roll: Oscillator {
                inertia: square(ROLL_GYRADIUS * ship.beam_m),
                restoring: weight_n * ship.gm_m,
                damping: roll,
            },
            pitch: Oscillator {
                inertia: square(PITCH_GYRADIUS * ship.length_m) * (1.0 + ADDED_HEAVE),
                restoring: specific_npm3 * longitudinal_m4,
                damping: pitch,
            },
        })
    }
}

/// The estimated periods and damping ratios of heave, roll and pitch with their sources, for reports.
#[must_use]
pub fn oscillator_estimates(of: &Hydrostatics) -> Source {
    let figures =
        [("heave", of.heave), ("roll", of.roll), ("pitch", of.pitch)].map(|(name, one)| {
            [
                Figure::of(&format!("{name} period"), one.period_s(), "s"),
                Figure::of(&format!("{name} damping"), one.damping, ""),
            ]
        });
    Source {
        group: "heave, roll and pitch".to_owned(),
        figures: figures.into_iter().flatten().collect(),
        source: "heave added mass A33 = 2 m, roll gyradius 0.40 B, pitch gyradius 0.25 L, \
                 waterplane inertia by D'Arcangelo, usual damping"
            .to_owned(),
        standing: Standing::Recalled,
        is_estimate: true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CONTAINER: HydrostaticParticulars = HydrostaticParticulars {
        mass_kg: 87.8e6,
        length_m: 298.0,
        beam_m: 46.0,
        draught_m: 9.0,
        waterplane_m2: 10_612.0,
        gm_m: 1.0,
        water_kgpm3: 1025.0,
    };

    /// The closed forms of validation/independent/ship_formulas.py, printed to a tenth: heave 9.87 s; roll 36.9, 26.1
    /// and 16.5 s at GM 1, 2 and 5 m.
    #[test]
    fn periods_of_the_container_ship_agree_with_the_closed_forms() {
        for (gm_m, roll_s) in [(1.0, 36.9), (2.0, 26.1), (5.0, 16.5)] {
            let ship = Hydrostatics::of(&HydrostaticParticulars { gm_m, ..CONTAINER }).unwrap();
            assert!((ship.roll.period_s() - roll_s).abs() < 0.05, "{}", ship.roll.period_s());
            assert!((ship.heave.period_s() - 9.9).abs() < 0.1, "{}", ship.heave.period_s());
            // No pitch period is published. Pitch and heave periods of a long ship are similar.
            assert!((0.7..1.3).contains(&(ship.pitch.period_s() / ship.heave.period_s())));
        }
    }

    #[test]
    fn ships_that_cannot_float_upright_are_rejected_by_name() {
        let rejected = |ship| Hydrostatics::of(&ship).unwrap_err().to_string();
        let message = rejected(HydrostaticParticulars { gm_m: -0.2, ..CONTAINER });
        assert_eq!(message, "metacentric height GM [m] must be positive, but is -0.2");
        assert!(
            rejected(HydrostaticParticulars { mass_kg: f64::NAN, ..CONTAINER })
                .contains("displacement")
        );
        assert!(
            rejected(HydrostaticParticulars { waterplane_m2: 2e4, ..CONTAINER })
                .contains("waterplane")
        );
    }
}
