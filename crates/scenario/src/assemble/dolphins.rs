//! Dolphins of rows of fenders: bodies that are fixed or on piles, and pairs with them.

use super::rows::keys::check_placing;
use fenderline_keys::checked::{Item, Table, Value};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::keys::BODY;
use fenderline_keys::reader;
use fenderline_keys::row_names::name_in_row;
use fenderline_keys::sources::{Sources, quoted};

/// Adds a body for each dolphin to the bodies of the file. A pair that names a row becomes a pair with each dolphin of
/// the row.
pub(crate) fn add_dolphins(sources: &Sources<'_>, file: &mut Table) -> Result<(), ScenarioError> {
    let mut rows: Vec<(String, Vec<String>)> = Vec::new();
    let mut dolphins = Vec::new();
    for (name, row) in file.given("fender_row").named() {
        check_placing(sources, row)?;
        let Some(places) = row.item("dolphins") else { continue };
        let mut names = Vec::new();
        for (index, place) in places.outline().iter().enumerate() {
            let place = Value::Vector(*place);
            names.push(name_in_row(name, index + 1));
            dolphins.push((name_in_row(name, index + 1), dolphin(sources, row, places, place)?));
        }
        rows.push((name.clone(), names));
    }
    if rows.is_empty() {
        return Ok(());
    }
    let bodies = named_mut(file, "body");
    for (name, dolphin) in dolphins {
        if bodies.iter().any(|(other, _)| *other == name) {
            let key = dolphin.path_of("dolphins");
            let message = format!("`{key}`: there is a body named {} already", quoted(&name));
            return Err(sources.error(&dolphin.span, &key, message));
        }
        bodies.push((name, dolphin));
    }
    bodies.sort_by_key(|(_, table)| table.span.start);
    let is_body: Vec<String> = bodies.iter().map(|(name, _)| name.clone()).collect();
    let dolphins_of = |name: &String| {
        let row = rows.iter().find(|(row, _)| row == name && !is_body.contains(name));
        row.map_or_else(|| vec![name.clone()], |(_, names)| names.clone())
    };
    let Value::List(pairs) = value_mut(file, "pair") else { unreachable!("pairs are a list") };
    let each = |pair: &Table| {
        let [one, other] = pair.given("bodies").two_names();
        let mut pairs = Vec::new();
        for one in dolphins_of(one) {
            for other in dolphins_of(other) {
                let mut pair = pair.clone();
                *value_mut(&mut pair, "bodies") = Value::TwoNames([one.clone(), other]);
                pairs.push(pair);
            }
        }
        pairs
    };
    *pairs = pairs.iter().flat_map(each).collect();
    Ok(())
}

/// The table of a dolphin's body. The table keeps the path of the row, so errors name the row's keys.
fn dolphin(
    sources: &Sources<'_>,
    row: &Table,
    places: &Item,
    place: Value,
) -> Result<Table, ScenarioError> {
    let mut items = vec![Item { name: "position", value: place, ..places.clone() }];
    if row.item("dolphin").is_none() {
        items.push(Item { name: "fixed", value: Value::Flag(true), ..places.clone() });
    }
    items.extend(
        ["outline", "heading", "dolphin"].iter().filter_map(|name| row.item(name)).cloned(),
    );
    reader::with_defaults(sources, &BODY, &row.path, &row.span, items)
}

fn named_mut<'t>(table: &'t mut Table, name: &str) -> &'t mut Vec<(String, Table)> {
    match value_mut(table, name) {
        Value::Named(tables) => tables,
        other => unreachable!("{name} holds {other:?}"),
    }
}

fn value_mut<'t>(table: &'t mut Table, name: &str) -> &'t mut Value {
    let item = table.items.iter_mut().find(|item| item.name == name);
    &mut item.unwrap_or_else(|| unreachable!("there is no {name}")).value
}
