//! The ships of the computed cases, made from the vessel data.

use fenderline_scenario::{VesselData, VesselLibrary};
use fenderline_sim::hydro::Particulars;
use fenderline_sim::hydro::vessels::Vessel;

/// A vessel of the folder `vessels/` by its name, ready for manoeuvres.
pub(crate) fn vessel(name: &str) -> Vessel {
    data(name).trial()
}

/// The container ship of Moreno et al. (2023), with coefficients based on the length overall, the only length that
/// their paper gives.
pub(super) fn container() -> Particulars {
    by_length_overall("container-ship")
}

/// The paper's tug, likewise.
pub(super) fn tug() -> Particulars {
    by_length_overall("paper-tug")
}

fn by_length_overall(name: &str) -> Particulars {
    let vessel = data(name);
    let hull = &vessel.ship.particulars;
    let length_m = vessel.length_overall_m.expect("the paper has it");
    let block = hull.volume_m3 / (length_m * hull.beam_m * hull.draught_m);
    Particulars::from_block(length_m, hull.beam_m, hull.draught_m, block).expect("she floats")
}

fn data(name: &str) -> VesselData {
    VesselLibrary::built_in().vessel(name).expect("the vessel is built into the program").clone()
}
