//! The results of a manoeuvre, ready to be printed.

use fenderline_sim::hydro::manoeuvres::Moment;

/// The measures of one manoeuvre.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Section {
    /// Its name on the command line.
    pub(super) manoeuvre: String,
    /// Title with the conditions.
    pub(super) title: String,
    /// One column per run: `starboard`, `port`.
    pub(super) columns: Vec<String>,
    pub(super) rows: Vec<Row>,
    /// Assumptions that the reader must know.
    pub(super) notes: Vec<&'static str>,
    pub(super) tracks: Vec<Track>,
}

/// One measure of every run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    /// Its key in JSON.
    pub(super) key: &'static str,
    /// Its name in the table.
    pub(super) label: &'static str,
    pub(super) unit: Unit,
    /// One value per column, in the unit.
    pub(super) values: Vec<f64>,
    /// IMO's limit.
    pub(super) imo_limit: Option<f64>,
}

/// The unit of a measure.
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

/// The track of a ship.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Track {
    /// Name of the file, without its ending.
    pub(super) name: String,
    pub(super) moments: Vec<Moment>,
}

impl Row {
    /// A measure without a limit.
    pub(super) fn new(key: &'static str, label: &'static str, unit: Unit, values: Vec<f64>) -> Row {
        Row { key, label, unit, values, imo_limit: None }
    }

    /// A measure with a limit, if there is one.
    pub(super) fn limited(self, imo_limit: Option<f64>) -> Row {
        Row { imo_limit, ..self }
    }

    /// Whether every run is within the limit; `None` without one.
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
