//! Logs as rows in SI units.

use crate::remark::Remark;

/// What a log holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LogKind {
    /// Distances of two sensors on the quay.
    Docking,
    /// Latitude, longitude and heading of an antenna on board.
    Track,
    /// NMEA 0183 sentences of the ship.
    Nmea,
    /// AIS sentences.
    Ais,
}

impl LogKind {
    /// The kind in words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            LogKind::Docking => "docking log",
            LogKind::Track => "track",
            LogKind::Nmea => "NMEA track",
            LogKind::Ais => "AIS track",
        }
    }
}

/// A quantity that a column of a table holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Quantity {
    Time,
    Date,
    BowDistance,
    SternDistance,
    BowSpeed,
    SternSpeed,
    Angle,
    Along,
    Ship,
    Berth,
    Latitude,
    Longitude,
    Heading,
    RateOfTurn,
}

/// A row of a log in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogRow {
    /// Line of the file, from 1.
    pub line: usize,
    /// Seconds since 1970 in UTC; since midnight of the first row for a log without dates.
    pub t_s: f64,
    /// Docking log: distances at bow and stern sensor (m), and place along the quay (m). Track: north and east of the
    /// scenario's origin (m), and heading (rad). NaN: not measured.
    pub readings: [f64; 3],
    /// Docking log: speeds at bow and stern sensor (m/s); NaN: not measured.
    pub speeds_mps: [f64; 2],
    /// Docking log: the log's own angle (rad); NaN: not measured.
    pub angle_rad: f64,
}

/// The rows of one ship in one file.
#[derive(Clone, Debug, PartialEq)]
pub struct Log {
    /// Name of the file.
    pub file: String,
    /// What it holds.
    pub kind: LogKind,
    /// Name of the ship; empty if the log names none.
    pub ship: String,
    /// Maritime mobile service identity of the ship.
    pub mmsi: Option<u32>,
    /// Distances from the antenna to bow, stern, port and starboard side (m), by AIS message 5.
    pub extent_m: Option<[f64; 4]>,
    /// Whether the times have a date.
    pub is_dated: bool,
    /// Steps in which each reading is written (m or rad).
    pub steps: [f64; 3],
    /// Rows in the order of the file.
    pub rows: Vec<LogRow>,
    /// Values of the columns to keep, for each row.
    pub kept: Vec<Vec<String>>,
    /// Ship of each row by index into `names`, for a docking log with a column of ships.
    pub ship_of_row: Vec<usize>,
    /// Names of the ships of `ship_of_row`.
    pub names: Vec<String>,
}

/// A log as read, and the remarks about it.
#[derive(Clone, Debug, Default)]
pub struct LogsRead {
    /// One log for each ship of an AIS receiver, else one.
    pub logs: Vec<Log>,
    /// What was guessed and left out.
    pub remarks: Vec<Remark>,
}
