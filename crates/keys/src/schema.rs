//! Makes the JSON Schema of files from the same declarations of keys that the reader uses.

use serde_json::{Map, Value as Json, json};
use toml::de::DeValue;

use crate::choices::{AnyChoices, Word};
use crate::spec::{Absent, KeySpec, Kind, Quantity, TableSpec};

/// Rough pattern of a text with a number and a unit; the reader of the file checks the unit itself.
const QUANTITY_PATTERN: &str = r"^\s*[+\-−]?[0-9]+(\.[0-9]+)?([eE][+\-]?[0-9]+)?\s*\S.*$";

/// The JSON Schema (draft 2020-12) of a file that has the keys of the table `spec`, under the title `title`.
#[must_use]
pub fn whole_file(spec: &TableSpec, title: &str) -> Json {
    let mut schema = table(spec);
    schema.insert("$schema".to_owned(), json!("https://json-schema.org/draft/2020-12/schema"));
    schema.insert("title".to_owned(), json!(title));
    Json::Object(schema)
}

fn table(spec: &TableSpec) -> Map<String, Json> {
    let properties: Map<String, Json> =
        spec.keys.iter().map(|spec| (spec.name.to_owned(), Json::Object(key(spec)))).collect();
    let required: Vec<&str> =
        spec.keys.iter().filter(|key| key.absent == Absent::Refused).map(|key| key.name).collect();
    let mut schema = object(json!({
        "type": "object",
        "title": capitalised(spec.what),
        "description": spec.doc,
        "properties": properties,
        "additionalProperties": false,
    }));
    if !required.is_empty() {
        schema.insert("required".to_owned(), json!(required));
    }
    if let Some(rules) = spec.rules {
        schema.extend(object(rules()));
    }
    schema
}

fn key(key: &KeySpec) -> Map<String, Json> {
    let mut schema = kind(&key.kind);
    let mut description = key.doc.to_owned();
    if let Some(unit) = unit(&key.kind) {
        description.push_str(&format!(" [{unit}]"));
    }
    match key.absent {
        Absent::Refused => {}
        Absent::Is(value) => {
            schema.insert("default".to_owned(), parsed(value));
        }
        Absent::Means(meaning) => description.push_str(&format!(" Without it: {meaning}.")),
        Absent::Unless(condition) => {
            description.push_str(&format!(" Required unless {condition}."));
        }
    }
    schema.insert("title".to_owned(), json!(capitalised(&key.name.replace('_', " "))));
    schema.insert("description".to_owned(), json!(description));
    if !key.examples.is_empty() {
        let examples: Vec<Json> = key.examples.iter().map(|example| parsed(example)).collect();
        schema.insert("examples".to_owned(), json!(examples));
    }
    schema
}

fn kind(kind: &Kind) -> Map<String, Json> {
    let name = || json!({ "type": "string", "minLength": 1, "maxLength": 200 });
    match kind {
        Kind::Text | Kind::FileName | Kind::MaterialName | Kind::BodyName => object(name()),
        Kind::Flag => object(json!({ "type": "boolean" })),
        Kind::Choice(choices) => choice(*choices),
        Kind::Quantity(value) => quantity(value),
        Kind::NameOr(value) => object(json!({
            "anyOf": [{ "type": "number", "minimum": value.low, "maximum": value.high }, name()]
        })),
        Kind::Vector(value) | Kind::Point(value) => object(two(&Json::Object(quantity(value)))),
        Kind::Texts | Kind::FileNames => object(json!({ "type": "array", "items": name() })),
        Kind::Values => object(json!({
            "type": "array",
            "items": { "anyOf": [{ "type": "number" }, { "type": "boolean" }, name()] },
            "minItems": 1
        })),
        Kind::AnyNumber => object(json!({ "anyOf": [{ "type": "number" }, name()] })),
        Kind::Outline(value) => {
            let point = two(&Json::Object(quantity(value)));
            object(json!({ "type": "array", "items": point, "minItems": 3 }))
        }
        Kind::Points(value, fewest, most) => {
            let point = two(&Json::Object(quantity(value)));
            object(json!({
                "type": "array", "items": point, "minItems": fewest, "maxItems": most
            }))
        }
        Kind::Curve(spec) => {
            let columns = [&spec.from.1, &spec.to.1].map(|column| Json::Object(quantity(column)));
            let row = json!({
                "type": "array", "prefixItems": columns, "items": false, "minItems": 2
            });
            object(json!({ "type": "array", "items": row, "minItems": spec.fewest }))
        }
        Kind::TwoBodyNames => object(two(&name())),
        Kind::Table(spec) => table(spec),
        Kind::Named(spec) => object(json!({
            "type": "object",
            "propertyNames": { "minLength": 1, "maxLength": 200, "not": { "const": "*" } },
            "additionalProperties": table(spec),
        })),
        Kind::List(spec) => object(json!({ "type": "array", "items": table(spec) })),
    }
}

fn choice(choices: &'static dyn AnyChoices) -> Map<String, Json> {
    let words = choices.words();
    let all: Vec<&str> = words.iter().map(|word| word.word).collect();
    let words: Vec<Json> = words
        .iter()
        .map(|Word { word, doc, .. }| json!({ "const": word, "description": doc }))
        .collect();
    object(json!({ "type": "string", "enum": all, "oneOf": words }))
}

fn quantity(quantity: &Quantity) -> Map<String, Json> {
    object(json!({
        "anyOf": [
            { "type": "number", "minimum": quantity.low, "maximum": quantity.high },
            { "type": "string", "pattern": QUANTITY_PATTERN },
        ]
    }))
}

fn two(item: &Json) -> Json {
    json!({ "type": "array", "items": item, "minItems": 2, "maxItems": 2 })
}

/// The SI unit in which plain numbers of a key are read.
fn unit(kind: &Kind) -> Option<&'static str> {
    match kind {
        Kind::Quantity(value)
        | Kind::Vector(value)
        | Kind::Point(value)
        | Kind::Outline(value)
        | Kind::NameOr(value)
        | Kind::Points(value, ..) => Some(value.measure.unit).filter(|unit| !unit.is_empty()),
        _ => None,
    }
}

/// "a material" to "Material".
fn capitalised(what: &str) -> String {
    let name = what.strip_prefix("an ").or_else(|| what.strip_prefix("a ")).unwrap_or(what);
    let mut chars = name.chars();
    chars.next().map_or(String::new(), |first| first.to_uppercase().chain(chars).collect())
}

fn object(value: Json) -> Map<String, Json> {
    match value {
        Json::Object(map) => map,
        other => unreachable!("{other} is no object"),
    }
}

/// Turns a TOML value in the declaration of a key, such as a default, into JSON.
fn parsed(toml: &str) -> Json {
    let value = DeValue::parse(toml).expect("the values in the declarations of the keys are TOML");
    to_json(value.get_ref())
}

fn to_json(value: &DeValue<'_>) -> Json {
    let number = |text: &str| serde_json::from_str(text).expect("a TOML decimal is a JSON number");
    match value {
        DeValue::String(text) => json!(text),
        DeValue::Integer(integer) => number(integer.as_str()),
        DeValue::Float(float) => number(float.as_str()),
        DeValue::Boolean(flag) => json!(flag),
        DeValue::Datetime(time) => json!(time.to_string()),
        DeValue::Array(items) => items.iter().map(|item| to_json(item.get_ref())).collect(),
        DeValue::Table(table) => Json::Object(
            table
                .iter()
                .map(|(key, value)| (key.get_ref().to_string(), to_json(value.get_ref())))
                .collect(),
        ),
    }
}
