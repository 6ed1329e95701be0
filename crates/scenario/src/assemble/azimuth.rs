//! Azimuth units.

use fenderline_sim::AzimuthSetup;
use fenderline_sim::hydro::{AzimuthThruster, Propeller, Series};

use fenderline_keys::checked::Table;

/// The units of a kind of vessel.
pub(crate) fn azimuths(tables: &[(String, Table)]) -> Vec<AzimuthSetup> {
    let read = |(name, table): &(String, Table)| {
        let number = |name: &str| *table.given(name).number();
        AzimuthSetup {
            name: name.clone(),
            unit: AzimuthThruster {
                propeller: Propeller {
                    diameter_m: number("diameter"),
                    thrust_polynomial: None,
                    series: Series::B4Pitch10,
                },
                along_m: number("along"),
                across_m: number("across"),
                // The bollard pull is net of losses, and the units are clear of the hull.
                wake: 0.0,
                thrust_deduction: 0.0,
            },
            bollard_n: number("force"),
            lag_s: number("lag"),
            rate_radps: number("rate"),
            stop_rad: table.item("stop").map(|item| *item.number()),
        }
    };
    let mut units: Vec<_> = tables.iter().map(read).collect();
    // Sorted by name: forces are summed in this order, so that the order in the file has no effect.
    units.sort_by(|one, other| one.name.cmp(&other.name));
    units
}
