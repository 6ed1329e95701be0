//! Keys of a campaign file for correlations, outputs, limits, the stop rule and design values.

use super::super::kinds::{MOST_RUNS, Statistic};
use fenderline_keys::choices::{Choice, Choices};
use fenderline_keys::held::{Number, OneOf, Text, Texts};
use fenderline_keys::spec::Absent::{Is, Means, Refused, Unless};
use fenderline_keys::spec::{Kind, Quantity, TableSpec, key};
use fenderline_keys::table_keys;
use fenderline_keys::units::measures as unit;

const PROBABILITY: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1.0 };

pub(super) static CORRELATION: TableSpec = TableSpec {
    what: "a correlation",
    doc: "A correlation of two variables with a distribution, by a Gaussian copula. The \
        coefficient is the correlation of the normal scores; for normal variables it is the \
        correlation of the variables.",
    keys: CorrelationKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a correlation.
    pub(crate) CorrelationKey {
        VARIABLES: Texts = key(
            "variables",
            Kind::Texts,
            Refused,
            "The two variables.",
            &["[\"speed\", \"angle\"]"],
        ),
        COEFFICIENT: Number = key(
            "coefficient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -1.0, high: 1.0 }),
            Refused,
            "Correlation of the normal scores of the two variables.",
            &["0.3"],
        ),
    }
}

pub(super) static OUTPUT: TableSpec = TableSpec {
    what: "an output",
    doc: "An output of your own: a number that a formula gives for each run.",
    keys: CampaignOutputKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of an output.
    pub(crate) CampaignOutputKey {
        EXPRESSION: Text = key(
            "expression",
            Kind::Text,
            Refused,
            "A formula that computes the output of a run. Use the names of the columns, in the units of the \
             columns, and the names of the variables; write names with points in braces. The functions are \
             those of a variable's `expression`.",
            &["\"reaction / 930\"", "\"{fender.fender_3.reaction} - {fender.fender_4.reaction}\""],
        ),
        UNIT: Text = key(
            "unit",
            Kind::Text,
            Means("it has none"),
            "Unit of the output, for the table.",
            &["\"kN\""],
        ),
    }
}

pub(super) static LIMIT: TableSpec = TableSpec {
    what: "a limit",
    doc: "A value of an output that should seldom be exceeded. The report draws this value, and \
        says how often the runs exceed it.",
    keys: CampaignLimitKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a limit.
    pub(crate) CampaignLimitKey {
        OUTPUT: Text = key(
            "output",
            Kind::Text,
            Refused,
            "Name of the output's column.",
            &["\"reaction\""],
        ),
        VALUE: Text = key(
            "value",
            Kind::AnyNumber,
            Refused,
            "The limit, with a unit if the output has a unit.",
            &["\"930 kN\"", "\"95 t\""],
        ),
    }
}

static STATISTICS: Choices<Statistic> = Choices(&[
    Choice { word: "mean", value: Statistic::Mean, doc: "the mean of the output" },
    Choice {
        word: "quantile",
        value: Statistic::Quantile,
        doc: "the value of the output that is not exceeded with `probability`",
    },
]);

pub(super) static STOP: TableSpec = TableSpec {
    what: "a stop rule",
    doc: "The campaign ends at the first multiple of `every` runs at which half of the confidence interval is at most `half_width`.",
    keys: StopKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a stop rule.
    pub(crate) StopKey {
        OUTPUT: Text = key(
            "output",
            Kind::Text,
            Refused,
            "Name of the output's column.",
            &["\"reaction\""],
        ),
        STATISTIC: OneOf<Statistic> = key(
            "statistic",
            Kind::Choice(&STATISTICS),
            Is("\"mean\""),
            "What is estimated.",
            &["\"quantile\""],
        ),
        PROBABILITY: Number = key(
            "probability",
            Kind::Quantity(PROBABILITY),
            Unless("the statistic is \"mean\""),
            "Probability of the quantile.",
            &["0.95"],
        ),
        HALF_WIDTH: Number = key(
            "half_width",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1e-12, high: 1e12 }),
            Refused,
            "Half the width of the confidence interval, as a share of the estimate.",
            &["0.02"],
        ),
        CONFIDENCE: Number = key(
            "confidence",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.5, high: 0.999_999 }),
            Is("0.95"),
            "Probability of the confidence interval.",
            &["0.9"],
        ),
        EVERY: Number = key(
            "every",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 10.0, high: MOST_RUNS }),
            Is("100"),
            "Number of runs between two tests of the stop rule. The result does not depend on the \
             number of threads.",
            &["1000"],
        ),
    }
}

pub(super) static DESIGN: TableSpec = TableSpec {
    what: "a design",
    doc: "How often the event that a run simulates, such as a berthing, happens in a year, and how \
        rare a design value is. Choose both numbers yourself: guidelines differ.",
    keys: DesignKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a design.
    pub(crate) DesignKey {
        BERTHINGS_PER_YEAR: Number = key(
            "berthings_per_year",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1e-6, high: 1e9 }),
            Refused,
            "Number of events, such as berthings, in a year.",
            &["300"],
        ),
        RETURN_PERIODS: Texts = key(
            "return_periods",
            Kind::Values,
            Is("[50, 100, 475, 1000]"),
            "Return periods (years): the design value is exceeded in a year with probability 1/T.",
            &["[50, 500]"],
        ),
        LIFE: Number = key(
            "life",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1e-3, high: 1e6 }),
            Is("50"),
            "Life of the structure (years), for the distribution of the largest value in this \
             life.",
            &["50"],
        ),
    }
}
