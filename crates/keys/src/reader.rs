//! Turns a TOML tree into checked tables, using only the declarations of the keys. The reader reads the keys in the
//! order of the file, so that it reports the first mistake in the file.

mod errors;
mod meant;
mod values;

use toml::Spanned;
use toml::de::{DeArray, DeString, DeTable, DeValue};

use crate::checked::{Item, Table, Value};
use crate::error::ScenarioError;
use crate::key_path;
use crate::sources::{Sources, Span};
use crate::spec::{Absent, KeySpec, Kind, TableSpec};

pub use self::errors::unknown_key;
use self::errors::{missing_key, wrong_type};
use self::values::{
    any_number, any_values, check_text, choice, curve, flag, name_or, number, outline, points,
    text, texts, two_names, vector,
};

type Read<T> = Result<T, ScenarioError>;

type Node<'i> = Spanned<DeValue<'i>>;

/// Reads a table and all tables within this table.
pub fn table(
    sources: &Sources<'_>,
    spec: &'static TableSpec,
    path: &str,
    span: Span,
    table: &DeTable<'_>,
) -> Read<Table> {
    let mut items = Vec::new();
    for (key, value) in in_file_order(table) {
        let name = key.get_ref();
        let Some(key_spec) = spec.key(name) else {
            return Err(unknown_key(sources, spec, path, name, &key.span()));
        };
        let path = key_path::join(path, key_spec.name);
        let item = Item {
            name: key_spec.name,
            key_span: key.span(),
            span: value.span(),
            is_default: false,
            value: read_value(sources, key_spec, &path, value)?,
        };
        items.push(item);
    }
    with_defaults(sources, spec, path, &span, items)
}

/// Makes a table of the items `items` and the defaults of all other keys.
pub fn with_defaults(
    sources: &Sources<'_>,
    spec: &'static TableSpec,
    path: &str,
    span: &Span,
    mut items: Vec<Item>,
) -> Read<Table> {
    for key in spec.keys {
        if items.iter().all(|item| item.name != key.name) {
            items.extend(absent_key(sources, spec, key, path, span)?);
        }
    }
    Ok(Table { spec, path: path.to_owned(), span: span.clone(), items })
}

/// The default of a key that the file does not give.
fn absent_key(
    sources: &Sources<'_>,
    spec: &'static TableSpec,
    key: &'static KeySpec,
    path: &str,
    span: &Span,
) -> Read<Option<Item>> {
    match key.absent {
        Absent::Means(_) | Absent::Unless(_) => Ok(None),
        Absent::Refused => Err(missing_key(sources, spec, key, path, span)),
        Absent::Is(text) => {
            let default = DeValue::parse(text).expect("defaults in the key table are TOML");
            let default = respan(&default, span);
            let value = read_value(sources, key, &key_path::join(path, key.name), &default)?;
            let (key_span, span) = (span.clone(), span.clone());
            Ok(Some(Item { name: key.name, key_span, span, is_default: true, value }))
        }
    }
}

/// The entries of a table in the order of the file; the crate `toml` sorts the entries by name.
fn in_file_order<'t, 'i>(table: &'t DeTable<'i>) -> Vec<(&'t Spanned<DeString<'i>>, &'t Node<'i>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}

/// Reads the value of one key.
pub fn read_value(
    sources: &Sources<'_>,
    key: &KeySpec,
    path: &str,
    node: &Node<'_>,
) -> Read<Value> {
    match &key.kind {
        Kind::Text | Kind::FileName => text(sources, path, node).map(Value::Text),
        Kind::Flag => flag(sources, path, node).map(Value::Flag),
        Kind::Choice(choices) => choice(sources, *choices, path, node).map(Value::Choice),
        Kind::Quantity(quantity) => number(sources, quantity, path, node).map(Value::Number),
        Kind::NameOr(quantity) => name_or(sources, quantity, path, node),
        Kind::Vector(quantity) => {
            vector(sources, quantity, path, node, ["north", "east"]).map(Value::Vector)
        }
        Kind::Point(quantity) => {
            vector(sources, quantity, path, node, ["forward", "starboard"]).map(Value::Vector)
        }
        Kind::Texts | Kind::FileNames => texts(sources, path, node).map(Value::Texts),
        Kind::Values => any_values(sources, path, node).map(Value::Texts),
        Kind::AnyNumber => any_number(sources, path, node).map(Value::Text),
        Kind::Outline(quantity) => outline(sources, quantity, path, node).map(Value::Outline),
        Kind::Points(quantity, fewest, most) => {
            points(sources, quantity, [*fewest, *most], path, node).map(Value::Outline)
        }
        Kind::Curve(spec) => curve(sources, spec, path, node).map(Value::Curve),
        Kind::MaterialName | Kind::BodyName => text(sources, path, node).map(Value::Name),
        Kind::TwoBodyNames => two_names(sources, path, node).map(Value::TwoNames),
        Kind::Table(spec) => {
            let inner = as_table(sources, spec.what, path, node)
                .map_err(|error| error.with_help(as_written(key.name, spec)))?;
            table(sources, spec, path, node.span(), inner).map(Value::Table)
        }
        Kind::Named(spec) => named(sources, spec, path, node).map(Value::Named),
        Kind::List(spec) => list(sources, spec, path, node).map(Value::List),
    }
}

fn named(
    sources: &Sources<'_>,
    spec: &'static TableSpec,
    path: &str,
    node: &Node<'_>,
) -> Read<Vec<(String, Table)>> {
    let tables = as_table(sources, &format!("{} under each name", spec.what), path, node)?;
    let mut read = Vec::with_capacity(tables.len());
    for (key, node) in in_file_order(tables) {
        let name = key.get_ref();
        let (parent, path) = (path, key_path::join(path, name));
        check_text(sources, &path, name, &key.span())?;
        if name == "*" {
            let message = format!("{} cannot be named \"*\", which stands for all", spec.what);
            return Err(sources.error(&key.span(), &path, message));
        }
        let inner = as_table(sources, spec.what, &path, node).map_err(|error| {
            // `material.stiffness = 1`, without a name.
            match spec.key(name) {
                Some(_) => error.with_help(format!("{} has a name: [{parent}.NAME]", spec.what)),
                None => error,
            }
        })?;
        read.push((name.to_string(), table(sources, spec, &path, node.span(), inner)?));
    }
    Ok(read)
}

fn list(
    sources: &Sources<'_>,
    spec: &'static TableSpec,
    path: &str,
    node: &Node<'_>,
) -> Read<Vec<Table>> {
    let DeValue::Array(nodes) = node.get_ref() else {
        let error = wrong_type(sources, "a list of tables", path, node);
        return Err(error.with_help(format!("write [[{path}]] with two brackets")));
    };
    let read_one = |(index, node): (usize, &Node<'_>)| {
        let path = key_path::join(path, &index.to_string());
        let inner = as_table(sources, spec.what, &path, node)?;
        table(sources, spec, &path, node.span(), inner)
    };
    nodes.iter().enumerate().map(read_one).collect()
}

fn as_table<'t, 'i>(
    sources: &Sources<'_>,
    wanted: &str,
    path: &str,
    node: &'t Node<'i>,
) -> Read<&'t DeTable<'i>> {
    match node.get_ref() {
        DeValue::Table(table) => Ok(table),
        _ => Err(wrong_type(sources, &format!("a table: {wanted}"), path, node)),
    }
}

/// Shows how to write a table, with the keys that the table must have, or with its first keys if no key is required.
fn as_written(name: &str, spec: &TableSpec) -> String {
    const SHOWN: usize = 3;
    let must = spec.keys.iter().filter(|key| matches!(key.absent, Absent::Refused));
    let shown: Vec<&KeySpec> = match must.clone().count() {
        0 => spec.keys.iter().take(SHOWN).collect(),
        _ => must.collect(),
    };
    let entry =
        |key: &&KeySpec| format!("{} = {}", key.name, key.examples.first().copied().unwrap_or("…"));
    let entries = shown.iter().map(entry).collect::<Vec<_>>().join(", ");
    format!("write {name} = {{ {entries} }}")
}

/// A copy of a TOML value in which every part has the same place `span` in the sources.
pub fn respan<'i>(node: &Node<'i>, span: &Span) -> Node<'i> {
    let value = match node.get_ref() {
        DeValue::Array(nodes) => {
            let mut array = DeArray::new();
            nodes.iter().for_each(|node| array.push(respan(node, span)));
            DeValue::Array(array)
        }
        DeValue::Table(table) => {
            let mut copy = DeTable::new();
            for (key, node) in table {
                let key = Spanned::new(span.clone(), key.get_ref().clone());
                copy.insert(key, respan(node, span));
            }
            DeValue::Table(copy)
        }
        other => other.clone(),
    };
    Spanned::new(span.clone(), value)
}
