//! Errors as JavaScript gets them.

use fenderline_embed::EngineError;
use fenderline_scenario::{Place, ScenarioError};
use serde::Serialize;

/// The largest text of a scenario that is read (bytes), which is also the program's limit.
pub const LARGEST_TEXT_BYTES: usize = 16 << 20;

/// An error.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem(Box<Details>);

/// The contents of an error: what is wrong, and the file, the line or the key that is wrong. Fields that do not apply
/// to the error are `None`.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Details {
    /// Kind of the error: `scenario`, `setup`, `step`, `model`, `engine`, `exercise` or `call`.
    pub kind: &'static str,
    /// What is wrong, in one line.
    pub message: String,
    /// The error over several lines, with the line of the file that is wrong, as the program prints it.
    pub text: String,
    /// The file.
    pub file: Option<String>,
    /// Line of the mistake in the file, counted from 1.
    pub line: Option<usize>,
    /// Column of the mistake in characters, counted from 1.
    pub column: Option<usize>,
    /// Dotted path of the key that is wrong.
    pub key: Option<String>,
    /// What to write instead.
    pub help: Option<String>,
    /// The override that is wrong, as `--set KEY=VALUE`.
    pub option: Option<String>,
}

impl Problem {
    /// Makes an error that has no place in a text.
    pub fn new(kind: &'static str, message: impl ToString) -> Problem {
        let message = message.to_string();
        let text = format!("error: {message}");
        Problem::from(Details { kind, text, message, ..Details::default() })
    }

    /// Gives the error a line and a column in a text that has no file.
    #[must_use]
    pub fn at(mut self, line: usize, column: usize) -> Problem {
        (self.0.line, self.0.column) = (Some(line), Some(column));
        self
    }

    /// The contents of the error: what is wrong, and where in the scenario.
    #[must_use]
    pub fn details(&self) -> &Details {
        &self.0
    }

    /// As JSON.
    #[must_use]
    pub fn json(&self) -> String {
        serde_json::to_string(&self.0).unwrap_or_else(|e| unreachable!("texts and numbers: {e}"))
    }
}

impl From<Details> for Problem {
    fn from(details: Details) -> Problem {
        Problem(Box::new(details))
    }
}

impl From<ScenarioError> for Problem {
    fn from(error: ScenarioError) -> Problem {
        let (file, line, column, option) = match error.place() {
            Place::File { name, line, column } => {
                (Some(name.clone()), Some(*line), Some(*column), None)
            }
            Place::WholeFile { name } => (Some(name.clone()), None, None, None),
            Place::Option { text } => (None, None, None, Some(text.clone())),
        };
        Problem::from(Details {
            kind: "scenario",
            message: error.message().to_owned(),
            text: error.to_string(),
            file,
            line,
            column,
            key: error.key().map(str::to_owned),
            help: error.help().map(str::to_owned),
            option,
        })
    }
}

impl From<EngineError> for Problem {
    fn from(error: EngineError) -> Problem {
        Problem::new("engine", error)
    }
}

/// Refuses a text that is too large to be a scenario.
///
/// # Errors
/// Fails for a text of more than [`LARGEST_TEXT_BYTES`] bytes.
pub fn check_size(file: &str, text: &str) -> Result<(), Problem> {
    if text.len() <= LARGEST_TEXT_BYTES {
        return Ok(());
    }
    let most = LARGEST_TEXT_BYTES >> 20;
    let message = format!("{file}: the text is larger than the {most} MiB that may be read");
    Err(Problem::new("scenario", message))
}
