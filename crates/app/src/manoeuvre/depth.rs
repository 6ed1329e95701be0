//! The shallow water of a manoeuvre, and the notices about it.

use fenderline_sim::constants::STANDARD_GRAVITY_MPS2;
use fenderline_sim::hydro::shallow::{PUBLISHED_RATIO, SHALLOWEST_RATIO};
use fenderline_sim::hydro::vessels::Vessel;

use super::section::Section;
use crate::cli::WaterDepth;
use crate::failure::Failure;
use fenderline_report::plot::{fixed, plain};

/// Depth Froude number above which the ship's own waves matter, which the shallow-water corrections leave out; the
/// number is recalled, not looked up.
const SLOW_FROUDE: f64 = 0.6;

/// The water depth in which a vessel manoeuvres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shallow {
    pub(super) depth_m: f64,
    /// Water depth divided by the vessel's draught.
    pub(super) ratio: f64,
}

impl Shallow {
    /// Checks that the vessel floats in this depth.
    ///
    /// # Errors
    /// Fails if the depth does not exceed the vessel's draught.
    pub(super) fn checked(depth: WaterDepth, vessel: &Vessel) -> Result<Shallow, Failure> {
        let draught_m = vessel.ship.particulars.draught_m;
        let depth_m = match depth {
            WaterDepth::Metres(depth_m) => depth_m,
            WaterDepth::Draughts(ratio) => ratio * draught_m,
        };
        if depth_m <= draught_m {
            return Err(Failure::input(format_args!(
                "error: --depth: {} m of water under a draught of {} m: {} is aground",
                plain(depth_m, 4),
                plain(draught_m, 4),
                vessel.origin.title
            )));
        }
        Ok(Shallow { depth_m, ratio: depth_m / draught_m })
    }

    /// The vessel with her shallow-water corrections.
    pub(super) fn vessel(&self, deep: &Vessel) -> Vessel {
        Vessel { ship: deep.ship.at_depth(self.depth_m), ..deep.clone() }
    }

    /// Notices for the user if the shallow-water corrections are used outside their range.
    pub(super) fn notices(&self, vessel: &Vessel, speed_mps: f64) -> Vec<String> {
        let mut all = Vec::new();
        let ratio = plain(self.ratio, 4);
        if self.ratio < SHALLOWEST_RATIO {
            all.push(format!(
                "--depth: {ratio} draughts; corrections are valid from {PUBLISHED_RATIO} on, and \
                 are constant below {SHALLOWEST_RATIO}"
            ));
        } else if self.ratio < PUBLISHED_RATIO {
            all.push(format!(
                "--depth: {ratio} draughts; corrections are valid from {PUBLISHED_RATIO} on; here \
                 the corrections are extrapolated"
            ));
        }
        let froude = speed_mps / (STANDARD_GRAVITY_MPS2 * self.depth_m).sqrt();
        if froude > SLOW_FROUDE {
            all.push(format!(
                "{} approaches at a Froude number of depth of {}; the corrections leave out the \
                 waves of the ship, which matter above {SLOW_FROUDE}: give a lower --speed",
                vessel.origin.title,
                fixed(froude, 2)
            ));
        }
        all
    }
}

/// Puts the results in shallow water and those in deep water into the columns of one table.
pub(super) fn beside(there: Section, deep: Section) -> Section {
    let mut merged = there;
    merged.columns.extend(deep.columns.iter().map(|column| format!("{column}, deep")));
    for (row, deep_row) in merged.rows.iter_mut().zip(deep.rows) {
        assert_eq!(
            row.key, deep_row.key,
            "a manoeuvre has the same measured quantities in any water"
        );
        row.values.extend(deep_row.values);
    }
    for track in &mut merged.tracks {
        track.name.push_str("_shallow");
    }
    merged.tracks.extend(deep.tracks);
    merged
}

#[cfg(test)]
mod tests {
    use super::WaterDepth;

    #[test]
    fn depths_are_metres_or_draughts() {
        let read = |text: &str| text.parse::<WaterDepth>();
        assert_eq!(read("31.2"), Ok(WaterDepth::Metres(31.2)));
        assert_eq!(read("31.2 m"), Ok(WaterDepth::Metres(31.2)));
        assert_eq!(read("1.5T"), Ok(WaterDepth::Draughts(1.5)));
        assert_eq!(read(" 1.5 T "), Ok(WaterDepth::Draughts(1.5)));
        for wrong in ["", "T", "deep", "-3", "0", "inf", "NaN T", "3 ft"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }
}
