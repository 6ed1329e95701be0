//! The manoeuvres that the command line can name.

use clap::ValueEnum;
use fenderline_sim::hydro::vessels::Vessel;

use crate::cli::ManoeuvreName;
use crate::failure::Failure;

/// A manoeuvre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Manoeuvre {
    Turning,
    Zigzag,
    CrashStop,
    Crabbing,
    BollardPull,
}

impl ManoeuvreName {
    /// The manoeuvre of this name; `None` for all of them.
    fn single(self) -> Option<Manoeuvre> {
        match self {
            ManoeuvreName::Turning => Some(Manoeuvre::Turning),
            ManoeuvreName::Zigzag => Some(Manoeuvre::Zigzag),
            ManoeuvreName::CrashStop => Some(Manoeuvre::CrashStop),
            ManoeuvreName::Crabbing => Some(Manoeuvre::Crabbing),
            ManoeuvreName::BollardPull => Some(Manoeuvre::BollardPull),
            ManoeuvreName::All => None,
        }
    }
}

impl Manoeuvre {
    fn name(self) -> ManoeuvreName {
        match self {
            Manoeuvre::Turning => ManoeuvreName::Turning,
            Manoeuvre::Zigzag => ManoeuvreName::Zigzag,
            Manoeuvre::CrashStop => ManoeuvreName::CrashStop,
            Manoeuvre::Crabbing => ManoeuvreName::Crabbing,
            Manoeuvre::BollardPull => ManoeuvreName::BollardPull,
        }
    }

    /// The word of the command line.
    pub(super) fn text(self) -> String {
        text_of(self.name())
    }

    /// Whether it needs a propeller.
    fn needs_propeller(self) -> bool {
        self != Manoeuvre::Crabbing
    }

    /// Whether it begins on a straight course at a speed.
    pub(super) fn has_approach(self) -> bool {
        matches!(
            self,
            Manoeuvre::Turning | Manoeuvre::Zigzag | Manoeuvre::CrashStop | Manoeuvre::BollardPull
        )
    }

    /// Whether a rudder angle is ordered in it.
    pub(super) fn has_rudder(self) -> bool {
        matches!(self, Manoeuvre::Turning | Manoeuvre::Zigzag)
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
) -> Result<Vec<Manoeuvre>, Failure> {
    let has_propeller = vessel.ship.propulsion.is_some();
    let has_speed = has_speed || vessel.approach_mps.is_some();
    let can = |manoeuvre: Manoeuvre| {
        (has_propeller || !manoeuvre.needs_propeller()) && (has_speed || !manoeuvre.has_approach())
    };
    let Some(manoeuvre) = name.single() else {
        // In the order of the command line's help.
        let all = ManoeuvreName::value_variants().iter().filter_map(|name| name.single());
        return Ok(all.filter(|manoeuvre| can(*manoeuvre)).collect());
    };
    if can(manoeuvre) {
        return Ok(vec![manoeuvre]);
    }
    let why = if has_propeller {
        "no speed of approach is known of her: give --speed"
    } else {
        "no propeller and no rudder are known of her; crabbing is what she can do"
    };
    Err(Failure::input(format_args!("error: {}: {why}", vessel.origin.title)))
}
