//! A simulated berthing beside the berthing formulas.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{BodyState, Contact, Rotation};

use super::added_mass::{pianc_2002_added_mass, ueda_added_mass, vasco_costa_added_mass};
use super::eccentricity::{ContactPoint, gyradius_m};
use super::energy::{BerthingEnergy, Configuration, Softness, abnormal_energy_j};
use super::error::BerthingError;
use crate::fender::FenderSetup;
use crate::record::StepRecord;
use crate::rigid_body::Inertia;

/// The inputs of the formulas: particulars of ship and berth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BerthingSetup {
    /// Index of the ship in [`crate::Setup::bodies`].
    pub ship: usize,
    /// Length between perpendiculars (m).
    pub length_bp_m: f64,
    /// Beam (m).
    pub beam_m: f64,
    /// Draught (m).
    pub draught_m: f64,
    /// Under-keel clearance (m).
    pub under_keel_clearance_m: f64,
    /// Block coefficient.
    pub block_coefficient: f64,
    /// Cs.
    pub softness: Softness,
    /// Cc.
    pub configuration: Configuration,
    /// Abnormal berthing factor, if the abnormal energy is wanted.
    pub abnormal_factor: Option<f64>,
}

impl BerthingSetup {
    /// Checks the particulars against the ranges of the formulas.
    ///
    /// # Errors
    /// The first particular outside its range.
    pub fn check(&self) -> Result<(), BerthingError> {
        self.added_masses()?;
        let gyradius_m = gyradius_m(self.block_coefficient, self.length_bp_m)?;
        let contact = ContactPoint { along_m: 0.0, beam_m: self.beam_m };
        contact.eccentricity(gyradius_m, 0.0)?;
        self.abnormal_factor.map_or(Ok(0.0), |factor| abnormal_energy_j(0.0, factor))?;
        Ok(())
    }

    /// Cm by PIANC 2002, Ueda and Vasco Costa.
    fn added_masses(&self) -> Result<[f64; 3], BerthingError> {
        Ok([
            pianc_2002_added_mass(self.under_keel_clearance_m, self.draught_m)?,
            ueda_added_mass(self.draught_m, self.beam_m, self.block_coefficient)?,
            vasco_costa_added_mass(self.draught_m, self.beam_m)?,
        ])
    }
}

/// The first contact of the ship with a fender: energies by the formulas and as simulated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BerthingOutcome {
    /// Start of the step of the first touch (s).
    pub first_touch_s: f64,
    /// Index of the fender in [`crate::Setup::fenders`].
    pub fender: usize,
    /// Speed of the ship's centre of gravity square to the fender's face (m/s).
    pub speed_mps: f64,
    /// Angle between hull and face (rad).
    pub angle_rad: f64,
    /// Point of contact along the hull from the centre of gravity, positive forward (m).
    pub along_m: f64,
    /// M, displacement without added mass (kg).
    pub displacement_kg: f64,
    /// Cm by PIANC 2002, Ueda and Vasco Costa.
    pub added_mass: [f64; 3],
    /// Mass normal to the face in the simulation, added mass included, over displacement.
    pub added_mass_simulated: f64,
    /// K, radius of gyration by formula (m).
    pub gyradius_m: f64,
    /// K in the simulation, added mass included (m).
    pub gyradius_simulated_m: f64,
    /// Ce with the formula's K.
    pub eccentricity: f64,
    /// Ce with the simulation's K.
    pub eccentricity_of_run: f64,
    /// Cs.
    pub softness: f64,
    /// Cc.
    pub configuration: f64,
    /// ½ M V² Cm Ce Cs Cc with each of the three Cm (J).
    pub energy_j: [f64; 3],
    /// The first of them times the abnormal berthing factor (J).
    pub abnormal_energy_j: Option<f64>,
    /// Kinetic energy normal to the face at first touch in the simulation, ½ M Cm V² (J).
    pub kinetic_j: f64,
    /// Largest energy absorbed by all fenders together during the first impact (J), hysteresis losses included. The impact
    /// lasts from the first touch until the fenders store less than half of their maximum. Work of other loads
    /// during that time is included.
    pub fender_energy_j: f64,
    /// `fender_energy_j` over `kinetic_j`: Ce as simulated.
    pub eccentricity_measured: f64,
}

/// Collects the outcome of a berthing, step by step.
#[derive(Clone, Debug)]
pub(crate) struct Study {
    setup: BerthingSetup,
    displacement_kg: f64,
    first_hit_is_over: bool,
    /// Hysteresis loss of the fenders since the first touch (J).
    heat_j: f64,
    /// Largest energy stored in the fenders (J).
    most_stored_j: f64,
    pub(crate) outcome: Option<Result<BerthingOutcome, BerthingError>>,
}

/// The quantities of one step that the study uses.
pub(crate) struct StudyStep<'a> {
    pub(crate) t_s: f64,
    pub(crate) states: &'a [BodyState],
    pub(crate) contacts: &'a [Contact],
    /// Recoverable energy stored in all fenders at the end of the step (J).
    pub(crate) stored_j: f64,
    /// Hysteresis loss of all fenders in the step (J).
    pub(crate) hysteresis_j: f64,
}

impl<'a> StudyStep<'a> {
    pub(crate) fn of(record: &StepRecord<'a>) -> StudyStep<'a> {
        let StepRecord { t_s, states, contacts, contact_energies, .. } = *record;
        let of_fenders = || contact_energies.iter().filter(|contact| contact.fender.is_some());
        let stored_j = of_fenders().map(|contact| contact.stored_j).sum();
        let hysteresis_j = of_fenders().map(|contact| contact.hysteresis_j).sum();
        StudyStep { t_s, states, contacts, stored_j, hysteresis_j }
    }
}

impl Study {
    /// A study of particulars that have been checked.
    pub(crate) fn new(setup: BerthingSetup, displacement_kg: f64) -> Study {
        Study {
            setup,
            displacement_kg,
            first_hit_is_over: false,
            heat_j: 0.0,
            most_stored_j: 0.0,
            outcome: None,
        }
    }

    /// Adds one step.
    pub(crate) fn add(
        &mut self,
        fenders: &[FenderSetup],
        inertias: &[Inertia],
        step: &StudyStep<'_>,
    ) {
        let of_ship = |c: &&Contact| {
            c.fender.is_some()
                && [c.body_1.0 as usize, c.body_2.0 as usize].contains(&self.setup.ship)
        };
        if self.first_hit_is_over {
            return;
        }
        let Some(contact) = step.contacts.iter().find(of_ship) else { return };
        if self.outcome.is_none() {
            self.outcome = Some(self.first_touch(fenders, inertias, step, contact));
        }
        let Some(Ok(outcome)) = self.outcome.as_mut() else { return };
        let peaks_j: f64 = step.contacts.iter().map(|c| c.energy.peak_absorbed_j).sum();
        self.heat_j += step.hysteresis_j;
        self.most_stored_j = greater(self.most_stored_j, step.stored_j);
        // The peaks of several fenders within a step need not coincide, so their sum is only an upper bound.
        let taken_j = step.stored_j + self.heat_j;
        outcome.fender_energy_j = greater(outcome.fender_energy_j, lesser(taken_j, peaks_j));
        outcome.eccentricity_measured = outcome.fender_energy_j / outcome.kinetic_j;
        // A light touch before the impact does not count as the impact.
        let was_hit = outcome.fender_energy_j > 0.05 * outcome.kinetic_j;
        self.first_hit_is_over = was_hit && step.stored_j < 0.5 * self.most_stored_j;
    }

    fn first_touch(
        &self,
        fenders: &[FenderSetup],
        inertias: &[Inertia],
        step: &StudyStep<'_>,
        contact: &Contact,
    ) -> Result<BerthingOutcome, BerthingError> {
        let setup = &self.setup;
        let fender = contact.fender.expect("a fender's contact").0 as usize;
        let host = &step.states[fenders[fender].body];
        let state = &step.states[setup.ship];
        let outward = Rotation::from_angle(host.heading_rad + fenders[fender].facing_rad)
            .apply(fenderline_contact::vec2(1.0, 0.0));
        let speed_mps = (host.velocity_mps - state.velocity_mps).dot(outward);
        let attitude = Rotation::from_angle(state.heading_rad);
        let ship_is_1 = contact.body_1.0 as usize == setup.ship;
        let arm_m = if ship_is_1 { contact.arm_1_m } else { contact.arm_2_m };
        let along_m = attitude.apply_inverse(arm_m).x;
        let own = attitude.apply_inverse(outward);
        let inertia = &inertias[setup.ship];
        let mass_kg = inertia.surge_kg * own.x * own.x + inertia.sway_kg * own.y * own.y;

        let added_mass = setup.added_masses()?;
        let gyradius_m = gyradius_m(setup.block_coefficient, setup.length_bp_m)?;
        let gyradius_simulated_m = libm::sqrt(inertia.yaw_kgm2 / mass_kg);
        let point = ContactPoint { along_m, beam_m: setup.beam_m };
        let angle_rad = contact.tilt_rad;
        let ce = point.eccentricity(gyradius_m, angle_rad)?;
        let (softness, configuration) = (setup.softness.factor(), setup.configuration.factor());
        let mut energy_j = [0.0; 3];
        for (energy_j, added_mass) in energy_j.iter_mut().zip(added_mass) {
            let energy = BerthingEnergy {
                displacement_kg: self.displacement_kg,
                speed_mps: speed_mps.abs(),
                added_mass,
                eccentricity: ce,
                softness,
                configuration,
            };
            *energy_j = energy.normal_j()?;
        }
        let abnormal_energy_j = match setup.abnormal_factor {
            Some(factor) => Some(abnormal_energy_j(energy_j[0], factor)?),
            None => None,
        };
        Ok(BerthingOutcome {
            first_touch_s: step.t_s,
            fender,
            speed_mps,
            angle_rad,
            along_m,
            displacement_kg: self.displacement_kg,
            added_mass,
            added_mass_simulated: mass_kg / self.displacement_kg,
            gyradius_m,
            gyradius_simulated_m,
            eccentricity: ce,
            eccentricity_of_run: point.eccentricity(gyradius_simulated_m, angle_rad)?,
            softness,
            configuration,
            energy_j,
            abnormal_energy_j,
            kinetic_j: 0.5 * mass_kg * speed_mps * speed_mps,
            fender_energy_j: 0.0,
            eccentricity_measured: 0.0,
        })
    }
}
