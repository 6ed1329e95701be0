//! Keys of a campaign file for a variable and its choices.

use super::super::kinds::FamilyKind;
use super::super::law::LawFamily;
use fenderline_keys::choices::{Choice, Choices};
use fenderline_keys::held::{ListOf, NamedOf, Number, OneOf, Text, Texts};
use fenderline_keys::spec::Absent::{Is, Means, Refused, Unless};
use fenderline_keys::spec::{Absent, KeySpec, Kind, Quantity, TableSpec, key};
use fenderline_keys::table_keys;
use fenderline_keys::units::measures as unit;

static FAMILIES: Choices<FamilyKind> = Choices(&[
    Choice {
        word: "normal",
        value: FamilyKind::Law(LawFamily::Normal),
        doc: "normal law, given by `mean` and `standard_deviation`, or by two `quantiles`",
    },
    Choice {
        word: "lognormal",
        value: FamilyKind::Law(LawFamily::Lognormal),
        doc: "law given by `mean` and `standard_deviation` of the variable, by `log_mean` and \
              `log_standard_deviation` of its natural logarithm, or by two `quantiles`",
    },
    Choice {
        word: "Weibull",
        value: FamilyKind::Law(LawFamily::Weibull),
        doc: "F = 1 - exp(-(x/scale)^shape): given by `scale` and `shape`, by `mean` and \
              `standard_deviation`, or by two `quantiles`",
    },
    Choice {
        word: "Gumbel",
        value: FamilyKind::Law(LawFamily::Gumbel),
        doc: "law of maxima, F = exp(-exp(-(x - location)/scale)): given by `location` and `scale`, \
              by `mean` and `standard_deviation`, or by two `quantiles`",
    },
    Choice {
        word: "uniform",
        value: FamilyKind::Law(LawFamily::Uniform),
        doc: "uniform law, given by `lower` and `upper`, by `mean` and `standard_deviation`, or by two `quantiles`",
    },
    Choice {
        word: "triangular",
        value: FamilyKind::Law(LawFamily::Triangular),
        doc: "triangular law, given by `lower`, `mode` and `upper`",
    },
    Choice {
        word: "empirical",
        value: FamilyKind::Empirical,
        doc: "each of the measured values in a column of `file` is drawn with the same probability",
    },
]);

const OTHER: Absent = Means("the distribution is given by other keys");

const fn parameter(
    name: &'static str,
    doc: &'static str,
    examples: &'static [&'static str],
) -> KeySpec {
    key(name, Kind::AnyNumber, OTHER, doc, examples)
}

pub(crate) static VARIABLE: TableSpec = TableSpec {
    what: "a variable",
    doc: "What differs from run to run: keys of the scenario with `values`, a `distribution` or an `expression`; or a `choice` that sets \
          several keys at once, such as a ship with her draught, mass and under-keel clearance.",
    keys: VariableKey::ALL,
    rules: Some(variable_rules),
};

table_keys! {
    /// Keys of a variable.
    pub(crate) VariableKey {
        KEY: Text = key(
            "key",
            Kind::Text,
            Unless("`keys` or `choice` is given"),
            "Key of the scenario, as in `--set`.",
            &["\"body.ship.approach.speed_normal\""],
        ),
        KEYS: Texts = key(
            "keys",
            Kind::Texts,
            Is("[]"),
            "Several keys of the scenario that get the same value.",
            &["[\"fender.a.temperature\", \"fender.b.temperature\"]"],
        ),
        VALUES: Texts = key(
            "values",
            Kind::Values,
            Means("the variable has a `choice`, a `distribution` or an `expression`"),
            "Values of the variable: numbers in SI units, or texts with units.",
            &["[\"0.08 m/s\", \"0.12 m/s\", \"0.15 m/s\"]"],
        ),
        WEIGHTS: Texts = key(
            "weights",
            Kind::Values,
            Means("all values have the same probability"),
            "Weights of the values in a random plan; any positive numbers.",
            &["[5, 3, 1]"],
        ),
        CHOICE: NamedOf<ChoiceKey> = key(
            "choice",
            Kind::Named(&CHOICE),
            Is("{}"),
            "Choices, by name, in place of `key` and `values`. Names that are numbers with the same unit, such as \"9 m\", make an axis of numbers in the figure.",
            &[],
        ),
        DISTRIBUTION: OneOf<FamilyKind> = key(
            "distribution",
            Kind::Choice(&FAMILIES),
            Means("the variable has `values`, a `choice` or an `expression`"),
            "Distribution from which the values are drawn.",
            &["\"lognormal\""],
        ),
        UNIT: Text = key(
            "unit",
            Kind::Text,
            Means("the unit of the distribution's parameters, else SI"),
            "Unit of the variable's numbers.",
            &["\"cm/s\""],
        ),
        MEAN: Text = parameter("mean", "Mean.", &["\"7.1 cm/s\""]),
        STANDARD_DEVIATION: Text = parameter(
            "standard_deviation",
            "Standard deviation.",
            &["\"4.47 cm/s\""],
        ),
        LOG_MEAN: Text = parameter(
            "log_mean",
            "Mean of the natural logarithm of the number in its unit.",
            &["1.8"],
        ),
        LOG_STANDARD_DEVIATION: Text = parameter(
            "log_standard_deviation",
            "Standard deviation of the natural logarithm.",
            &["0.5"],
        ),
        LOCATION: Text = parameter(
            "location",
            "Location of a Gumbel law: its most frequent value.",
            &["\"5 cm/s\""],
        ),
        SCALE: Text = parameter("scale", "Scale of a Weibull or Gumbel law.", &["\"8 cm/s\""]),
        SHAPE: Text = parameter("shape", "Shape of a Weibull law.", &["1.6"]),
        LOWER: Text = parameter(
            "lower",
            "Lower end of a uniform or triangular law.",
            &["\"-2 deg\""],
        ),
        MODE: Text = parameter("mode", "Most frequent value of a triangular law.", &["\"0 deg\""]),
        UPPER: Text = parameter(
            "upper",
            "Upper end of a uniform or triangular law.",
            &["\"5 deg\""],
        ),
        QUANTILES: ListOf<QuantileKey> = key(
            "quantiles",
            Kind::List(&QUANTILE),
            Is("[]"),
            "Two values with their probabilities, in place of the parameters.",
            &[],
        ),
        AT_LEAST: Text = key(
            "at_least",
            Kind::AnyNumber,
            Means("the law is not cut below"),
            "Least value: the law is cut at this value, and the rest of the law has the whole \
             probability.",
            &["\"1 cm/s\""],
        ),
        AT_MOST: Text = key(
            "at_most",
            Kind::AnyNumber,
            Means("the law is not cut above"),
            "Greatest value: the law is cut at this value, as with `at_least`.",
            &["\"40 cm/s\""],
        ),
        FILE: Text = key(
            "file",
            Kind::Text,
            Means("the distribution is not \"empirical\""),
            "File of measured values, CSV or Parquet, relative to the campaign file.",
            &["\"speeds.csv\""],
        ),
        COLUMN: Text = key(
            "column",
            Kind::Text,
            Means("the name of the variable"),
            "Column of `file`, or of the campaign's `table`.",
            &["\"speed\""],
        ),
        EXPRESSION: Text = key(
            "expression",
            Kind::Text,
            Means("the variable has `values`, a `choice` or a `distribution`"),
            "A formula of the numbers of other variables, each in its unit, with the result in \
             `unit`. It may use + - * / ^, < <= > >= (1 if true, else 0), sqrt, abs, floor, exp, \
             ln, log10, sin, cos, tan, atan (of radians), min(a, b), max(a, b) and PI. A sign \
             counts before ^: -2^2 is 4.",
            &["\"0.6 * speed + 0.02\""],
        ),
        SOURCE: Text = key(
            "source",
            Kind::Text,
            Means("the report says that no source is given"),
            "Source of the values, for the report.",
            &["\"measurements at berth 4, 2019 to 2024\""],
        ),
    }
}

static CHOICE: TableSpec = TableSpec {
    what: "a choice",
    doc: "A value of a variable that sets several keys.",
    keys: ChoiceKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a choice.
    pub(crate) ChoiceKey {
        SET: Texts = key(
            "set",
            Kind::Texts,
            Refused,
            "Keys of the scenario and their values, as KEY=VALUE, the form of `--set`.",
            &["[\"body.ship.mass=39000 t\", \"berthing.draught=9.5 m\"]"],
        ),
        WEIGHT: Number = key(
            "weight",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1e12 }),
            Is("1"),
            "Weight of the choice in a random plan: its probability is its share of the sum of all \
             weights.",
            &["0.3"],
        ),
    }
}

static QUANTILE: TableSpec = TableSpec {
    what: "a quantile",
    doc: "A value, and the probability that it is not exceeded.",
    keys: QuantileKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a quantile.
    pub(crate) QuantileKey {
        PROBABILITY: Number = key(
            "probability",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1.0 }),
            Refused,
            "Probability.",
            &["0.98"],
        ),
        VALUE: Text = key("value", Kind::AnyNumber, Refused, "Value.", &["\"20 cm/s\""]),
    }
}

/// Rules of the JSON Schema for a variable: either it sets one key or several keys to the same value, or it has
/// choices, each of which sets its own keys.
fn variable_rules() -> serde_json::Value {
    serde_json::json!({
        "oneOf": [
            {
                "anyOf": [{ "required": ["key"] }, { "required": ["keys"] }],
                "properties": { "choice": { "maxProperties": 0 } },
            },
            {
                "required": ["choice"],
                "properties": { "key": false, "keys": false, "values": false, "distribution": false, "expression": false },
            },
        ]
    })
}
