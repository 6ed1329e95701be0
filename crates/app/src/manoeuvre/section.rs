//! What a manoeuvre gave, ready to be shown.

use fenderline_sim::hydro::manoeuvres::Moment;

/// The measures of one manoeuvre.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Section {
    /// As the command line has it.
    pub(super) manoeuvre: String,
    /// With its conditions.
    pub(super) title: String,
    /// One a run: `starboard`, `port`.
    pub(super) columns: Vec<String>,
    pub(super) rows: Vec<Row>,
    /// What the reader must know to believe the numbers.
    pub(super) notes: Vec<&'static str>,
    pub(super) tracks: Vec<Track>,
}

/// One measure of every run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    /// In JSON.
    pub(super) key: &'static str,
    /// In print.
    pub(super) label: &'static str,
    pub(super) unit: Unit,
    /// One a column, in the unit.
    pub(super) values: Vec<f64>,
    /// The most that IMO allows.
    pub(super) imo_limit: Option<f64>,
}

/// What a measure is counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unit {
    /// Ship's lengths.
    Lengths,
    /// Degrees.
    Degrees,
    /// Seconds.
    Seconds,
    /// Knots.
    Knots,
    /// Revolutions a minute.
    PerMinute,
    /// Kilonewtons.
    Kilonewtons,
    /// A plain number.
    One,
}

/// Where a ship went.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Track {
    /// Of the file, without its ending.
    pub(super) name: String,
    pub(super) moments: Vec<Moment>,
}

impl Row {
    /// A measure without a limit.
    pub(super) fn new(key: &'static str, label: &'static str, unit: Unit, values: Vec<f64>) -> Row {
        Row { key, label, unit, values, imo_limit: None }
    }

    /// With a limit, where there is one.
    pub(super) fn limited(self, imo_limit: Option<f64>) -> Row {
        Row { imo_limit, ..self }
    }

    /// Whether every run keeps the limit; `None` without one.
    pub(super) fn is_within(&self) -> Option<bool> {
        self.imo_limit.map(|limit| self.values.iter().all(|value| value.abs() <= limit))
    }
}

impl Unit {
    /// As printed behind a number.
    pub(super) fn text(self) -> &'static str {
        match self {
            Unit::Lengths => "L",
            Unit::Degrees => "°",
            Unit::Seconds => "s",
            Unit::Knots => "kn",
            Unit::PerMinute => "rpm",
            Unit::Kilonewtons => "kN",
            Unit::One => "",
        }
    }

    /// Decimals in print.
    pub(super) fn decimals(self) -> usize {
        match self {
            Unit::Lengths | Unit::Knots => 2,
            Unit::Degrees | Unit::PerMinute => 1,
            Unit::Seconds => 0,
            Unit::Kilonewtons | Unit::One => 3,
        }
    }
}
