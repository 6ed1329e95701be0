//! Reads the values of single keys: texts, words, numbers with units, points and curves.

use fenderline_contact::{Vec2, vec2};
use toml::Spanned;
use toml::de::DeValue;

use super::errors::wrong_type;
use super::meant::meant;
use crate::checked::Value;
use crate::choices::{AnyChoices, Word};
use crate::error::ScenarioError;
use crate::key_path;
use crate::sources::{Sources, Span, quoted};
use crate::spec::{CurveSpec, Quantity};
use crate::suggest::nearest;
use crate::units::{self, Measure, UnitError};

type Read<T> = Result<T, ScenarioError>;
type Node<'i> = Spanned<DeValue<'i>>;

/// Longest name or title, in bytes.
const LONGEST_TEXT: usize = 200;

pub(super) fn text(sources: &Sources<'_>, path: &str, node: &Node<'_>) -> Read<String> {
    match node.get_ref() {
        DeValue::String(text) => {
            check_text(sources, path, text, &node.span())?;
            Ok(text.to_string())
        }
        _ => Err(wrong_type(sources, "a text in quotes", path, node)),
    }
}

/// Reads a number with its unit, or a name. A text that begins like a number is read as a number.
pub(super) fn name_or(
    sources: &Sources<'_>,
    quantity: &Quantity,
    path: &str,
    node: &Node<'_>,
) -> Read<Value> {
    let is_name = match node.get_ref() {
        DeValue::String(text) => !text
            .trim_start()
            .starts_with(|c: char| c.is_ascii_digit() || "+-.\u{2212}".contains(c)),
        _ => false,
    };
    match is_name {
        true => text(sources, path, node).map(Value::Text),
        false => number(sources, quantity, path, node).map(Value::Number),
    }
}

pub(super) fn texts(sources: &Sources<'_>, path: &str, node: &Node<'_>) -> Read<Vec<String>> {
    let DeValue::Array(nodes) = node.get_ref() else {
        return Err(wrong_type(sources, "a list of texts in quotes", path, node));
    };
    let one = |(index, node)| text(sources, &key_path::item(path, index), node);
    nodes.iter().enumerate().map(one).collect()
}

/// Reads a list of numbers, texts and flags; each item becomes the text that would stand behind `--set KEY=`.
pub(super) fn any_values(sources: &Sources<'_>, path: &str, node: &Node<'_>) -> Read<Vec<String>> {
    let wanted = "a list of numbers or of texts in quotes";
    let DeValue::Array(nodes) = node.get_ref() else {
        return Err(wrong_type(sources, wanted, path, node));
    };
    let one = |(index, node): (usize, &Node<'_>)| match node.get_ref() {
        DeValue::Integer(integer) if integer.radix() == 10 => Ok(integer.as_str().to_owned()),
        DeValue::Float(float) => Ok(float.as_str().to_owned()),
        DeValue::Boolean(flag) => Ok(flag.to_string()),
        _ => text(sources, &key_path::item(path, index), node),
    };
    nodes.iter().enumerate().map(one).collect()
}

/// Reads a number with or without a unit, as the text that would stand behind `--set KEY=`.
pub(super) fn any_number(sources: &Sources<'_>, path: &str, node: &Node<'_>) -> Read<String> {
    match node.get_ref() {
        DeValue::Integer(integer) if integer.radix() == 10 => Ok(integer.as_str().to_owned()),
        DeValue::Float(float) => Ok(float.as_str().to_owned()),
        DeValue::String(_) => text(sources, path, node),
        _ => Err(wrong_type(sources, "a number or a text with a number and its unit", path, node)),
    }
}

/// Checks that a name or title is short and in one line.
pub(super) fn check_text(sources: &Sources<'_>, path: &str, text: &str, span: &Span) -> Read<()> {
    let complaint = if text.trim().is_empty() {
        format!("`{path}` is empty")
    } else if text.len() > LONGEST_TEXT {
        format!("`{path}` is longer than {LONGEST_TEXT} bytes")
    } else if text.contains(char::is_control) {
        format!("`{path}` has a line break or another control character in it")
    } else {
        return Ok(());
    };
    Err(sources.error(span, path, complaint))
}

pub(super) fn flag(sources: &Sources<'_>, path: &str, node: &Node<'_>) -> Read<bool> {
    match node.get_ref() {
        DeValue::Boolean(flag) => Ok(*flag),
        _ => Err(wrong_type(sources, "true or false", path, node)),
    }
}

pub(super) fn choice(
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

pub(super) fn vector(
    sources: &Sources<'_>,
    quantity: &Quantity,
    path: &str,
    node: &Node<'_>,
    axes: [&str; 2],
) -> Read<Vec2> {
    let columns = axes.map(|axis| (axis, quantity));
    two_numbers(sources, columns, path, node).map(|(x, y)| vec2(x, y))
}

/// Reads a list of two numbers, each with its name and quantity.
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

pub(super) fn curve(
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

pub(super) fn outline(
    sources: &Sources<'_>,
    quantity: &Quantity,
    path: &str,
    node: &Node<'_>,
) -> Read<Vec<Vec2>> {
    let DeValue::Array(nodes) = node.get_ref() else {
        return Err(wrong_type(sources, "a list of points [forward, starboard]", path, node));
    };
    let point = |(index, node): (usize, &Node<'_>)| {
        // The point's path is built only for an error: outlines may be long.
        let at = |path: &str| vector(sources, quantity, path, node, ["forward", "starboard"]);
        at(path).or_else(|_| at(&key_path::item(path, index)))
    };
    nodes.iter().enumerate().map(point).collect()
}

/// Reads a list of points as [`outline`] does, and checks that there are `fewest` to `most` points.
pub(super) fn points(
    sources: &Sources<'_>,
    quantity: &Quantity,
    [fewest, most]: [usize; 2],
    path: &str,
    node: &Node<'_>,
) -> Read<Vec<Vec2>> {
    let points = outline(sources, quantity, path, node)?;
    if (fewest..=most).contains(&points.len()) {
        return Ok(points);
    }
    let wanted = if fewest == most { fewest.to_string() } else { format!("{fewest} to {most}") };
    let message = format!("`{path}` must be {wanted} points, but has {}", points.len());
    Err(sources.error(&node.span(), path, message))
}

pub(super) fn two_names(sources: &Sources<'_>, path: &str, node: &Node<'_>) -> Read<[String; 2]> {
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

pub(super) fn number(
    sources: &Sources<'_>,
    quantity: &Quantity,
    path: &str,
    node: &Node<'_>,
) -> Read<f64> {
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
    // Written so that NaN would fail.
    if value >= quantity.low && value <= quantity.high {
        return Ok(value);
    }
    let (side, bound) =
        if value > quantity.high { ("most", quantity.high) } else { ("least", quantity.low) };
    let [bound, value_si] = [bound, value].map(|each| shown(each, measure));
    let error = complain(format!("`{path}` must be at {side} {bound}, but is {value_si}"));
    let is_plain = !matches!(node.get_ref(), DeValue::String(_));
    let of_text = || core::ptr::eq(measure, &units::measures::CELSIUS);
    Err(match meant(quantity, value).filter(|_| is_plain || of_text()) {
        Some(help) => error.with_help(help),
        None => error,
    })
}

fn with_unit(
    sources: &Sources<'_>,
    quantity: &Quantity,
    path: &str,
    text: &str,
    span: &Span,
) -> Read<f64> {
    let measure = quantity.measure;
    let refused = |error: UnitError| {
        let message = format!("`{path}` = {}: {}", quoted(text), error.message);
        let help = error.help.unwrap_or_else(|| measure.help());
        sources.error(span, path, message).with_help(help)
    };
    if core::ptr::eq(measure, &units::measures::CELSIUS) {
        return units::celsius(text).map_err(refused);
    }
    let parsed = units::parse(text).map_err(refused)?;
    if parsed.dimension == measure.dimension {
        return Ok(parsed.si);
    }
    let found = if parsed.has_unit {
        parsed.dimension.to_string()
    } else {
        "a number without a unit".to_owned()
    };
    let message = format!("`{path}` must be {measure}, but {} is {found}", quoted(text));
    let error = sources.error(span, path, message);
    Err(match parsed.dimension.of_weight() == Some(measure.dimension) {
        true => error.with_help(
            "a tonne is a mass: write tf, kgf, lbf or LTf for its weight, as in \"60 tf\" or \"20 \
             tf.m\"",
        ),
        false => error.with_help(measure.help()),
    })
}

/// A quantity in SI units as messages show it; an angle is shown in degrees, too.
fn shown(value: f64, measure: &Measure) -> String {
    let si = si(value, measure.unit);
    match core::ptr::eq(measure, &units::measures::ANGLE) {
        true => format!("{si} ({} deg)", libm::round(value.to_degrees() * 10.0) / 10.0),
        false => si,
    }
}

/// A number and its unit as a short text, such as `1e15 N/m²`.
pub(super) fn si(value: f64, unit: &str) -> String {
    let plain = value == 0.0 || (1e-3..1e7).contains(&value.abs());
    let number = if plain { format!("{value}") } else { format!("{value:e}") };
    if unit.is_empty() { number } else { format!("{number} {unit}") }
}
