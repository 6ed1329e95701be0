//! Keys of a campaign file for a downtime analysis, which counts the hours that a berth loses to the weather.

use fenderline_keys::held::{Number, Text};
use fenderline_keys::spec::Absent::{Is, Refused};
use fenderline_keys::spec::{Kind, Quantity, TableSpec, key};
use fenderline_keys::table_keys;
use fenderline_keys::units::measures as unit;

/// Largest number of states, and of hours of the sample: far more than the hours of a year.
const MOST: f64 = 1e6;

pub(super) static DOWNTIME: TableSpec = TableSpec {
    what: "a downtime",
    doc: "Hours that a berth loses to the weather: the hours of a series of waves, wind and \
        current are grouped into states, each state is a run of the scenario, and an hour is lost \
        if its state exceeds a limit. The limits are those of the scenario, [limit.NAME]. A \
        fender over its rating, a line over its working load, and any failure count too.",
    keys: DowntimeKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a downtime.
    pub(crate) DowntimeKey {
        FILE: Text = key(
            "file",
            Kind::Text,
            Refused,
            "The file of the weather, CSV or Parquet, relative to the campaign file. Columns: \
             hs_m, tp_s and wave_from_deg; wind_speed_mps and wind_from_deg; current_speed_mps and \
             current_towards_deg; level_m of the water above datum; at least one of waves, wind \
             and current. A series has `time` too, as 2025-01-31T23:00, or t_s, at equal steps \
             without gaps. A scatter diagram has `hours` in a year, or `share` of a year, instead.",
            &["\"hindcast.csv\""],
        ),
        STATES: Number = key(
            "states",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: MOST }),
            Is("300"),
            "Largest number of states into which the hours of a series are grouped. Each row of a \
             scatter diagram is a state.",
            &["150"],
        ),
        SAMPLE: Number = key(
            "sample",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: MOST }),
            Is("60"),
            "Number of single hours of a series, drawn at random by `seed`, that are also run with \
             their own weather. These single hours show how large the error of the grouping into \
             states is. A scatter diagram has no single hours.",
            &["200"],
        ),
    }
}
