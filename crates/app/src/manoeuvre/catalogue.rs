//! The manoeuvres that the command line can name.

use clap::ValueEnum;
use fenderline_sim::hydro::vessels::Vessel;

use crate::cli::{Manoeuvre, ManoeuvreChoice};
use crate::failure::Failure;

impl Manoeuvre {
    /// Name of the manoeuvre on the command line.
    pub(super) fn text(self) -> String {
        self.to_possible_value().expect("no name is hidden").get_name().to_owned()
    }

    /// Whether the manoeuvre needs a propeller.
    fn needs_propeller(self) -> bool {
        self != Manoeuvre::Crabbing
    }

    /// Whether the manoeuvre begins on a straight course at a given speed.
    pub(super) fn has_approach(self) -> bool {
        matches!(
            self,
            Manoeuvre::Turning | Manoeuvre::Zigzag | Manoeuvre::CrashStop | Manoeuvre::BollardPull
        )
    }

    /// Whether a rudder angle is ordered in the manoeuvre.
    pub(super) fn has_rudder(self) -> bool {
        matches!(self, Manoeuvre::Turning | Manoeuvre::Zigzag)
    }
}

/// The manoeuvres that the user's choice stands for. `has_speed` says that the user gives a speed of approach.
///
/// # Errors
/// Fails if the vessel has no propeller or no speed of approach for the manoeuvre.
pub(super) fn chosen(
    choice: ManoeuvreChoice,
    vessel: &Vessel,
    has_speed: bool,
) -> Result<Vec<Manoeuvre>, Failure> {
    let has_propeller = vessel.ship.propulsion.is_some();
    let has_speed = has_speed || vessel.approach_mps.is_some();
    let can = |manoeuvre: Manoeuvre| {
        (has_propeller || !manoeuvre.needs_propeller()) && (has_speed || !manoeuvre.has_approach())
    };
    match choice {
        ManoeuvreChoice::All => {
            let each = Manoeuvre::value_variants().iter().copied();
            return Ok(each.filter(|manoeuvre| can(*manoeuvre)).collect());
        }
        ManoeuvreChoice::One(manoeuvre) if can(manoeuvre) => return Ok(vec![manoeuvre]),
        ManoeuvreChoice::One(_) => {}
    }
    let why = if has_propeller {
        "the data have no speed of approach: give --speed"
    } else {
        "the data have no propeller and no rudder; crabbing is the only manoeuvre"
    };
    Err(Failure::input(format_args!("error: {}: {why}", vessel.origin.title)))
}
