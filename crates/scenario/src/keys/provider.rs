//! Keys of programs that put forces on bodies.

use crate::spec::Absent::{Is, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec};
use crate::units::measures as unit;

pub(super) static PROVIDER: TableSpec = TableSpec {
    what: "a provider",
    doc: "Another program that puts a force on a body each step. It is started with the run and asked once \
          a step by one line of JSON on its standard input; its answer is one line on its standard \
          output (examples/provider shows one in Python).",
    keys: &[
        KeySpec {
            name: "body",
            kind: Kind::BodyName,
            absent: Refused,
            doc: "The floating body that it acts on.",
            examples: &["\"ship\""],
        },
        KeySpec {
            name: "command",
            kind: Kind::Texts,
            absent: Refused,
            doc: "Program and arguments; relative paths start where the run was started.",
            examples: &["[\"python3\", \"examples/provider/drag.py\"]"],
        },
        KeySpec {
            name: "timeout",
            kind: Kind::Quantity(Quantity { measure: &unit::TIME, low: 1e-3, high: 3600.0 }),
            absent: Is("1"),
            doc: "How long a step waits for its answer.",
            examples: &["\"0.5 s\""],
        },
        KeySpec {
            name: "hold",
            kind: Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 1e9 }),
            absent: Is("5"),
            doc: "How long its last force is held when it falls silent; then it is dropped.",
            examples: &["\"2 s\""],
        },
    ],
    rules: None,
};
