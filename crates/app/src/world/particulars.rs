//! Where a vessel's manoeuvring model comes from.

use fenderline_sim::VesselSetup;
use fenderline_sim::hydro::vessels::{self, Source};

/// The origin of a manoeuvring model.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Origin {
    /// A published ship, by her name and her coefficients' sources.
    Published(&'static str, &'static [Source]),
    /// Estimated from main particulars.
    Estimated,
}

/// Of a vessel: a published ship has a polynomial of her own, and keeps her particulars at any depth; what
/// has no polynomial was estimated.
pub(crate) fn origin(vessel: &VesselSetup) -> Origin {
    let published = [vessels::kvlcc2(), vessels::kcs()];
    let same = |known: &&vessels::Vessel| {
        vessel.ship.hull.under_way.is_some() && known.ship.particulars == vessel.ship.particulars
    };
    match published.iter().find(same) {
        Some(known) => Origin::Published(known.name, known.sources),
        None => Origin::Estimated,
    }
}
