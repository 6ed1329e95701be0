//! Keys of an exercise: what a pilot is asked to do, and how the pilot's work is scored.

use fenderline_sim::exercise::Measure;
use serde_json::{Value, json};

use super::mooring::COUNT;
use super::quantities::{FORCE, LENGTH, POSITION};
use crate::choices::{Choice, Choices};
use crate::held::{Flag, Name, Number, OneOf, TableOf, Text, Texts, Vector};
use crate::spec::Absent::{self, Is, Means, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec, key};
use crate::typed_key::{AnyKey, Key};
use crate::units::measures as unit;
use crate::{any_keys, table_keys};

/// The goal of an exercise: where the ship must come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GoalWord {
    /// The ship lies alongside the berth, at rest, with her lines fast.
    AllFast,
    /// The ship lies alongside the berth, at rest.
    Alongside,
    /// The ship is off the berth, with all her lines on board.
    Clear,
    /// The ship is brought up: at rest, with anchors that hold.
    Anchored,
}

pub(super) static EXERCISE: TableSpec = TableSpec {
    what: "an exercise",
    doc: "An exercise is a goal for the pilot, and limits that cost points if they are exceeded. \
        The score begins at 100. An exceeded limit costs points in proportion to the excess; at \
        the value `worst` it costs all the points of the limit. The pages of a live session show \
        goal and score. The summary and the report of a run or a session list every deduction with \
        its cause. An exercise does not change the run.",
    keys: ExerciseKey::ALL,
    rules: Some(|| {
        let rules: Vec<_> = GOALS.0.iter().map(|goal| goal_rule(goal.word, goal.value)).collect();
        json!({ "allOf": rules })
    }),
};

table_keys! {
    /// Keys of an exercise.
    pub ExerciseKey {
        TASK: Text = key(
            "task",
            Kind::Text,
            Means("no words"),
            "Task of the pilot, in words.",
            &["\"Bring her alongside and make her fast.\""],
        ),
        VESSEL: Name = key(
            "vessel",
            Kind::BodyName,
            Refused,
            "The ship that the pilot handles: a body with a vessel.",
            &["\"ship\""],
        ),
        GOAL: OneOf<GoalWord> = key(
            "goal",
            Kind::Choice(&GOALS),
            Refused,
            "The goal of the exercise. When the goal is reached, the exercise ends.",
            &["\"all_fast\""],
        ),
        BERTH: Name = key(
            "berth",
            Kind::BodyName,
            Means(
                "the body without a vessel that has most fenders; of several with equally many, \
                 the body nearest to the ship",
            ),
            "The body with the fenders of the berth.",
            &["\"quay\""],
        ),
        VIEW_MARKS: Flag = key(
            "view_marks",
            Kind::Flag,
            Is("true"),
            "If false, the view out of the window shows no marks to pilot, tugmasters and observers: no distances, \
             path, forces, loads or current. Plan and docking board are not changed.",
            &["false"],
        ),
        MARK: TableOf<MarkKey> = key(
            "mark",
            Kind::Table(&MARK_TABLE),
            Means("no mark"),
            "A mark of the berth abeam of which a place of the ship shall lie, such as \"bow at bollard 9\". The \
             docking board of a live session shows the distance to go along the berth. The mark is no part of the goal.",
            &["{ name = \"Bow at bollard 9\", at = [1.5, 75] }"],
        ),
        LINES: Texts = key(
            "lines",
            Kind::Texts,
            Means("all lines of the ship"),
            "For the goal `all_fast`: names of the lines that count as fast lines.",
            &["[\"head\", \"stern\"]"],
        ),
        AT_LEAST: Number = key(
            "at_least",
            Kind::Quantity(COUNT),
            Means("all lines for the goal `all_fast`, one anchor for the goal `anchored`"),
            "For the goals `all_fast` and `anchored`: how many lines must be fast, or how many anchors must \
             hold.",
            &["1"],
        ),
        LEAST_TENSION: Number = key(
            "least_tension",
            Kind::Quantity(FORCE),
            Means("no least tension"),
            "For the goal `all_fast`: a line with less tension does not count, nor does a line whose winch heaves or pays out.",
            &["\"30 kN\""],
        ),
        MOST_TENSION: Number = key(
            "most_tension",
            Kind::Quantity(FORCE),
            Means("no greatest tension"),
            "For the goal `all_fast`: a line with more tension does not count.",
            &["\"300 kN\""],
        ),
        ANCHORS: Texts = key(
            "anchors",
            Kind::Texts,
            Means("all anchors of the ship"),
            "For the goal `anchored`: names of the anchors that count.",
            &["[\"port\", \"starboard\"]"],
        ),
        CHAIN_OUT: Number = key(
            "chain_out",
            Kind::Quantity(LENGTH),
            Means("any"),
            "For the goal `anchored`: least length of chain out for an anchor to count.",
            &["\"5 shackles\""],
        ),
        POSITION: Vector = key(
            "position",
            Kind::Vector(POSITION),
            Means("anywhere"),
            "For the goal `anchored`: the place on the bottom at which an anchor must lie, north and east.",
            &["[400, -120]"],
        ),
        DISTANCE: Number = key(
            "distance",
            Kind::Quantity(LENGTH),
            Means("0.5 m; 30 m for the goal `clear`; 50 m for the goal `anchored`"),
            "Greatest distance of bow and stern from the line of the fenders with which the goal \
             is reached; for the goal `clear`, the least distance. For this distance, bow and stern \
             are the ends of the flat part of the ship's side. For the goal `anchored`, the key \
             gives the greatest distance of an anchor from `position`.",
            &["\"0.3 m\""],
        ),
        REST_SPEED: Number = key(
            "rest_speed",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 1e-3, high: 10.0 }),
            Is("0.05"),
            "For the goals `all_fast`, `alongside` and `anchored`: greatest speed of bow and stern relative \
             to the berth with which the ship counts as at rest; without a berth, greatest speed \
             over ground of the ship's origin.",
            &["\"0.03 m/s\""],
        ),
        HOLD: Number = key(
            "hold",
            Kind::Quantity(DURATION),
            Is("10"),
            "How long the goal must be met without a break.",
            &["\"30 s\""],
        ),
        TIME_LIMIT: Number = key(
            "time_limit",
            Kind::Quantity(DURATION),
            Means("no limit"),
            "Time after which the exercise ends, even if the goal is not reached.",
            &["\"90 min\""],
        ),
        PASS_MARK: Number = key(
            "pass_mark",
            Kind::Quantity(POINTS),
            Is("60"),
            "The least score with which the exercise is passed.",
            &["70"],
        ),
        LIMIT: TableOf<ExerciseLimitKey> = key(
            "limit",
            Kind::Table(&LIMITS),
            Is("{}"),
            "The limits.",
            &[],
        ),
    }
}

static MARK_TABLE: TableSpec = TableSpec {
    what: "a mark of the berth",
    doc: "A mark of the berth, and the place of the ship that shall lie abeam of the mark.",
    keys: MarkKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a mark of the berth.
    pub MarkKey {
        NAME: Text = key(
            "name",
            Kind::Text,
            Means("\"mark\""),
            "Name of the mark on the docking board.",
            &["\"Bow at bollard 9\""],
        ),
        AT: Vector = key(
            "at",
            Kind::Vector(POSITION),
            Refused,
            "Place of the mark, forward and to starboard of the origin of the berth's body, as for a bollard. Only the \
             place along the fenders counts.",
            &["[1.5, 75]"],
        ),
        OF_SHIP: Number = key(
            "of_ship",
            Kind::Quantity(POSITION),
            Means("the foremost place of the ship's outline"),
            "Place of the ship that shall lie abeam of the mark, forward of her body's origin, such as that of her \
             manifold; negative aft of the origin.",
            &["\"-12 m\""],
        ),
    }
}

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
    /// The keys of an exercise that do not apply to this goal.
    pub fn unused(self) -> &'static [AnyKey<ExerciseKey>] {
        match self {
            GoalWord::AllFast => any_keys![ExerciseKey: ANCHORS, CHAIN_OUT, POSITION],
            GoalWord::Alongside => {
                any_keys![
                    ExerciseKey: LINES, AT_LEAST, LEAST_TENSION, MOST_TENSION, ANCHORS, CHAIN_OUT,
                    POSITION
                ]
            }
            GoalWord::Clear => {
                any_keys![
                    ExerciseKey: LINES, AT_LEAST, LEAST_TENSION, MOST_TENSION, ANCHORS, CHAIN_OUT,
                    POSITION, REST_SPEED
                ]
            }
            GoalWord::Anchored => {
                any_keys![ExerciseKey: MARK, LINES, LEAST_TENSION, MOST_TENSION]
            }
        }
    }
}

/// The rule of the JSON schema for a goal: the exercise has no keys that do not apply to this goal, and for `anchored`
/// it has `distance` only with `position`.
fn goal_rule(word: &str, goal: GoalWord) -> Value {
    let unused: Vec<_> =
        goal.unused().iter().map(|key| json!({ "required": [key.name()] })).collect();
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
/// Bounds of a share, such as a share of a rated value, of the break load or of full revolutions.
const SHARE: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 100.0 };
const SPEED: Quantity = Quantity { measure: &unit::SPEED, low: 0.0, high: 100.0 };
const ANGLE: Quantity = Quantity { measure: &unit::ANGLE, low: 0.0, high: 1.6 };
const DISTANCE: Quantity = Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e5 };

const POINTS_KEY: KeySpec = key(
    "points",
    Kind::Quantity(POINTS),
    Refused,
    "Points of the score of 100 that the limit costs; they are lost in full at the value `worst` \
     and beyond.",
    &["20"],
);
const FAILS_KEY: KeySpec = key(
    "fails",
    Kind::Flag,
    Is("false"),
    "If true, an exceeded limit fails the exercise, whatever the score.",
    &["true"],
);

const fn most(quantity: Quantity, examples: &'static [&'static str]) -> KeySpec {
    let doc = "The greatest value of the limited quantity that costs no points.";
    key("most", Kind::Quantity(quantity), Refused, doc, examples)
}

const fn least() -> KeySpec {
    let doc = "The least value of the limited quantity that costs no points.";
    key("least", Kind::Quantity(DISTANCE), Refused, doc, &["\"2 m\""])
}

const fn worst(quantity: Quantity, absent: Absent, examples: &'static [&'static str]) -> KeySpec {
    let doc = "The value of the limited quantity that costs all points of the limit.";
    key("worst", Kind::Quantity(quantity), absent, doc, examples)
}

const fn within(metres: &'static str) -> KeySpec {
    key(
        "within",
        Kind::Quantity(DISTANCE),
        Is(metres),
        "The limit counts while the ship is abreast of the berth and nearer than this \
         distance; bow and stern count separately.",
        &["\"30 m\""],
    )
}

// The tables of the limits have some of these keys, each with a range and a default of its own.
table_keys! {
    /// Keys of a limit of an exercise.
    pub ScoreKey {
        MOST: Number = most(SHARE, &[]),
        LEAST: Number = least(),
        WORST: Number = worst(SHARE, Means("twice `most`"), &[]),
        POINTS: Number = POINTS_KEY,
        FAILS: Flag = FAILS_KEY,
        WITHIN: Number = within("20"),
    }
}

/// Declares the table of a limit that says how large a quantity may become.
macro_rules! at_most {
    ($name:ident, $what:literal, $doc:literal, $quantity:expr, $example:literal $(, near $within:literal)?) => {
        static $name: TableSpec = TableSpec {
            what: $what,
            doc: $doc,
            keys: &[
                most($quantity, &[$example]),
                worst($quantity, Means("twice `most`"), &[$example]),
                POINTS_KEY,
                FAILS_KEY,
                $(within($within),)?
            ],
            rules: None,
        };
    };
}

/// Declares the table of a limit that says how small a quantity may become.
macro_rules! at_least {
    ($name:ident, $what:literal, $doc:literal) => {
        static $name: TableSpec = TableSpec {
            what: $what,
            doc: $doc,
            keys: &[least(), worst(DISTANCE, Is("0"), &["\"1 m\""]), POINTS_KEY, FAILS_KEY],
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
    "Speed of the ship along her own axis, ahead or astern, relative to the berth.",
    SPEED,
    "\"0.3 m/s\"",
    near "20"
);
at_most!(
    ANGLE_LIMIT,
    "a limit of the angle",
    "Angle between ship and berth, with the bow or with the stern nearer to the berth.",
    ANGLE,
    "\"3 deg\"",
    near "20"
);
at_most!(
    ENGINE,
    "a limit of the engine",
    "Revolutions of the engine divided by full revolutions, ahead or astern; for azimuth units, \
     power divided by full power. The engine is limited near the berth because the propeller's \
     wash moves vessels there.",
    SHARE,
    "0.3",
    near "20"
);
at_most!(
    FENDER,
    "a limit of the load of fenders",
    "Energy or reaction of a fender of the berth, divided by the rated value.",
    SHARE,
    "\"80 %\""
);
at_most!(
    LINE,
    "a limit of the load of lines",
    "Tension of any line that is fast to the ship, towlines included, divided by the line's break \
     load.",
    SHARE,
    "\"50 %\""
);
at_most!(
    CHAIN,
    "a limit of the load of chains",
    "Tension of any anchor chain of the ship, divided by the chain's break load.",
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
at_most!(
    CROSS_TRACK,
    "a limit of the cross-track distance",
    "Distance of midship from the track of the ship's passage plan, to port or to starboard, between the first and the \
     last waypoint.",
    DISTANCE,
    "\"30 m\""
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
    doc: "Touches of the hull with a structure or another hull, without a fender between the two.",
    keys: &[POINTS_KEY, FAILS_KEY],
    rules: None,
};

/// The limits of an exercise. The keys are the variants of `fenderline_sim::exercise::Measure`, in the order of that
/// type.
static LIMITS: TableSpec = TableSpec {
    what: "the limits of an exercise",
    doc: "The limits of an exercise whose excess costs points.",
    keys: ExerciseLimitKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of the limits of an exercise.
    pub ExerciseLimitKey {
        APPROACH_SPEED: TableOf<ScoreKey> = limit(
            "approach_speed",
            &APPROACH_SPEED,
            "Speed of bow and stern towards the berth.",
        ),
        AHEAD_SPEED: TableOf<ScoreKey> = limit(
            "ahead_speed",
            &AHEAD_SPEED,
            "Speed ahead or astern near the berth.",
        ),
        ANGLE: TableOf<ScoreKey> = limit("angle", &ANGLE_LIMIT, "Angle between ship and berth."),
        ENGINE: TableOf<ScoreKey> = limit("engine", &ENGINE, "Use of the engine near the berth."),
        FENDER: TableOf<ScoreKey> = limit("fender", &FENDER, "Load of the fenders of the berth."),
        LINE: TableOf<ScoreKey> = limit("line", &LINE, "Load of the lines."),
        CHAIN: TableOf<ScoreKey> = limit("chain", &CHAIN, "Load of the anchor chains."),
        DRAGGED: TableOf<ScoreKey> = limit("dragged", &DRAGGED, "How far anchors drag."),
        CLEARANCE: TableOf<ScoreKey> = limit(
            "clearance",
            &CLEARANCE,
            "Distance from structures other than the berth.",
        ),
        UNDER_KEEL: TableOf<ScoreKey> = limit("under_keel", &UNDER_KEEL, "Water under the keel."),
        CROSS_TRACK: TableOf<ScoreKey> = limit(
            "cross_track",
            &CROSS_TRACK,
            "Distance from the track of the ship's passage plan.",
        ),
        TOUCH: TableOf<ScoreKey> = limit("touch", &TOUCH, "Touches without a fender."),
        TIME: TableOf<ScoreKey> = limit("time", &TIME, "Time until the goal is reached."),
    }
}

const fn limit(name: &'static str, table: &'static TableSpec, doc: &'static str) -> KeySpec {
    key(name, Kind::Table(table), Means("no such limit"), doc, &[])
}

/// The key in the limits of an exercise that limits the quantity `measure`.
pub fn limit_key(measure: Measure) -> Key<ExerciseLimitKey, TableOf<ScoreKey>> {
    match measure {
        Measure::ApproachSpeed => ExerciseLimitKey::APPROACH_SPEED,
        Measure::AheadSpeed => ExerciseLimitKey::AHEAD_SPEED,
        Measure::Angle => ExerciseLimitKey::ANGLE,
        Measure::Engine => ExerciseLimitKey::ENGINE,
        Measure::Fender => ExerciseLimitKey::FENDER,
        Measure::Line => ExerciseLimitKey::LINE,
        Measure::Chain => ExerciseLimitKey::CHAIN,
        Measure::Dragged => ExerciseLimitKey::DRAGGED,
        Measure::Clearance => ExerciseLimitKey::CLEARANCE,
        Measure::UnderKeel => ExerciseLimitKey::UNDER_KEEL,
        Measure::CrossTrack => ExerciseLimitKey::CROSS_TRACK,
        Measure::Touch => ExerciseLimitKey::TOUCH,
        Measure::Time => ExerciseLimitKey::TIME,
    }
}
