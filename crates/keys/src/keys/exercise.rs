//! Keys of an exercise: what a pilot is asked to do, and how it is marked.

use serde_json::{Value, json};

use super::mooring::COUNT;
use super::quantities::{FORCE, LENGTH, POSITION};
use crate::choices::{Choice, Choices};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec, key};
use crate::units::measures as unit;

/// What an exercise asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GoalWord {
    /// Alongside, at rest, with lines fast.
    AllFast,
    /// Alongside, at rest.
    Alongside,
    /// Off the berth, with all lines on board.
    Clear,
    /// Brought up: at rest, with anchors that hold.
    Anchored,
}

pub(super) static EXERCISE: TableSpec = TableSpec {
    what: "an exercise",
    doc: "A goal for the pilot, and limits with points. The score begins at 100; an exceeded limit \
        costs points in proportion to the excess, up to all points of the limit at `worst`. Live \
        pages show goal and score. The summary and the report of a run or a session list every \
        deduction with its cause. An exercise does not change the run.",
    keys: &[
        key(
            "task",
            Kind::Text,
            Means("no words"),
            "Task of the pilot, in words.",
            &["\"Bring her alongside and make her fast.\""],
        ),
        key("vessel", Kind::BodyName, Refused, "The ship: a body with a vessel.", &["\"ship\""]),
        key(
            "goal",
            Kind::Choice(&GOALS),
            Refused,
            "The goal. When it is reached, the exercise ends.",
            &["\"all_fast\""],
        ),
        key(
            "berth",
            Kind::BodyName,
            Means(
                "the body without a vessel that has most fenders; among equals, the body nearest \
                 to the ship",
            ),
            "The body with the fenders of the berth.",
            &["\"quay\""],
        ),
        key(
            "lines",
            Kind::Texts,
            Means("all lines of the ship"),
            "For `all_fast`: the lines that count.",
            &["[\"head\", \"stern\"]"],
        ),
        key(
            "at_least",
            Kind::Quantity(COUNT),
            Means("all lines for `all_fast`, one anchor for `anchored`"),
            "For `all_fast` and `anchored`: how many of the lines or anchors are needed.",
            &["1"],
        ),
        key(
            "least_tension",
            Kind::Quantity(FORCE),
            Means("no least tension"),
            "For `all_fast`: a line with less tension does not count.",
            &["\"30 kN\""],
        ),
        key(
            "most_tension",
            Kind::Quantity(FORCE),
            Means("no greatest tension"),
            "For `all_fast`: a line with more tension does not count.",
            &["\"300 kN\""],
        ),
        key(
            "anchors",
            Kind::Texts,
            Means("all anchors of the ship"),
            "For `anchored`: the anchors that count.",
            &["[\"port\", \"starboard\"]"],
        ),
        key(
            "chain_out",
            Kind::Quantity(LENGTH),
            Means("any"),
            "For `anchored`: least length of chain out for an anchor to count.",
            &["\"5 shackles\""],
        ),
        key(
            "position",
            Kind::Vector(POSITION),
            Means("anywhere"),
            "For `anchored`: the place on the bottom at which an anchor must lie, north and east.",
            &["[400, -120]"],
        ),
        key(
            "distance",
            Kind::Quantity(LENGTH),
            Means("0.5 m; 30 m for `clear`; 50 m for `anchored`"),
            "Greatest distance of bow and stern from the line of the fenders; for `clear` the \
             least distance. Bow and stern are the ends of the flat part of the ship's side. For \
             `anchored`: greatest distance of an anchor from `position`.",
            &["\"0.3 m\""],
        ),
        key(
            "rest_speed",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 1e-3, high: 10.0 }),
            Is("0.05"),
            "For `all_fast`, `alongside` and `anchored`: greatest speed of bow and stern relative \
             to the berth; without a berth, greatest speed of the ship's origin over ground.",
            &["\"0.03 m/s\""],
        ),
        key(
            "hold",
            Kind::Quantity(DURATION),
            Is("10"),
            "How long the goal must hold without a break.",
            &["\"30 s\""],
        ),
        key(
            "time_limit",
            Kind::Quantity(DURATION),
            Means("no limit"),
            "After this time the exercise ends, even if the goal is not reached.",
            &["\"90 min\""],
        ),
        key(
            "pass_mark",
            Kind::Quantity(POINTS),
            Is("60"),
            "The least score with which the exercise is passed.",
            &["70"],
        ),
        key("limit", Kind::Table(&LIMITS), Is("{}"), "The limits.", &[]),
    ],
    rules: Some(|| {
        let rules: Vec<_> = GOALS.0.iter().map(|goal| goal_rule(goal.word, goal.value)).collect();
        json!({ "allOf": rules })
    }),
};

static GOALS: Choices<GoalWord> = Choices(&[
    Choice {
        word: "all_fast",
        value: GoalWord::AllFast,
        doc: "alongside the fenders of the berth, at rest, with her lines fast",
    },
    Choice {
        word: "alongside",
        value: GoalWord::Alongside,
        doc: "alongside the fenders of the berth, at rest",
    },
    Choice {
        word: "clear",
        value: GoalWord::Clear,
        doc: "off the berth by `distance`, with all her lines on board",
    },
    Choice {
        word: "anchored",
        value: GoalWord::Anchored,
        doc: "brought up: at rest, with anchors on the bottom that hold on the brake",
    },
]);

impl GoalWord {
    /// The keys that the goal does not use.
    pub fn unused(self) -> &'static [&'static str] {
        match self {
            GoalWord::AllFast => &["anchors", "chain_out", "position"],
            GoalWord::Alongside => &[
                "lines",
                "at_least",
                "least_tension",
                "most_tension",
                "anchors",
                "chain_out",
                "position",
            ],
            GoalWord::Clear => &[
                "lines",
                "at_least",
                "least_tension",
                "most_tension",
                "anchors",
                "chain_out",
                "position",
                "rest_speed",
            ],
            GoalWord::Anchored => &["lines", "least_tension", "most_tension"],
        }
    }
}

/// The rule of the schema for a goal: no keys that it does not use; for `anchored`, `distance` only with `position`.
fn goal_rule(word: &str, goal: GoalWord) -> Value {
    let unused: Vec<_> = goal.unused().iter().map(|key| json!({ "required": [key] })).collect();
    let mut then = json!({ "not": { "anyOf": unused } });
    if goal == GoalWord::Anchored {
        then["dependentRequired"] = json!({ "distance": ["position"] });
    }
    json!({
        "if": { "properties": { "goal": { "const": word } }, "required": ["goal"] },
        "then": then
    })
}

const DURATION: Quantity = Quantity { measure: &unit::TIME, low: 0.0, high: 1e6 };
const POINTS: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 100.0 };
/// A share: of rated, of break load, of full revolutions.
const SHARE: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 100.0 };
const SPEED: Quantity = Quantity { measure: &unit::SPEED, low: 0.0, high: 100.0 };
const ANGLE: Quantity = Quantity { measure: &unit::ANGLE, low: 0.0, high: 1.6 };
const DISTANCE: Quantity = Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e5 };

const POINTS_KEY: KeySpec = key(
    "points",
    Kind::Quantity(POINTS),
    Refused,
    "Points that the limit costs, of the score of 100; in full at `worst` and beyond.",
    &["20"],
);
const FAILS_KEY: KeySpec = key(
    "fails",
    Kind::Flag,
    Is("false"),
    "If true, an exceeded limit fails the exercise, whatever the score.",
    &["true"],
);

/// The table of a limit with a greatest value.
macro_rules! at_most {
    ($name:ident, $what:literal, $doc:literal, $quantity:expr, $example:literal $(, near $within:literal)?) => {
        static $name: TableSpec = TableSpec {
            what: $what,
            doc: $doc,
            keys: &[
                key("most", Kind::Quantity($quantity), Refused, "The greatest value that costs nothing.", &[$example]),
                key("worst", Kind::Quantity($quantity), Means("twice `most`"), "The value that costs all points.", &[$example]),
                POINTS_KEY,
                FAILS_KEY,
                $(key(
                    "within",
                    Kind::Quantity(DISTANCE),
                    Is($within),
                    "The limit counts while the ship is abreast of the berth and nearer than this \
                     distance; bow and stern count separately.",
                    &["\"30 m\""],
                ),)?
            ],
            rules: None,
        };
    };
}

/// The table of a limit with a least value.
macro_rules! at_least {
    ($name:ident, $what:literal, $doc:literal) => {
        static $name: TableSpec = TableSpec {
            what: $what,
            doc: $doc,
            keys: &[
                key(
                    "least",
                    Kind::Quantity(DISTANCE),
                    Refused,
                    "The least value that costs nothing.",
                    &["\"2 m\""],
                ),
                key(
                    "worst",
                    Kind::Quantity(DISTANCE),
                    Is("0"),
                    "The value that costs all points.",
                    &["\"1 m\""],
                ),
                POINTS_KEY,
                FAILS_KEY,
            ],
            rules: None,
        };
    };
}

at_most!(
    APPROACH_SPEED,
    "a limit of the approach speed",
    "Speed of bow and stern towards the berth.",
    SPEED,
    "\"0.15 m/s\"",
    near "50"
);
at_most!(
    AHEAD_SPEED,
    "a limit of the speed ahead",
    "Speed along the ship's axis, ahead or astern, relative to the berth.",
    SPEED,
    "\"0.3 m/s\"",
    near "20"
);
at_most!(
    ANGLE_LIMIT,
    "a limit of the angle",
    "Angle between ship and berth, either way.",
    ANGLE,
    "\"3 deg\"",
    near "20"
);
at_most!(
    ENGINE,
    "a limit of the engine",
    "Revolutions over full revolutions, ahead or astern; for azimuth units, power over full power. \
     The wash of the propeller moves vessels near it.",
    SHARE,
    "0.3",
    near "20"
);
at_most!(
    FENDER,
    "a limit of the load of fenders",
    "Energy or reaction of a fender of the berth over the rated value.",
    SHARE,
    "\"80 %\""
);
at_most!(
    LINE,
    "a limit of the load of lines",
    "Tension over break load of any line that is fast to the ship, towlines included.",
    SHARE,
    "\"50 %\""
);
at_most!(
    CHAIN,
    "a limit of the load of chains",
    "Tension over break load of any anchor chain of the ship.",
    SHARE,
    "\"40 %\""
);
at_most!(
    DRAGGED,
    "a limit of dragging",
    "Distance that an anchor of the ship drags after it came to the bottom.",
    DISTANCE,
    "\"20 m\""
);
at_most!(TIME, "a limit of the time", "Time until the goal is reached.", DURATION, "\"60 min\"");
at_least!(
    CLEARANCE,
    "a limit of the distance from structures",
    "Distance of the hull from fixed bodies other than the berth."
);
at_least!(UNDER_KEEL, "a limit of the water under the keel", "Water under the keel.");

static TOUCH: TableSpec = TableSpec {
    what: "a limit of touches",
    doc: "The hull touches a structure or another hull without a fender between them.",
    keys: &[POINTS_KEY, FAILS_KEY],
    rules: None,
};

/// The keys are those of `fenderline_sim::exercise::Measure`, in its order.
static LIMITS: TableSpec = TableSpec {
    what: "the limits of an exercise",
    doc: "What costs points.",
    keys: &[
        limit("approach_speed", &APPROACH_SPEED, "Speed of bow and stern towards the berth."),
        limit("ahead_speed", &AHEAD_SPEED, "Speed ahead or astern near the berth."),
        limit("angle", &ANGLE_LIMIT, "Angle between ship and berth."),
        limit("engine", &ENGINE, "Use of the engine near the berth."),
        limit("fender", &FENDER, "Load of the fenders of the berth."),
        limit("line", &LINE, "Load of the lines."),
        limit("chain", &CHAIN, "Load of the anchor chains."),
        limit("dragged", &DRAGGED, "How far anchors drag."),
        limit("clearance", &CLEARANCE, "Distance from structures other than the berth."),
        limit("under_keel", &UNDER_KEEL, "Water under the keel."),
        limit("touch", &TOUCH, "Touches without a fender."),
        limit("time", &TIME, "Time until the goal is reached."),
    ],
    rules: None,
};

const fn limit(name: &'static str, table: &'static TableSpec, doc: &'static str) -> KeySpec {
    key(name, Kind::Table(table), Means("no such limit"), doc, &[])
}
