//! Keys of lines, bollards and line handlers.

use fenderline_sim::mooring::RopeCurve;
use serde_json::json;

use super::quantities::{FORCE, LENGTH, PLACE, POSITION, TIME};
use crate::choices::{Choice, Choices};
use crate::held::{Flag, Name, Number, OneOf, TableOf, Text, Vector};
use crate::spec::Absent::{Is, Means, Refused, Unless};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec, key};
use crate::typed_key::AnyKey;
use crate::units::measures as unit;
use crate::{any_keys, shared_keys, table_keys};

/// The keys that describe the far end of a line that is fast from the start. A line without the key `to` has none of
/// these keys.
pub const AT_THE_FAR_END: &[AnyKey<LineKey>] =
    any_keys![LineKey: BOLLARD, BOLLARD_HEIGHT, BITTS, LENGTH, PRETENSION, MADE_FAST];

pub(super) static LINE: TableSpec = TableSpec {
    what: "a line",
    doc: "A mooring line from a body to a bollard or to another body. The weight of the line is \
        neglected, unless `mass` is given.",
    keys: LineKey::ALL,
    rules: Some(|| {
        let either = |place: &str, height: &str, name: &str| {
            let refused: serde_json::Map<String, serde_json::Value> =
                [(height.to_owned(), json!(false))].into_iter().collect();
            json!({ "oneOf": [
                { "required": [place] }, { "required": [name], "properties": refused }
            ] })
        };
        json!({
            "allOf": [rope_rules(), either("fairlead", "fairlead_height", "chock"), {
                "if": { "required": ["constant_tension"] },
                "then": { "required": ["winch"], "properties": { "winch": { "const": true } } }
            }],
            "if": { "required": ["to"] },
            "then": {
                "oneOf": [{ "required": ["length"] }, { "required": ["pretension"] }],
                "allOf": [either("bollard", "bollard_height", "bitts")]
            },
            "else": {
                "properties": AT_THE_FAR_END.iter().map(|key| (key.name().to_owned(), json!(false)))
                    .collect::<serde_json::Map<String, serde_json::Value>>()
            }
        })
    }),
};

table_keys! {
    /// Keys of a line.
    pub LineKey {
        FROM: Name = key(
            "from",
            Kind::BodyName,
            Refused,
            "The body that holds the line, with a winch or bitts.",
            &["\"ship\""],
        ),
        FAIRLEAD: Vector = key(
            "fairlead",
            Kind::Point(POSITION),
            Unless("`chock` is given"),
            "Place of the fairlead, forward and to starboard of the body's origin.",
            &["[140, 5]"],
        ),
        FAIRLEAD_HEIGHT: Number = key(
            "fairlead_height",
            Kind::Quantity(PLACE),
            Is("0"),
            "Height of the fairlead above the still water; on a fixed body above datum.",
            &["\"12 m\""],
        ),
        CHOCK: Text = key(
            "chock",
            Kind::Text,
            Unless("`fairlead` is given"),
            "Name of a chock of the vessel `from`, instead of `fairlead` and `fairlead_height`.",
            &["\"head\""],
        ),
        TO: Name = key(
            "to",
            Kind::BodyName,
            Means("the line is on board until an order sends it to a bollard"),
            "The body at the far end of the line, such as a quay or another ship.",
            &["\"quay\""],
        ),
        BOLLARD: Vector = key(
            "bollard",
            Kind::Point(POSITION),
            Unless("`bitts` is given, or the line is on board"),
            "Place of the bollard, forward and to starboard of the origin of the body `to`.",
            &["[170, 4]"],
        ),
        BOLLARD_HEIGHT: Number = key(
            "bollard_height",
            Kind::Quantity(PLACE),
            Is("0"),
            "Height of the bollard above the still water; on a fixed body above datum.",
            &["\"4 m\""],
        ),
        BITTS: Text = key(
            "bitts",
            Kind::Text,
            Unless("`bollard` is given, or the line is on board"),
            "Name of bitts of the vessel `to`, instead of `bollard` and `bollard_height`.",
            &["\"fore\""],
        ),
        ROPE: OneOf<BuiltIn> = key(
            "rope",
            Kind::Choice(&ROPES),
            Refused,
            "Material of the rope.",
            &["\"hmpe\""],
        ),
        AXIAL_STIFFNESS: Number = AXIAL_STIFFNESS,
        LOAD_EXTENSION: Text = LOAD_EXTENSION,
        BREAK_LOAD: Number = key(
            "break_load",
            Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e9 }),
            Refused,
            "Line design break force.",
            &["\"1200 kN\""],
        ),
        WORKING_LOAD: Number = key(
            "working_load",
            Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e9 }),
            Means(
                "55 % of the rope's break load for wire, 50 % for other ropes (from public \
                 summaries of MEG4)",
            ),
            "Working load of the rope, which the verdict of the run compares with the tension of \
             the line.",
            &["\"600 kN\""],
        ),
        MASS: Number = key(
            "mass",
            Kind::Quantity(Quantity { measure: &unit::MASS_PER_LENGTH, low: 1e-3, high: 1e3 }),
            Means("the rope has no weight and is straight"),
            "Mass of the rope and its tail per metre. A rope with mass sags by its weight in air \
             as a flat parabola, and each end bears half of the weight.",
            &["\"7.2 kg/m\""],
        ),
        ON_DECK: TableOf<OnDeckKey> = key(
            "on_deck",
            Kind::Table(&ON_DECK),
            Means("the rope ends at the chock or fairlead"),
            "The rope on deck between the chock and the winch or bitts, which stretches too.",
            &[],
        ),
        TAIL: TableOf<TailKey> = key(
            "tail",
            Kind::Table(&TAIL),
            Means("no tail"),
            "A tail: a softer rope in series at the far end of the line.",
            &[],
        ),
        LENGTH: Number = key(
            "length",
            Kind::Quantity(LENGTH),
            Unless("`pretension` is given, or the line is on board"),
            "Unstretched length of the line outboard, tail included.",
            &["\"45 m\""],
        ),
        PRETENSION: Number = key(
            "pretension",
            Kind::Quantity(FORCE),
            Unless("`length` is given, or the line is on board"),
            "Tension with which the line is made fast.",
            &["\"100 kN\""],
        ),
        WINCH: Flag = key(
            "winch",
            Kind::Flag,
            Is("false"),
            "True for a line on a winch, whose brake slips at 60 % of the break load; false for a \
             line on bitts.",
            &["true"],
        ),
        CONSTANT_TENSION: TableOf<ConstantTensionKey> = key(
            "constant_tension",
            Kind::Table(&CONSTANT_TENSION),
            Means("the brake holds the line"),
            "Makes the winch hold a constant tension by itself; needs `winch = true`.",
            &[],
        ),
        ROPE_LENGTH: Number = key(
            "rope_length",
            Kind::Quantity(LENGTH),
            Is("220"),
            "Length of the rope of a line that an order sends to a bollard. The default of 220 m \
             is from memory, not from a source.",
            &["\"200 m\""],
        ),
        MADE_FAST: Number = key(
            "made_fast",
            Kind::Quantity(TIME),
            Is("0"),
            "Time at which the line is made fast.",
            &["\"25 min\""],
        ),
    }
}

static CONSTANT_TENSION: TableSpec = TableSpec {
    what: "a constant-tension winch",
    doc: "A winch that pays out if the tension is above a band about the set tension, and heaves \
          in if the tension is below the band. The brake of a constant-tension winch slips at 60 % \
          of the line's break load, as on other winches. An order to heave or to pay out comes \
          before the constant tension, until the order to hold. The default values of a \
          constant-tension winch are assumptions, not from a source.",
    keys: ConstantTensionKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a constant-tension winch.
    pub ConstantTensionKey {
        TENSION: Number = key(
            "tension",
            Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e9 }),
            Refused,
            "The set tension.",
            &["\"150 kN\""],
        ),
        BAND: Number = key(
            "band",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 0.9 }),
            Is("0.1"),
            "Half of the width of the band of tension in which the winch stands still, as a share \
             of the set tension.",
            &["0.2"],
        ),
        HEAVING_SPEED: Number = key(
            "heaving_speed",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.0, high: 20.0 }),
            Is("0.25"),
            "The largest speed at which the winch heaves in.",
            &["\"0.2 m/s\""],
        ),
        PAYING_OUT_SPEED: Number = key(
            "paying_out_speed",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.0, high: 20.0 }),
            Is("0.25"),
            "The largest speed at which the winch pays out.",
            &["\"0.3 m/s\""],
        ),
    }
}

static ON_DECK: TableSpec = TableSpec {
    what: "a rope on deck",
    doc: "The rope on deck between the chock and the winch or bitts. The rope on deck stretches \
        under the tension that reaches it over the chock: T e^(−μφ), by the capstan equation for a \
        rope that is hauled outboard. We assume that the same share of the tension reaches the \
        deck when the tension falls, so that the rope is elastic. The limits of the winch, for \
        brake and stall, are compared with the tension outboard of the chock.",
    keys: OnDeckKey::ALL,
    rules: Some(|| json!({ "dependentRequired": { "wrap": ["friction"] } })),
};

table_keys! {
    /// Keys of a rope on deck.
    pub OnDeckKey {
        LENGTH: Number = key(
            "length",
            Kind::Quantity(LENGTH),
            Refused,
            "Unstretched length of the rope on deck.",
            &["\"25 m\""],
        ),
        FRICTION: Number = key(
            "friction",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 2.0 }),
            Is("0"),
            "Coefficient of friction μ of the rope on the chock. With a coefficient of 0, as on a \
             roller that turns, the whole tension reaches the rope on deck.",
            &["0.2"],
        ),
        WRAP: Number = key(
            "wrap",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: 0.0, high: 12.6 }),
            Is("\"90 deg\""),
            "Angle φ by which the rope is bent about the chock and about everything that the rope \
             touches on deck.",
            &["\"60 deg\""],
        ),
    }
}

const AXIAL_STIFFNESS: KeySpec = key(
    "axial_stiffness",
    Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e13 }),
    Means("`rope` or `load_extension` gives the stretch of the rope"),
    "With `rope = \"own\"`: axial stiffness EA of the rope, which is the tension divided by the \
     strain.",
    &["\"11.25 MN\""],
);
const LOAD_EXTENSION: KeySpec = key(
    "load_extension",
    Kind::FileName,
    Means("`rope` or `axial_stiffness` gives the stretch of the rope"),
    "With `rope = \"own\"`: file with the load-extension curve of the rope. The file of the curve \
     has the columns `extension_percent` and `load_kn`, or `extension_percent` and `load_percent` \
     (of the break load). The first row of the load-extension curve is 0, 0 and both columns rise. \
     The load-extension curve is straight between the rows and beyond the last row.",
    &["\"rope.csv\""],
);

/// The rule of the JSON schema for a rope: with `rope = "own"` the rope has either `axial_stiffness` or
/// `load_extension`; any other rope has neither of these keys.
fn rope_rules() -> serde_json::Value {
    json!({
        "if": { "properties": { "rope": { "const": "own" } }, "required": ["rope"] },
        "then": { "oneOf": [
            { "required": ["axial_stiffness"] }, { "required": ["load_extension"] }
        ] },
        "else": { "properties": { "axial_stiffness": false, "load_extension": false } }
    })
}

static TAIL: TableSpec = TableSpec {
    what: "a tail",
    doc: "A tail: a softer rope in series with the mooring line.",
    keys: TailKey::ALL,
    rules: Some(rope_rules),
};

table_keys! {
    /// Keys of a tail.
    pub TailKey {
        ROPE: OneOf<BuiltIn> = key(
            "rope",
            Kind::Choice(&ROPES),
            Is("\"nylon\""),
            "Material of the rope.",
            &["\"nylon\""],
        ),
        AXIAL_STIFFNESS: Number = AXIAL_STIFFNESS,
        LOAD_EXTENSION: Text = LOAD_EXTENSION,
        BREAK_LOAD: Number = key(
            "break_load",
            Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e9 }),
            Refused,
            "Break force of the tail.",
            &["\"1500 kN\""],
        ),
        LENGTH: Number = key(
            "length",
            Kind::Quantity(LENGTH),
            Is("11"),
            "Length of the tail.",
            &["\"11 m\""],
        ),
    }
}

shared_keys! {
    /// Keys of a rope: of a line or of its tail.
    pub RopeKey of LineKey and TailKey {
        ROPE: OneOf<BuiltIn>,
        AXIAL_STIFFNESS: Number,
        LOAD_EXTENSION: Text,
        BREAK_LOAD: Number,
    }
}

/// The load-extension curve of a rope's material; `None` if the scenario gives the stiffness or the curve of the rope.
pub type BuiltIn = Option<fn() -> RopeCurve>;

static ROPES: Choices<BuiltIn> = Choices(&[
    Choice { word: "wire", value: Some(RopeCurve::wire), doc: "steel wire with a steel core" },
    Choice { word: "hmpe", value: Some(RopeCurve::hmpe), doc: "high-modulus polyethylene" },
    Choice { word: "polyester", value: Some(RopeCurve::polyester), doc: "polyester" },
    Choice { word: "nylon", value: Some(RopeCurve::nylon), doc: "nylon, as in tails" },
    Choice {
        word: "own",
        value: None,
        doc: "your own rope, which `axial_stiffness` or `load_extension` describes",
    },
]);

pub(super) static BOLLARD: TableSpec = TableSpec {
    what: "a bollard",
    doc: "A bollard to which the order `send` can send mooring lines.",
    keys: BollardKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a bollard.
    pub BollardKey {
        ON: Name = key(
            "on",
            Kind::BodyName,
            Refused,
            "The body on which the bollard stands: a quay, a dolphin, another ship.",
            &["\"quay\""],
        ),
        AT: Vector = key(
            "at",
            Kind::Point(POSITION),
            Refused,
            "Place of the bollard, forward and to starboard of the body's origin.",
            &["[60, 2]"],
        ),
        HEIGHT: Number = key(
            "height",
            Kind::Quantity(PLACE),
            Is("0"),
            "Height of the bollard above the still water; on a fixed body above datum.",
            &["\"4 m\""],
        ),
        LINES: Number = key(
            "lines",
            Kind::Quantity(COUNT),
            Is("4"),
            "How many lines the bollard takes at once.",
            &["2"],
        ),
    }
}

pub(super) static LINE_HANDLING: TableSpec = TableSpec {
    what: "the handling of lines",
    doc: "How line handlers bring mooring lines to a bollard when an order sends the lines there. \
          A gang of line handlers takes one line at a time; further lines wait. The default values \
          for line handling are assumptions, not from a source.",
    keys: LineHandlingKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of the handling of lines.
    pub LineHandlingKey {
        GANGS: Number = key(
            "gangs",
            Kind::Quantity(COUNT),
            Is("2"),
            "Number of gangs of line handlers.",
            &["1"],
        ),
        HEAVING_LINE: Number = key(
            "heaving_line",
            Kind::Quantity(LENGTH),
            Is("30"),
            "Longest distance from fairlead to bollard that a heaving line can bridge.",
            &["\"25 m\""],
        ),
        TIME: Number = key(
            "time",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 1e5 }),
            Is("60"),
            "Time to bring a line ashore with a heaving line, until the eye of the line is over \
             the bollard.",
            &["\"90 s\""],
        ),
        BOAT: Flag = key(
            "boat",
            Kind::Flag,
            Is("true"),
            "Whether a boat carries lines to bollards that a heaving line does not reach.",
            &["false"],
        ),
        BOAT_SPEED: Number = key(
            "boat_speed",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.01, high: 20.0 }),
            Is("1"),
            "Speed of the boat that carries a line; the time of the boat's way is added to `time`.",
            &["\"2 kn\""],
        ),
    }
}

/// Bounds of a number of gangs, or of lines at a bollard.
pub(super) const COUNT: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 100.0 };
