//! Writes a scenario anew: the keys of its file, some of them changed, become a new file that people can read. Comments
//! of the file are lost, and values stay as they were written.

mod write;

use toml::Spanned;
use toml::de::{DeArray, DeString, DeTable, DeValue};

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

/// Writes a scenario file with overrides and then edits of its keys, in their order.
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
    let mut document = syntax::parse(&sources)?;
    overrides::apply(&sources, &mut document)?;
    // A new key comes behind all others of its table, by its place in the order of keys.
    let mut behind = sources.override_span(overrides.len()).start;
    for Edit { path, value } in edits {
        behind += 1;
        let value = value.as_deref().map(|value| match DeValue::parse(value) {
            Ok(value) => value,
            Err(error) => panic!("`{value}` is not TOML: {error}"),
        });
        in_table(&mut document, path, value, behind);
    }
    Ok(write::document(&document))
}

fn in_table<'a>(
    table: &mut DeTable<'a>,
    path: &'a [String],
    value: Option<Spanned<DeValue<'a>>>,
    behind: usize,
) {
    let Some((name, deeper)) = path.split_first() else { return };
    if deeper.is_empty() {
        match (value, table.get_mut(name.as_str())) {
            (Some(value), Some(old)) => *old.get_mut() = value.into_inner(),
            (Some(value), None) => {
                let key = Spanned::new(behind..behind, DeString::Borrowed(name));
                table.insert(key, value);
            }
            (None, _) => {
                table.remove(name.as_str());
            }
        }
        return;
    }
    if !table.contains_key(name.as_str()) {
        if value.is_none() {
            return;
        }
        let key = Spanned::new(behind..behind, DeString::Borrowed(name));
        table.insert(key, Spanned::new(behind..behind, DeValue::Table(DeTable::new())));
    }
    match table.get_mut(name.as_str()).map(Spanned::get_mut) {
        Some(DeValue::Table(inner)) => in_table(inner, deeper, value, behind),
        Some(DeValue::Array(items)) => in_list(items, deeper, value, behind),
        _ => {}
    }
}

fn in_list<'a>(
    items: &mut DeArray<'a>,
    path: &'a [String],
    value: Option<Spanned<DeValue<'a>>>,
    behind: usize,
) {
    let Some((number, deeper)) = path.split_first() else { return };
    let Some(index) = number.parse::<usize>().ok().filter(|&index| index < items.len()) else {
        return;
    };
    let Some(item) = items.get_mut(index) else { return };
    match (value, item.get_mut()) {
        (None, _) if deeper.is_empty() => {
            let all = std::mem::replace(items, DeArray::new());
            for (_, item) in all.into_iter().enumerate().filter(|(number, _)| *number != index) {
                items.push(item);
            }
        }
        (Some(value), item) if deeper.is_empty() => *item = value.into_inner(),
        (value, DeValue::Table(inner)) => in_table(inner, deeper, value, behind),
        _ => {}
    }
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
