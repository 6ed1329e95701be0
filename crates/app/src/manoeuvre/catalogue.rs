//! The vessels and the manoeuvres that the command line can name.

use clap::ValueEnum;
use fenderline_sim::hydro::Water;
use fenderline_sim::hydro::vessels::{Vessel, esso_osaka_model, kcs, kvlcc2, kvlcc2_model};

use crate::failure::Failure;

/// A built-in vessel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum VesselName {
    /// KVLCC2, a tanker of 320 m
    Kvlcc2,
    /// KVLCC2, the free-running model of 7 m
    Kvlcc2Model,
    /// KCS, a container ship of 230 m
    Kcs,
    /// Esso Osaka, the bare hull of a model of 3 m: crabbing only
    EssoOsaka,
}

/// A manoeuvre, or all that the vessel can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ManoeuvreName {
    /// Turning circle to either side
    Turning,
    /// Zig-zag 10°/10° and 20°/20°, first to either side
    Zigzag,
    /// From full ahead to standstill by the propeller astern
    CrashStop,
    /// Sideways under a steady force at midship, engine stopped
    Crabbing,
    /// Pull on a bollard, ahead and astern
    BollardPull,
    /// Every manoeuvre that the vessel can do
    All,
}

/// Every single manoeuvre, in the order in which they are printed.
const EACH: [ManoeuvreName; 5] = [
    ManoeuvreName::Turning,
    ManoeuvreName::Zigzag,
    ManoeuvreName::CrashStop,
    ManoeuvreName::Crabbing,
    ManoeuvreName::BollardPull,
];

impl VesselName {
    /// The vessel.
    pub(super) fn vessel(self) -> Vessel {
        match self {
            VesselName::Kvlcc2 => kvlcc2(),
            VesselName::Kvlcc2Model => kvlcc2_model(),
            VesselName::Kcs => kcs(),
            VesselName::EssoOsaka => esso_osaka_model(),
        }
    }

    /// Whether it is a model in a tank, of which IMO asks nothing.
    pub(super) fn is_model(self) -> bool {
        matches!(self, VesselName::Kvlcc2Model | VesselName::EssoOsaka)
    }

    /// Where it floats: models in a tank, ships at sea.
    pub(super) fn water(self) -> Water {
        if self.is_model() { Water::FRESH } else { Water::SEA }
    }

    /// As the command line has it.
    pub(super) fn text(self) -> String {
        text_of(self)
    }
}

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

/// The manoeuvres that a name asks for.
///
/// # Errors
/// A manoeuvre that the vessel has no propeller for.
pub(super) fn chosen(name: ManoeuvreName, vessel: &Vessel) -> Result<Vec<ManoeuvreName>, Failure> {
    let can =
        |manoeuvre: ManoeuvreName| vessel.ship.propulsion.is_some() || !manoeuvre.needs_propeller();
    if name == ManoeuvreName::All {
        return Ok(EACH.into_iter().filter(|manoeuvre| can(*manoeuvre)).collect());
    }
    if can(name) {
        return Ok(vec![name]);
    }
    Err(Failure::input(format_args!(
        "error: {}: no propeller and no rudder are known of her; crabbing is what she can do",
        vessel.name
    )))
}
