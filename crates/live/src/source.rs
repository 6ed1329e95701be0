//! The source of a session: a scenario and the files that it names, as text.

use std::collections::BTreeMap;

use fenderline_scenario::{Override, Scenario, ScenarioError};
use serde::{Deserialize, Serialize};

use crate::ghost::Ghost;

/// A self-contained scenario: its text and the texts of the files that it names. A recording contains it. A recording
/// that contains a self-contained scenario can be replayed after the scenario's files have changed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Source {
    /// Name of the scenario's file, without folders.
    pub file: String,
    /// The text of the scenario.
    pub text: String,
    /// Texts of the files that the scenario names. The keys of the map are the names that the scenario uses.
    pub files: BTreeMap<String, String>,
    /// Keys of the scenario to override, each as `KEY=VALUE`.
    pub set: Vec<String>,
    /// A measured ship that pages show beside the simulated ships.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ghost: Option<Ghost>,
}

impl Source {
    /// Collects a scenario and its files. `read` returns the text of a file that the scenario names, or the reason why
    /// it cannot be read.
    ///
    /// # Errors
    /// Fails with the first mistake in the scenario.
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
        Ok((Source { file: file.to_owned(), text, files, set, ghost: None }, scenario))
    }

    /// Parses the scenario.
    ///
    /// # Errors
    /// Fails with the first mistake in the scenario, such as a file that it names but that `files` lacks.
    pub fn scenario(&self) -> Result<Scenario, ScenarioError> {
        self.scenario_with(&[])
    }

    /// Parses the scenario as [`Source::scenario`] does, and overrides further keys.
    ///
    /// # Errors
    /// The errors of [`Source::scenario`].
    pub fn scenario_with(&self, more: &[Override]) -> Result<Scenario, ScenarioError> {
        let mut overrides = overrides(&self.set)?;
        overrides.extend_from_slice(more);
        Scenario::parse_among(&self.text, &self.file, &overrides, &mut |name| {
            self.files
                .get(name)
                .cloned()
                .ok_or_else(|| format!("the recording lacks the file {name}"))
        })
    }

    /// The comment of a scenario file above its first key, without comment signs. In the comment above the first key,
    /// the author describes the scenario.
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
