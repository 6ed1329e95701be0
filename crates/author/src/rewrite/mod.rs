//! Writes a scenario anew: the text of a file with some of its keys changed. Comments, order and spelling of the file stay.

mod inline;

use toml::de::{DeTable, DeValue};
use toml_edit::{ArrayOfTables, DocumentMut, Item, Table, Value};

use fenderline_keys::error::ScenarioError;
use fenderline_keys::overrides::{self, Override};
use fenderline_keys::sources::Sources;
use fenderline_keys::syntax;

/// A change of a key. A path names an item of a list by the item's number, counted from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    path: Vec<String>,
    /// The new value of the key as TOML; if `None`, the key is removed.
    value: Option<String>,
}

impl Edit {
    /// Sets a key to a value in TOML.
    #[must_use]
    pub fn set(path: &[&str], value: impl Into<String>) -> Edit {
        Edit { path: names(path), value: Some(value.into()) }
    }

    /// Removes a key of the file if the key exists.
    #[must_use]
    pub fn remove(path: &[&str]) -> Edit {
        Edit { path: names(path), value: None }
    }
}

fn names(path: &[&str]) -> Vec<String> {
    path.iter().map(|&name| name.to_owned()).collect()
}

/// Writes a scenario with overrides and then edits, in their order. The first comment, which describes the scenario, is
/// left out: the caller writes another comment.
///
/// # Errors
/// Fails for a text that is not TOML, and for an override of a key that does not exist.
///
/// # Panics
/// Panics if the value of an edit is not TOML.
pub fn rewritten(
    text: &str,
    file_name: &str,
    overrides: &[Override],
    edits: &[Edit],
) -> Result<String, ScenarioError> {
    let sources = Sources::new(file_name, text, overrides);
    let mut checked = syntax::parse(&sources)?;
    overrides::apply(&sources, &mut checked)?;
    let mut document: DocumentMut = match without_first_comment(text).parse() {
        Ok(document) => document,
        Err(error) => panic!("one reader of TOML reads {file_name}, the other does not: {error}"),
    };
    for set in overrides {
        let value = value_at(&checked, set.path()).map(inline::inline);
        change(document.as_item_mut(), set.path(), value.as_deref().map(value_of), 0);
    }
    for Edit { path, value } in edits {
        change(document.as_item_mut(), path, value.as_deref().map(value_of), 0);
    }
    Ok(document.to_string())
}

/// The text behind the comment with which it begins.
fn without_first_comment(text: &str) -> &str {
    let mut rest = text.trim_start();
    while rest.starts_with('#') {
        rest = rest.split_once('\n').map_or("", |(_, rest)| rest);
    }
    rest.trim_start()
}

/// Finds the value at `path`, a list of nested keys, in a table of TOML.
fn value_at<'t, 'a>(table: &'t DeTable<'a>, path: &[String]) -> Option<&'t DeValue<'a>> {
    let (first, deeper) = path.split_first()?;
    let mut value = table.get(first.as_str())?.get_ref();
    for name in deeper {
        value = match value {
            DeValue::Table(inner) => inner.get(name.as_str())?.get_ref(),
            DeValue::Array(items) => items.get(name.parse::<usize>().ok()?)?.get_ref(),
            _ => return None,
        };
    }
    Some(value)
}

/// A value from its TOML.
fn value_of(text: &str) -> Value {
    match text.parse() {
        Ok(value) => value,
        Err(error) => panic!("`{text}` is not TOML: {error}"),
    }
}

/// Sets the value at a path below an item, or removes the key. Tables on the way that do not exist are made, unless the key
/// is removed. `depth` is the number of keys that lead from the top of the file to the item.
fn change(item: &mut Item, path: &[String], value: Option<Value>, depth: usize) {
    let Some((name, deeper)) = path.split_first() else { return };
    if let Ok(index) = name.parse::<usize>()
        && !item.is_table_like()
    {
        return in_list(item, index, deeper, value, depth);
    }
    let has_header = item.is_table();
    let Some(table) = item.as_table_like_mut() else { return };
    if deeper.is_empty() {
        match (value, table.get_mut(name)) {
            (None, _) => {
                table.remove(name);
            }
            (Some(value), Some(old)) => *old = in_place_of(old, value, has_header && depth == 0),
            (Some(value), None) => {
                let new = if has_header && depth == 0 { top_level(value) } else { plain(value) };
                table.insert(name, new);
            }
        }
        return;
    }
    if !table.contains_key(name) {
        if value.is_none() {
            return;
        }
        let new = match has_header {
            true => {
                let mut new = Table::new();
                // The table of all bodies has no header, the table of one body has.
                new.set_implicit(deeper.len() > 1);
                Item::Table(new)
            }
            false => Item::Value(Value::InlineTable(toml_edit::InlineTable::new())),
        };
        table.insert(name, new);
    }
    if let Some(inner) = table.get_mut(name) {
        change(inner, deeper, value, depth + 1);
    }
}

/// Does the same as [`change`] in a list of TOML: sets or removes the value at the path `deeper` below the list's entry
/// number `index`.
fn in_list(item: &mut Item, index: usize, deeper: &[String], value: Option<Value>, depth: usize) {
    if let Some(tables) = item.as_array_of_tables_mut() {
        if index >= tables.len() {
            return;
        }
        match (deeper.is_empty(), value) {
            (true, None) => {
                tables.remove(index);
            }
            (true, Some(value)) => {
                if let (Some(old), Value::InlineTable(new)) = (tables.get_mut(index), value) {
                    *old = new.into_table();
                }
            }
            (false, value) => {
                let Some(old) = tables.get_mut(index) else { return };
                let mut inner = Item::Table(std::mem::take(old));
                change(&mut inner, deeper, value, depth + 1);
                if let Item::Table(changed) = inner {
                    *old = changed;
                }
            }
        }
    } else if let Some(items) = item.as_array_mut() {
        if index >= items.len() {
            return;
        }
        match (deeper.is_empty(), value) {
            (true, None) => {
                items.remove(index);
            }
            (true, Some(value)) => {
                items.replace(index, value);
            }
            (false, value) => {
                let Some(old) = items.get_mut(index) else { return };
                let mut inner = Item::Value(old.clone());
                change(&mut inner, deeper, value, depth + 1);
                if let Item::Value(changed) = inner {
                    *old = changed;
                }
            }
        }
    }
}

/// A new value for a key. The comment behind an old value of one line stays.
fn in_place_of(old: &Item, value: Value, is_top_level: bool) -> Item {
    let new = if is_top_level { top_level(value) } else { plain(value) };
    match (old, new) {
        (Item::Value(old), Item::Value(mut new)) => {
            *new.decor_mut() = old.decor().clone();
            Item::Value(new)
        }
        (_, new) => new,
    }
}

fn plain(value: Value) -> Item {
    Item::Value(value.decorated(" ", ""))
}

/// A value at the top level: a table, or a list of tables, is written under headers.
fn top_level(value: Value) -> Item {
    match value {
        Value::InlineTable(table) => Item::Table(spaced(table.into_table())),
        Value::Array(items) if !items.is_empty() && items.iter().all(Value::is_inline_table) => {
            let mut tables = ArrayOfTables::new();
            for item in items {
                if let Value::InlineTable(table) = item {
                    tables.push(spaced(table.into_table()));
                }
            }
            Item::ArrayOfTables(tables)
        }
        value => plain(value),
    }
}

/// A new table behind an empty line, with its keys in the usual form.
fn spaced(mut table: Table) -> Table {
    table.fmt();
    table.decor_mut().set_prefix("\n");
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"
# A comment.
title = "Two \"quoted\""

[time]
step = "0.1 s"
duration = 20

[material.rubber]
stiffness = 5e5

[body.tug]
outline = [[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]
mass = "930 t"
gyradius = "8 m"
velocity = { surge = "4 kn" }

[body."big quay"]
fixed = true
outline = [[0, -50], [5, -50], [5, 50], [0, 50]]
position = [20, 0]

[[pair]]
bodies = ["tug", "big quay"]
material = "rubber"

[[load]]
body = "tug"
force = [1, 2]

[[load]]
body = "tug"
moment = 3
"#;

    #[test]
    fn a_scenario_without_edits_is_the_same_scenario_and_writing_it_again_changes_nothing() {
        let once = rewritten(TEXT, "a.toml", &[], &[]).unwrap();
        let twice = rewritten(&once, "a.toml", &[], &[]).unwrap();
        assert_eq!(once, twice);
        let [one, other] = [TEXT, once.as_str()]
            .map(|text| fenderline_scenario::Scenario::parse(text, "a.toml").unwrap());
        assert_eq!(one, other);
    }

    #[test]
    fn comments_order_and_spelling_of_a_file_stay() {
        let text = "# What it is.\n\ntitle = \"A\" # a title\n\n# The time.\n[time]\nstep = \"0.1 s\" # a step\nduration = 20.0\n\n\
                    # Not wanted.\n[[load]]\nbody = \"tug\"\n\n[[load]]\n# a moment\nmoment = 3e0\n";
        let edits = [
            Edit::set(&["time", "step"], "\"0.2 s\""),
            Edit::remove(&["load", "0"]),
            Edit::set(&["order"], "[{ at = 1 }, { at = 2, to = [1, 2] }]"),
            Edit::set(&["body", "tug", "mass"], "\"9 t\""),
        ];
        assert_eq!(
            rewritten(text, "a.toml", &[], &edits).unwrap(),
            "title = \"A\" # a title\n\n# The time.\n[time]\nstep = \"0.2 s\" # a step\nduration = 20.0\n\n\
             [[load]]\n# a moment\nmoment = 3e0\n\n[[order]]\nat = 1\n\n[[order]]\nat = 2\nto = [1, 2]\n\n\
             [body.tug]\nmass = \"9 t\"\n"
        );
    }

    #[test]
    fn keys_are_set_added_and_removed_in_tables_and_lists() {
        let edits = [
            Edit::set(&["body", "tug", "position"], "[1.5, -2]"),
            Edit::remove(&["body", "tug", "velocity", "surge"]),
            Edit::set(&["body", "tug", "velocity", "sway"], "0.25"),
            Edit::remove(&["load", "0"]),
            Edit::set(&["load", "0", "moment"], "4"),
            Edit::set(&["environment", "wind"], "{ speed = 5, from = 0 }"),
            Edit::remove(&["nothing", "here"]),
        ];
        let set = [Override::parse("time.duration=30").unwrap()];
        let text = rewritten(TEXT, "a.toml", &set, &edits).unwrap();
        let setup = fenderline_scenario::Scenario::parse(&text, "a.toml").unwrap().setup;
        assert_eq!(setup.bodies[0].position_m, fenderline_contact::vec2(1.5, -2.0));
        assert_eq!(setup.bodies[0].velocity.surge_mps, 0.0);
        assert_eq!(setup.bodies[0].velocity.sway_mps, 0.25);
        assert_eq!(setup.loads.len(), 1);
        assert_eq!(setup.loads[0].moment_nm, 4.0);
        assert_eq!(setup.duration_s, 30.0);
        assert!(setup.world.environment.wind.is_some());
    }
}
