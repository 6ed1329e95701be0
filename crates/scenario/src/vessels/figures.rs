//! Writes the numbers in a vessel's table as texts, each with its path.

use std::f64::consts::TAU;

use fenderline_sim::hydro::vessels::Figure;

use crate::vessels::keys::FileVesselKey;
use fenderline_keys::checked::{Item, Table, Value};
use fenderline_keys::keys::vessel::VesselKey;
use fenderline_keys::sources::Span;
use fenderline_keys::spec::{Kind, Quantity};
use fenderline_keys::typed_key::AnyKey;
use fenderline_keys::units::measures as unit;
use fenderline_keys::{any_keys, key_path};

/// Keys of a vessel that do not hold numbers.
const NO_FIGURES: &[AnyKey<FileVesselKey>] =
    any_keys![FileVesselKey: TITLE, TANK_MODEL, COEFFICIENTS_OF, SOURCE];

/// A number of a vessel as text, and the place of its key in the file.
pub(super) struct Leaf {
    /// Path of the number below the vessel, as in `propeller.wake`, and the value of the number.
    pub(super) figure: Figure,
    /// True if the value is the key's default, because the file does not give the key.
    pub(super) is_default: bool,
    /// Place of the number's key in the file.
    pub(super) key_span: Span,
}

/// Every number of a vessel's table.
pub(super) fn leaves(table: &Table) -> Vec<Leaf> {
    let mut all = Vec::new();
    for item in table.items.iter().filter(|item| has_figures(item)) {
        collect(table, item, "", &mut all);
    }
    all
}

/// Whether a key holds numbers of the vessel.
fn has_figures(item: &Item) -> bool {
    !item.is(VesselKey::FROM) && !NO_FIGURES.iter().any(|key| item.is(*key))
}

fn collect(table: &Table, item: &Item, path: &str, all: &mut Vec<Leaf>) {
    let path = key_path::join(path, item.name);
    let mut below = |inner: &Table, path: &str| {
        inner.items.iter().for_each(|item| collect(inner, item, path, all));
    };
    match &item.value {
        Value::Table(inner) => below(inner, &path),
        Value::Named(tables) => {
            for (name, inner) in tables {
                below(inner, &key_path::join(&path, name));
            }
        }
        _ => {
            let kind = &table
                .spec
                .key(item.name)
                .expect("the item was read by the declaration of its table")
                .kind;
            all.push(Leaf {
                figure: Figure { name: path, text: value_text(kind, item) },
                is_default: item.is_default,
                key_span: item.key_span.clone(),
            });
        }
    }
}

fn value_text(kind: &Kind, item: &Item) -> String {
    match (kind, &item.value) {
        (Kind::Quantity(quantity), Value::Number(value)) => number(quantity, *value),
        (_, Value::Vector(at)) => format!("[{}, {}] m", digits(at.x), digits(at.y)),
        (_, Value::Outline(points)) => format!("{} points", points.len()),
        (_, Value::Choice(word)) => word.word.to_owned(),
        (_, Value::Text(text)) => text.clone(),
        (_, Value::Texts(texts)) => texts.join(", "),
        (_, Value::Flag(flag)) => flag.to_string(),
        (_, other) => unreachable!("no key of a vessel holds {other:?}"),
    }
}

/// Writes a number in the unit that seamen use.
fn number(quantity: &Quantity, value: f64) -> String {
    let of = quantity.measure;
    let (value, unit) = match of {
        _ if of == &unit::ANGLE => (value.to_degrees(), "°"),
        _ if of == &unit::RATE_OF_TURN && value > 0.3 => (60.0 * value / TAU, "rpm"),
        _ if of == &unit::RATE_OF_TURN => (value.to_degrees(), "°/s"),
        _ if of == &unit::MASS => (1e-3 * value, "t"),
        _ if of == &unit::FORCE => (1e-3 * value, "kN"),
        _ => (value, of.unit),
    };
    let digits = digits(value);
    if unit.is_empty() || unit.starts_with('°') {
        format!("{digits}{unit}")
    } else {
        format!("{digits} {unit}")
    }
}

/// Writes a number with at most nine digits, which hides rounding errors of the unit conversion.
pub(super) fn digits(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let rounded: f64 = format!("{value:.8e}").parse().expect("the text of a number can be parsed");
    format!("{rounded}")
}
