//! Keys of the result tables.

use crate::held::{Number, Texts};
use crate::spec::Absent::Means;
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static OUTPUT: TableSpec = TableSpec {
    what: "an output table",
    doc: "Which result tables a run writes, and how often. Summary, verdict and report always use every step.",
    keys: OutputKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of an output table.
    pub OutputKey {
        INTERVAL: Number = key(
            "interval",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 1e9 }),
            Means(
                "the time step; in runs of more than 10 000 steps 2, 5, 10, 20, … steps, so that \
                 each body has at most 10 000 rows",
            ),
            "Time for which one row of a table stands: a whole number of time steps, or 0 for one \
             step. In a row, states are the states at the start of this time, forces are means, \
             columns with `peak_` hold the largest value of any step, works are sums.",
            &["\"1 s\"", "0"],
        ),
        TABLES: Texts = key(
            "tables",
            Kind::Texts,
            Means(
                "all tables for which the scenario has something; `contacts` only if a row is one \
                 step",
            ),
            "Names of the tables to write: bodies, contacts, fenders, panels, chains, vessels, thrusters, azimuths, tugs, lines, anchors, \
             energy. An empty list writes none.",
            &["[\"fenders\", \"lines\"]"],
        ),
    }
}
