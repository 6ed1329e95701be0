//! Finds the keys for which the path of an override stands. The path `fender.*.tolerance` stands for all fenders and
//! rows; the path `fender.a_3.tolerance` stands for an exception of the row `a`.

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::pattern::{fits, is_pattern};
use crate::keys::fender_row::MOST_IN_ROW;
use crate::row_names::number_in_row;
use crate::sources::Span;

/// The paths for which the path of an override stands: the path itself, the paths that fit its pattern, or the paths of
/// rows. The list is empty if nothing fits the pattern.
pub(super) fn paths(document: &mut DeTable<'_>, path: &[String], span: &Span) -> Vec<Vec<String>> {
    match path {
        [table, name, deeper @ ..] if table == "fender" && !has(document, "fender", name) => {
            of_fenders(document, name, deeper, span).unwrap_or_else(|| vec![path.to_vec()])
        }
        _ => expanded(document, path),
    }
}

/// The paths for a key of the fender `name`, which has no table of its own but stands in a row; `None` if no row has a
/// fender of this name.
fn of_fenders(
    document: &mut DeTable<'_>,
    name: &str,
    deeper: &[String],
    span: &Span,
) -> Option<Vec<Vec<String>>> {
    let mut found = Vec::new();
    if is_pattern(name) {
        let own = names(document, "fender").into_iter().filter(|own| fits(name, own));
        found.extend(own.map(|own| joined(&["fender", &own], deeper)));
    }
    for row in names(document, "fender_row") {
        let every = format!("{row}_*");
        if name == "*" || *name == every {
            found.push(joined(&["fender_row", &row], deeper));
            let exceptions = exceptions_of(document, &row).map(|table| keys(table));
            for exception in exceptions.unwrap_or_default() {
                found.push(joined(&["fender_row", &row, "exception", &exception], deeper));
            }
        } else if stands_in(&row, name) {
            add_exception(document, &row, name, span);
            found.push(joined(&["fender_row", &row, "exception", name], deeper));
        }
    }
    (is_pattern(name) || !found.is_empty()).then_some(found)
}

/// Replaces each pattern in a path by the names of the tables that fit the pattern.
fn expanded(document: &DeTable<'_>, path: &[String]) -> Vec<Vec<String>> {
    let is_pattern_here =
        |(table, name): (&DeTable<'_>, &String)| is_pattern(name) && !table.contains_key(&**name);
    let mut table = document;
    for (at, name) in path.iter().enumerate() {
        if is_pattern_here((table, name)) {
            let fitting = keys(table).into_iter().filter(|key| fits(name, key));
            let one = |key: String| {
                let path = joined(&[], &[&path[..at], &[key], &path[at + 1..]].concat());
                expanded(document, &path)
            };
            return fitting.flat_map(one).collect();
        }
        match table.get(&**name).map(Spanned::get_ref) {
            Some(DeValue::Table(inner)) => table = inner,
            _ => break,
        }
    }
    vec![path.to_vec()]
}

/// Whether `name` is the name of a fender of the row `row`, or a pattern that a fender's name in this row fits.
fn stands_in(row: &str, name: &str) -> bool {
    match is_pattern(name) {
        false => number_in_row(row, name).is_some(),
        true => (1..=MOST_IN_ROW).any(|number| fits(name, &format!("{row}_{number}"))),
    }
}

fn joined(start: &[&str], deeper: &[String]) -> Vec<String> {
    start.iter().map(|name| (*name).to_owned()).chain(deeper.iter().cloned()).collect()
}

fn table<'t, 'a>(document: &'t mut DeTable<'a>, name: &str) -> Option<&'t mut DeTable<'a>> {
    match document.get_mut(name)?.get_mut() {
        DeValue::Table(table) => Some(table),
        _ => None,
    }
}

fn keys(table: &DeTable<'_>) -> Vec<String> {
    table.keys().map(|key| key.get_ref().to_string()).collect()
}

fn names(document: &mut DeTable<'_>, of: &str) -> Vec<String> {
    table(document, of).map(|table| keys(table)).unwrap_or_default()
}

fn has(document: &mut DeTable<'_>, of: &str, name: &str) -> bool {
    table(document, of).is_some_and(|table| table.contains_key(name))
}

fn exceptions_of<'t, 'a>(document: &'t mut DeTable<'a>, row: &str) -> Option<&'t mut DeTable<'a>> {
    table(table(table(document, "fender_row")?, row)?, "exception")
}

/// Adds an empty exception `name` to a row of fenders, unless the row already has an exception of this name.
fn add_exception(document: &mut DeTable<'_>, row: &str, name: &str, span: &Span) {
    let rows = table(document, "fender_row");
    let Some(row) = rows.and_then(|rows| table(rows, row)) else { return };
    let empty = || Spanned::new(span.clone(), DeValue::Table(DeTable::new()));
    let key = |name: &str| Spanned::new(span.clone(), DeString::Owned(name.to_owned()));
    row.entry(key("exception")).or_insert_with(empty);
    if let Some(exceptions) = table(row, "exception") {
        exceptions.entry(key(name)).or_insert_with(empty);
    }
}
