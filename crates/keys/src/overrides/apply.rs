//! Sets the keys of a TOML document that overrides name.

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::Override;
use super::paths::paths;
use super::pattern::is_pattern;
use crate::error::ScenarioError;
use crate::key_path;
use crate::keys::SCENARIO;
use crate::reader::{respan, unknown_key};
use crate::sources::Sources;
use crate::spec::{Kind, TableSpec};
use crate::suggest::nearest;

/// Applies all overrides to the document, one after the other. Returns the path of each key that was set, with the
/// index of the override that set the key.
pub fn apply<'a>(
    sources: &Sources<'a>,
    document: &mut DeTable<'a>,
) -> Result<Vec<(Vec<String>, usize)>, ScenarioError> {
    let mut set = Vec::new();
    for (index, change) in sources.overrides.iter().enumerate() {
        let value = respan(&change.value()?, &sources.override_span(index));
        let span = sources.override_key_span(index);
        let key = change.path().join(".");
        let refused = |message: String| sources.error(&span, &key, message);
        if change.path().last().is_some_and(|name| is_pattern(name)) {
            let error =
                refused(format!("`{key}` ends in a pattern, which stands for whole tables"));
            return Err(error.with_help("add the key to be set after the pattern"));
        }
        let paths = paths(document, change.path(), &span);
        if paths.is_empty() {
            return Err(refused(format!("the file has no table that the pattern in `{key}` fits")));
        }
        for path in paths {
            let setter = Setter { sources, index, value: value.clone() };
            let (name, deeper) = path.split_first().expect("a dotted path has at least one name");
            setter.in_table(document, &SCENARIO, "", (name, deeper))?;
            set.push((path, index));
        }
    }
    Ok(set)
}

/// The keys of a scenario that the overrides set, in the order of the overrides, each with its value as the user wrote
/// it. An override whose path has a `*` gives the paths of all keys for which this path stands.
///
/// # Errors
/// Fails if the text is not TOML, or if an override names a key that does not exist.
pub fn set_keys(
    text: &str,
    file_name: &str,
    overrides: &[Override],
) -> Result<Vec<(Vec<String>, String)>, ScenarioError> {
    let sources = Sources::new(file_name, text, overrides);
    let mut document = crate::syntax::parse(&sources)?;
    let set = apply(&sources, &mut document)?;
    Ok(set
        .into_iter()
        .map(|(path, index)| (path, overrides[index].value_text().to_owned()))
        .collect())
}

/// The next name of a dotted path, and the names after that name.
type Names<'p> = (&'p str, &'p [String]);

/// Sets one override's value on its way down through the tables of the document. In its functions, `at` is the path
/// down to the present table, for messages.
struct Setter<'s, 'a> {
    sources: &'s Sources<'a>,
    index: usize,
    value: Spanned<DeValue<'a>>,
}

impl<'a> Setter<'_, 'a> {
    fn in_table(
        self,
        table: &mut DeTable<'a>,
        spec: &TableSpec,
        at: &str,
        (name, deeper): Names<'_>,
    ) -> Result<(), ScenarioError> {
        let span = self.sources.override_key_span(self.index);
        let Some(key) = spec.key(name) else {
            return Err(unknown_key(self.sources, spec, at, name, &span));
        };
        let at = key_path::join(at, name);
        let [next, deeper @ ..] = deeper else {
            self.set(table, key.name);
            return Ok(());
        };
        let names = (next.as_str(), deeper);
        match &key.kind {
            Kind::Table(inner) => {
                let entry = table.entry(Spanned::new(span.clone(), DeString::Borrowed(key.name)));
                let node =
                    entry.or_insert_with(|| Spanned::new(span, DeValue::Table(DeTable::new())));
                match node.get_mut() {
                    DeValue::Table(table) => self.in_table(table, inner, &at, names),
                    _ => Err(self.not_a_table(&at)),
                }
            }
            Kind::Named(inner) => match table.get_mut(key.name).map(Spanned::get_mut) {
                Some(DeValue::Table(tables)) => self.in_named(tables, inner, &at, names),
                _ => Err(self.missing(&at)),
            },
            Kind::List(inner) => match table.get_mut(key.name).map(Spanned::get_mut) {
                Some(DeValue::Array(nodes)) => self.in_list(nodes, inner, &at, names),
                _ => Err(self.missing(&at)),
            },
            _ => Err(self.error(&at, format!("`{at}` holds a value and has no keys of its own"))),
        }
    }

    fn in_named(
        self,
        tables: &mut DeTable<'a>,
        spec: &TableSpec,
        at: &str,
        (name, deeper): Names<'_>,
    ) -> Result<(), ScenarioError> {
        let inner_at = key_path::join(at, name);
        let [next, deeper @ ..] = deeper else {
            self.set(tables, name);
            return Ok(());
        };
        match tables.get_mut(name).map(Spanned::get_mut) {
            Some(DeValue::Table(table)) => self.in_table(table, spec, &inner_at, (next, deeper)),
            Some(_) => Err(self.not_a_table(&inner_at)),
            None => {
                let error = self.missing(&inner_at);
                let names = tables.keys().map(|key| &**key.get_ref());
                Err(match nearest(name, names) {
                    Some(name) => error.with_help(format!("did you mean `{name}`?")),
                    None => error,
                })
            }
        }
    }

    fn in_list(
        self,
        nodes: &mut [Spanned<DeValue<'a>>],
        spec: &TableSpec,
        at: &str,
        (name, deeper): Names<'_>,
    ) -> Result<(), ScenarioError> {
        let (inner_at, count) = (key_path::join(at, name), nodes.len());
        let node = name.parse::<usize>().ok().and_then(|index| nodes.get_mut(index));
        let Some(node) = node else {
            let message = format!("`{inner_at}` does not exist: the file has {count} of `{at}`");
            return Err(self
                .error(&inner_at, message)
                .with_help("the items of a list are numbered from 0"));
        };
        let [next, deeper @ ..] = deeper else {
            *node = self.value;
            return Ok(());
        };
        match node.get_mut() {
            DeValue::Table(table) => self.in_table(table, spec, &inner_at, (next, deeper)),
            _ => Err(self.not_a_table(&inner_at)),
        }
    }

    /// Sets a key of a table to the override's value. A key that stands in the file keeps its place in the file.
    fn set(self, table: &mut DeTable<'a>, name: &str) {
        let span = self.sources.override_key_span(self.index);
        match table.get_mut(name) {
            Some(node) => *node = self.value,
            None => {
                let key = Spanned::new(span, DeString::Owned(name.to_owned()));
                table.insert(key, self.value);
            }
        }
    }

    fn not_a_table(&self, at: &str) -> ScenarioError {
        self.error(at, format!("`{at}` is not a table in the file"))
    }

    fn missing(&self, at: &str) -> ScenarioError {
        self.error(at, format!("the file has no `{at}`"))
    }

    fn error(&self, key: &str, message: String) -> ScenarioError {
        self.sources.error(&self.sources.override_key_span(self.index), key, message)
    }
}
