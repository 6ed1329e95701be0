//! Reads the main particulars of a vessel: size, displacement, centre of gravity and gyradius.

use fenderline_sim::constants::SEA_WATER_KGPM3;
use fenderline_sim::hydro::vessels::Figure;
use fenderline_sim::hydro::{HydroError, Particulars};

use super::figure;
use super::reading::Reading;
use crate::vessels::figures::digits;
use crate::vessels::keys::FileVesselKey;
use fenderline_keys::any_keys;
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::Number;
use fenderline_keys::typed_key::{AnyKey, Key};

type Read<T> = Result<T, ScenarioError>;

impl Reading<'_, '_> {
    pub(super) fn particulars(&self, assumed: &mut Vec<Figure>) -> Read<Particulars> {
        let table = self.table;
        let number = |name: Key<_, Number>| *table.given(name).number();
        let (length_m, beam_m, draught_m) = (
            number(FileVesselKey::LENGTH_BP),
            number(FileVesselKey::BEAM),
            number(FileVesselKey::DRAUGHT),
        );
        let mut given =
            GivenBy::ALL.iter().filter_map(|kind| Some((kind, table.item_if_any(kind.key())?)));
        let (first, second) = (given.next(), given.next());
        if let (Some((first, _)), Some((_, second))) = (first, second) {
            return Err(self
                .together(table, second, first.key())
                .with_help("keep only one of the two keys"));
        }
        let Some((kind, item)) = first else {
            let help = "give one of the keys `volume`, `displacement`, `block_coefficient` and \
                        `mass_coefficient`";
            return Err(self.missing(table, FileVesselKey::BLOCK_COEFFICIENT, help));
        };
        let value = *item.number();
        let volume_m3 = match kind {
            GivenBy::Volume => value,
            GivenBy::Displacement => value / SEA_WATER_KGPM3,
            GivenBy::MassCoefficient => value * (0.5 * length_m * length_m * draught_m),
            GivenBy::BlockCoefficient => value * length_m * beam_m * draught_m,
        };
        let centre_of_gravity_m =
            table.number_if_any(FileVesselKey::CENTRE_OF_GRAVITY).unwrap_or_else(|| {
                assumed.push(figure("centre_of_gravity", "0 m"));
                0.0
            });
        let gyradius_m = table.number_if_any(FileVesselKey::GYRADIUS).unwrap_or_else(|| {
            assumed.push(figure("gyradius", &format!("{} m", digits(0.25 * length_m))));
            0.25 * length_m
        });
        let yaw_gyradius_ratio = gyradius_m / length_m;
        let ship = Particulars {
            length_m,
            beam_m,
            draught_m,
            volume_m3,
            centre_of_gravity_m,
            yaw_gyradius_ratio,
        };
        ship.check().map_err(|error| self.impossible(&error))
    }

    /// Makes an error about impossible particulars that points to the key that causes the error.
    pub(super) fn impossible(&self, error: &HydroError) -> ScenarioError {
        const VOLUMES: &[AnyKey<FileVesselKey>] = &{
            let [a, b, c, d] = GivenBy::ALL;
            [a.key().any(), b.key().any(), c.key().any(), d.key().any()]
        };
        // How a quantity's name begins, and the keys that can cause the error.
        const CAUSES: [(&str, &[AnyKey<FileVesselKey>]); 15] = [
            ("length", any_keys![FileVesselKey: LENGTH_BP]),
            ("beam", any_keys![FileVesselKey: BEAM]),
            ("draught", any_keys![FileVesselKey: DRAUGHT]),
            ("displaced volume", VOLUMES),
            ("block coefficient", VOLUMES),
            ("centre of gravity", any_keys![FileVesselKey: CENTRE_OF_GRAVITY]),
            ("yaw gyradius", any_keys![FileVesselKey: GYRADIUS]),
            ("added", any_keys![FileVesselKey: ADDED_MASS]),
            ("diameter of the propeller", any_keys![FileVesselKey: PROPELLER]),
            ("thrust", any_keys![FileVesselKey: PROPELLER]),
            ("wake", any_keys![FileVesselKey: PROPELLER]),
            ("area of the rudder", any_keys![FileVesselKey: RUDDER]),
            ("rudder", any_keys![FileVesselKey: RUDDER]),
            ("cross-flow", any_keys![FileVesselKey: LOW_SPEED]),
            ("resistance", any_keys![FileVesselKey: LOW_SPEED, SWAY_POLYNOMIAL, DRIFT_POLYNOMIAL]),
        ];
        if let HydroError::OutOfRange { quantity, .. } = error {
            let about = CAUSES.iter().find(|(start, _)| quantity.starts_with(start));
            let mut items = about
                .into_iter()
                .flat_map(|(_, keys)| *keys)
                .filter_map(|key| self.table.item_if_any(*key));
            if let Some(item) = items.next() {
                return self.at(self.table, item, error);
            }
        }
        let path = &self.table.path;
        self.sources.error(&self.table.span, path, format!("`{path}`: {error}"))
    }
}

/// The key with which a table gives the displaced volume of a vessel.
#[derive(Clone, Copy)]
enum GivenBy {
    Volume,
    Displacement,
    BlockCoefficient,
    MassCoefficient,
}

impl GivenBy {
    const ALL: [GivenBy; 4] = [
        GivenBy::Volume,
        GivenBy::Displacement,
        GivenBy::BlockCoefficient,
        GivenBy::MassCoefficient,
    ];

    /// Its key.
    const fn key(self) -> Key<FileVesselKey, Number> {
        match self {
            GivenBy::Volume => FileVesselKey::VOLUME,
            GivenBy::Displacement => FileVesselKey::DISPLACEMENT,
            GivenBy::BlockCoefficient => FileVesselKey::BLOCK_COEFFICIENT,
            GivenBy::MassCoefficient => FileVesselKey::MASS_COEFFICIENT,
        }
    }
}
