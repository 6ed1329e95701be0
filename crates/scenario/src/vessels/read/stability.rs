//! Reads the data of a vessel for heave, roll and pitch.

use fenderline_sim::attitude::{HydrostaticParticulars, Hydrostatics, oscillator_estimates};
use fenderline_sim::constants::SEA_WATER_KGPM3;
use fenderline_sim::hydro::Particulars;
use fenderline_sim::hydro::vessels::Source;

use super::reading::Reading;
use crate::vessels::data::Stability;
use crate::vessels::figures::digits;
use crate::vessels::keys::FileVesselKey;
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::Number;
use fenderline_keys::keys::vessel::StabilityKey;
use fenderline_keys::typed_key::Key;

type Read<T> = Result<T, ScenarioError>;

impl Reading<'_, '_> {
    pub(super) fn stability(&self, ship: &Particulars) -> Read<Option<Stability>> {
        let Some(item) = self.table.item(FileVesselKey::STABILITY) else { return Ok(None) };
        let table = item.table();
        let number = |name: Key<_, Number>| *table.given(name).number();
        let stability = Stability {
            gm_m: number(StabilityKey::GM),
            gravity_above_keel_m: number(StabilityKey::GRAVITY_ABOVE_KEEL),
            waterplane_m2: number(StabilityKey::WATERPLANE_AREA),
        };
        hydrostatics(&stability, ship, SEA_WATER_KGPM3)
            .map_err(|error| self.at(self.table, item, &error))?;
        // An upper bound of the metacentre: KB is at most the draught, and BM = I/∇ is largest for a box.
        let most_m = ship.draught_m
            + ship.length_m * ship.beam_m * ship.beam_m * ship.beam_m / (12.0 * ship.volume_m3);
        let above_keel_m = stability.gm_m + stability.gravity_above_keel_m;
        if above_keel_m > most_m {
            let message = format!(
                "the metacentre would be {} m above the keel, but in a hull of this size it is at \
                 most {} m above the keel",
                digits(above_keel_m),
                digits((10.0 * most_m).round() / 10.0)
            );
            return Err(self.at(table, table.given(StabilityKey::GM), &message));
        }
        Ok(Some(stability))
    }
}

/// The oscillators of heave, roll and pitch of a vessel in water of the density `water_kgpm3` (kg/m³).
///
/// # Errors
/// Fails if the ship is not stable upright.
pub(crate) fn hydrostatics(
    stability: &Stability,
    ship: &Particulars,
    water_kgpm3: f64,
) -> Result<Hydrostatics, fenderline_sim::attitude::AttitudeError> {
    Hydrostatics::of(&HydrostaticParticulars {
        mass_kg: water_kgpm3 * ship.volume_m3,
        length_m: ship.length_m,
        beam_m: ship.beam_m,
        draught_m: ship.draught_m,
        waterplane_m2: stability.waterplane_m2,
        gm_m: stability.gm_m,
        water_kgpm3,
    })
}

/// The estimates of heave, roll and pitch in sea water; `None` if the vessel has no stability data.
pub(super) fn oscillators(stability: Option<&Stability>, ship: &Particulars) -> Option<Source> {
    let of_sea = |stability| hydrostatics(stability, ship, SEA_WATER_KGPM3).ok();
    stability.and_then(of_sea).map(|of| oscillator_estimates(&of))
}
