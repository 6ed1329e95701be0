//! The published ships, from the vessel data.
#![allow(dead_code, reason = "each test sails some of them")]

use fenderline_scenario::VesselLibrary;
use fenderline_sim::hydro::vessels::Vessel;

fn ship(name: &str) -> Vessel {
    VesselLibrary::built_in().vessel(name).expect("a built-in vessel").trial()
}

/// KVLCC2, the ship of 320 m.
pub(crate) fn kvlcc2() -> Vessel {
    ship("kvlcc2")
}

/// KVLCC2, the model of 7 m.
pub(crate) fn kvlcc2_model() -> Vessel {
    ship("kvlcc2-model")
}

/// KCS, the ship of 230 m.
pub(crate) fn kcs() -> Vessel {
    ship("kcs")
}

/// Esso Osaka, the free-running model of 3 m.
pub(crate) fn esso_osaka_model() -> Vessel {
    ship("esso-osaka")
}
