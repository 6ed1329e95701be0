//! Azimuth units.

use fenderline_sim::AzimuthSetup;
use fenderline_sim::hydro::{AzimuthThruster, Propeller, Series};

use fenderline_keys::checked::{Of, Tables};
use fenderline_keys::held::Number;
use fenderline_keys::keys::azimuth::AzimuthKey;
use fenderline_keys::typed_key::Key;

/// Reads the azimuth units of a kind of vessel.
pub(crate) fn azimuths(tables: Tables<'_, AzimuthKey>) -> Vec<AzimuthSetup> {
    let read = |(name, table): (&String, Of<'_, _>)| {
        let number = |name: Key<_, Number>| *table.given(name).number();
        AzimuthSetup {
            name: name.clone(),
            unit: AzimuthThruster {
                propeller: Propeller {
                    diameter_m: number(AzimuthKey::DIAMETER),
                    thrust_polynomial: None,
                    series: Series::B4Pitch10,
                },
                along_m: number(AzimuthKey::ALONG),
                across_m: number(AzimuthKey::ACROSS),
                // The bollard pull is net of losses, and the units are clear of the hull.
                wake: 0.0,
                thrust_deduction: 0.0,
            },
            bollard_n: number(AzimuthKey::FORCE),
            lag_s: number(AzimuthKey::LAG),
            rate_radps: number(AzimuthKey::RATE),
            stop_rad: table.item(AzimuthKey::STOP).map(|item| *item.number()),
        }
    };
    let mut units: Vec<_> = tables.iter().map(read).collect();
    // Sorted by name: forces are summed in this order, so that the order in the file has no effect.
    units.sort_by(|one, other| one.name.cmp(&other.name));
    units
}
