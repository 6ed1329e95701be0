//! The manoeuvres that the command line can name.

use clap::ValueEnum;
use fenderline_sim::hydro::vessels::Vessel;

use crate::cli::ManoeuvreName;
use crate::failure::Failure;

/// Every single manoeuvre, in the order in which they are printed.
const EACH: [ManoeuvreName; 5] = [
    ManoeuvreName::Turning,
    ManoeuvreName::Zigzag,
    ManoeuvreName::CrashStop,
    ManoeuvreName::Crabbing,
    ManoeuvreName::BollardPull,
];

impl ManoeuvreName {
    /// As the command line has it.
    pub(super) fn text(self) -> String {
        text_of(self)
    }

    /// Whether it needs a propeller.
    fn needs_propeller(self) -> bool {
        self != ManoeuvreName::Crabbing
    }

    /// Whether it begins on a straight course at a speed.
    pub(super) fn has_approach(self) -> bool {
        matches!(
            self,
            ManoeuvreName::Turning
                | ManoeuvreName::Zigzag
                | ManoeuvreName::CrashStop
                | ManoeuvreName::BollardPull
        )
    }

    /// Whether a rudder angle is ordered in it.
    pub(super) fn has_rudder(self) -> bool {
        matches!(self, ManoeuvreName::Turning | ManoeuvreName::Zigzag)
    }
}

fn text_of(value: impl ValueEnum) -> String {
    value.to_possible_value().expect("no name is hidden").get_name().to_owned()
}

/// The manoeuvres that a name asks for, of a vessel whose speed of approach may be ordered.
///
/// # Errors
/// A manoeuvre that the vessel has no propeller or no speed of approach for.
pub(super) fn chosen(
    name: ManoeuvreName,
    vessel: &Vessel,
    has_speed: bool,
) -> Result<Vec<ManoeuvreName>, Failure> {
    let has_propeller = vessel.ship.propulsion.is_some();
    let has_speed = has_speed || vessel.approach_mps.is_some();
    let can = |manoeuvre: ManoeuvreName| {
        (has_propeller || !manoeuvre.needs_propeller()) && (has_speed || !manoeuvre.has_approach())
    };
    if name == ManoeuvreName::All {
        return Ok(EACH.into_iter().filter(|manoeuvre| can(*manoeuvre)).collect());
    }
    if can(name) {
        return Ok(vec![name]);
    }
    let why = if has_propeller {
        "no speed of approach is known of her: give --speed"
    } else {
        "no propeller and no rudder are known of her; crabbing is what she can do"
    };
    Err(Failure::input(format_args!("error: {}: {why}", vessel.origin.title)))
}
