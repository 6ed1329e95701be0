//! Makes the dolphins of a row of fenders: bodies that are fixed or stand on piles, and pairs with these bodies.

use super::rows::keys::check_placing;
use fenderline_keys::checked::{Entry, Item, Of, Table, Value};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::NamedOf;
use fenderline_keys::keys::body::BodyKey;
use fenderline_keys::keys::fender_row::FenderRowKey;
use fenderline_keys::keys::material::PairKey;
use fenderline_keys::keys::{BODY, ScenarioKey};
use fenderline_keys::row_names::name_in_row;
use fenderline_keys::sources::{Sources, quoted};
use fenderline_keys::typed_key::Key;
use fenderline_keys::{any_keys, key_path, reader};

/// Adds a body for each dolphin of a row of fenders to the bodies of the file. A pair of bodies that names a row
/// becomes a pair with each dolphin of the row.
pub(crate) fn add_dolphins(sources: &Sources<'_>, file: &mut Table) -> Result<(), ScenarioError> {
    let mut rows: Vec<(String, Vec<String>)> = Vec::new();
    let mut dolphins = Vec::new();
    for (name, row) in file.of::<ScenarioKey>().given(ScenarioKey::FENDER_ROW).named() {
        check_placing(sources, row)?;
        let Some(places) = row.item(FenderRowKey::DOLPHINS) else { continue };
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
    let bodies = named_mut(file, ScenarioKey::BODY);
    for (name, dolphin) in dolphins {
        if bodies.iter().any(|(other, _)| *other == name) {
            let key = key_path::join(&dolphin.path, FenderRowKey::DOLPHINS.name());
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
    let Value::List(pairs) = value_mut(file, ScenarioKey::PAIR) else {
        unreachable!("pairs are a list")
    };
    let each = |pair: &Table| {
        let [one, other] = pair.of::<PairKey>().given(PairKey::BODIES).two_names();
        let mut pairs = Vec::new();
        for one in dolphins_of(one) {
            for other in dolphins_of(other) {
                let mut pair = pair.clone();
                *value_mut(&mut pair, PairKey::BODIES) = Value::TwoNames([one.clone(), other]);
                pairs.push(pair);
            }
        }
        pairs
    };
    *pairs = pairs.iter().flat_map(each).collect();
    Ok(())
}

/// Makes the table of a dolphin's body. The table keeps the path of the row, so that errors name the keys of the row.
fn dolphin<V>(
    sources: &Sources<'_>,
    row: Of<'_, FenderRowKey>,
    places: Entry<'_, V>,
    place: Value,
) -> Result<Table, ScenarioError> {
    let mut items =
        vec![Item { name: BodyKey::POSITION.name(), value: place, ..places.item().clone() }];
    if row.item(FenderRowKey::DOLPHIN).is_none() {
        items.push(Item {
            name: BodyKey::FIXED.name(),
            value: Value::Flag(true),
            ..places.item().clone()
        });
    }
    items.extend(
        any_keys![FenderRowKey: OUTLINE, HEADING, DOLPHIN]
            .iter()
            .filter_map(|key| row.item(*key))
            .map(|item| item.item().clone()),
    );
    reader::with_defaults(sources, &BODY, &row.path, &row.span, items)
}

fn named_mut<T, R>(table: &mut Table, key: Key<T, NamedOf<R>>) -> &mut Vec<(String, Table)> {
    match value_mut(table, key) {
        Value::Named(tables) => tables,
        other => unreachable!("{key} holds {other:?}"),
    }
}

fn value_mut<T, V>(table: &mut Table, key: Key<T, V>) -> &mut Value {
    let item = table.items.iter_mut().find(|item| item.is(key));
    &mut item.unwrap_or_else(|| unreachable!("there is no {key}")).value
}
