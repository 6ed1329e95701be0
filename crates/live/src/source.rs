//! Where a session begins: a scenario with all that it names, as text.

use std::collections::BTreeMap;

use fenderline_scenario::{Override, Scenario, ScenarioError};
use serde::{Deserialize, Serialize};

/// A scenario that stands alone: its text and the texts of the files that it names. What a recording holds, so
/// that it can be replayed when those files are gone or changed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Source {
    /// Name of the scenario's file, without folders.
    pub file: String,
    /// The scenario.
    pub text: String,
    /// Texts of the files that it names, by the names that stand in it.
    pub files: BTreeMap<String, String>,
    /// Changes of keys, as `KEY=VALUE`.
    pub set: Vec<String>,
}

impl Source {
    /// Collects a scenario: `read` is from a name that stands in it to that file's text, or why there is none.
    ///
    /// # Errors
    /// The first mistake in the scenario.
    pub fn collect(
        file: &str,
        text: String,
        set: Vec<String>,
        mut read: impl FnMut(&str) -> Result<String, String>,
    ) -> Result<(Source, Scenario), ScenarioError> {
        let mut files = BTreeMap::new();
        let scenario = Scenario::parse_among(&text, file, &overrides(&set)?, &mut |name| {
            let text = read(name)?;
            files.insert(name.to_owned(), text.clone());
            Ok(text)
        })?;
        Ok((Source { file: file.to_owned(), text, files, set }, scenario))
    }

    /// The scenario.
    ///
    /// # Errors
    /// The first mistake in it, a file that it names and that is not among `files` for one.
    pub fn scenario(&self) -> Result<Scenario, ScenarioError> {
        let overrides = overrides(&self.set)?;
        Scenario::parse_among(&self.text, &self.file, &overrides, &mut |name| {
            self.files.get(name).cloned().ok_or_else(|| format!("{name}: the recording lacks it"))
        })
    }

    /// What stands above the first key, without comment signs: what the scenario's author says of it.
    #[must_use]
    pub fn leading_comment(text: &str) -> String {
        let lines = text.lines().skip_while(|line| line.trim().is_empty());
        let comment = lines.map_while(|line| line.strip_prefix('#'));
        let words: Vec<&str> = comment.flat_map(str::split_whitespace).collect();
        words.join(" ")
    }
}

fn overrides(set: &[String]) -> Result<Vec<Override>, ScenarioError> {
    set.iter().map(|text| Override::parse(text)).collect()
}
