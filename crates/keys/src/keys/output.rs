//! Keys that choose the result tables of a run.

use crate::held::{Number, Texts};
use crate::spec::Absent::Means;
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static OUTPUT: TableSpec = TableSpec {
    what: "an output table",
    doc: "Which result tables a run writes, and how often. Summary, verdict and report of a run \
          always use every step, whatever the tables hold.",
    keys: OutputKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of the table `[output]`, which chooses the result tables of a run.
    pub OutputKey {
        INTERVAL: Number = key(
            "interval",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 1e9 }),
            Means(
                "the time step; in runs of more than 10 000 steps, an interval of 2, 5, 10, 20, … \
                 steps, so that each body has at most 10 000 rows",
            ),
            "Length of time that one row of a result table covers: a whole number of time steps, \
             or 0 for one step. A row holds positions and velocities at the start of the row's \
             time, mean forces, in columns with `peak_` the largest value of any step, and work \
             summed over the steps.",
            &["\"1 s\"", "0"],
        ),
        TABLES: Texts = key(
            "tables",
            Kind::Texts,
            Means(
                "all tables that would have a row for this scenario; `contacts` only if a row \
                 covers one step",
            ),
            "Names of the result tables to write: bodies, contacts, fenders, panels, chains, \
             vessels, thrusters, azimuths, tugs, lines, anchors, energy. With an empty list the \
             run writes no tables.",
            &["[\"fenders\", \"lines\"]"],
        ),
    }
}
