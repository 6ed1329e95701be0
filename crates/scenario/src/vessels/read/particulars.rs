//! Main particulars of a vessel: size, displacement, centre of gravity and gyradius.

use fenderline_sim::constants::SEA_WATER_KGPM3;
use fenderline_sim::hydro::vessels::Figure;
use fenderline_sim::hydro::{HydroError, Particulars};

use super::figure;
use super::reading::Reading;
use crate::vessels::figures::digits;
use fenderline_keys::error::ScenarioError;

type Read<T> = Result<T, ScenarioError>;

impl Reading<'_, '_> {
    pub(super) fn particulars(&self, assumed: &mut Vec<Figure>) -> Read<Particulars> {
        let table = self.table;
        let number = |name: &str| *table.given(name).number();
        let (length_m, beam_m, draught_m) =
            (number("length_bp"), number("beam"), number("draught"));
        let mut given =
            GivenBy::ALL.iter().filter_map(|kind| Some((kind, table.item_if_any(kind.key())?)));
        let (first, second) = (given.next(), given.next());
        if let (Some((_, first)), Some((_, second))) = (first, second) {
            return Err(self.together(table, second, first.name).with_help("keep one of the two"));
        }
        let Some((kind, item)) = first else {
            let help =
                "give one of `volume`, `displacement`, `block_coefficient` and `mass_coefficient`";
            return Err(self.missing(table, "block_coefficient", help));
        };
        let value = *item.number();
        let volume_m3 = match kind {
            GivenBy::Volume => value,
            GivenBy::Displacement => value / SEA_WATER_KGPM3,
            GivenBy::MassCoefficient => value * (0.5 * length_m * length_m * draught_m),
            GivenBy::BlockCoefficient => value * length_m * beam_m * draught_m,
        };
        let centre_of_gravity_m = table.number_if_any("centre_of_gravity").unwrap_or_else(|| {
            assumed.push(figure("centre_of_gravity", "0 m"));
            0.0
        });
        let gyradius_m = table.number_if_any("gyradius").unwrap_or_else(|| {
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

    /// An error about particulars, at the key that causes it.
    pub(super) fn impossible(&self, error: &HydroError) -> ScenarioError {
        const VOLUMES: &[&str] = &{
            let [a, b, c, d] = GivenBy::ALL;
            [a.key(), b.key(), c.key(), d.key()]
        };
        // How a quantity's name begins, and the keys that can cause the error.
        const CAUSES: [(&str, &[&str]); 15] = [
            ("length", &["length_bp"]),
            ("beam", &["beam"]),
            ("draught", &["draught"]),
            ("displaced volume", VOLUMES),
            ("block coefficient", VOLUMES),
            ("centre of gravity", &["centre_of_gravity"]),
            ("yaw gyradius", &["gyradius"]),
            ("added", &["added_mass"]),
            ("diameter of the propeller", &["propeller"]),
            ("thrust", &["propeller"]),
            ("wake", &["propeller"]),
            ("area of the rudder", &["rudder"]),
            ("rudder", &["rudder"]),
            ("cross-flow", &["low_speed"]),
            ("resistance", &["low_speed", "sway_polynomial", "drift_polynomial"]),
        ];
        if let HydroError::OutOfRange { quantity, .. } = error {
            let about = CAUSES.iter().find(|(start, _)| quantity.starts_with(start));
            let mut items = about
                .into_iter()
                .flat_map(|(_, keys)| *keys)
                .filter_map(|key| self.table.item_if_any(key));
            if let Some(item) = items.next() {
                return self.at(self.table, item, error);
            }
        }
        let path = &self.table.path;
        self.sources.error(&self.table.span, path, format!("`{path}`: {error}"))
    }
}

/// How a table gives the displaced volume.
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
    const fn key(self) -> &'static str {
        match self {
            GivenBy::Volume => "volume",
            GivenBy::Displacement => "displacement",
            GivenBy::BlockCoefficient => "block_coefficient",
            GivenBy::MassCoefficient => "mass_coefficient",
        }
    }
}
