//! The ships of the computed cases, made from the vessel data.

use fenderline_scenario::{VesselData, VesselLibrary};
use fenderline_sim::hydro::Particulars;
use fenderline_sim::hydro::vessels::Vessel;

/// A vessel of the folder `vessels/` by its name, ready for manoeuvres.
pub(crate) fn vessel(name: &str) -> Vessel {
    data(name).trial()
}

/// KVLCC2's model of 7 m with coefficients fitted to her turning circles, by her vessel file.
/// `validation/independent/kvlcc2_fit.py` makes the file.
pub(super) fn fitted_kvlcc2() -> VesselData {
    let name = "kvlcc2_fitted.toml";
    let text = include_str!(concat!(env!("FENDERLINE_DATA"), "/validation/kvlcc2_fitted.toml"));
    let library = VesselLibrary::built_in().with_file(text, name);
    let library = library.unwrap_or_else(|e| panic!("the built-in validation/{name}: {e}"));
    library.vessel("kvlcc2-test-fitted").expect("the file has this vessel").clone()
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
