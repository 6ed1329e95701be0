//! Overrides of single keys from the command line. Overrides are applied to the tables of the scenario file before the
//! tables are checked.

mod apply;
mod paths;
pub mod pattern;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

pub use self::apply::{apply, set_keys};
use self::pattern::with_quotes;
use crate::error::{Place, ScenarioError};
use crate::key_path;
use crate::origin::Origin;
use crate::place::quoted;

/// One key of a scenario and the value that replaces the value in the file, as `--set KEY=VALUE` gives them.
///
/// The key is a dotted path, in which an item of a list is named by its number from 0, as in `load.0.force`. A `*` in a
/// name of the path stands for any text: `fender.*.temperature` sets the temperature of all fenders. A path names a
/// single fender of a row as in `fender.a_3.tolerance`, and the whole row as in `fender_row.a.tolerance`. The value of
/// an override is TOML, or a text without quotes: `0.5`, `4 kn`, `["0 kN", "-500 kN"]`, `paper`.
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
    /// The origins of key and value, if they do not come from the command line.
    origins: Option<Box<[Origin; 2]>>,
}

impl Override {
    /// Reads an override from the text `KEY=VALUE`. Errors call the override `--set KEY=VALUE`.
    ///
    /// # Errors
    /// Fails if the text has no `=`, or if the key is not a dotted path.
    pub fn parse(text: &str) -> Result<Override, ScenarioError> {
        let option = format!("--set {text}");
        match text.split_once('=') {
            Some((key, value)) => Override::new(&option, key, value),
            None => Err(option_error(&option, None, "there is no `=`".to_owned())
                .with_help("write KEY=VALUE, as in time.step=0.5")),
        }
    }

    /// Makes an override of the key `key` by the value `value`. Errors call the override `option`, which is its text in
    /// the command line.
    ///
    /// # Errors
    /// Fails if the key is not a dotted path, or if the value is empty.
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

    /// Makes an override whose key and value come from other files. Errors about the key point to `key_origin`, errors
    /// about the value point to `origin`.
    ///
    /// # Errors
    /// Fails like [`Override::new`].
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

    /// This override without the origins of its key and value.
    #[must_use]
    pub fn without_origins(self) -> Override {
        Override { origins: None, ..self }
    }

    /// The names in the dotted path of the override's key.
    #[must_use]
    pub fn path(&self) -> &[String] {
        &self.path
    }

    /// The value of the override as the user wrote it: TOML, or a text without quotes.
    #[must_use]
    pub fn value_text(&self) -> &str {
        &self.value
    }

    /// The option of the command line, as errors print it.
    pub fn shown(&self) -> &str {
        &self.shown
    }

    /// The origin of the override's key; `None` if the key comes from the command line.
    pub fn key_origin(&self) -> Option<&Origin> {
        self.origins.as_ref().map(|origins| &origins[0])
    }

    /// The origin of the override's value; `None` if the value comes from the command line.
    pub fn origin(&self) -> Option<&Origin> {
        self.origins.as_ref().map(|origins| &origins[1])
    }

    /// The value of the override, read as TOML, or as a text if the value is not TOML.
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

/// The text of an option, cut to a length that messages can show.
fn shown(option: &str) -> String {
    let (kept, is_cut) = crate::place::first(option, 200);
    if is_cut { format!("{kept}…") } else { kept }
}

/// The names in a dotted path. TOML's parser reads the path, so that names in quotes work as in a file.
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
