//! A scenario and all that comes of it.

use std::collections::BTreeMap;

use fenderline_results::KeptValues;
use fenderline_scenario::Scenario;
use fenderline_wasm::run::{Run, Source, Wanted, parse};
use serde_json::{Value as Json, json};
use toml::de::{DeTable, DeValue};

/// A scenario as JSON, with the files that it names.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    /// What it is called in messages.
    pub(crate) name: String,
    /// The scenario.
    pub(crate) document: Json,
    /// Texts of the files that it names.
    pub(crate) files: BTreeMap<String, String>,
}

/// What the key can change.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Results {
    summary: Json,
    tables: String,
    report: String,
}

impl Case {
    fn source<'t>(&self, text: &'t str) -> Source<'t> {
        Source { text, file: "case.toml", set: &[], files: self.files.clone() }
    }

    /// The scenario with a document in place of its own; `None` if it is refused.
    #[must_use]
    pub(crate) fn read(&self, document: &Json) -> Option<Scenario> {
        parse(&self.source(&toml_of(document))).ok()
    }

    /// Why the scenario is refused.
    #[must_use]
    pub(crate) fn why(&self) -> String {
        let read = parse(&self.source(&toml_of(&self.document)));
        read.err().map_or(String::new(), |error| error.details().text.clone())
    }

    /// Runs a document; `None` if it cannot be run.
    #[must_use]
    pub(crate) fn results(&self, document: &Json) -> Option<Results> {
        let text = toml_of(document);
        let wanted = Wanted { tables: true, frames: false };
        let mut run = Run::new(&self.source(&text), wanted).ok()?;
        while !run.simulation().is_done() {
            run.advance(1000).ok()?;
        }
        let mut summary: Json = serde_json::from_str(&run.summary().ok()?).ok()?;
        summary["notices"] = json!([]);
        let report = without_notices(&run.report());
        run.tables().ok()?;
        Some(Results { summary, tables: tables(&run), report })
    }
}

impl Results {
    /// What differs, in a word; `None` for equal ones.
    #[must_use]
    pub(crate) fn difference(&self, other: &Results) -> Option<&'static str> {
        if self.summary != other.summary {
            Some("summary")
        } else if self.tables != other.tables {
            Some("tables")
        } else if self.report != other.report {
            Some("report")
        } else {
            None
        }
    }
}

/// A report without its list of notices, which names lines of the file.
fn without_notices(report: &str) -> String {
    report.lines().filter(|line| !line.contains("line ")).collect::<Vec<_>>().join("\n")
}

/// Every value of every table.
fn tables(run: &Run) -> String {
    let mut text = String::new();
    for table in 0.. {
        if run.column(table, 0).is_none() {
            return text;
        }
        for column in 0.. {
            let Some(values) = run.column(table, column) else { break };
            text += &match values {
                KeptValues::Floats(values) => {
                    format!("{:x}\n", values.iter().fold(7_u64, |sum, v| mixed(sum, v.to_bits())))
                }
                other => format!("{other:?}\n"),
            };
        }
    }
    text
}

fn mixed(sum: u64, value: u64) -> u64 {
    (sum.rotate_left(5) ^ value).wrapping_mul(0x9E37_79B9_7F4A_7C15)
}

/// The text of a scenario file as JSON.
#[must_use]
pub(crate) fn json_of(text: &str) -> Json {
    fn value(node: &DeValue<'_>) -> Json {
        match node {
            DeValue::String(text) => json!(text),
            DeValue::Integer(number) => serde_json::from_str(number.as_str()).expect("decimal"),
            DeValue::Float(number) => serde_json::from_str(number.as_str()).expect("decimal"),
            DeValue::Boolean(flag) => json!(flag),
            DeValue::Datetime(time) => json!(time.to_string()),
            DeValue::Array(items) => items.iter().map(|item| value(item.get_ref())).collect(),
            DeValue::Table(map) => table(map),
        }
    }
    fn table(map: &DeTable<'_>) -> Json {
        let mut entries: Vec<_> = map.iter().collect();
        entries.sort_by_key(|(key, _)| key.span().start);
        let entries = entries.into_iter();
        Json::Object(
            entries.map(|(key, node)| (key.get_ref().to_string(), value(node.get_ref()))).collect(),
        )
    }
    table(DeTable::parse(text).expect("a TOML file").get_ref())
}

/// A JSON document as TOML: one inline value a line.
#[must_use]
pub(crate) fn toml_of(document: &Json) -> String {
    fn value(json: &Json) -> String {
        match json {
            Json::Object(map) => {
                let entries = map.iter().map(|(key, inner)| format!("{key:?} = {}", value(inner)));
                format!("{{ {} }}", entries.collect::<Vec<_>>().join(", "))
            }
            Json::Array(items) => {
                format!("[{}]", items.iter().map(value).collect::<Vec<_>>().join(", "))
            }
            other => other.to_string(),
        }
    }
    let lines = document.as_object().expect("a table").iter();
    lines.map(|(key, inner)| format!("{key} = {}\n", value(inner))).collect()
}
