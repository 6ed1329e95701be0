//! From a TOML tree to checked tables, by the key table alone. Keys are taken in the order of the
//! file, so that the first mistake in the file is the one reported.

use fenderline_contact::{Vec2, vec2};
use toml::Spanned;
use toml::de::{DeArray, DeString, DeTable, DeValue};

use crate::checked::{Item, Table, Value};
use crate::choices::{AnyChoices, Word};
use crate::error::ScenarioError;
use crate::key_path;
use crate::sources::{Sources, Span, quoted};
use crate::spec::{Absent, CurveSpec, KeySpec, Kind, Quantity, TableSpec};
use crate::suggest::nearest;
use crate::units;

type Read<T> = Result<T, ScenarioError>;
type Node<'i> = Spanned<DeValue<'i>>;

/// Longest name or title, in bytes.
const LONGEST_TEXT: usize = 200;

/// Reads a table and all below it.
pub(crate) fn table(
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
    for key in spec.keys {
        if items.iter().all(|item| item.name != key.name) {
            items.extend(absent_key(sources, spec, key, path, &span)?);
        }
    }
    Ok(Table { spec, path: path.to_owned(), span, items })
}

/// What stands for a key that the file does not give.
fn absent_key(
    sources: &Sources<'_>,
    spec: &'static TableSpec,
    key: &'static KeySpec,
    path: &str,
    span: &Span,
) -> Read<Option<Item>> {
    match key.absent {
        Absent::Means(_) => Ok(None),
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

/// A table's entries, sorted by where they stand: `toml` sorts them by name.
fn in_file_order<'t, 'i>(table: &'t DeTable<'i>) -> Vec<(&'t Spanned<DeString<'i>>, &'t Node<'i>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}

fn read_value(sources: &Sources<'_>, key: &KeySpec, path: &str, node: &Node<'_>) -> Read<Value> {
    match &key.kind {
        Kind::Text | Kind::FileName => text(sources, path, node).map(Value::Text),
        Kind::Flag => flag(sources, path, node).map(Value::Flag),
        Kind::Choice(choices) => choice(sources, *choices, path, node).map(Value::Choice),
        Kind::Quantity(quantity) => number(sources, quantity, path, node).map(Value::Number),
        Kind::Vector(quantity) => {
            vector(sources, quantity, path, node, ["north", "east"]).map(Value::Vector)
        }
        Kind::Point(quantity) => {
            vector(sources, quantity, path, node, ["forward", "starboard"]).map(Value::Vector)
        }
        Kind::Texts => texts(sources, path, node).map(Value::Texts),
        Kind::Outline(quantity) => outline(sources, quantity, path, node).map(Value::Outline),
        Kind::Curve(spec) => curve(sources, spec, path, node).map(Value::Curve),
        Kind::MaterialName | Kind::BodyName => text(sources, path, node).map(Value::Name),
        Kind::TwoBodyNames => two_names(sources, path, node).map(Value::TwoNames),
        Kind::Table(spec) => {
            let inner = as_table(sources, spec.what, path, node)?;
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
            let message = format!("{} cannot be called \"*\": it stands for all", spec.what);
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

fn text(sources: &Sources<'_>, path: &str, node: &Node<'_>) -> Read<String> {
    match node.get_ref() {
        DeValue::String(text) => {
            check_text(sources, path, text, &node.span())?;
            Ok(text.to_string())
        }
        _ => Err(wrong_type(sources, "a text in quotes", path, node)),
    }
}

fn texts(sources: &Sources<'_>, path: &str, node: &Node<'_>) -> Read<Vec<String>> {
    let DeValue::Array(nodes) = node.get_ref() else {
        return Err(wrong_type(sources, "a list of texts in quotes", path, node));
    };
    let one = |(index, node)| text(sources, &key_path::item(path, index), node);
    nodes.iter().enumerate().map(one).collect()
}

/// Names and titles are short and in one line.
fn check_text(sources: &Sources<'_>, path: &str, text: &str, span: &Span) -> Read<()> {
    let complaint = if text.trim().is_empty() {
        "is empty".to_owned()
    } else if text.len() > LONGEST_TEXT {
        format!("is longer than {LONGEST_TEXT} bytes")
    } else if text.contains(char::is_control) {
        "has a line break or another control character in it".to_owned()
    } else {
        return Ok(());
    };
    Err(sources.error(span, path, format!("`{path}` {complaint}")))
}

fn flag(sources: &Sources<'_>, path: &str, node: &Node<'_>) -> Read<bool> {
    match node.get_ref() {
        DeValue::Boolean(flag) => Ok(*flag),
        _ => Err(wrong_type(sources, "true or false", path, node)),
    }
}

fn choice(
    sources: &Sources<'_>,
    choices: &'static dyn AnyChoices,
    path: &str,
    node: &Node<'_>,
) -> Read<Word> {
    let words = choices.words();
    let all = words.iter().map(|word| format!("\"{}\"", word.word)).collect::<Vec<_>>().join(", ");
    let DeValue::String(text) = node.get_ref() else {
        return Err(wrong_type(sources, &format!("one of {all}"), path, node));
    };
    if let Some(word) = words.iter().find(|word| word.word == text) {
        return Ok(*word);
    }
    let message = format!("`{path}` is {all}, not {}", quoted(text));
    let message = if words.len() > 1 { message.replacen("is ", "is one of ", 1) } else { message };
    let error = sources.error(&node.span(), path, message);
    Err(match nearest(text, words.iter().map(|word| word.word)) {
        Some(word) => error.with_help(format!("did you mean \"{word}\"?")),
        None => error,
    })
}

fn vector(
    sources: &Sources<'_>,
    quantity: &Quantity,
    path: &str,
    node: &Node<'_>,
    axes: [&str; 2],
) -> Read<Vec2> {
    let columns = axes.map(|axis| (axis, quantity));
    two_numbers(sources, columns, path, node).map(|(x, y)| vec2(x, y))
}

/// A list of two numbers, each with its name and quantity.
fn two_numbers(
    sources: &Sources<'_>,
    columns: [(&str, &Quantity); 2],
    path: &str,
    node: &Node<'_>,
) -> Read<(f64, f64)> {
    let wanted = || format!("[{}, {}]", columns[0].0, columns[1].0);
    let DeValue::Array(nodes) = node.get_ref() else {
        return Err(wrong_type(sources, &wanted(), path, node));
    };
    let [x, y] = nodes.as_ref() else {
        let message = format!("`{path}` is {}, but has {} numbers", wanted(), nodes.len());
        return Err(sources.error(&node.span(), path, message));
    };
    let component =
        |index: usize, node| number(sources, columns[index].1, &key_path::item(path, index), node);
    Ok((component(0, x)?, component(1, y)?))
}

fn curve(
    sources: &Sources<'_>,
    spec: &CurveSpec,
    path: &str,
    node: &Node<'_>,
) -> Read<Vec<(f64, f64)>> {
    let ((from, from_quantity), (to, to_quantity)) = (&spec.from, &spec.to);
    let DeValue::Array(nodes) = node.get_ref() else {
        return Err(wrong_type(sources, &format!("a list of rows [{from}, {to}]"), path, node));
    };
    let mut rows: Vec<(f64, f64)> = Vec::with_capacity(nodes.len());
    for (index, node) in nodes.iter().enumerate() {
        let path = key_path::item(path, index);
        let row = two_numbers(sources, [(from, from_quantity), (to, to_quantity)], &path, node)?;
        if let Some((before, _)) = rows.last().filter(|before| before.0 >= row.0) {
            let message = format!("`{path}`: the {from} must rise, but {} follows {before}", row.0);
            return Err(sources.error(&node.span(), &path, message));
        }
        rows.push(row);
    }
    if rows.len() < spec.fewest {
        let message = format!(
            "`{path}` needs at least {} rows [{from}, {to}], but has {}",
            spec.fewest,
            rows.len()
        );
        return Err(sources.error(&node.span(), path, message));
    }
    Ok(rows)
}

fn outline(
    sources: &Sources<'_>,
    quantity: &Quantity,
    path: &str,
    node: &Node<'_>,
) -> Read<Vec<Vec2>> {
    let DeValue::Array(nodes) = node.get_ref() else {
        return Err(wrong_type(sources, "a list of [forward, starboard] points", path, node));
    };
    let point = |(index, node): (usize, &Node<'_>)| {
        // A path is only built for an error: outlines may be long.
        let at = |path: &str| vector(sources, quantity, path, node, ["forward", "starboard"]);
        at(path).or_else(|_| at(&key_path::item(path, index)))
    };
    nodes.iter().enumerate().map(point).collect()
}

fn two_names(sources: &Sources<'_>, path: &str, node: &Node<'_>) -> Read<[String; 2]> {
    let DeValue::Array(nodes) = node.get_ref() else {
        return Err(wrong_type(sources, "the names of two bodies, [\"a\", \"b\"]", path, node));
    };
    let [one, other] = nodes.as_ref() else {
        let message = format!("`{path}` names two bodies, but has {}", nodes.len());
        return Err(sources.error(&node.span(), path, message));
    };
    let name = |index, node| text(sources, &key_path::item(path, index), node);
    Ok([name(0, one)?, name(1, other)?])
}

fn number(sources: &Sources<'_>, quantity: &Quantity, path: &str, node: &Node<'_>) -> Read<f64> {
    let measure = quantity.measure;
    let complain = |message| sources.error(&node.span(), path, message);
    let value = match node.get_ref() {
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
        DeValue::Integer(integer) => {
            u64::from_str_radix(integer.as_str(), integer.radix()).ok().map(|value| value as f64)
        }
        DeValue::Float(float) => float.as_str().parse().ok(),
        DeValue::String(text) => Some(with_unit(sources, quantity, path, text, &node.span())?),
        _ => return Err(wrong_type(sources, &measure.to_string(), path, node)),
    };
    let Some(value) = value.filter(|value: &f64| value.is_finite()) else {
        return Err(complain(format!("`{path}` is not a finite number")));
    };
    // Written so that NaN, were it ever to come here, fails.
    if value >= quantity.low && value <= quantity.high {
        return Ok(value);
    }
    let bound = if value > quantity.high {
        format!("must be at most {}", si(quantity.high, measure.unit))
    } else {
        format!("must be at least {}", si(quantity.low, measure.unit))
    };
    Err(complain(format!("`{path}` {bound}, but is {}", si(value, measure.unit))))
}

fn with_unit(
    sources: &Sources<'_>,
    quantity: &Quantity,
    path: &str,
    text: &str,
    span: &Span,
) -> Read<f64> {
    let measure = quantity.measure;
    let parsed = units::parse(text).map_err(|error| {
        let message = format!("`{path}` = {}: {}", quoted(text), error.message);
        let help = error.help.unwrap_or_else(|| measure.help());
        sources.error(span, path, message).with_help(help)
    })?;
    if parsed.dimension == measure.dimension {
        return Ok(parsed.si);
    }
    let found = if parsed.has_unit {
        parsed.dimension.to_string()
    } else {
        "a number without a unit".to_owned()
    };
    let message = format!("`{path}` must be {measure}, but {} is {found}", quoted(text));
    Err(sources.error(span, path, message).with_help(measure.help()))
}

/// A number and its unit, short: `1e15 N/m²`.
fn si(value: f64, unit: &str) -> String {
    let plain = value == 0.0 || (1e-3..1e7).contains(&value.abs());
    let number = if plain { format!("{value}") } else { format!("{value:e}") };
    if unit.is_empty() { number } else { format!("{number} {unit}") }
}

fn wrong_type(sources: &Sources<'_>, wanted: &str, path: &str, node: &Node<'_>) -> ScenarioError {
    let found = match node.get_ref() {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date or a time of day",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    };
    sources.error(&node.span(), path, format!("`{path}` must be {wanted}, but is {found}"))
}

/// The error for a key that a table does not have.
pub(crate) fn unknown_key(
    sources: &Sources<'_>,
    spec: &TableSpec,
    path: &str,
    name: &str,
    span: &Span,
) -> ScenarioError {
    let path = key_path::join(path, name);
    let names = || spec.keys.iter().map(|key| key.name);
    let error = sources.error(span, &path, format!("`{path}` is not a key of {}", spec.what));
    error.with_help(match (nearest(name, names()), table_with(spec, name)) {
        (Some(name), _) => format!("did you mean `{name}`?"),
        (None, Some(table)) => format!("`{name}` belongs under {table}"),
        (None, None) => {
            format!("{} has the keys {}", spec.what, names().collect::<Vec<_>>().join(", "))
        }
    })
}

/// The header of a table right below this one that has a key of this name.
fn table_with(spec: &TableSpec, name: &str) -> Option<String> {
    spec.keys.iter().find_map(|key| {
        let (inner, header) = match key.kind {
            Kind::Table(inner) => (inner, format!("[{}]", key.name)),
            Kind::Named(inner) => (inner, format!("[{}.NAME]", key.name)),
            Kind::List(inner) => (inner, format!("[[{}]]", key.name)),
            _ => return None,
        };
        inner.key(name).map(|_| header)
    })
}

fn missing_key(
    sources: &Sources<'_>,
    spec: &TableSpec,
    key: &KeySpec,
    path: &str,
    span: &Span,
) -> ScenarioError {
    let full = key_path::join(path, key.name);
    if path.is_empty() {
        let message = format!("{} needs `{full}`, which is missing", spec.what);
        return sources.error(span, &full, message).with_help(match key.kind {
            Kind::Named(_) => format!("write [{}.NAME] with its keys below", key.name),
            _ => format!("write [{}] with its keys below", key.name),
        });
    }
    let error = sources.error(span, &full, format!("`{full}` is missing"));
    match key.examples.first() {
        Some(example) => error.with_help(format!("write {} = {example}", key.name)),
        None => error,
    }
}

/// A copy of a value that stands, with all in it, at one span of the sources.
pub(crate) fn respan<'i>(node: &Node<'i>, span: &Span) -> Node<'i> {
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
