//! Methods for the wind coefficients of a ship.
//!
//! To add a wind method (see also `docs/design/adding.md`):
//!
//! 1. A file in this folder: a struct with the method's own parameters, `check` for their ranges, `coefficients` for a
//!    wind angle from 0 to π, and a unit test at the end. `blendermann.rs` is an example.
//! 2. Here: `mod`, `pub use` and a variant of [`WindMethod`]; the compiler then points to the matches below.
//! 3. `crates/keys/src/keys/windage.rs`: the word for `method`, its keys and their documentation, from which the key
//!    reference is generated.
//! 4. `crates/scenario/src/assemble/windage.rs`: from the keys to the struct of step 1.

mod blendermann;
mod fujiwara;
mod isherwood;
mod own;

pub use blendermann::{BLENDERMANN_TYPES, Blendermann, BlendermannType};
pub use fujiwara::Fujiwara;
pub use isherwood::Isherwood;
pub use own::OwnWindTable;

use super::above_water::AboveWater;
use super::coefficients::WindCoefficients;
use crate::range::OutOfRange;

/// A method for the wind coefficients of a ship.
#[derive(Clone, Debug, PartialEq)]
pub enum WindMethod {
    /// Isherwood 1972: regression over merchant ships.
    Isherwood(Isherwood),
    /// Blendermann 1994: four parameters by type of ship.
    Blendermann(Blendermann),
    /// Fujiwara et al. 1998: regression of a Fourier series in the wind angle.
    Fujiwara(Fujiwara),
    /// A table that the user gives.
    Own(OwnWindTable),
}

impl WindMethod {
    /// Name of the method, and how well its source is known, for reports.
    #[must_use]
    pub fn standing(&self) -> (&str, &str) {
        match self {
            WindMethod::Isherwood(_) => {
                ("Isherwood 1972", "tables read in a public toolbox; the paper was not read")
            }
            WindMethod::Blendermann(_) => (
                "Blendermann 1994",
                "formulas and table of types read in a public toolbox; the paper was not read",
            ),
            WindMethod::Fujiwara(_) => (
                "Fujiwara et al. 1998",
                "coefficients read in a public code; the paper was not read, and no published value was found to \
                 validate them",
            ),
            WindMethod::Own(table) => ("the scenario's table", &table.source),
        }
    }

    /// Checks the method's own parameters.
    ///
    /// # Errors
    /// The first number out of range.
    pub(super) fn check(&self, ship: &AboveWater) -> Result<(), OutOfRange> {
        match self {
            WindMethod::Isherwood(method) => method.check(ship),
            WindMethod::Blendermann(method) => method.check(),
            WindMethod::Fujiwara(method) => method.check(ship),
            WindMethod::Own(_) => Ok(()),
        }
    }

    /// Coefficients at an angle γ (rad) from 0 to π; those of a table also from −π to 0.
    pub(super) fn coefficients(&self, ship: &AboveWater, angle_rad: f64) -> WindCoefficients {
        match self {
            WindMethod::Isherwood(method) => method.coefficients(ship, angle_rad),
            WindMethod::Blendermann(method) => method.coefficients(ship, angle_rad),
            WindMethod::Fujiwara(method) => method.coefficients(ship, angle_rad),
            WindMethod::Own(table) => table.coefficients(ship, angle_rad),
        }
    }

    /// κ of the heeling moment K = κ·s_H·Y; 1 if the method has no such parameter.
    pub(super) fn roll_factor(&self) -> f64 {
        match self {
            WindMethod::Blendermann(method) => method.kind.roll_factor,
            WindMethod::Isherwood(_) | WindMethod::Fujiwara(_) | WindMethod::Own(_) => 1.0,
        }
    }
}
