//! What goes wrong, as JavaScript gets it.

use fenderline_embed::EngineError;
use fenderline_scenario::{Place, ScenarioError};
use serde::Serialize;

/// The largest text of a scenario that is read (bytes): that of the program.
pub const LARGEST_TEXT_BYTES: usize = 16 << 20;

/// An error.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem(Box<Details>);

/// What is wrong, and where. The fields that do not apply are `None`.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Details {
    /// `scenario`, `setup`, `step`, `model`, `engine`, `exercise` or `call`.
    pub kind: &'static str,
    /// What is wrong, in one line.
    pub message: String,
    /// The same over several lines, with the line of the file, as the program prints it.
    pub text: String,
    /// The file.
    pub file: Option<String>,
    /// Line in the file, from 1.
    pub line: Option<usize>,
    /// Column in characters, from 1.
    pub column: Option<usize>,
    /// Dotted path of the key.
    pub key: Option<String>,
    /// What to write instead.
    pub help: Option<String>,
    /// The override that is wrong, as `--set KEY=VALUE`.
    pub option: Option<String>,
}

impl Problem {
    /// A problem without a place.
    pub fn new(kind: &'static str, message: impl ToString) -> Problem {
        let message = message.to_string();
        let text = format!("error: {message}");
        Problem::from(Details { kind, text, message, ..Details::default() })
    }

    /// The same at a place in a text that has no file.
    #[must_use]
    pub fn at(mut self, line: usize, column: usize) -> Problem {
        (self.0.line, self.0.column) = (Some(line), Some(column));
        self
    }

    /// What is wrong, and where.
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
/// It has more bytes than [`LARGEST_TEXT_BYTES`].
pub fn check_size(file: &str, text: &str) -> Result<(), Problem> {
    if text.len() <= LARGEST_TEXT_BYTES {
        return Ok(());
    }
    let most = LARGEST_TEXT_BYTES >> 20;
    let message = format!("{file}: it is larger than the {most} MiB that are read");
    Err(Problem::new("scenario", message))
}
