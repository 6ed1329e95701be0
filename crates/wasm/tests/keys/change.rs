//! Every way to set one key of a scenario to another value, by the schema: what the reader then accepts are the legal ones.

use serde_json::{Map, Value as Json, json};

/// One key and the values that are tried in its place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Change {
    /// The names of the dotted path; items of lists by their numbers.
    pub(crate) path: Vec<String>,
    /// Values to try, each other than the present one.
    pub(crate) values: Vec<Json>,
    /// Whether the scenario gives the key.
    pub(crate) is_given: bool,
}

impl Change {
    /// The path as errors and notices have it.
    #[must_use]
    pub(crate) fn key(&self) -> String {
        let plain = |name: &String| {
            let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
            if name.chars().all(is_bare) { name.clone() } else { format!("{name:?}") }
        };
        self.path.iter().map(plain).collect::<Vec<_>>().join(".")
    }

    /// The key without the names that the scenario gives: `fender.*.width`.
    #[must_use]
    pub(crate) fn kind(&self, schema: &Json) -> String {
        let (mut node, mut names) = (schema, Vec::new());
        for name in &self.path {
            (node, names) = match node["properties"].get(name) {
                Some(inner) => (inner, [names, vec![name.clone()]].concat()),
                None if node["items"].is_object() => (&node["items"], names),
                None => (&node["additionalProperties"], [names, vec!["*".to_owned()]].concat()),
            };
        }
        names.join(".")
    }

    /// The document with one of the values in place.
    #[must_use]
    pub(crate) fn applied(&self, document: &Json, value: &Json) -> Json {
        let mut changed = document.clone();
        let mut node = &mut changed;
        for name in &self.path {
            node = match name.parse::<usize>() {
                Ok(index) if node.is_array() => &mut node[index],
                _ => &mut node[name.as_str()],
            };
        }
        *node = value.clone();
        changed
    }
}

/// The changes of every key of every table that the document has, in the order of the schema.
#[must_use]
pub(crate) fn changes(schema: &Json, document: &Json) -> Vec<Change> {
    let mut names = Vec::new();
    collect_names(document, &mut names);
    let mut all = Vec::new();
    of_table(schema, document, &mut Vec::new(), &names, &mut all);
    all
}

/// Names and texts of the document, for keys that refer to something.
fn collect_names(node: &Json, names: &mut Vec<String>) {
    match node {
        Json::Object(map) => {
            for (key, inner) in map {
                if inner.is_object() {
                    names.push(key.clone());
                }
                collect_names(inner, names);
            }
        }
        Json::Array(items) => items.iter().for_each(|item| collect_names(item, names)),
        _ => {}
    }
    names.sort();
    names.dedup();
}

fn of_table(
    schema: &Json,
    table: &Json,
    path: &mut Vec<String>,
    names: &[String],
    all: &mut Vec<Change>,
) {
    let Some(properties) = schema["properties"].as_object() else { return };
    for (key, spec) in properties {
        path.push(key.clone());
        of_key(spec, table.get(key), path, names, all);
        path.pop();
    }
}

fn of_key(
    spec: &Json,
    present: Option<&Json>,
    path: &mut Vec<String>,
    names: &[String],
    all: &mut Vec<Change>,
) {
    let is_list = spec["items"]["properties"].is_object();
    match present {
        Some(table) if spec["properties"].is_object() => of_table(spec, table, path, names, all),
        Some(Json::Object(tables)) => {
            for (name, table) in tables {
                path.push(name.clone());
                of_table(&spec["additionalProperties"], table, path, names, all);
                path.pop();
            }
        }
        Some(Json::Array(tables)) if is_list => {
            for (index, table) in tables.iter().enumerate() {
                path.push(index.to_string());
                of_table(&spec["items"], table, path, names, all);
                path.pop();
            }
        }
        _ => {
            let values = values(spec, present, names);
            if !values.is_empty() {
                all.push(Change { path: path.clone(), values, is_given: present.is_some() });
            }
        }
    }
}

/// Values other than the present one, the likeliest to be accepted first.
fn values(spec: &Json, present: Option<&Json>, names: &[String]) -> Vec<Json> {
    let now = present.or_else(|| spec.get("default"));
    let examples = spec["examples"].as_array().cloned().unwrap_or_default();
    let mut values: Vec<Json> = Vec::new();
    if let Some(words) = spec["enum"].as_array() {
        values.extend(words.iter().cloned());
    } else if spec["type"] == "boolean" {
        values.extend([json!(true), json!(false)]);
    } else if let Some(now) = now {
        for factor in [1.25, 0.8, 1.01] {
            values.extend(scaled(now, factor));
        }
        values.extend(stepped(now));
        values.extend(examples);
    } else if examples.is_empty() {
        values.extend(of_needed(spec));
    } else {
        for example in examples {
            values.extend(scaled(&example, 1.25));
            values.push(example);
        }
    }
    if spec["type"] == "string" && spec["enum"].is_null() {
        values.extend(names.iter().map(|name| json!(name)));
        values.extend(now.and_then(Json::as_str).map(|text| json!(format!("{text} 2"))));
    }
    let mut known = Vec::new();
    for value in values {
        if Some(&value) != now && !known.contains(&value) {
            known.push(value);
        }
    }
    known
}

/// A table of the examples of what it needs; `None` if something needed has no example.
fn of_needed(spec: &Json) -> Option<Json> {
    let properties = spec["properties"].as_object()?;
    let needed = spec["required"].as_array()?;
    let mut table = Map::new();
    for key in needed.iter().filter_map(Json::as_str) {
        let inner = &properties[key];
        let value = inner["examples"].get(0).cloned().or_else(|| of_needed(inner));
        table.insert(key.to_owned(), value?);
    }
    Some(Json::Object(table))
}

/// All numbers of a value times a factor; `None` if that changes nothing.
fn scaled(value: &Json, factor: f64) -> Option<Json> {
    let changed = match value {
        Json::Number(number) => number_json(number.as_f64()? * factor),
        Json::String(text) => {
            let (number, unit) = number_and_unit(text)?;
            json!(format!("{} {unit}", number * factor))
        }
        Json::Array(items) if items.iter().all(|item| !item.is_object()) => {
            items.iter().map(|item| scaled(item, factor).unwrap_or_else(|| item.clone())).collect()
        }
        _ => return None,
    };
    (changed != *value).then_some(changed)
}

/// Numbers that are counts, zero, or in narrow bounds.
fn stepped(value: &Json) -> Vec<Json> {
    let with = |number: f64, unit: &str| match unit {
        "" => number_json(number),
        unit => json!(format!("{number} {unit}")),
    };
    let found = match value {
        Json::Number(number) => number.as_f64().map(|number| (number, "")),
        Json::String(text) => number_and_unit(text),
        _ => None,
    };
    let Some((number, unit)) = found else { return Vec::new() };
    let mut values = vec![with(number + 1.0, unit), with(number - 1.0, unit)];
    if number == 0.0 {
        values.extend([0.1, 5.0, -0.1, 1000.0].map(|other| with(other, unit)));
    }
    values
}

fn number_json(number: f64) -> Json {
    match number == number.trunc() && number.abs() < 1e15 {
        true => json!(number as i64),
        false => json!(number),
    }
}

/// The number at the beginning of a text, and what follows it.
fn number_and_unit(text: &str) -> Option<(f64, &str)> {
    let end = text.find(|c: char| !(c.is_ascii_digit() || "+-.".contains(c))).unwrap_or(text.len());
    Some((text[..end].parse().ok()?, text[end..].trim()))
}
