//! The methods that give a ship's wind coefficients. To add one: its file here, its case in [`WindMethod`], its keys in
//! the scenario's key table and their assembly (`docs/design/adding.md`).

mod blendermann;
mod fujiwara;
mod isherwood;

pub use blendermann::{BLENDERMANN_TYPES, Blendermann, BlendermannType};
pub use fujiwara::Fujiwara;
pub use isherwood::Isherwood;

use super::windage::{ShipWindage, WindCoefficients};
use crate::range::OutOfRange;

/// How wind coefficients are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WindMethod {
    /// Isherwood 1972: regression over merchant ships.
    Isherwood(Isherwood),
    /// Blendermann 1994: four parameters of a type of ship.
    Blendermann(Blendermann),
    /// Fujiwara et al. 1998: regression of a Fourier series in the angle.
    Fujiwara(Fujiwara),
}

impl WindMethod {
    /// Its name, and how well it is known, for a reader of a report.
    #[must_use]
    pub fn standing(&self) -> (&'static str, &'static str) {
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
                "coefficients read in a public code; the paper was not read, and no printed number was found to \
                 hold them against",
            ),
        }
    }

    /// Checks the method's own particulars.
    ///
    /// # Errors
    /// The first that no ship has, by its name.
    pub(super) fn check(&self, ship: &ShipWindage) -> Result<(), OutOfRange> {
        match self {
            WindMethod::Isherwood(method) => method.check(ship),
            WindMethod::Blendermann(method) => method.check(),
            WindMethod::Fujiwara(method) => method.check(ship),
        }
    }

    /// Coefficients at an angle γ (rad) from 0 to π.
    pub(super) fn coefficients(&self, ship: &ShipWindage, angle_rad: f64) -> WindCoefficients {
        match self {
            WindMethod::Isherwood(method) => method.coefficients(ship, angle_rad),
            WindMethod::Blendermann(method) => method.coefficients(ship, angle_rad),
            WindMethod::Fujiwara(method) => method.coefficients(ship, angle_rad),
        }
    }

    /// κ of the heeling moment K = κ·s_H·Y; 1 where the method has none.
    pub(super) fn roll_factor(&self) -> f64 {
        match self {
            WindMethod::Blendermann(method) => method.kind.roll_factor,
            WindMethod::Isherwood(_) | WindMethod::Fujiwara(_) => 1.0,
        }
    }
}
