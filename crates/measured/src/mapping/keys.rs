//! Every key of a mapping file, in the form of [`fenderline_keys::keys`].

use fenderline_keys::choices::{Choice, Choices};
use fenderline_keys::held::{NamedOf, Number, OneOf, TableOf, Text, Texts, Vector};
use fenderline_keys::spec::Absent::{Is, Means, Refused};
use fenderline_keys::spec::{Kind, Quantity, TableSpec, key};
use fenderline_keys::table_keys;
use fenderline_keys::units::measures as unit;

use crate::log::LogKind;

const PLACE: Quantity = Quantity { measure: &unit::LENGTH, low: -1e4, high: 1e4 };
const TIME: Quantity = Quantity { measure: &unit::TIME, low: 1.0, high: 3600.0 };

static KINDS: Choices<LogKind> = Choices(&[
    Choice {
        word: "docking",
        value: LogKind::Docking,
        doc: "a table of the distances of two sensors on the quay",
    },
    Choice {
        word: "track",
        value: LogKind::Track,
        doc: "a table of latitude, longitude and heading of an antenna on board",
    },
    Choice { word: "nmea", value: LogKind::Nmea, doc: "NMEA 0183 sentences of the ship" },
    Choice { word: "ais", value: LogKind::Ais, doc: "AIS sentences of a receiver" },
]);

static DAY_FIRST: Choices<bool> = Choices(&[
    Choice { word: "day first", value: true, doc: "31/01/2025" },
    Choice { word: "month first", value: false, doc: "01/31/2025" },
]);

static BOW_IN: Choices<bool> = Choices(&[
    Choice { word: "bow in", value: true, doc: "the bow points towards the quay" },
    Choice { word: "stern in", value: false, doc: "the stern points towards the quay" },
]);

/// The whole file.
pub(crate) static MAPPING: TableSpec = TableSpec {
    what: "a mapping",
    doc: "What the columns of a docking log or a track mean, where the sensors or the antenna stand, and which ship \
        of the scenario a ship of the log is.",
    keys: MappingKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a mapping.
    pub(crate) MappingKey {
        KIND: OneOf<LogKind> = key(
            "kind",
            Kind::Choice(&KINDS),
            Means("it is guessed from the first lines of each log, and the guess is told"),
            "What the logs hold.",
            &["\"docking\""],
        ),
        TIME_ZONE: Text = key(
            "time_zone",
            Kind::Text,
            Means("UTC; this is told if the times of a log name no zone"),
            "Time zone of times that name none, as hours and minutes east of Greenwich.",
            &["\"+02:00\""],
        ),
        DATES: OneOf<bool> = key(
            "dates",
            Kind::Choice(&DAY_FIRST),
            Means("31.01.2025 has the day first; with slashes, the first date that leaves no doubt decides"),
            "Order of dates that do not begin with the year.",
            &["\"day first\""],
        ),
        COLUMNS: TableOf<ColumnsKey> = key(
            "columns",
            Kind::Table(&COLUMNS),
            Means("usual names are found, and told"),
            "Names of the columns in the logs.",
            &[],
        ),
        UNITS: TableOf<UnitsKey> = key(
            "units",
            Kind::Table(&UNITS),
            Means("the unit stands in the name of the column, as in `Bow (ft)`; else see the keys"),
            "Units of the columns.",
            &[],
        ),
        BOW_SENSOR: TableOf<SensorKey> = key(
            "bow_sensor",
            Kind::Table(&SENSOR),
            Means("a docking log is refused"),
            "The sensor towards the ship's bow.",
            &["{ place = \"45 m\" }"],
        ),
        STERN_SENSOR: TableOf<SensorKey> = key(
            "stern_sensor",
            Kind::Table(&SENSOR),
            Means("a docking log is refused"),
            "The sensor towards the ship's stern.",
            &["{ place = \"-45 m\" }"],
        ),
        ANGLE_POSITIVE: OneOf<bool> = key(
            "angle_positive",
            Kind::Choice(&BOW_IN),
            Means("the sign of the log's angle is compared with the distances, and told if it is the opposite"),
            "When the angle in the log is positive. With this key, an angle of the opposite sign means that the \
             sensors are swapped, and the berthing is refused.",
            &["\"bow in\""],
        ),
        LOST: Texts = key(
            "lost",
            Kind::Texts,
            Is("[]"),
            "Readings that mean that a sensor does not see the hull, beside empty cells and texts.",
            &["[\"999\", \"0\"]"],
        ),
        FARTHEST: Number = key(
            "farthest",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1.0, high: 1e4 }),
            Is("\"300 m\""),
            "Longest distance that a sensor measures; a longer reading means that the sensor does not see the hull.",
            &["\"200 m\""],
        ),
        SHIP: Text = key(
            "ship",
            Kind::Text,
            Means("the ship of the scenario's [berthing]"),
            "Name of the scenario's body that berths.",
            &["\"ship\""],
        ),
        BERTH: Text = key(
            "berth",
            Kind::Text,
            Means("all rows are of this berth"),
            "Which berth's rows to read, where a log has a column `berth`; the others are counted and left out.",
            &["\"4\""],
        ),
        SHIP_PLACE: Number = key(
            "ship_place",
            Kind::Quantity(PLACE),
            Means("the place of the ship at the start of the scenario"),
            "Place of the ship's centre of gravity along the quay when she berths, from the middle of the fenders, \
             positive towards her bow; for logs that do not measure it.",
            &["\"-3 m\""],
        ),
        SHIP_PLACE_DEVIATION: Number = key(
            "ship_place_deviation",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e3 }),
            Is("\"1 m\""),
            "Standard deviation of the ship's place along the quay, for logs that do not measure it.",
            &["\"0.5 m\""],
        ),
        LONGITUDINAL_SPEED_DEVIATION: Number = key(
            "longitudinal_speed_deviation",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.0, high: 10.0 }),
            Is("\"2 cm/s\""),
            "Standard deviation of the ship's speed along the quay, for logs that do not measure it.",
            &["\"5 cm/s\""],
        ),
        ANTENNA: Vector = key(
            "antenna",
            Kind::Point(PLACE),
            Means("the antenna is at the centre of gravity, or where AIS message 5 says"),
            "Place of the antenna on board: forward and to starboard of the centre of gravity.",
            &["[\"-60 m\", \"4 m\"]"],
        ),
        ORIGIN: TableOf<OriginKey> = key(
            "origin",
            Kind::Table(&ORIGIN),
            Means("the origin of the scenario's [chart]"),
            "Latitude and longitude of the scenario's origin, for tracks.",
            &["{ latitude = \"51.95 deg\", longitude = \"4.05 deg\" }"],
        ),
        POSITION_DEVIATION: Number = key(
            "position_deviation",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e3 }),
            Means("5 m for AIS, 5 cm for other tracks; this is told"),
            "Standard deviation of the constant error of a track's positions. A track that goes on while the ship lies \
             alongside is moved so that she lies at the fenders, which takes this error out square to the quay.",
            &["\"0.5 m\""],
        ),
        HEADING_DEVIATION: Number = key(
            "heading_deviation",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: 0.0, high: 1.0 }),
            Means("1° for AIS, 0 for other tracks"),
            "Standard deviation of the constant error of a track's headings.",
            &["\"0.5 deg\""],
        ),
        BANDWIDTH: Number = key(
            "bandwidth",
            Kind::Quantity(TIME),
            Means("30 s, and longer for a log with few rows, up to 120 s; the table states it"),
            "Length of time before the touch through which the parabola is laid.",
            &["\"20 s\""],
        ),
        RUN_FROM: Number = key(
            "run_from",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.05, high: 50.0 }),
            Is("\"2 m\""),
            "Distance of the ship from the nearest fender at which the run begins from the measured state.",
            &["\"1 m\""],
        ),
        FOLLOW_FROM: Number = key(
            "follow_from",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1.0, high: 1e4 }),
            Means("no run follows the measured path"),
            "Distance of the ship from the nearest fender from which a second run follows the measured path to the touch. The \
             force that keeps the ship on the path tells what tugs, thrusters and wind together gave.",
            &["\"20 m\""],
        ),
        KEEP: Texts = key(
            "keep",
            Kind::Texts,
            Is("[]"),
            "Further columns of the logs, such as tide, class or pilot, whose values at the touch go into the table.",
            &["[\"Tide\", \"Class\"]"],
        ),
        SHIPS: NamedOf<ShipKey> = key(
            "ships",
            Kind::Named(&SHIP_OF_LOG),
            Is("{}"),
            "Ships by their names in the logs.",
            &[],
        ),
    }
}

static COLUMNS: TableSpec = TableSpec {
    what: "columns",
    doc: "Names of the columns in the logs, as written there, with or without the unit in brackets.",
    keys: ColumnsKey::ALL,
    rules: None,
};

macro_rules! columns {
    ($($id:ident = $name:literal, $doc:literal, $example:literal;)*) => {
        table_keys! {
            /// Keys of columns.
            pub(crate) ColumnsKey {
                $($id: Text = key(
                    $name,
                    Kind::Text,
                    Means("usual names are found"),
                    $doc,
                    &[$example],
                ),)*
            }
        }
    };
}

columns! {
    TIME = "time", "Time, with or without the date.", "\"Timestamp\"";
    DATE = "date", "Date, where it has a column of its own.", "\"Date\"";
    BOW_DISTANCE = "bow_distance", "Distance of the hull at the bow sensor.", "\"Dist A\"";
    STERN_DISTANCE = "stern_distance", "Distance of the hull at the stern sensor.", "\"Dist B\"";
    BOW_SPEED = "bow_speed", "Speed at the bow sensor; it checks the distances.", "\"Speed A\"";
    STERN_SPEED = "stern_speed", "Speed at the stern sensor; it checks the distances.", "\"Speed B\"";
    ANGLE = "angle", "Angle between ship and quay; it checks the distances.", "\"Angle\"";
    ALONG = "along", "Place of the ship's centre of gravity along the quay, from the middle of the fenders, positive towards her bow.", "\"Offset\"";
    SHIP = "ship", "Name of the ship.", "\"Vessel\"";
    BERTH = "berth", "Name of the berth.", "\"Jetty\"";
    LATITUDE = "latitude", "Latitude of the antenna.", "\"Lat\"";
    LONGITUDE = "longitude", "Longitude of the antenna.", "\"Lon\"";
    HEADING = "heading", "Heading from true north.", "\"HDG\"";
    RATE_OF_TURN = "rate_of_turn", "Rate of turn, positive to starboard.", "\"ROT\"";
}

static UNITS: TableSpec = TableSpec {
    what: "units",
    doc: "Units of the columns whose names do not state a unit.",
    keys: UnitsKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of units.
    pub(crate) UnitsKey {
        DISTANCE: Text = key(
            "distance",
            Kind::Text,
            Means("m; this is told"),
            "Unit of the distances, and of the place along the quay.",
            &["\"ft\""],
        ),
        SPEED: Text = key(
            "speed",
            Kind::Text,
            Means("m/s; this is told"),
            "Unit of the speeds.",
            &["\"cm/s\""],
        ),
        ANGLE: Text = key(
            "angle",
            Kind::Text,
            Means("degrees"),
            "Unit of angle, latitude, longitude and heading.",
            &["\"rad\""],
        ),
        RATE_OF_TURN: Text = key(
            "rate_of_turn",
            Kind::Text,
            Means("degrees a minute; this is told"),
            "Unit of the rate of turn.",
            &["\"deg/s\""],
        ),
    }
}

static SENSOR: TableSpec = TableSpec {
    what: "a sensor",
    doc: "A sensor on the quay that measures the distance of the hull square to the line of the fenders.",
    keys: SensorKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a sensor.
    pub(crate) SensorKey {
        PLACE: Number = key(
            "place",
            Kind::Quantity(PLACE),
            Refused,
            "Place along the quay from the middle of the fenders, positive towards the ship's bow.",
            &["\"45 m\""],
        ),
        BEHIND: Number = key(
            "behind",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: -100.0, high: 100.0 }),
            Is("0"),
            "Reading of the sensor when the hull is at the faces of the fenders: 0 for a system that shows distances \
             to the fenders, the distance of the sensor behind the faces for one that shows its own readings.",
            &["\"1.9 m\""],
        ),
    }
}

static ORIGIN: TableSpec = TableSpec {
    what: "an origin",
    doc: "Latitude and longitude of the scenario's origin on WGS 84.",
    keys: OriginKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of an origin.
    pub(crate) OriginKey {
        LATITUDE: Number = key(
            "latitude",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: -1.48, high: 1.48 }),
            Refused,
            "Latitude, north positive.",
            &["\"51.95 deg\""],
        ),
        LONGITUDE: Number = key(
            "longitude",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: -3.2, high: 3.2 }),
            Refused,
            "Longitude, east positive.",
            &["\"4.05 deg\""],
        ),
    }
}

static SHIP_OF_LOG: TableSpec = TableSpec {
    what: "a ship",
    doc: "A ship of the logs: how the scenario's ship is changed for her.",
    keys: ShipKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a ship.
    pub(crate) ShipKey {
        MMSI: Number = key(
            "mmsi",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 999_999_999.0 }),
            Means("AIS tells her by her name"),
            "Her maritime mobile service identity in AIS.",
            &["244000123"],
        ),
        SET: Texts = key(
            "set",
            Kind::Texts,
            Is("[]"),
            "Keys of the scenario that are other for this ship, as KEY=VALUE, the form of `--set`.",
            &["[\"body.ship.mass=41000 t\", \"berthing.draught=10.2 m\"]"],
        ),
    }
}
