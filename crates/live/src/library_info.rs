//! The ships, tugs and fenders among which an instructor chooses for a new exercise.

use std::sync::OnceLock;

use fenderline_author::{can_be_ship, can_be_tug};
use fenderline_scenario::{FenderLibrary, VesselLibrary};

use crate::message::{FamilyInfo, LibraryInfo, LibraryVessel, SizeInfo};

/// The ships, tugs and fenders in the program's libraries.
#[must_use]
pub fn library_info() -> &'static LibraryInfo {
    static LIBRARY: OnceLock<LibraryInfo> = OnceLock::new();
    LIBRARY.get_or_init(|| LibraryInfo {
        vessels: VesselLibrary::built_in()
            .vessels()
            .iter()
            .filter(|vessel| can_be_ship(vessel) || can_be_tug(vessel))
            .map(|vessel| LibraryVessel {
                name: vessel.name.clone(),
                title: vessel.origin.title.clone(),
                length_m: vessel.ship.particulars.length_m,
                beam_m: vessel.ship.particulars.beam_m,
                draught_m: vessel.ship.particulars.draught_m,
                is_tug: can_be_tug(vessel),
            })
            .collect(),
        fenders: FenderLibrary::built_in()
            .families()
            .iter()
            .map(|family| FamilyInfo {
                name: family.name.clone(),
                sizes: family
                    .sizes
                    .iter()
                    .map(|size| SizeInfo {
                        designation: size.designation.clone(),
                        height_m: size.height_m,
                        rated_reaction_n: size.rated_reaction_n,
                    })
                    .collect(),
            })
            .collect(),
    })
}
