//! A scenario with all files that the scenario names, as one text: the resource that an FMU's library
//! reads.

use core::fmt;
use std::collections::BTreeMap;
use std::path::Path;

use fenderline_scenario::{Override, Scenario, ScenarioError, read_text};
use serde_json::{Map, Value, json};

use crate::table::Kind;

/// Version of the format.
const FORM: u64 = 1;

/// A self-contained scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bundle {
    /// The kind of FMU.
    pub kind: Kind,
    /// Name of the scenario file, for messages and the default title.
    name: String,
    text: String,
    /// Keys that replace keys of the scenario's text, each with its value.
    changes: Vec<[String; 2]>,
    /// Texts of the files that the scenario names, by those names.
    files: BTreeMap<String, String>,
}

/// Why a scenario cannot be bundled, or why a text is not a bundle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BundleError {
    /// The scenario file cannot be read.
    Unreadable(String),
    /// The scenario reader refuses the file.
    Refused(ScenarioError),
    /// The text is not a bundle; says which part is missing.
    NotABundle(&'static str),
}

impl fmt::Display for BundleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BundleError::Unreadable(why) => write!(f, "error: cannot read {why}"),
            BundleError::Refused(error) => error.fmt(f),
            BundleError::NotABundle(what) => write!(f, "error: the FMU's scenario has no {what}"),
        }
    }
}

impl std::error::Error for BundleError {}

impl Bundle {
    /// Reads a scenario file and the files that it names, with some keys replaced.
    ///
    /// # Errors
    /// As [`Scenario::load`].
    pub fn load(kind: Kind, path: &Path, changes: Vec<[String; 2]>) -> Result<Bundle, BundleError> {
        let text = read_text(path).map_err(BundleError::Unreadable)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        Bundle::of_text(kind, text, &path.display().to_string(), folder, changes)
    }

    /// Takes the text of a scenario file named `shown`, and reads the files that it names in `folder`.
    ///
    /// # Errors
    /// As [`Scenario::parse_beside`].
    pub fn of_text(
        kind: Kind,
        text: String,
        shown: &str,
        folder: &Path,
        changes: Vec<[String; 2]>,
    ) -> Result<Bundle, BundleError> {
        let name = Path::new(shown).file_name().unwrap_or_default().to_string_lossy().into_owned();
        let overrides = overrides(&changes)?;
        let mut files = BTreeMap::new();
        Scenario::parse_among(&text, shown, &overrides, &mut |file| {
            let text = read_text(&folder.join(file))?;
            files.insert(file.to_owned(), text.clone());
            Ok(text)
        })
        .map_err(BundleError::Refused)?;
        Ok(Bundle { kind, name, text, changes, files })
    }

    /// The scenario.
    ///
    /// # Errors
    /// [`BundleError::Refused`].
    pub fn scenario(&self) -> Result<Scenario, BundleError> {
        let overrides = overrides(&self.changes)?;
        Scenario::parse_among(&self.text, &self.name, &overrides, &mut |name| {
            self.files
                .get(name)
                .cloned()
                .ok_or_else(|| format!("{name}: the file is not in the FMU"))
        })
        .map_err(BundleError::Refused)
    }

    /// The bundle as text.
    #[must_use]
    pub fn to_json(&self) -> String {
        let files: Map<String, Value> =
            self.files.iter().map(|(name, text)| (name.clone(), json!(text))).collect();
        let bundle = json!({
            "form": FORM,
            "kind": self.kind.name(),
            "name": self.name,
            "text": self.text,
            "changes": self.changes,
            "files": files,
        });
        format!("{bundle:#}\n")
    }

    /// The content of the bundle from which a hash is made: each text after its length. The bytes that are hashed do
    /// not depend on how [`Bundle::to_json`] orders its keys, which another crate's choice of `serde_json`'s features
    /// can change.
    pub(crate) fn content(&self) -> Vec<u8> {
        let changes = self.changes.iter().flatten().map(String::as_str);
        let files = self.files.iter().flat_map(|(name, text)| [name.as_str(), text.as_str()]);
        let counts = [self.changes.len(), self.files.len()];
        let texts = [self.kind.name(), &self.name, &self.text];
        let mut content = Vec::new();
        counts.iter().for_each(|count| content.extend((*count as u64).to_le_bytes()));
        for text in texts.into_iter().chain(changes).chain(files) {
            content.extend((text.len() as u64).to_le_bytes());
            content.extend(text.as_bytes());
        }
        content
    }

    /// Reads a bundle from its text.
    ///
    /// # Errors
    /// [`BundleError::NotABundle`].
    pub fn from_json(json: &str) -> Result<Bundle, BundleError> {
        let no = BundleError::NotABundle;
        let bundle: Value = serde_json::from_str(json).map_err(|_| no("JSON"))?;
        if bundle["form"] != json!(FORM) {
            return Err(no("format version that this library can read"));
        }
        let text = |key: &str| bundle[key].as_str().map(str::to_owned);
        let change =
            |change: &Value| Some([change[0].as_str()?.to_owned(), change[1].as_str()?.to_owned()]);
        let file =
            |(name, text): (&String, &Value)| Some((name.clone(), text.as_str()?.to_owned()));
        let changes = bundle["changes"].as_array().ok_or(no("changes"))?;
        let files = bundle["files"].as_object().ok_or(no("files"))?;
        Ok(Bundle {
            kind: text("kind").and_then(|name| Kind::of_name(&name)).ok_or(no("kind"))?,
            name: text("name").ok_or(no("name"))?,
            text: text("text").ok_or(no("text"))?,
            changes: changes.iter().map(change).collect::<Option<_>>().ok_or(no("changes"))?,
            files: files.iter().map(file).collect::<Option<_>>().ok_or(no("files"))?,
        })
    }
}

fn overrides(changes: &[[String; 2]]) -> Result<Vec<Override>, BundleError> {
    let of = |[key, value]: &[String; 2]| Override::new(&format!("{key}={value}"), key, value);
    changes.iter().map(of).collect::<Result<_, _>>().map_err(BundleError::Refused)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bundle() -> Bundle {
        Bundle {
            kind: Kind::Engine,
            name: "tug.toml".into(),
            text: "a".into(),
            changes: vec![["k".into(), "v".into()]],
            files: BTreeMap::from([("b.toml".into(), "b".into()), ("c.toml".into(), "c".into())]),
        }
    }

    #[test]
    fn the_content_does_not_depend_on_the_order_of_keys_in_the_json_text() {
        // The bundle as a `serde_json` writes it that keeps the order of insertion, and as a
        // `serde_json` writes it that sorts keys.
        let orders = [
            r#"{"form":1,"kind":"engine","name":"tug.toml","text":"a","changes":[["k","v"]],
                "files":{"c.toml":"c","b.toml":"b"}}"#,
            r#"{"changes":[["k","v"]],"files":{"b.toml":"b","c.toml":"c"},"form":1,"kind":"engine",
                "name":"tug.toml","text":"a"}"#,
        ];
        for json in orders {
            let read = Bundle::from_json(json).expect("a bundle");
            assert_eq!(read, bundle());
            assert_eq!(read.content(), bundle().content());
        }
    }

    #[test]
    fn each_part_of_a_bundle_changes_its_content() {
        let others = [
            Bundle { kind: Kind::Simulation, ..bundle() },
            Bundle { name: "tug.tom".into(), text: "la".into(), ..bundle() },
            Bundle { changes: Vec::new(), ..bundle() },
            Bundle { files: BTreeMap::from([("b.toml".into(), "b".into())]), ..bundle() },
            // The same texts with another border between changes and files.
            Bundle {
                changes: vec![["k".into(), "v".into()], ["b.toml".into(), "b".into()]],
                files: BTreeMap::from([("c.toml".into(), "c".into())]),
                ..bundle()
            },
        ];
        for other in others {
            assert_ne!(other.content(), bundle().content(), "{other:?}");
        }
    }
}
