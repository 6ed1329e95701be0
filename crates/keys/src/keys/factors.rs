//! Keys of partial factors.

use fenderline_sim::factors::LineCapacity;
use serde_json::json;

use crate::choices::{Choice, Choices};
use crate::held::{Number, OneOf, Text};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

const FACTOR: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.1, high: 10.0 };

pub(super) static FACTORS: TableSpec = TableSpec {
    what: "a table of partial factors",
    doc: "Partial factors on the results of the run, with their source. fenderline has no factors \
        of any guideline, and claims no conformity: take the factors of your guideline. Report, \
        summary and verdict of a run show the partial factors with their source.",
    keys: FactorsKey::ALL,
    rules: Some(|| {
        json!({
            "anyOf": [
                { "required": ["energy"] }, { "required": ["reaction"] }, { "required": ["line_load"] }
            ],
            "dependentRequired": { "reaction_limit": ["reaction"], "line_capacity": ["line_load"] }
        })
    }),
};

table_keys! {
    /// Keys of a table of partial factors.
    pub FactorsKey {
        SOURCE: Text = key(
            "source",
            Kind::Text,
            Refused,
            "Source of the factors, in your words.",
            &["\"design basis 4711, table 3\""],
        ),
        ENERGY: Number = key(
            "energy",
            Kind::Quantity(FACTOR),
            Means("energies have no factor"),
            "Factor on the energy that a fender absorbs. The absorbed energy times this factor is \
             compared with the rated energy.",
            &["1.25"],
        ),
        REACTION: Number = key(
            "reaction",
            Kind::Quantity(FACTOR),
            Means("reactions have no factor"),
            "Factor on the reaction of a fender. The reaction times this factor is compared with \
             `reaction_limit`.",
            &["1.1"],
        ),
        REACTION_LIMIT: Number = key(
            "reaction_limit",
            Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e10 }),
            Means("the results show the factored reactions without comparing them with a limit"),
            "Reaction that the structure behind a fender can resist.",
            &["\"1.8 MN\""],
        ),
        LINE_LOAD: Number = key(
            "line_load",
            Kind::Quantity(FACTOR),
            Means("line loads have no factor"),
            "Factor on the tension of a line. The tension times this factor is compared with \
             `line_capacity`.",
            &["1.3"],
        ),
        LINE_CAPACITY: OneOf<LineCapacity> = key(
            "line_capacity",
            Kind::Choice(&CAPACITIES),
            Is("\"working_load\""),
            "Capacity of a line with which its factored tension is compared.",
            &["\"break_load\""],
        ),
    }
}

static CAPACITIES: Choices<LineCapacity> = Choices(&[
    Choice {
        word: "working_load",
        value: LineCapacity::WorkingLoad,
        doc: "the working load of the line",
    },
    Choice {
        word: "break_load",
        value: LineCapacity::BreakLoad,
        doc: "the break load of the line: the smaller one of the break loads of rope and tail",
    },
]);
