//! The manoeuvring model of a ship with one propeller and one rudder by the MMG standard method (Yasukawa & Yoshimura,
//! "Introduction of MMG standard method for ship maneuvering predictions", Journal of Marine Science and Technology 20,
//! 2015), extended to low speed, astern and bollard.
//!
//! An [`Mmg`] is plain data, checked by [`Mmg::check`]. [`Mmg::forces`] is a pure function of the velocity through the
//! water and the controls. The forces of the model include all hydrodynamic terms except those proportional to
//! accelerations (the added mass itself). The forces of the model include the Coriolis terms of the added mass; the
//! Munk moment is part of N_v.

mod check;
mod wake;

pub use super::linear_terms::LinearTerms;
pub use super::polynomial::{DriftPolynomial, Polynomial, SwayPolynomial};
pub use wake::Wake;

use super::added_mass::AddedMass;
use super::blend::Hull;
use super::particulars::Particulars;
use super::propeller::Propeller;
use super::quantities::{Controls, Force, Velocity, Water};
use super::rudder::{Race, Rudder};

/// A ship's manoeuvring model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mmg {
    /// Main particulars.
    pub particulars: Particulars,
    /// Added mass.
    pub added_mass: AddedMass,
    /// Hull coefficients.
    pub hull: Hull,
    /// Propeller and rudder of the ship; `None` for a barge or a ship with other propulsion.
    pub propulsion: Option<Propulsion>,
}

/// One propeller with a rudder behind it, on the ship's centre line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Propulsion {
    /// The propeller, with its characteristics in open water.
    pub propeller: Propeller,
    /// Thrust deduction t_P for thrust ahead.
    pub thrust_deduction: f64,
    /// Thrust deduction for thrust astern, caused by the propeller race on the hull.
    pub thrust_deduction_astern: f64,
    /// Wake at the propeller.
    pub wake: Wake,
    /// The rudder.
    pub rudder: Rudder,
}

/// The hydrodynamic forces on a ship, part by part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parts {
    /// Force of the hull, with the Coriolis terms of the added mass.
    pub hull: Force,
    /// Propeller, less thrust deduction.
    pub propeller: Force,
    /// Force of the rudder, with its interaction force on the hull.
    pub rudder: Force,
}

impl Mmg {
    /// Sum of the parts: surge force X and sway force Y (N) and yaw moment N (N m) about midship.
    pub fn forces(&self, velocity: &Velocity, controls: &Controls, water: Water) -> Force {
        let Parts { hull, propeller, rudder } = self.parts(velocity, controls, water);
        hull + propeller + rudder
    }

    /// The forces of hull, propeller and rudder.
    pub fn parts(&self, velocity: &Velocity, controls: &Controls, water: Water) -> Parts {
        let ship = &self.particulars;
        let hull = self.hull.force(velocity, ship, &self.added_mass, water);
        let Some(propulsion) = &self.propulsion else {
            return Parts { hull, ..Parts::default() };
        };
        let race = propulsion.race(velocity, controls.shaft_rps, ship.length_m, water);
        Parts {
            hull,
            propeller: propulsion.driving_force(&race),
            rudder: propulsion.rudder.force(
                velocity,
                &race,
                controls.rudder_rad,
                ship.length_m,
                water,
            ),
        }
    }
}

impl Propulsion {
    /// Computes inflow and thrust of the propeller, for the rudder behind it.
    fn race(&self, velocity: &Velocity, shaft_rps: f64, length_m: f64, water: Water) -> Race {
        let advance_mps = velocity.surge_mps * self.wake.remaining(velocity, length_m);
        Race {
            advance_mps,
            thrust_n: self.propeller.thrust_n(advance_mps, shaft_rps, water),
            diameter_m: self.propeller.diameter_m,
        }
    }

    /// Surge force of the propeller X_P = (1 − t)T, with the thrust deduction t for the direction of the thrust T.
    fn driving_force(&self, race: &Race) -> Force {
        let deduction =
            if race.thrust_n < 0.0 { self.thrust_deduction_astern } else { self.thrust_deduction };
        Force { surge_n: (1.0 - deduction) * race.thrust_n, ..Force::default() }
    }
}
