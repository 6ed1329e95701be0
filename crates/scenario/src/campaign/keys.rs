//! Every key of a campaign file, in the form of [`crate::keys`].

use crate::spec::Absent::{Is, Means, Refused, Unless};
use crate::spec::{Kind, TableSpec, key};

/// The whole file.
pub(crate) static CAMPAIGN_FILE: TableSpec = TableSpec {
    what: "a campaign",
    doc: "Many runs of one scenario: every combination of the values of its variables. Variables change in the order of the \
          file, the last one fastest.",
    keys: &[
        key(
            "title",
            Kind::Text,
            Means("the name of the file"),
            "Title of the page.",
            &["\"Fender spacing at berth 4\""],
        ),
        key(
            "scenario",
            Kind::Text,
            Refused,
            "File of the scenario, relative to this one.",
            &["\"quay.toml\""],
        ),
        key(
            "set",
            Kind::Texts,
            Is("[]"),
            "Keys of the scenario that all runs change, as KEY=VALUE, the form of `--set`.",
            &["[\"time.duration=3 min\", \"fender.*.temperature=30 degC\"]"],
        ),
        key("variable", Kind::Named(&VARIABLE), Refused, "Variables, by name.", &[]),
    ],
    rules: None,
};

static VARIABLE: TableSpec = TableSpec {
    what: "a variable",
    doc: "What differs from run to run: one key of the scenario with its `values`, or a `choice` that sets several keys at once, such as \
          a ship with her draught, mass and under-keel clearance.",
    keys: &[
        key(
            "key",
            Kind::Text,
            Unless("`choice` is given"),
            "Key of the scenario, as in `--set`.",
            &["\"body.ship.approach.speed_normal\""],
        ),
        key(
            "values",
            Kind::Values,
            Unless("`choice` is given"),
            "Its values: numbers in SI units, or texts with their units.",
            &["[\"0.08 m/s\", \"0.12 m/s\", \"0.15 m/s\"]"],
        ),
        key(
            "choice",
            Kind::Named(&CHOICE),
            Is("{}"),
            "Choices, by name, in place of `key` and `values`. Names that are numbers with the same unit, such as \"9 m\", make an axis.",
            &[],
        ),
    ],
    rules: Some(variable_rules),
};

static CHOICE: TableSpec = TableSpec {
    what: "a choice",
    doc: "A value of a variable that sets several keys.",
    keys: &[key(
        "set",
        Kind::Texts,
        Refused,
        "Keys of the scenario and their values, as KEY=VALUE, the form of `--set`.",
        &["[\"body.ship.mass=39000 t\", \"berthing.draught=9.5 m\"]"],
    )],
    rules: None,
};

/// Either one key with its values, or choices.
fn variable_rules() -> serde_json::Value {
    serde_json::json!({
        "oneOf": [
            { "required": ["key", "values"], "properties": { "choice": { "maxProperties": 0 } } },
            { "required": ["choice"], "properties": { "key": false, "values": false } },
        ]
    })
}
