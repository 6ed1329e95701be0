//! Keys of orders. All but the telegraph are made from the table of orders in `fenderline_sim`, so a
//! new order in that table is a key here.

use fenderline_sim::hydro::actuator::Telegraph;
use fenderline_sim::order::{
    Absent as Default, Argument, ArgumentKind, Frame, Named, OrderName, TargetKind, Unit,
};
use serde_json::{Value as Json, json};

use super::quantities::TIME;
use crate::choices::{Choice, Choices};
use crate::held::{Flag, Held, Name, Number, OneOf, TableOf, Text};
use crate::spec::Absent::{self, Is, Means, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableKeys, TableSpec, key};
use crate::table_keys;
use crate::typed_key::{AnyKey, Key, is_same};
use crate::units::{Measure, measures as unit};

/// An order.
pub static ORDER: TableSpec = TableSpec {
    what: "an order",
    doc: "An order to a vessel (`vessel`), a tug (`tug`), a line (`line`) or an anchor (`anchor`) \
        at a time; each [[order]] has one target.",
    keys: &KEYS,
    rules: Some(rules),
};

/// How many orders there are.
const ORDERS: usize = OrderName::ALL.len();
/// The most arguments of an order.
const MOST_ARGUMENTS: usize = 4;
const ANOTHER: Absent = Means("another order");
/// Fills an array until its keys are known.
const PLACEHOLDER: KeySpec = key("", Kind::Flag, ANOTHER, "", &[]);

table_keys! {
    /// Keys of an order that come before the orders: time, target, telegraph, and the direction of a push or pull.
    pub OrderKey of &KEYS; {
        AT: Number = key("at", Kind::Quantity(TIME), Is("0"), "Time of the order.", &["\"90 s\""]),
        VESSEL: Name = key(
            "vessel",
            Kind::BodyName,
            Means("the order is for a tug, a line or an anchor"),
            "The body of the vessel.",
            &["\"ship\""],
        ),
        TUG: Text = key(
            "tug",
            Kind::Text,
            Means("the order is for a vessel, a line or an anchor"),
            "The tug.",
            &["\"bow tug\""],
        ),
        LINE: Text = key(
            "line",
            Kind::Text,
            Means("the order is for a vessel, a tug or an anchor"),
            "The line.",
            &["\"head line\""],
        ),
        ANCHOR: Text = key(
            "anchor",
            Kind::Text,
            Means("the order is for a vessel, a tug or a line"),
            "The anchor.",
            &["\"port\""],
        ),
        TELEGRAPH: OneOf<Telegraph> = key(
            "telegraph",
            Kind::Choice(&TELEGRAPH_WORDS),
            ANOTHER,
            "Engine order in the words of the telegraph.",
            &["\"slow astern\""],
        ),
        DIRECTION: Number = argument_spec(argument(OrderName::Push, "direction")),
    }
}

/// Keys of the arguments in the table of an order.
#[derive(Debug)]
pub enum ArgumentKey {}

impl TableKeys for ArgumentKey {
    const KEYS: &'static [KeySpec] = ARGUMENTS.as_flattened();
}

static KEYS: [KeySpec; OrderKey::ALL.len() + ORDERS] = {
    let mut keys = [PLACEHOLDER; OrderKey::ALL.len() + ORDERS];
    let mut index = 0;
    while index < keys.len() {
        keys[index] = if index < OrderKey::ALL.len() {
            OrderKey::ALL[index]
        } else {
            key_of(OrderName::ALL[index - OrderKey::ALL.len()])
        };
        index += 1;
    }
    keys
};

/// The argument of this name. The compiler refuses an order without it.
const fn argument(order: OrderName, name: &str) -> &'static Argument {
    let arguments = order.spec().arguments;
    let mut index = 0;
    while index < arguments.len() {
        if is_same(arguments[index].name, name) {
            return &arguments[index];
        }
        index += 1;
    }
    panic!("the order has no argument of this name")
}

/// The keys of the arguments of each order.
static ARGUMENTS: [[KeySpec; MOST_ARGUMENTS]; ORDERS] = {
    let mut all = [[PLACEHOLDER; MOST_ARGUMENTS]; ORDERS];
    let mut order = 0;
    while order < ORDERS {
        let arguments = OrderName::ALL[order].spec().arguments;
        let mut index = 0;
        while index < arguments.len() {
            all[order][index] = argument_spec(&arguments[index]);
            index += 1;
        }
        order += 1;
    }
    all
};

/// The tables of the orders of form [`Form::Table`].
static TABLES: [TableSpec; ORDERS] = {
    let mut all =
        [const { TableSpec { what: "an order", doc: "", keys: &[], rules: None } }; ORDERS];
    let mut order = 0;
    while order < ORDERS {
        let spec = OrderName::ALL[order].spec();
        all[order] = TableSpec {
            what: "an order",
            doc: spec.meaning,
            keys: ARGUMENTS[order].split_at(spec.arguments.len()).0,
            rules: match OrderName::ALL[order] {
                OrderName::Azimuth => Some(power_or_direction),
                _ => None,
            },
        };
        order += 1;
    }
    all
};

/// How the key of an order holds its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// `true`: the order has no arguments.
    Flag,
    /// The first argument, a number. The others are keys beside the order.
    Number,
    /// A table of all arguments.
    Table,
}

/// The form of an order's key.
pub const fn form(order: OrderName) -> Form {
    match order.spec().arguments {
        [] => Form::Flag,
        [Argument { kind: ArgumentKind::Number { .. }, .. }, ..] => Form::Number,
        _ => Form::Table,
    }
}

/// The words of all orders to a kind of target.
pub fn words(target: TargetKind) -> Vec<&'static str> {
    let specs = OrderName::ALL.iter().map(|order| order.spec());
    let telegraph = (target == TargetKind::Vessel).then_some(OrderKey::TELEGRAPH.name());
    specs.filter(|spec| spec.target == target).map(|spec| spec.word).chain(telegraph).collect()
}

/// The key of a target.
pub fn target_key(kind: TargetKind) -> AnyKey<OrderKey> {
    match kind {
        TargetKind::Vessel => OrderKey::VESSEL.any(),
        TargetKind::Tug => OrderKey::TUG.any(),
        TargetKind::Line => OrderKey::LINE.any(),
        TargetKind::Anchor => OrderKey::ANCHOR.any(),
    }
}

/// The key of an order, by what the key holds.
#[derive(Clone, Copy, Debug)]
pub enum OrderKind {
    /// `true`: the order has no arguments.
    Flag(Key<OrderKey, Flag>),
    /// The first argument. The others are keys beside the order.
    Number(Key<OrderKey, Number>),
    /// A table of all arguments.
    Table(Key<OrderKey, TableOf<ArgumentKey>>),
}

/// The key of an order.
pub fn order_key(order: OrderName) -> OrderKind {
    let spec = key_of(order);
    match form(order) {
        Form::Flag => OrderKind::Flag(Key::of(&spec)),
        Form::Number => OrderKind::Number(Key::of(&spec)),
        Form::Table => OrderKind::Table(Key::of(&spec)),
    }
}

/// The key of an argument: beside the order, or in the table of the order.
///
/// # Panics
/// If the argument is not a `V`.
pub fn argument_key<T, V: Held>(argument: &Argument) -> Key<T, V> {
    Key::of(&argument_spec(argument))
}

const fn key_of(order: OrderName) -> KeySpec {
    let spec = order.spec();
    let (kind, examples): (Kind, &'static [&'static str]) = match form(order) {
        Form::Flag => (Kind::Flag, &["true"]),
        Form::Number => (kind_of(&spec.arguments[0]), example(&spec.arguments[0])),
        Form::Table => (Kind::Table(&TABLES[order as usize]), &[]),
    };
    key(spec.word, kind, ANOTHER, spec.meaning, examples)
}

const fn argument_spec(argument: &Argument) -> KeySpec {
    let absent = match argument.absent {
        Default::Refused => Refused,
        Default::Is(_, words) | Default::Means(words) => Means(words),
    };
    key(argument.name, kind_of(argument), absent, argument.meaning, example(argument))
}

const fn kind_of(argument: &Argument) -> Kind {
    match argument.kind {
        ArgumentKind::Number { unit, low, high } => {
            Kind::Quantity(Quantity { measure: measure(unit), low, high })
        }
        ArgumentKind::Place { most_m, frame } => {
            let quantity = Quantity { measure: &unit::LENGTH, low: -most_m, high: most_m };
            match frame {
                Frame::Earth => Kind::Vector(quantity),
                Frame::Body => Kind::Point(quantity),
            }
        }
        ArgumentKind::Name(Named::Body) => Kind::BodyName,
        ArgumentKind::Name(Named::Thruster | Named::AzimuthUnit | Named::Line | Named::Bollard) => {
            Kind::Text
        }
    }
}

const fn measure(of: Unit) -> &'static Measure {
    match of {
        Unit::Share => &unit::PLAIN_NUMBER,
        Unit::Radian => &unit::ANGLE,
        Unit::Metre => &unit::LENGTH,
        Unit::MetrePerSecond => &unit::SPEED,
        Unit::Newton => &unit::FORCE,
    }
}

const fn example(argument: &Argument) -> &'static [&'static str] {
    match argument.kind {
        ArgumentKind::Number { unit: Unit::Share, .. } => &["0.4"],
        ArgumentKind::Number { unit: Unit::Radian, .. } => &["\"-20 deg\""],
        ArgumentKind::Number { unit: Unit::Metre, .. } => &["\"3 shackles\""],
        ArgumentKind::Number { unit: Unit::MetrePerSecond, .. } => &["\"0.1 m/s\""],
        ArgumentKind::Number { unit: Unit::Newton, .. } => &["\"300 kN\""],
        ArgumentKind::Place { .. } => &["[90, -23]"],
        ArgumentKind::Name(Named::Thruster) => &["\"bow\""],
        ArgumentKind::Name(Named::AzimuthUnit) => &["\"port\""],
        ArgumentKind::Name(Named::Body) => &["\"ship\""],
        ArgumentKind::Name(Named::Line) => &["\"tow\""],
        ArgumentKind::Name(Named::Bollard) => &["\"b3\""],
    }
}

fn power_or_direction() -> Json {
    json!({ "anyOf": [{ "required": ["power"] }, { "required": ["direction"] }] })
}

/// One order for one target. A flag must be true: false would order nothing.
fn rules() -> Json {
    let flags = OrderName::ALL.iter().filter(|order| form(**order) == Form::Flag);
    let flags: serde_json::Map<String, Json> =
        flags.map(|order| (order.spec().word.to_owned(), json!({ "const": true }))).collect();
    let kinds = [TargetKind::Vessel, TargetKind::Tug, TargetKind::Line, TargetKind::Anchor];
    let for_kind = |kind: TargetKind| {
        let own: Vec<Json> = words(kind).iter().map(|word| json!({ "required": [word] })).collect();
        let others = kinds.iter().filter(|other| **other != kind);
        let mut refused: serde_json::Map<String, Json> = others
            .flat_map(|other| [vec![other.word()], words(*other)].concat())
            .map(|word| (word.to_owned(), json!(false)))
            .collect();
        if kind != TargetKind::Tug {
            refused.insert(OrderKey::DIRECTION.name().to_owned(), json!(false));
        }
        json!({ "allOf": [{ "required": [kind.word()], "oneOf": own }, { "properties": refused }] })
    };
    json!({
        "allOf": [{ "properties": flags }],
        "oneOf": kinds.map(for_kind),
    })
}

/// The words of an engine telegraph.
pub static TELEGRAPH_WORDS: Choices<Telegraph> = Choices(&[
    Choice {
        word: Telegraph::FullAstern.word(),
        value: Telegraph::FullAstern,
        doc: "70 % of full revolutions astern",
    },
    Choice { word: Telegraph::HalfAstern.word(), value: Telegraph::HalfAstern, doc: "55 % astern" },
    Choice { word: Telegraph::SlowAstern.word(), value: Telegraph::SlowAstern, doc: "40 % astern" },
    Choice {
        word: Telegraph::DeadSlowAstern.word(),
        value: Telegraph::DeadSlowAstern,
        doc: "30 % astern",
    },
    Choice { word: Telegraph::Stop.word(), value: Telegraph::Stop, doc: "stop" },
    Choice {
        word: Telegraph::DeadSlowAhead.word(),
        value: Telegraph::DeadSlowAhead,
        doc: "30 % ahead",
    },
    Choice { word: Telegraph::SlowAhead.word(), value: Telegraph::SlowAhead, doc: "40 % ahead" },
    Choice { word: Telegraph::HalfAhead.word(), value: Telegraph::HalfAhead, doc: "55 % ahead" },
    Choice {
        word: Telegraph::FullAhead.word(),
        value: Telegraph::FullAhead,
        doc: "70 % ahead: manoeuvring full",
    },
    Choice {
        word: Telegraph::NavigationFull.word(),
        value: Telegraph::NavigationFull,
        doc: "full revolutions",
    },
]);
