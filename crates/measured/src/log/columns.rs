//! Finds the columns of a table by the mapping or by usual names.

use std::collections::BTreeMap;

use fenderline_keys::units::measures as unit;
use fenderline_scenario::nearest;

use super::column::{Column, Title};
use super::row::Quantity;
use crate::mapping::{Mapping, factor_of};
use crate::remark::{Remarks, Weight};

/// Usual names of each quantity, in small letters with `_` between words.
const USUAL: [(Quantity, &[&str]); 14] = [
    (
        Quantity::Time,
        &[
            "time",
            "timestamp",
            "date_time",
            "datetime",
            "utc",
            "time_utc",
            "t",
            "time_local",
            "local_time",
        ],
    ),
    (Quantity::Date, &["date", "day"]),
    (
        Quantity::BowDistance,
        &[
            "bow_distance",
            "distance_bow",
            "bow_dist",
            "dist_bow",
            "d_bow",
            "bow",
            "fwd_distance",
            "distance_fwd",
            "forward_distance",
        ],
    ),
    (
        Quantity::SternDistance,
        &[
            "stern_distance",
            "distance_stern",
            "stern_dist",
            "dist_stern",
            "d_stern",
            "stern",
            "aft_distance",
            "distance_aft",
        ],
    ),
    (
        Quantity::BowSpeed,
        &[
            "bow_speed",
            "speed_bow",
            "v_bow",
            "bow_velocity",
            "velocity_bow",
            "fwd_speed",
            "speed_fwd",
        ],
    ),
    (
        Quantity::SternSpeed,
        &[
            "stern_speed",
            "speed_stern",
            "v_stern",
            "stern_velocity",
            "velocity_stern",
            "aft_speed",
            "speed_aft",
        ],
    ),
    (Quantity::Angle, &["angle", "berthing_angle", "approach_angle", "ship_angle"]),
    (Quantity::Along, &["along", "place_along", "longitudinal", "along_quay"]),
    (Quantity::Ship, &["ship", "vessel", "ship_name", "vessel_name"]),
    (Quantity::Berth, &["berth", "berth_no", "jetty", "berth_name"]),
    (Quantity::Latitude, &["latitude", "lat"]),
    (Quantity::Longitude, &["longitude", "lon", "long", "lng"]),
    (Quantity::Heading, &["heading", "hdg", "true_heading", "heading_true", "hdt"]),
    (Quantity::RateOfTurn, &["rate_of_turn", "rot", "turn_rate"]),
];

/// The columns of a table.
#[derive(Clone, Debug, Default)]
pub(super) struct Columns {
    found: BTreeMap<Quantity, Column>,
    /// Indices of the columns to keep.
    pub(super) kept: Vec<usize>,
}

impl Columns {
    /// Finds the columns by the heads of a table, and tells what was guessed.
    ///
    /// # Errors
    /// Says which column that the mapping names is missing, or which unit is of another dimension.
    pub(super) fn find(
        heads: &[String],
        mapping: &Mapping,
        remarks: &mut Remarks,
        line: usize,
    ) -> Result<Columns, String> {
        let titles: Vec<Title> = heads.iter().map(|head| Title::of(head)).collect();
        let mut columns = Columns::default();
        let mut guesses: Vec<String> = Vec::new();
        for (quantity, names) in USUAL {
            let place = match mapping.columns.get(&quantity) {
                Some(wanted) => Some(place_of(wanted, heads, &titles)?),
                None => {
                    let found = names
                        .iter()
                        .find_map(|name| titles.iter().position(|title| title.plain == *name));
                    if let Some(place) = found {
                        guesses.push(format!("`{}` is the {}", heads[place], words(quantity)));
                    }
                    found
                }
            };
            let Some(place) = place else { continue };
            let factor = factor(quantity, &titles[place], mapping, &mut guesses)
                .map_err(|why| format!("column `{}`: {why}", heads[place]))?;
            columns.found.insert(quantity, Column { place, factor });
        }
        for name in &mapping.keep {
            columns.kept.push(place_of(name, heads, &titles)?);
        }
        if !guesses.is_empty() {
            remarks.add(Weight::Guess, Some(line), format!("guessed: {}", guesses.join("; ")));
        }
        Ok(columns)
    }

    pub(super) fn has(&self, quantity: Quantity) -> bool {
        self.found.contains_key(&quantity)
    }

    pub(super) fn get(&self, quantity: Quantity) -> Option<Column> {
        self.found.get(&quantity).copied()
    }

    /// The first of some quantities for which the table has no column, in words.
    pub(super) fn lacks(&self, needed: &[Quantity]) -> Option<&'static str> {
        needed.iter().find(|quantity| !self.has(**quantity)).map(|quantity| words(*quantity))
    }
}

fn place_of(wanted: &str, heads: &[String], titles: &[Title]) -> Result<usize, String> {
    let plain = Title::of(wanted).plain;
    let exact = heads.iter().position(|head| head.trim() == wanted.trim());
    exact.or_else(|| titles.iter().position(|title| title.plain == plain)).ok_or_else(|| {
        let near = nearest(wanted, heads.iter().map(String::as_str));
        let near = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
        format!("the log has no column `{wanted}`, which the mapping names{near}")
    })
}

/// Factor to SI of a column: by the unit in its head, by the mapping, or by default.
fn factor(
    quantity: Quantity,
    title: &Title,
    mapping: &Mapping,
    guesses: &mut Vec<String>,
) -> Result<f64, String> {
    let (dimension, default) = match quantity {
        Quantity::BowDistance | Quantity::SternDistance | Quantity::Along => {
            (unit::LENGTH.dimension, "m")
        }
        Quantity::BowSpeed | Quantity::SternSpeed => (unit::SPEED.dimension, "m/s"),
        Quantity::Angle | Quantity::Latitude | Quantity::Longitude | Quantity::Heading => {
            (unit::ANGLE.dimension, "deg")
        }
        Quantity::RateOfTurn => (unit::RATE_OF_TURN.dimension, "deg/min"),
        Quantity::Time | Quantity::Date | Quantity::Ship | Quantity::Berth => return Ok(1.0),
    };
    if let Some(factor) = mapping.factors.get(&quantity) {
        return Ok(*factor);
    }
    if !title.unit.is_empty() {
        return factor_of(&title.unit, dimension);
    }
    if default != "deg" {
        guesses.push(format!("the {} is in {default}", words(quantity)));
    }
    factor_of(default, dimension)
}

fn words(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Time => "time",
        Quantity::Date => "date",
        Quantity::BowDistance => "distance at the bow",
        Quantity::SternDistance => "distance at the stern",
        Quantity::BowSpeed => "speed at the bow",
        Quantity::SternSpeed => "speed at the stern",
        Quantity::Angle => "angle",
        Quantity::Along => "place along the quay",
        Quantity::Ship => "ship",
        Quantity::Berth => "berth",
        Quantity::Latitude => "latitude",
        Quantity::Longitude => "longitude",
        Quantity::Heading => "heading",
        Quantity::RateOfTurn => "rate of turn",
    }
}
