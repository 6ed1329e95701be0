//! Keys of rows of fenders: the keys of a fender, and the place of the row.

use serde_json::{Value as Json, json};

use super::dolphin::{DOLPHIN, DolphinKey};
use super::fender::{FENDER, FenderKey};
use super::quantities::{DIRECTION, FENDER_SIZE, POSITION};
use super::quay_line::{QUAY_LINE, QuayLineKey};
use crate::held::{Name, NamedOf, Number, Points, TableOf, Vector};
use crate::spec::Absent::{Is, Means, Refused, Unless};
use crate::spec::{Absent, KeySpec, Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::typed_key::is_same;
use crate::units::measures as unit;

/// Greatest number of fenders in a row.
pub const MOST_IN_ROW: usize = 1000;

pub(super) static FENDER_ROW: TableSpec = TableSpec {
    what: "a row of fenders",
    doc: "A row of equal fenders, which are named NAME_1, NAME_2 and so on. The row begins at \
          `first` or stands along a `wall`, with two of the keys `spacing`, `number` and `last`; \
          or it stands along a `quay_line` of the chart, with `spacing`; or on `dolphins`. All other keys of the row are keys of a fender, and hold for \
          each fender of the row.",
    keys: &ROW_KEYS,
    rules: Some(row_rules),
};

/// Whether a key of a fender is also a key of a row of fenders, with the same meaning. The keys of a row that are not
/// keys of a fender are in [`FenderRowKey`].
const fn is_shared(name: &str) -> bool {
    let own = [
        FenderKey::ON.name(),
        FenderKey::POSITION.name(),
        FenderKey::FACING.name(),
        FenderKey::BELTING.name(),
        FenderKey::WIDTH.name(),
    ];
    let mut index = 0;
    while index < own.len() {
        if is_same(own[index], name) {
            return false;
        }
        index += 1;
    }
    true
}

table_keys! {
    /// Keys of a row of fenders that a single fender does not have, or has with another meaning. The key `exception`
    /// comes last.
    pub FenderRowKey of &ROW_KEYS; {
        ON: Name = key(
            "on",
            Kind::BodyName,
            Unless("`dolphins` is given"),
            "The body that carries the row.",
            &["\"quay\""],
        ),
        FIRST: Vector = key(
            "first",
            Kind::Point(POSITION),
            Unless("`wall`, `quay_line` or `dolphins` of the row is given"),
            "Middle of the line where the first fender is mounted: distances forward and to \
             starboard of the body's origin. For a row on dolphins, `first` is the place of the \
             fender on each dolphin; [0, 0] unless given.",
            &["[-70, 0]"],
        ),
        LAST: Vector = key(
            "last",
            Kind::Point(POSITION),
            Unless("`spacing` and `number` of the row are given"),
            "Middle of the line where the last fender is mounted. Without `last`, the row runs \
             along the edge on which `first` lies, or at right angles to `facing`. The row \
             then runs forward, or to starboard if it lies straight across the body.",
            &["[70, 0]"],
        ),
        SPACING: Number = key(
            "spacing",
            Kind::Quantity(FENDER_SIZE),
            Unless("`last` and `number` of the row are given"),
            "Distance from the middle of a fender to the middle of the next fender.",
            &["\"20 m\""],
        ),
        NUMBER: Number = key(
            "number",
            Kind::Quantity(Quantity {
                measure: &unit::PLAIN_NUMBER,
                low: 1.0,
                high: MOST_IN_ROW as f64,
            }),
            Unless("`last` and `spacing`, or `quay_line`, of the row are given"),
            "Number of fenders. A row along a `quay_line` has as many as the line has room for, unless \
             the number is given.",
            &["8"],
        ),
        WALL: Points = key(
            "wall",
            Kind::Points(POSITION, 2, 2),
            Means("the row begins at `first`"),
            "Two corners of the body between which the row stands along an edge of the outline, \
             from the first corner to the second.",
            &["[[-100, 0], [100, 0]]"],
        ),
        QUAY_LINE: TableOf<QuayLineKey> = key(
            "quay_line",
            Kind::Table(&QUAY_LINE),
            Means("the row does not follow the chart"),
            "A line of the chart along which the row stands, on a fixed body such as `shore`. The \
             fenders are mounted on the body's face at the line and face the water.",
            &["{ name = \"Long Quay\" }"],
        ),
        FROM_CORNER: Number = key(
            "from_corner",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e5 }),
            Means("the row stands in the middle of the wall"),
            "Distance from the first corner of the `wall`, or from the start of the `quay_line`, to the \
             middle of the first fender.",
            &["\"5 m\""],
        ),
        DOLPHINS: Points = key(
            "dolphins",
            Kind::Points(POSITION, 1, MOST_IN_ROW),
            Means("the row stands on one body"),
            "Positions of the dolphins: north and east coordinate of each dolphin. The dolphins \
             are the bodies NAME_1, NAME_2 and so on, each with one fender. A pair of bodies that \
             names NAME is a pair with each dolphin of the row.",
            &["[[-60, 20], [60, 20]]"],
        ),
        OUTLINE: Points = key(
            "outline",
            Kind::Outline(POSITION),
            Unless("the row has no `dolphins`"),
            "Outline of each dolphin, with vertices relative to the position of the dolphin.",
            &["[[-2, 0], [2, 0], [2, 4], [-2, 4]]"],
        ),
        DOLPHIN: TableOf<DolphinKey> = key(
            "dolphin",
            Kind::Table(&DOLPHIN),
            Means("fixed dolphins"),
            "Makes each of the `dolphins` a flexible dolphin: a head on piles that bend, with the \
             mass of head and piles.",
            &["{ stiffness = \"5 MN/m\", mass = \"60 t\", yield_load = \"1500 kN\" }"],
        ),
        HEADING: Number = key(
            "heading",
            Kind::Quantity(DIRECTION),
            Means("north"),
            "Heading of the dolphins.",
            &["\"30 deg\""],
        ),
        FACING: Number = key(
            "facing",
            Kind::Quantity(DIRECTION),
            Unless("the row stands along an edge of the body's outline"),
            "Direction in which the fenders face, clockwise from the body's forward direction. By \
             default the fenders face out at right angles to the edge on which they stand.",
            &["\"-90 deg\""],
        ),
        WIDTH: Number = key(
            "width",
            Kind::Quantity(FENDER_SIZE),
            Refused,
            "Width of the face of each fender (of the panel, if there is a panel).",
            &["\"2.4 m\""],
        ),
        EXCEPTION: NamedOf<FenderKey> = key(
            "exception",
            Kind::Named(&EXCEPTION),
            Is("{}"),
            "Keys of single fenders of the row in tables named after the fenders: \
                  [fender_row.NAME.exception.NAME_3]. A `*` in the name of such a table stands for \
                  any text. The option `--set fender.NAME_3.KEY=VALUE` also changes a single \
                  fender of the row.",
            &[],
        ),
    }
}

/// How many keys of [`FenderRowKey`] come before the keys of a fender in the list of a row's keys.
const OWN: usize = FenderRowKey::ALL.len() - 1;

static EXCEPTION: TableSpec = TableSpec {
    what: "an exception of a row of fenders",
    doc: "Keys in which a single fender of a row differs from the other fenders of the row. An \
          exception may have all keys of a fender but `on` and `belting`.",
    keys: &EXCEPTION_KEYS,
    rules: None,
};

const SHARED: usize = count_shared();
const fn count_shared() -> usize {
    let (mut count, mut index) = (0, 0);
    while index < FENDER.keys.len() {
        count += is_shared(FENDER.keys[index].name) as usize;
        index += 1;
    }
    count
}

static ROW_KEYS: [KeySpec; OWN + SHARED + 1] = row_keys();

const fn row_keys() -> [KeySpec; OWN + SHARED + 1] {
    let mut keys = [FenderRowKey::ALL[OWN]; OWN + SHARED + 1];
    let (mut at, mut index) = (0, 0);
    while index < OWN {
        keys[at] = FenderRowKey::ALL[index];
        (at, index) = (at + 1, index + 1);
    }
    index = 0;
    while index < FENDER.keys.len() {
        if is_shared(FENDER.keys[index].name) {
            keys[at] = FENDER.keys[index];
            at += 1;
        }
        index += 1;
    }
    keys
}

/// Keys of a fender but `on` and `belting`; each may be left out.
static EXCEPTION_KEYS: [KeySpec; FENDER.keys.len() - 2] = exception_keys();

const fn exception_keys() -> [KeySpec; FENDER.keys.len() - 2] {
    let mut keys = [FENDER.keys[0]; FENDER.keys.len() - 2];
    let (mut at, mut index) = (0, 0);
    while index < FENDER.keys.len() {
        let key = FENDER.keys[index];
        if !is_same(key.name, FenderKey::ON.name()) && !is_same(key.name, FenderKey::BELTING.name())
        {
            keys[at] = KeySpec { absent: Absent::Means("as the row"), ..key };
            at += 1;
        }
        index += 1;
    }
    keys
}

/// The rules of a fender without the rule of beltings, and the rules for the place of the row.
fn row_rules() -> Json {
    let of_fender = FENDER.rules.map_or(json!({}), |rules| rules());
    let is_of_beltings = |rule: &Json| rule["if"]["required"] == json!(["belting"]);
    let all = of_fender["allOf"].as_array().into_iter().flatten();
    let mut rules: Vec<Json> = all.filter(|rule| !is_of_beltings(rule)).cloned().collect();
    rules.push(
        json!({ "if": of_fender["if"], "then": of_fender["then"], "else": of_fender["else"] }),
    );
    let refused = |names: &[&str]| -> Json {
        names.iter().map(|name| ((*name).to_owned(), json!(false))).collect()
    };
    let two_of_three = json!([
        { "required": ["spacing", "number"], "not": { "required": ["last"] } },
        { "required": ["spacing", "last"], "not": { "required": ["number"] } },
        { "required": ["number", "last"], "not": { "required": ["spacing"] } },
    ]);
    rules.push(json!({
        "if": { "required": ["dolphins"] },
        "then": {
            "required": ["outline"],
            "properties": refused(&[
                "on", "wall", "quay_line", "from_corner", "last", "spacing", "number"
            ])
        },
        "else": {
            "required": ["on"],
            "properties": refused(&["outline", "heading", "dolphin"]),
            "if": { "required": ["quay_line"] },
            "then": {
                "required": ["spacing"],
                "properties": refused(&["wall", "first", "last", "facing"])
            },
            "else": {
                "if": { "required": ["wall"] },
                "then": {
                    "required": ["spacing", "number"],
                    "properties": refused(&["first", "last"])
                },
                "else": {
                    "required": ["first"],
                    "properties": refused(&["from_corner"]),
                    "oneOf": two_of_three
                }
            }
        }
    }));
    json!({ "allOf": rules })
}
