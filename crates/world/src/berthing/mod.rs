//! Berthing energy by the kinetic method of PIANC 2002, E = ½ M V² Cm Ce Cs Cc. The program compares the berthing
//! energy of this design calculation with the energy in a simulation.
//!
//! This module has pure functions in SI units. Each function of this module names the source of its formula and says
//! how well the source is known. *Found* means that we read the formula in a public source. *Recalled* means that the
//! formula is from memory and must be checked. We did not read the text of PIANC's guidelines, and we claim no
//! conformity with them.
//!
//! ```
//! use fenderline_world::berthing::*;
//! // A bulk carrier that comes in at 5° and touches at a third of her length.
//! let (length_bp_m, beam_m, block) = (236.0, 43.0, 0.796);
//! let contact = ContactPoint { along_m: length_bp_m / 6.0, beam_m };
//! let angle_rad = 5.0_f64.to_radians();
//! let energy = BerthingEnergy {
//!     displacement_kg: 105e6,
//!     speed_mps: 0.12,
//!     added_mass: pianc_2002_added_mass(2.5, 12.8)?,
//!     eccentricity: contact.eccentricity(gyradius_m(block, length_bp_m)?, angle_rad)?,
//!     softness: Softness::Soft.factor(),
//!     configuration: Configuration::OpenPiles.factor(),
//! };
//! assert!((energy.eccentricity - 0.760).abs() < 5e-4);
//! let design_j = abnormal_energy_j(energy.normal_j()?, 1.5)?;
//! assert!((design_j / 1.49e6 - 1.0).abs() < 1e-2);
//! # Ok::<(), BerthingError>(())
//! ```

mod added_mass;
mod check;
mod eccentricity;
mod energy;
mod error;
mod fenders;
mod formula;
mod setup;

pub use added_mass::{
    pianc_2002_added_mass, ueda_added_mass, ufc_added_mass, vasco_costa_added_mass,
};
pub use eccentricity::{ContactPoint, eccentricity_factor, frictionless_factor, gyradius_m};
pub use energy::{BerthingEnergy, Configuration, Softness, abnormal_energy_j};
pub use error::BerthingError;
pub use fenders::{compression_time_s, hull_pressure_npm2, largest_spacing_m};
pub use formula::{AddedMass, AddedMassFormula};
pub use setup::BerthingSetup;
