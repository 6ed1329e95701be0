//! Overrides of single keys from the command line, laid over the file before it is checked.

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use crate::error::{Place, ScenarioError};
use crate::key_path;
use crate::keys::SCENARIO;
use crate::reader::{respan, unknown_key};
use crate::sources::{Sources, quoted};
use crate::spec::{Kind, TableSpec};
use crate::suggest::nearest;

/// One key of a scenario and the value that replaces the file's, as `--set KEY=VALUE` gives them.
///
/// The key is a dotted path; an item of a list goes by its number from 0, as in `load.0.force`. The
/// value is TOML, or else a text without its quotes: `0.5`, `4 kn`, `["0 kN", "-500 kN"]`, `paper`.
///
/// ```
/// use fenderline_scenario::Override;
/// let half = Override::parse("time.step=0.5 s")?;
/// let flag = Override::new("--duration 2 min", "time.duration", "2 min")?;
/// assert!(Override::parse("time.step").is_err());
/// # Ok::<(), fenderline_scenario::ScenarioError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Override {
    shown: String,
    path: Vec<String>,
    value: String,
}

impl Override {
    /// Reads `KEY=VALUE`. Errors name it `--set KEY=VALUE`.
    ///
    /// # Errors
    /// A text without `=`, or a key that is no dotted path.
    pub fn parse(text: &str) -> Result<Override, ScenarioError> {
        let option = format!("--set {text}");
        match text.split_once('=') {
            Some((key, value)) => Override::new(&option, key, value),
            None => Err(option_error(&option, None, "it has no `=`".to_owned())
                .with_help("write KEY=VALUE, as in time.step=0.5")),
        }
    }

    /// An override that stands in a command line as `option`, by which errors name it.
    ///
    /// # Errors
    /// A key that is no dotted path, or an empty value.
    pub fn new(option: &str, key: &str, value: &str) -> Result<Override, ScenarioError> {
        let shown = shown(option);
        let path = split_path(key.trim()).ok_or_else(|| {
            option_error(&shown, None, format!("{} is not a key", quoted(key)))
                .with_help("write a dotted path, as in body.tug.velocity.surge")
        })?;
        let value = value.trim();
        if value.is_empty() {
            let key = path.iter().fold(String::new(), |path, name| key_path::join(&path, name));
            let message = format!("there is no value for `{key}`");
            return Err(option_error(&shown, Some(key), message));
        }
        Ok(Override { shown, path, value: value.to_owned() })
    }

    /// The names of the dotted path.
    #[must_use]
    pub fn path(&self) -> &[String] {
        &self.path
    }

    /// The value as it was given: TOML, or else a text without its quotes.
    #[must_use]
    pub fn value_text(&self) -> &str {
        &self.value
    }

    /// The option as errors show it.
    pub(crate) fn shown(&self) -> &str {
        &self.shown
    }

    /// The value as TOML; a text where it is none.
    fn value(&self) -> Result<Spanned<DeValue<'_>>, ScenarioError> {
        match DeValue::parse(&self.value) {
            Ok(value) => Ok(value),
            Err(error) if self.value.starts_with(['[', '{', '"', '\'']) => Err(option_error(
                &self.shown,
                None,
                format!("the value is broken: {}", error.message()),
            )),
            Err(_) => Ok(Spanned::new(0..0, DeValue::String(self.value.as_str().into()))),
        }
    }
}

fn option_error(shown: &str, key: Option<String>, message: String) -> ScenarioError {
    ScenarioError::new(Place::Option { text: shown.to_owned() }, key, message)
}

/// An option, cut and fit to print.
fn shown(option: &str) -> String {
    let (kept, is_cut) = crate::sources::first(option, 200);
    if is_cut { format!("{kept}…") } else { kept }
}

/// The names of a dotted path, in TOML's own reading, quotes and all.
fn split_path(key: &str) -> Option<Vec<String>> {
    const DEEPEST: usize = 16;
    if key.contains(['=', '\n', '\r']) || key.len() > 1000 {
        return None;
    }
    let probe = format!("{key} = 0");
    let document = DeTable::parse(&probe).ok()?.into_inner();
    let mut table = &document;
    let mut path = Vec::new();
    loop {
        let (name, value) = table.iter().next()?;
        path.push(name.get_ref().to_string());
        match value.get_ref() {
            DeValue::Table(inner) if path.len() < DEEPEST => table = inner,
            DeValue::Integer(_) => return Some(path),
            _ => return None,
        }
    }
}

/// Lays every override over the document, in their order.
pub(crate) fn apply<'a>(
    sources: &Sources<'a>,
    document: &mut DeTable<'a>,
) -> Result<(), ScenarioError> {
    for (index, change) in sources.overrides.iter().enumerate() {
        let span = sources.override_span(index);
        let laying = Laying { sources, index, value: respan(&change.value()?, &span) };
        laying.over_table(document, &SCENARIO, "", &change.path)?;
    }
    Ok(())
}

/// One override on its way down the document.
struct Laying<'s, 'a> {
    sources: &'s Sources<'a>,
    index: usize,
    value: Spanned<DeValue<'a>>,
}

impl<'a> Laying<'_, 'a> {
    fn over_table(
        self,
        table: &mut DeTable<'a>,
        spec: &TableSpec,
        at: &str,
        path: &[String],
    ) -> Result<(), ScenarioError> {
        let [name, rest @ ..] = path else { unreachable!("a path has a name at every level") };
        let span = self.sources.override_span(self.index);
        let Some(key) = spec.key(name) else {
            return Err(unknown_key(self.sources, spec, at, name, &span));
        };
        let at = key_path::join(at, name);
        if rest.is_empty() {
            self.set(table, key.name);
            return Ok(());
        }
        match &key.kind {
            Kind::Table(inner) => {
                let entry = table.entry(Spanned::new(span.clone(), DeString::Borrowed(key.name)));
                let node =
                    entry.or_insert_with(|| Spanned::new(span, DeValue::Table(DeTable::new())));
                match node.get_mut() {
                    DeValue::Table(table) => self.over_table(table, inner, &at, rest),
                    _ => Err(self.error(&at, format!("`{at}` is not a table in the file"))),
                }
            }
            Kind::Named(inner) => match table.get_mut(key.name).map(Spanned::get_mut) {
                Some(DeValue::Table(tables)) => self.over_named(tables, inner, &at, rest),
                _ => Err(self.error(&at, format!("the file has no `{at}` to set a key of"))),
            },
            Kind::List(inner) => match table.get_mut(key.name).map(Spanned::get_mut) {
                Some(DeValue::Array(nodes)) => self.over_list(nodes, inner, &at, rest),
                _ => Err(self.error(&at, format!("the file has no `{at}` to set a key of"))),
            },
            _ => {
                let message = format!("`{at}` holds a value, it has no keys of its own");
                Err(self.error(&at, message))
            }
        }
    }

    fn over_named(
        self,
        tables: &mut DeTable<'a>,
        spec: &TableSpec,
        at: &str,
        path: &[String],
    ) -> Result<(), ScenarioError> {
        let [name, rest @ ..] = path else { unreachable!("a path has a name at every level") };
        let inner_at = key_path::join(at, name);
        if rest.is_empty() {
            self.set(tables, name);
            return Ok(());
        }
        match tables.get_mut(name.as_str()).map(Spanned::get_mut) {
            Some(DeValue::Table(table)) => self.over_table(table, spec, &inner_at, rest),
            Some(_) => {
                Err(self.error(&inner_at, format!("`{inner_at}` is not a table in the file")))
            }
            None => {
                let error = self.error(&inner_at, format!("the file has no `{inner_at}`"));
                let names = tables.keys().map(|key| &**key.get_ref());
                Err(match nearest(name, names) {
                    Some(name) => error.with_help(format!("did you mean `{name}`?")),
                    None => error,
                })
            }
        }
    }

    fn over_list(
        self,
        nodes: &mut [Spanned<DeValue<'a>>],
        spec: &TableSpec,
        at: &str,
        path: &[String],
    ) -> Result<(), ScenarioError> {
        let [name, rest @ ..] = path else { unreachable!("a path has a name at every level") };
        let (inner_at, count) = (key_path::join(at, name), nodes.len());
        let node = name.parse::<usize>().ok().and_then(|index| nodes.get_mut(index));
        let Some(node) = node else {
            let message = format!("`{inner_at}` does not exist: the file has {count} of `{at}`");
            return Err(self.error(&inner_at, message).with_help("they are numbered from 0"));
        };
        match (node.get_mut(), rest) {
            (_, []) => {
                *node = self.value;
                Ok(())
            }
            (DeValue::Table(table), rest) => self.over_table(table, spec, &inner_at, rest),
            _ => Err(self.error(&inner_at, format!("`{inner_at}` is not a table in the file"))),
        }
    }

    /// Puts the value under a key, which keeps its place in the file if it has one there.
    fn set(self, table: &mut DeTable<'a>, name: &str) {
        let span = self.sources.override_span(self.index);
        match table.get_mut(name) {
            Some(node) => *node = self.value,
            None => {
                let key = Spanned::new(span, DeString::Owned(name.to_owned()));
                table.insert(key, self.value);
            }
        }
    }

    fn error(&self, key: &str, message: String) -> ScenarioError {
        self.sources.error(&self.sources.override_span(self.index), key, message)
    }
}
