//! The mapping file: what the columns of a log mean, where sensors and antennas stand, and which ship is which.

pub(crate) mod keys;

use std::collections::BTreeMap;

use fenderline_contact::{Vec2, vec2};
use fenderline_keys::calendar::zone_s;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::Text;
use fenderline_keys::overrides::Override;
use fenderline_keys::schema::whole_file;
use fenderline_keys::sources::Sources;
use fenderline_keys::units::measures as unit;
use fenderline_keys::units::{self, Dimension};
use fenderline_keys::{reader, syntax};

use self::keys::{ColumnsKey, MAPPING, MappingKey, OriginKey, SensorKey, ShipKey, UnitsKey};
use crate::log::{LogKind, Quantity};

type Read<T> = Result<T, ScenarioError>;

/// A sensor on the quay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensor {
    /// Place along the quay from the middle of the fenders, positive towards the ship's bow (m).
    pub place_m: f64,
    /// Reading when the hull is at the faces of the fenders (m).
    pub behind_m: f64,
}

/// A ship of the logs.
#[derive(Clone, Debug, PartialEq)]
pub struct ShipOfLog {
    /// Maritime mobile service identity.
    pub mmsi: Option<u32>,
    /// Changes of the scenario for her.
    pub set: Vec<Override>,
}

/// What the columns of the logs mean, and where sensors and antenna stand. The default guesses all that can be guessed.
#[derive(Clone, Debug, PartialEq)]
pub struct Mapping {
    /// What the logs hold; `None` to guess.
    pub kind: Option<LogKind>,
    /// Seconds by which the clock of times without a zone is ahead of UTC; `None` for UTC, which is told.
    pub zone_s: Option<f64>,
    /// Whether dates have the day before the month; `None` to find out.
    pub day_first: Option<bool>,
    /// Names of columns.
    pub columns: BTreeMap<Quantity, String>,
    /// Factors to SI of the quantities whose unit is given.
    pub factors: BTreeMap<Quantity, f64>,
    /// The sensors towards bow and stern; `None` without both.
    pub sensors: Option<[Sensor; 2]>,
    /// Whether a positive angle in the log has the bow nearer to the quay; `None` if not stated.
    pub is_bow_in: Option<bool>,
    /// Readings without a hull.
    pub lost: Vec<String>,
    /// Longest distance that a sensor measures (m).
    pub farthest_m: f64,
    /// Name of the scenario's body that berths.
    pub ship: Option<String>,
    /// Name of the berth in the logs.
    pub berth: Option<String>,
    /// Place of the ship's centre of gravity along the quay (m); `None` for the place in the scenario.
    pub ship_place_m: Option<f64>,
    /// Standard deviation of that place (m).
    pub ship_place_sd_m: f64,
    /// Standard deviation of the speed along the quay where it is not measured (m/s).
    pub along_speed_sd_mps: f64,
    /// Place of the antenna, forward and to starboard of the centre of gravity (m); `None` if not stated.
    pub antenna_m: Option<Vec2>,
    /// Latitude and longitude of the scenario's origin (rad).
    pub origin_rad: Option<[f64; 2]>,
    /// Standard deviation of the constant error of a track's positions (m); `None` for the default.
    pub position_sd_m: Option<f64>,
    /// Standard deviation of the constant error of a track's headings (rad); `None` for the default.
    pub heading_sd_rad: Option<f64>,
    /// Length of time before the touch through which a parabola is laid (s); `None` for the default.
    pub bandwidth_s: Option<f64>,
    /// Distance from the nearest fender at which the run begins (m).
    pub run_from_m: f64,
    /// Distance from the nearest fender from which a run follows the measured path (m); `None` for no such run.
    pub follow_from_m: Option<f64>,
    /// Further columns for the table.
    pub keep: Vec<String>,
    /// Ships by name, in the order of the file.
    pub ships: Vec<(String, ShipOfLog)>,
}

impl Default for Mapping {
    fn default() -> Mapping {
        Mapping::parse("", "the default mapping").expect("every key has a meaning if absent")
    }
}

impl Mapping {
    /// Reads the text of a mapping file; `name` is for messages.
    ///
    /// # Errors
    /// Reports the first mistake with file, line and key: text that is not TOML, an unknown key, a bad value, a unit
    /// of another dimension, one sensor without the other, two sensors in one place or in the wrong order, or a change
    /// that is not KEY=VALUE.
    pub fn parse(text: &str, name: &str) -> Read<Mapping> {
        let sources = Sources::new(name, text, &[]);
        let document = syntax::parse(&sources)?;
        let end = text.trim_end().len();
        let file = reader::table(&sources, &MAPPING, "", end..end, &document)?;
        let file = file.of::<MappingKey>();
        let number = |entry: Option<Entry<'_, fenderline_keys::held::Number>>| {
            entry.map(|entry| *entry.number())
        };
        let words = |entry: Option<Entry<'_, Text>>| entry.map(|entry| entry.text().to_owned());
        let zone = file.item(MappingKey::TIME_ZONE).map(|entry| {
            zone_s(entry.text()).ok_or_else(|| {
                let message = format!("\"{}\" is no time zone", entry.text());
                let error = sources.error(&entry.span, MappingKey::TIME_ZONE.name(), message);
                error.with_help(
                    "write hours and minutes east of Greenwich, as \"+02:00\", or \"UTC\"",
                )
            })
        });
        let origin = file.item(MappingKey::ORIGIN).map(|entry| {
            let table = entry.table();
            [OriginKey::LATITUDE, OriginKey::LONGITUDE].map(|key| *table.given(key).number())
        });
        Ok(Mapping {
            kind: file.item(MappingKey::KIND).map(Entry::choice),
            zone_s: zone.transpose()?,
            day_first: file.item(MappingKey::DATES).map(Entry::choice),
            columns: columns(file),
            factors: factors(&sources, file)?,
            sensors: sensors(&sources, file)?,
            is_bow_in: file.item(MappingKey::ANGLE_POSITIVE).map(Entry::choice),
            lost: file.given(MappingKey::LOST).texts().to_vec(),
            farthest_m: *file.given(MappingKey::FARTHEST).number(),
            ship: words(file.item(MappingKey::SHIP)),
            berth: words(file.item(MappingKey::BERTH)),
            ship_place_m: number(file.item(MappingKey::SHIP_PLACE)),
            ship_place_sd_m: *file.given(MappingKey::SHIP_PLACE_DEVIATION).number(),
            along_speed_sd_mps: *file.given(MappingKey::LONGITUDINAL_SPEED_DEVIATION).number(),
            antenna_m: file.item(MappingKey::ANTENNA).map(|entry| {
                let at = entry.vector();
                vec2(at.x, at.y)
            }),
            origin_rad: origin,
            position_sd_m: number(file.item(MappingKey::POSITION_DEVIATION)),
            heading_sd_rad: number(file.item(MappingKey::HEADING_DEVIATION)),
            bandwidth_s: number(file.item(MappingKey::BANDWIDTH)),
            run_from_m: *file.given(MappingKey::RUN_FROM).number(),
            follow_from_m: number(file.item(MappingKey::FOLLOW_FROM)),
            keep: file.given(MappingKey::KEEP).texts().to_vec(),
            ships: ships(&sources, file)?,
        })
    }

    /// The ship of the logs that has this name or this identity.
    #[must_use]
    pub fn ship_called(&self, name: &str, mmsi: Option<u32>) -> Option<&(String, ShipOfLog)> {
        let is_her = |(own, ship): &&(String, ShipOfLog)| {
            own.eq_ignore_ascii_case(name) || (mmsi.is_some() && ship.mmsi == mmsi)
        };
        self.ships.iter().find(is_her)
    }
}

/// The JSON Schema (draft 2020-12) of mapping files, which [`Mapping::parse`] reads.
#[must_use]
pub fn mapping_schema() -> serde_json::Value {
    whole_file(&MAPPING, "Fenderline mapping of measured berthings")
}

fn columns(file: Of<'_, MappingKey>) -> BTreeMap<Quantity, String> {
    let Some(entry) = file.item(MappingKey::COLUMNS) else { return BTreeMap::new() };
    let table = entry.table();
    let keys = [
        (ColumnsKey::TIME, Quantity::Time),
        (ColumnsKey::DATE, Quantity::Date),
        (ColumnsKey::BOW_DISTANCE, Quantity::BowDistance),
        (ColumnsKey::STERN_DISTANCE, Quantity::SternDistance),
        (ColumnsKey::BOW_SPEED, Quantity::BowSpeed),
        (ColumnsKey::STERN_SPEED, Quantity::SternSpeed),
        (ColumnsKey::ANGLE, Quantity::Angle),
        (ColumnsKey::ALONG, Quantity::Along),
        (ColumnsKey::SHIP, Quantity::Ship),
        (ColumnsKey::BERTH, Quantity::Berth),
        (ColumnsKey::LATITUDE, Quantity::Latitude),
        (ColumnsKey::LONGITUDE, Quantity::Longitude),
        (ColumnsKey::HEADING, Quantity::Heading),
        (ColumnsKey::RATE_OF_TURN, Quantity::RateOfTurn),
    ];
    let named = keys
        .into_iter()
        .filter_map(|(key, quantity)| Some((quantity, table.item(key)?.text().to_owned())));
    named.collect()
}

fn factors(sources: &Sources<'_>, file: Of<'_, MappingKey>) -> Read<BTreeMap<Quantity, f64>> {
    let mut factors = BTreeMap::new();
    let Some(entry) = file.item(MappingKey::UNITS) else { return Ok(factors) };
    let table = entry.table();
    for (key, measure, quantities) in [
        (
            UnitsKey::DISTANCE,
            &unit::LENGTH,
            &[Quantity::BowDistance, Quantity::SternDistance, Quantity::Along][..],
        ),
        (UnitsKey::SPEED, &unit::SPEED, &[Quantity::BowSpeed, Quantity::SternSpeed]),
        (
            UnitsKey::ANGLE,
            &unit::ANGLE,
            &[Quantity::Angle, Quantity::Latitude, Quantity::Longitude, Quantity::Heading],
        ),
        (UnitsKey::RATE_OF_TURN, &unit::RATE_OF_TURN, &[Quantity::RateOfTurn]),
    ] {
        let Some(entry) = table.item(key) else { continue };
        let factor = factor_of(entry.text(), measure.dimension).map_err(|why| {
            let path = table.path_of(key);
            sources.error(&entry.span, &path, format!("`{path}`: {why}"))
        })?;
        factors.extend(quantities.iter().map(|quantity| (*quantity, factor)));
    }
    Ok(factors)
}

/// Other spellings of units in the heads of logs.
const SPELLINGS: [(&str, &str); 12] = [
    ("kts", "kn"),
    ("kt", "kn"),
    ("knots", "kn"),
    ("feet", "ft"),
    ("meter", "m"),
    ("meters", "m"),
    ("metres", "m"),
    ("degrees", "deg"),
    ("mps", "m/s"),
    ("cmps", "cm/s"),
    ("deg/minute", "deg/min"),
    ("°/min", "deg/min"),
];

/// The factor to SI of a unit of the dimension `dimension`.
///
/// # Errors
/// Says what is wrong with the unit.
pub(crate) fn factor_of(text: &str, dimension: Dimension) -> Result<f64, String> {
    let text = text.trim();
    let spelt = SPELLINGS.iter().find(|(other, _)| text.eq_ignore_ascii_case(other));
    let text = spelt.map_or(text, |(_, usual)| usual);
    let parsed = units::parse(&format!("1 {text}")).map_err(|error| match error.help {
        Some(help) => format!("{}; {help}", error.message),
        None => error.message,
    })?;
    match parsed.has_unit && parsed.dimension == dimension {
        true => Ok(parsed.si),
        false => Err(format!("`{text}` is {}, but must be {dimension}", parsed.dimension)),
    }
}

fn sensors(sources: &Sources<'_>, file: Of<'_, MappingKey>) -> Read<Option<[Sensor; 2]>> {
    let keys = [MappingKey::BOW_SENSOR, MappingKey::STERN_SENSOR];
    let given = keys.map(|key| file.item(key));
    let sensor = |table: Of<'_, SensorKey>| Sensor {
        place_m: *table.given(SensorKey::PLACE).number(),
        behind_m: *table.given(SensorKey::BEHIND).number(),
    };
    match given {
        [None, None] => Ok(None),
        [Some(bow), Some(stern)] => {
            let both = [sensor(bow.table()), sensor(stern.table())];
            if both[0].place_m - both[1].place_m >= 1.0 {
                return Ok(Some(both));
            }
            let message = "the bow's sensor must stand at least 1 m nearer to the ship's bow than the stern's";
            let error = sources.error(&stern.span, keys[1].name(), message);
            Err(error.with_help("`place` is positive towards the bow of the scenario's ship"))
        }
        [Some(own), None] | [None, Some(own)] => {
            let message = "a docking log needs both `bow_sensor` and `stern_sensor`";
            Err(sources.error(&own.span, own.name, message))
        }
    }
}

fn ships(sources: &Sources<'_>, file: Of<'_, MappingKey>) -> Read<Vec<(String, ShipOfLog)>> {
    let tables = file.given(MappingKey::SHIPS).named();
    let ship = |(name, table): (&String, Of<'_, ShipKey>)| {
        let given = table.given(ShipKey::SET);
        let set = given.texts().iter().map(|text| {
            let origin = sources.origin(&given.span);
            Override::parse(text).map_err(|error| error.at_origin(&origin))
        });
        let mmsi = table.item(ShipKey::MMSI).map(|entry| *entry.number() as u32);
        Ok((name.clone(), ShipOfLog { mmsi, set: set.collect::<Read<_>>()? }))
    };
    tables.iter().map(ship).collect()
}
