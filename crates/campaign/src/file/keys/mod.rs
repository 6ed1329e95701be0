//! Every key of a campaign file, in the form of [`fenderline_keys::keys`].

pub(crate) mod design;
pub(crate) mod downtime;
pub(crate) mod variable;

use self::design::{
    CORRELATION, CampaignLimitKey, CampaignOutputKey, CorrelationKey, DESIGN, DesignKey, LIMIT,
    OUTPUT, STOP, StopKey,
};
use self::downtime::{DOWNTIME, DowntimeKey};
use self::variable::{VARIABLE, VariableKey};
use super::kinds::{MOST_RUNS, PlanKind};
use fenderline_keys::choices::{Choice, Choices};
use fenderline_keys::held::{ListOf, NamedOf, Number, OneOf, TableOf, Text, Texts};
use fenderline_keys::spec::Absent::{Is, Means, Refused, Unless};
use fenderline_keys::spec::{Kind, Quantity, TableSpec, key};
use fenderline_keys::typed_key::AnyKey;
use fenderline_keys::units::measures as unit;
use fenderline_keys::{any_keys, table_keys};
use serde_json::{Value as Json, json};

/// Largest number of time steps that a campaign file can allow for one run.
const MOST_STEPS: f64 = 1e15;

pub(crate) static PLANS: Choices<PlanKind> = Choices(&[
    Choice {
        word: "full factorial",
        value: PlanKind::FullFactorial,
        doc: "every combination of the values, in the order of the file, the last variable fastest",
    },
    Choice { word: "Monte Carlo", value: PlanKind::MonteCarlo, doc: "independent draws" },
    Choice {
        word: "Latin hypercube",
        value: PlanKind::LatinHypercube,
        doc: "each variable has one draw in each of `number` parts of equal probability, in random order",
    },
    Choice {
        word: "Sobol",
        value: PlanKind::Sobol,
        doc: "a Sobol sequence with Owen's scrambling, at most 65,536 runs",
    },
    Choice {
        word: "table",
        value: PlanKind::Table,
        doc: "each row of the file `table` is a run; the columns are the variables",
    },
]);

/// Keys of a campaign that do not go together with `downtime`.
pub(crate) const BESIDE_DOWNTIME: &[AnyKey<CampaignFileKey>] = any_keys![
    CampaignFileKey: VARIABLE, PLAN, NUMBER, TABLE, CORRELATION, SUCCESS, STOP, DESIGN, LIMIT
];

/// The whole file.
pub(crate) static CAMPAIGN_FILE: TableSpec = TableSpec {
    what: "a campaign",
    doc: "Many runs of one scenario. `plan` determines how the values of the variables are chosen.",
    keys: CampaignFileKey::ALL,
    rules: Some(|| {
        let others = BESIDE_DOWNTIME;
        let none: serde_json::Map<String, Json> =
            others.iter().map(|key| (key.name().to_owned(), Json::Bool(false))).collect();
        json!({ "oneOf": [
            { "required": ["variable"], "properties": { "downtime": false } },
            { "required": ["downtime"], "properties": none }
        ] })
    }),
};

table_keys! {
    /// Keys of a campaign.
    pub(crate) CampaignFileKey {
        TITLE: Text = key(
            "title",
            Kind::Text,
            Means("the name of the file"),
            "Title of the page.",
            &["\"Fender spacing at berth 4\""],
        ),
        SCENARIO: Text = key(
            "scenario",
            Kind::Text,
            Refused,
            "File of the scenario, relative to the campaign file.",
            &["\"quay.toml\""],
        ),
        SET: Texts = key(
            "set",
            Kind::Texts,
            Is("[]"),
            "Keys of the scenario that all runs change, as KEY=VALUE, the form of `--set`.",
            &["[\"time.duration=3 min\", \"fender.*.temperature=30 degC\"]"],
        ),
        PLAN: OneOf<PlanKind> = key(
            "plan",
            Kind::Choice(&PLANS),
            Means("\"Monte Carlo\" if a variable has a `distribution`, else \"full factorial\""),
            "Plan by which the values of the variables are chosen.",
            &["\"Latin hypercube\""],
        ),
        NUMBER: Number = key(
            "number",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: MOST_RUNS }),
            Unless("the plan is \"full factorial\" or \"table\", or [downtime] is given"),
            "Number of runs.",
            &["10000"],
        ),
        SEED: Number = key(
            "seed",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 9e15 }),
            Is("1"),
            "Seed of the random numbers. The values of a run depend only on the seed and the \
             number of the run; in a \"Latin hypercube\" also on the number of runs.",
            &["7"],
        ),
        TABLE: Text = key(
            "table",
            Kind::Text,
            Unless("the plan is not \"table\""),
            "File of the plan \"table\", CSV or Parquet, relative to the campaign file: a column \
             for each variable, a row for each run.",
            &["\"runs.csv\""],
        ),
        VARIABLE: NamedOf<VariableKey> = key(
            "variable",
            Kind::Named(&VARIABLE),
            Unless("[downtime] is given"),
            "Variables, by name.",
            &[],
        ),
        DOWNTIME: TableOf<DowntimeKey> = key(
            "downtime",
            Kind::Table(&DOWNTIME),
            Means("the campaign has variables and a plan"),
            "Hours of a year that a berth loses to the weather, in place of variables and a plan.",
            &[],
        ),
        CORRELATION: ListOf<CorrelationKey> = key(
            "correlation",
            Kind::List(&CORRELATION),
            Is("[]"),
            "Correlations between variables that have a distribution.",
            &[],
        ),
        OUTPUTS: Texts = key(
            "outputs",
            Kind::Texts,
            Is("[]"),
            "Further numbers of each run: a quantity of one fender, as `fender.NAME.reaction`, of one line, as `line.NAME.tension`, of \
             one body, as `body.NAME.largest_sway`, or of one tug, as `tug.NAME.largest_push`.",
            &["[\"fender.fender_3.reaction\"]"],
        ),
        OUTPUT: NamedOf<CampaignOutputKey> = key(
            "output",
            Kind::Named(&OUTPUT),
            Is("{}"),
            "Outputs of your own, by name.",
            &[],
        ),
        SUCCESS: Text = key(
            "success",
            Kind::Text,
            Means("a run succeeds if its verdict is \"all well\" or a note"),
            "Output that is 1 if a run succeeds and 0 if not, for the operability in the report.",
            &["\"berthed\""],
        ),
        LIMIT: NamedOf<CampaignLimitKey> = key(
            "limit",
            Kind::Named(&LIMIT),
            Is("{}"),
            "Limits of outputs, by name, as `limit.\"rated reaction\"`.",
            &[],
        ),
        STOP: TableOf<StopKey> = key(
            "stop",
            Kind::Table(&STOP),
            Means("all runs are made"),
            "Ends the campaign early, when an estimate is good enough.",
            &[],
        ),
        DESIGN: TableOf<DesignKey> = key(
            "design",
            Kind::Table(&DESIGN),
            Means("there are no return periods in the report"),
            "Number of events and return periods, for design values.",
            &[],
        ),
        MOST_STEPS: Number = key(
            "most_steps",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: MOST_STEPS }),
            Is("100000000"),
            "Largest number of time steps of a run. A run with more steps is not made, and its row of \
             the table says so.",
            &["20000"],
        ),
    }
}
