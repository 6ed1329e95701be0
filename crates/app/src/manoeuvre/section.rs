//! The results of a manoeuvre, ready to be printed.

use fenderline_sim::hydro::manoeuvres::Moment;

/// The measured results of one manoeuvre.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Section {
    /// Name of the manoeuvre on the command line.
    pub(super) manoeuvre: String,
    /// Title of the section, with the conditions of the manoeuvre.
    pub(super) title: String,
    /// Names of the columns, one for each run, such as `starboard` and `port`.
    pub(super) columns: Vec<String>,
    pub(super) rows: Vec<Row>,
    /// Assumptions of the manoeuvre that the reader must know.
    pub(super) notes: Vec<&'static str>,
    pub(super) tracks: Vec<Track>,
}

/// A row of the section: one measured quantity of every run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    /// Key of the quantity in JSON.
    pub(super) key: &'static str,
    /// Name of the quantity in the printed table.
    pub(super) label: &'static str,
    pub(super) unit: Unit,
    /// One value for each column, in the row's unit.
    pub(super) values: Vec<f64>,
    /// IMO's limit.
    pub(super) imo_limit: Option<f64>,
}

/// The unit of a measured quantity.
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
    /// Name of the track's file, without its extension.
    pub(super) name: String,
    pub(super) moments: Vec<Moment>,
}

impl Row {
    /// Makes a row for a quantity without a limit.
    pub(super) fn new(key: &'static str, label: &'static str, unit: Unit, values: Vec<f64>) -> Row {
        Row { key, label, unit, values, imo_limit: None }
    }

    /// Makes a row for a quantity that may have a limit of IMO.
    pub(super) fn limited(self, imo_limit: Option<f64>) -> Row {
        Row { imo_limit, ..self }
    }

    /// Whether every run is within IMO's limit; `None` if there is no limit.
    pub(super) fn is_within(&self) -> Option<bool> {
        self.imo_limit.map(|limit| self.values.iter().all(|value| value.abs() <= limit))
    }
}

impl Unit {
    /// The unit's text as it is printed behind a number.
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
