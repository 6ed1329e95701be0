//! Keys of orders. All keys of orders but `telegraph` are made from the table of orders in `fenderline_sim`, so a new
//! order in that table becomes a key of the scenario file.

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
    doc: "An order at a time of the run to a vessel (`vessel`), a tug (`tug`), a line (`line`) or \
          an anchor (`anchor`); each [[order]] has one of these targets.",
    keys: &KEYS,
    rules: Some(rules),
};

/// Number of orders in the table of orders in `fenderline_sim`.
const ORDERS: usize = OrderName::ALL.len();
/// Greatest number of arguments of an order.
const MOST_ARGUMENTS: usize = 4;
const ANOTHER: Absent = Means("another order");
/// Fills an array of keys at compile time, until the actual keys are put into the array.
const PLACEHOLDER: KeySpec = key("", Kind::Flag, ANOTHER, "", &[]);

table_keys! {
    /// Keys of an `[[order]]` that are not orders from the table: time, target, telegraph, and the direction of a push or
    /// pull.
    pub OrderKey of &KEYS; {
        AT: Number = key("at", Kind::Quantity(TIME), Is("0"), "Time of the order.", &["\"90 s\""]),
        VESSEL: Name = key(
            "vessel",
            Kind::BodyName,
            Means("the order is for a tug, a line or an anchor"),
            "The body of the vessel that gets the order.",
            &["\"ship\""],
        ),
        TUG: Text = key(
            "tug",
            Kind::Text,
            Means("the order is for a vessel, a line or an anchor"),
            "Name of the tug that gets the order.",
            &["\"bow tug\""],
        ),
        LINE: Text = key(
            "line",
            Kind::Text,
            Means("the order is for a vessel, a tug or an anchor"),
            "Name of the line to which the order applies.",
            &["\"head line\""],
        ),
        ANCHOR: Text = key(
            "anchor",
            Kind::Text,
            Means("the order is for a vessel, a tug or a line"),
            "Name of the anchor to which the order applies.",
            &["\"port\""],
        ),
        TELEGRAPH: OneOf<Telegraph> = key(
            "telegraph",
            Kind::Choice(&TELEGRAPH_WORDS),
            ANOTHER,
            "Engine order, in the words of the engine telegraph.",
            &["\"slow astern\""],
        ),
        DIRECTION: Number = argument_spec(argument(OrderName::Push, "direction")),
    }
}

/// Keys of an order's arguments, for orders that are a table.
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

/// The argument `name` of an order. The program does not compile if the order has no argument `name`.
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

/// The declarations of the tables of all orders whose form is [`Form::Table`].
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
    /// The key holds `true`, because the order has no arguments.
    Flag,
    /// The key holds the order's first argument, a number. Further arguments are keys beside the key of the order.
    Number,
    /// The key holds a table of all the order's arguments.
    Table,
}

/// How the key of an order holds the order's arguments.
pub const fn form(order: OrderName) -> Form {
    match order.spec().arguments {
        [] => Form::Flag,
        [Argument { kind: ArgumentKind::Number { .. }, .. }, ..] => Form::Number,
        _ => Form::Table,
    }
}

/// The words of all orders that a kind of target, such as a tug, can get.
pub fn words(target: TargetKind) -> Vec<&'static str> {
    let specs = OrderName::ALL.iter().map(|order| order.spec());
    let telegraph = (target == TargetKind::Vessel).then_some(OrderKey::TELEGRAPH.name());
    specs.filter(|spec| spec.target == target).map(|spec| spec.word).chain(telegraph).collect()
}

/// The key that names the target of an order, for a kind of target.
pub fn target_key(kind: TargetKind) -> AnyKey<OrderKey> {
    match kind {
        TargetKind::Vessel => OrderKey::VESSEL.any(),
        TargetKind::Tug => OrderKey::TUG.any(),
        TargetKind::Line => OrderKey::LINE.any(),
        TargetKind::Anchor => OrderKey::ANCHOR.any(),
    }
}

/// The key of an order, with the type of the value that the key holds.
#[derive(Clone, Copy, Debug)]
pub enum OrderKind {
    /// The key holds `true`, because the order has no arguments.
    Flag(Key<OrderKey, Flag>),
    /// The key holds the first argument of the order. Further arguments are keys beside the key of the order.
    Number(Key<OrderKey, Number>),
    /// The key holds a table of all the order's arguments.
    Table(Key<OrderKey, TableOf<ArgumentKey>>),
}

/// The key of an order in the scenario file.
pub fn order_key(order: OrderName) -> OrderKind {
    let spec = key_of(order);
    match form(order) {
        Form::Flag => OrderKind::Flag(Key::of(&spec)),
        Form::Number => OrderKind::Number(Key::of(&spec)),
        Form::Table => OrderKind::Table(Key::of(&spec)),
    }
}

/// The key of an order's argument, which stands beside the key of the order or in the table of the order.
///
/// # Panics
/// Panics if the argument's value is not of type `V`.
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

/// The rule of the JSON schema: each `[[order]]` has one target and one order for this target. An order without arguments
/// must be `true`, because `false` would order nothing.
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

/// The words of the engine telegraph, each with its engine order.
pub static TELEGRAPH_WORDS: Choices<Telegraph> = Choices(&[
    Choice {
        word: Telegraph::FullAstern.word(),
        value: Telegraph::FullAstern,
        doc: "70 % of full revolutions, astern",
    },
    Choice {
        word: Telegraph::HalfAstern.word(),
        value: Telegraph::HalfAstern,
        doc: "55 % of full revolutions, astern",
    },
    Choice {
        word: Telegraph::SlowAstern.word(),
        value: Telegraph::SlowAstern,
        doc: "40 % of full revolutions, astern",
    },
    Choice {
        word: Telegraph::DeadSlowAstern.word(),
        value: Telegraph::DeadSlowAstern,
        doc: "30 % of full revolutions, astern",
    },
    Choice { word: Telegraph::Stop.word(), value: Telegraph::Stop, doc: "stop" },
    Choice {
        word: Telegraph::DeadSlowAhead.word(),
        value: Telegraph::DeadSlowAhead,
        doc: "30 % of full revolutions, ahead",
    },
    Choice {
        word: Telegraph::SlowAhead.word(),
        value: Telegraph::SlowAhead,
        doc: "40 % of full revolutions, ahead",
    },
    Choice {
        word: Telegraph::HalfAhead.word(),
        value: Telegraph::HalfAhead,
        doc: "55 % of full revolutions, ahead",
    },
    Choice {
        word: Telegraph::FullAhead.word(),
        value: Telegraph::FullAhead,
        doc: "70 % of full revolutions, ahead: full speed for manoeuvring",
    },
    Choice {
        word: Telegraph::NavigationFull.word(),
        value: Telegraph::NavigationFull,
        doc: "full revolutions",
    },
]);
