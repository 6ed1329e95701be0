//! Errors about keys and types, with the key that the user may have meant.

use toml::Spanned;
use toml::de::DeValue;

use crate::error::ScenarioError;
use crate::key_path;
use crate::sources::{Sources, Span};
use crate::spec::{KeySpec, Kind, TableSpec};
use crate::suggest::nearest;

type Node<'i> = Spanned<DeValue<'i>>;

pub(super) fn wrong_type(
    sources: &Sources<'_>,
    wanted: &str,
    path: &str,
    node: &Node<'_>,
) -> ScenarioError {
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

/// The error for a key in the file that this kind of table does not have.
pub fn unknown_key(
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

/// The header of a table directly within this table that has a key of the name `name`.
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

pub(super) fn missing_key(
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
