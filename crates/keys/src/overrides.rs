//! Overrides of single keys from the command line, applied to the file's tables before they are checked.

mod paths;
pub mod pattern;

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use self::pattern::{is_pattern, with_quotes};
use crate::error::{Place, ScenarioError};
use crate::key_path;
use crate::keys::SCENARIO;
use crate::origin::Origin;
use crate::reader::{respan, unknown_key};
use crate::sources::{Sources, quoted};
use crate::spec::{Kind, TableSpec};
use crate::suggest::nearest;

/// One key of a scenario and the value that replaces the file's, as `--set KEY=VALUE` gives them.
///
/// The key is a dotted path; an item of a list goes by its number from 0, as in `load.0.force`. A `*` in a name stands for
/// any text: `fender.*.temperature` sets this key of all fenders. A fender of a row goes by its own name, as in
/// `fender.a_3.tolerance`, the whole row as in `fender_row.a.tolerance`. The value is TOML, or a text without quotes: `0.5`, `4 kn`, `["0 kN", "-500 kN"]`, `paper`.
///
/// ```
/// use fenderline_keys::overrides::Override;
/// let half = Override::parse("time.step=0.5 s")?;
/// let flag = Override::new("--duration 2 min", "time.duration", "2 min")?;
/// assert!(Override::parse("time.step").is_err());
/// # Ok::<(), fenderline_keys::error::ScenarioError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Override {
    shown: String,
    path: Vec<String>,
    value: String,
    /// Where key and value come from, if not from the command line.
    origins: Option<Box<[Origin; 2]>>,
}

impl Override {
    /// Reads `KEY=VALUE`. Errors name it `--set KEY=VALUE`.
    ///
    /// # Errors
    /// A text without `=`, or a key that is not a dotted path.
    pub fn parse(text: &str) -> Result<Override, ScenarioError> {
        let option = format!("--set {text}");
        match text.split_once('=') {
            Some((key, value)) => Override::new(&option, key, value),
            None => Err(option_error(&option, None, "there is no `=`".to_owned())
                .with_help("write KEY=VALUE, as in time.step=0.5")),
        }
    }

    /// An override of a key by a value. Errors name it by `option`, its text in the command line.
    ///
    /// # Errors
    /// A key that is not a dotted path, or an empty value.
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
        Ok(Override { shown, path, value: value.to_owned(), origins: None })
    }

    /// An override of a key by a value that come from other files: errors about the one point at `key_origin`, about the other at
    /// `origin`.
    ///
    /// # Errors
    /// As [`Override::new`].
    pub fn from_files(
        (key, key_origin): (&str, Origin),
        (value, origin): (&str, Origin),
    ) -> Result<Override, ScenarioError> {
        let read = Override::new(&format!("--set {key}={value}"), key, value);
        let is_of_value = !key.trim().is_empty() && value.trim().is_empty();
        match read {
            Ok(read) => Ok(Override { origins: Some(Box::new([key_origin, origin])), ..read }),
            Err(error) if is_of_value => Err(error.at_origin(&origin)),
            Err(error) => Err(error.at_origin(&key_origin)),
        }
    }

    /// The same without the files that it comes from.
    #[must_use]
    pub fn without_origins(self) -> Override {
        Override { origins: None, ..self }
    }

    /// The names of the dotted path.
    #[must_use]
    pub fn path(&self) -> &[String] {
        &self.path
    }

    /// The value as the user wrote it: TOML, or a text without quotes.
    #[must_use]
    pub fn value_text(&self) -> &str {
        &self.value
    }

    /// The option as errors print it.
    pub fn shown(&self) -> &str {
        &self.shown
    }

    /// Where the key comes from.
    pub fn key_origin(&self) -> Option<&Origin> {
        self.origins.as_ref().map(|origins| &origins[0])
    }

    /// Where the value comes from.
    pub fn origin(&self) -> Option<&Origin> {
        self.origins.as_ref().map(|origins| &origins[1])
    }

    /// The value as TOML, or as a text if it is not TOML.
    pub fn value(&self) -> Result<Spanned<DeValue<'_>>, ScenarioError> {
        match DeValue::parse(&self.value) {
            Ok(value) => Ok(value),
            Err(error) if self.value.starts_with(['[', '{', '"', '\'']) => {
                let message = format!("the value is not TOML: {}", error.message());
                let error = option_error(&self.shown, None, message);
                Err(match self.origin() {
                    Some(origin) => error.at_origin(origin),
                    None => error,
                })
            }
            Err(_) => Ok(Spanned::new(0..0, DeValue::String(self.value.as_str().into()))),
        }
    }
}

fn option_error(shown: &str, key: Option<String>, message: String) -> ScenarioError {
    ScenarioError::new(Place::Option { text: shown.to_owned() }, key, message)
}

/// An option, cut to a length that messages can show.
fn shown(option: &str) -> String {
    let (kept, is_cut) = crate::sources::first(option, 200);
    if is_cut { format!("{kept}…") } else { kept }
}

/// The names of a dotted path. TOML's parser reads it, so that quoted names work as in a file.
fn split_path(key: &str) -> Option<Vec<String>> {
    const DEEPEST: usize = 16;
    if key.contains(['=', '\n', '\r']) || key.len() > 1000 {
        return None;
    }
    let probe = format!("{} = 0", with_quotes(key));
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

/// Applies every override to the document, in their order. Returns the path of each key that was set, and the index of
/// its override.
pub fn apply<'a>(
    sources: &Sources<'a>,
    document: &mut DeTable<'a>,
) -> Result<Vec<(Vec<String>, usize)>, ScenarioError> {
    let mut set = Vec::new();
    for (index, change) in sources.overrides.iter().enumerate() {
        let value = respan(&change.value()?, &sources.override_span(index));
        let span = sources.override_key_span(index);
        let refused = |message: String| {
            let key = change.path.join(".");
            sources.error(&span, &key, format!("`{key}` {message}"))
        };
        if change.path.last().is_some_and(|name| is_pattern(name)) {
            let error = refused("ends in a pattern, which stands for whole tables".to_owned());
            return Err(error.with_help("add the key to be set"));
        }
        let paths = paths::paths(document, &change.path, &span);
        if paths.is_empty() {
            return Err(refused("fits nothing in the file".to_owned()));
        }
        for path in paths {
            let setter = Setter { sources, index, value: value.clone() };
            let (name, deeper) = path.split_first().expect("a path has a name");
            setter.in_table(document, &SCENARIO, "", (name, deeper))?;
            set.push((path, index));
        }
    }
    Ok(set)
}

/// The keys of a scenario's text that overrides set, in their order, and the value of each as the user wrote it. A path
/// with a `*` becomes that of every key for which it stands.
///
/// # Errors
/// A text that is not TOML, or an override of a key that there is not.
pub fn set_keys(
    text: &str,
    file_name: &str,
    overrides: &[Override],
) -> Result<Vec<(Vec<String>, String)>, ScenarioError> {
    let sources = Sources::new(file_name, text, overrides);
    let mut document = crate::syntax::parse(&sources)?;
    let set = apply(&sources, &mut document)?;
    Ok(set.into_iter().map(|(path, index)| (path, overrides[index].value.clone())).collect())
}

/// The next name of a dotted path, and the names after it.
type Names<'p> = (&'p str, &'p [String]);

/// One override on its way down the document. `at` is the path so far, for messages.
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
            return Err(self.error(&inner_at, message).with_help("they are numbered from 0"));
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

    /// Sets a key to the value. A key of the file keeps its place there.
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
