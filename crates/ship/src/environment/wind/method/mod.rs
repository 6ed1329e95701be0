//! Methods for the wind coefficients of a ship.
//!
//! Adding a wind method takes four steps (see also `docs/design/adding.md`):
//!
//! 1. Add a file in this folder: a struct with the method's own parameters, `check` for their ranges, `coefficients`
//!    for a wind angle from 0 to π, and a unit test at the end. `blendermann.rs` is an example.
//! 2. Add `mod`, `pub use` and a variant of [`WindMethod`] in this file; the compiler then points to each `match` that
//!    needs the new variant.
//! 3. In `crates/keys/src/keys/windage.rs`, add the method's word for the key `method`, its own keys and their
//!    documentation, from which the key reference is generated.
//! 4. In `crates/scenario/src/assemble/windage.rs`, make the struct of step 1 from the keys.

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
    /// Isherwood's method of 1972: a regression over merchant ships.
    Isherwood(Isherwood),
    /// Blendermann's method of 1994: a few parameters for each type of ship.
    Blendermann(Blendermann),
    /// Fujiwara's method of 1998: a Fourier series in the wind angle, with coefficients by regression.
    Fujiwara(Fujiwara),
    /// Wind coefficients from a table that the user gives.
    Own(OwnWindTable),
}

impl WindMethod {
    /// Name of the wind method, and how well its source is known, for reports.
    #[must_use]
    pub fn standing(&self) -> (&str, &str) {
        match self {
            WindMethod::Isherwood(_) => {
                ("Isherwood 1972", "tables read in a public toolbox; the paper was not read")
            }
            WindMethod::Blendermann(_) => (
                "Blendermann 1994",
                "formulas and table of ship types read in a public toolbox; the paper was not read",
            ),
            WindMethod::Fujiwara(_) => (
                "Fujiwara et al. 1998",
                "coefficients read in a public code; the paper was not read, and no published value was found to \
                 validate them",
            ),
            WindMethod::Own(table) => ("the scenario's table", &table.source),
        }
    }

    /// Checks the wind method's own parameters.
    ///
    /// # Errors
    /// Fails at the first parameter that is out of range.
    pub(super) fn check(&self, ship: &AboveWater) -> Result<(), OutOfRange> {
        match self {
            WindMethod::Isherwood(method) => method.check(ship),
            WindMethod::Blendermann(method) => method.check(),
            WindMethod::Fujiwara(method) => method.check(ship),
            WindMethod::Own(_) => Ok(()),
        }
    }

    /// Wind coefficients at an angle γ (rad) from 0 to π; a user's table also gives those from −π to 0.
    pub(super) fn coefficients(&self, ship: &AboveWater, angle_rad: f64) -> WindCoefficients {
        match self {
            WindMethod::Isherwood(method) => method.coefficients(ship, angle_rad),
            WindMethod::Blendermann(method) => method.coefficients(ship, angle_rad),
            WindMethod::Fujiwara(method) => method.coefficients(ship, angle_rad),
            WindMethod::Own(table) => table.coefficients(ship, angle_rad),
        }
    }

    /// Factor κ of the wind's heeling moment K = κ·s_H·Y; 1 if the method has no such parameter.
    pub(super) fn roll_factor(&self) -> f64 {
        match self {
            WindMethod::Blendermann(method) => method.kind.roll_factor,
            WindMethod::Isherwood(_) | WindMethod::Fujiwara(_) | WindMethod::Own(_) => 1.0,
        }
    }
}
