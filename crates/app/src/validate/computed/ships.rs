//! The two ships of the paper, as the design sheet has them.

use fenderline_sim::hydro::Particulars;

/// Density of sea water [kg/m³].
pub(super) const SEA_KGPM3: f64 = 1025.0;
/// Displacement of the container ship [kg].
pub(super) const CONTAINER_KG: f64 = 87.8e6;

/// The container ship: 298 × 46 × 9 m, 87 800 t.
pub(super) fn container() -> Particulars {
    displacing(298.0, 46.0, 9.0, CONTAINER_KG)
}

/// The tug: 32 × 13 m, 930 t, with a draught of 4.5 m, which the sheet assumes.
pub(super) fn tug() -> Particulars {
    displacing(32.0, 13.0, 4.5, 930e3)
}

fn displacing(length_m: f64, beam_m: f64, draught_m: f64, displacement_kg: f64) -> Particulars {
    let block = displacement_kg / SEA_KGPM3 / (length_m * beam_m * draught_m);
    Particulars::from_block(length_m, beam_m, draught_m, block).expect("the ship can float")
}
