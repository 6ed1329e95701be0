//! What went wrong in a scenario, and where.

use core::fmt;

use crate::origin::Origin;
pub use crate::place::Place;
use crate::place::Snippet;
use crate::printable::printable_line;

/// A scenario that cannot be run: one mistake, its place, and if possible what to write instead. Displays as
/// several lines with the offending line of the file.
#[derive(Clone, PartialEq, Eq)]
pub struct ScenarioError(Box<Content>);

#[derive(Clone, PartialEq, Eq)]
struct Content {
    place: Place,
    key: Option<String>,
    message: String,
    help: Option<String>,
    note: Option<String>,
    snippet: Option<Snippet>,
}

impl ScenarioError {
    /// An error at a place, of a key.
    pub fn new(place: Place, key: Option<String>, message: String) -> ScenarioError {
        ScenarioError(Box::new(Content {
            place,
            key,
            message,
            help: None,
            note: None,
            snippet: None,
        }))
    }

    /// A mistake in a row of a file that a campaign names; `key` is the campaign's key that names the file.
    #[must_use]
    pub fn in_row(origin: &Origin, key: &str, message: impl Into<String>) -> ScenarioError {
        ScenarioError::new(origin.place.clone(), Some(key.to_owned()), message.into())
            .at_origin(origin)
    }

    /// The error with a suggestion.
    pub fn with_help(mut self, help: impl Into<String>) -> ScenarioError {
        self.0.help = Some(help.into());
        self
    }

    /// Puts the error where a key or value from outside of the file comes from.
    pub fn at_origin(mut self, origin: &Origin) -> ScenarioError {
        self.0.place = origin.place.clone();
        self.0.snippet.clone_from(&origin.snippet);
        self.0.note.clone_from(&origin.note);
        self
    }

    /// The error with the line that it is in.
    pub fn with_snippet(mut self, snippet: Option<Snippet>) -> ScenarioError {
        self.0.snippet = snippet;
        self
    }

    /// Where the mistake is.
    #[must_use]
    pub fn place(&self) -> &Place {
        &self.0.place
    }

    /// Line of the file, from 1; `None` if the mistake does not belong to one line.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        match self.0.place {
            Place::File { line, .. } => Some(line),
            Place::WholeFile { .. } | Place::Option { .. } => None,
        }
    }

    /// Dotted path of the key with the mistake, as `material.paper.stiffness`; `None` for a syntax error
    /// outside of any key.
    #[must_use]
    pub fn key(&self) -> Option<&str> {
        self.0.key.as_deref()
    }

    /// What is wrong, in one line.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// Information that the place does not show, such as the value that a campaign drew.
    #[must_use]
    pub fn note(&self) -> Option<&str> {
        self.0.note.as_deref()
    }

    /// What to write instead.
    #[must_use]
    pub fn help(&self) -> Option<&str> {
        self.0.help.as_deref()
    }
}

impl fmt::Display for ScenarioError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Content { place, message, help, note, snippet, .. } = &*self.0;
        let line = self.line().map_or(String::new(), |line| line.to_string());
        let indent = " ".repeat(line.len().max(1));
        write!(f, "error: {}\n{indent}--> {place}", printable_line(message))?;
        if let Some(Snippet { line: text, before, marked }) = snippet {
            let (space, marks) = (" ".repeat(*before), "^".repeat(*marked));
            write!(f, "\n{indent} |\n{line} | {text}\n{indent} | {space}{marks}")?;
        }
        if let Some(note) = note {
            write!(f, "\n{indent} = note: {}", printable_line(note))?;
        }
        if let Some(help) = help {
            write!(f, "\n{indent} = help: {}", printable_line(help))?;
        }
        Ok(())
    }
}

/// As [`Display`](fmt::Display), so that `unwrap` in a host's test shows the place.
impl fmt::Debug for ScenarioError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for ScenarioError {}

/// A warning about a scenario that can be run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// Where the warning points.
    pub place: Place,
    /// Dotted path of the key that the warning concerns.
    pub key: String,
    /// The warning, in one line.
    pub message: String,
}

/// The beginning of notices about keys and tables that have no effect.
pub const NO_EFFECT: &str = "no effect: ";

impl Notice {
    /// Whether the warning says that the key has no effect in this scenario, whatever happens in the run.
    /// `docs/design/files.md` has the criterion.
    ///
    /// ```
    /// # let tug = "outline = [[-9, -3], [9, -3], [9, 3], [-9, 3]]\nmass = 1e5\ngyradius = 5";
    /// let text = format!("time = {{ step = 0.1, duration = 9 }}\nenvironment.current = {{ speed = 1, towards = 0 }}\n[body.a]\n{tug}\n");
    /// let scenario = fenderline_scenario::Scenario::parse(&text, "tug.toml")?;
    /// let notice = &scenario.notices[0];
    /// assert_eq!(notice.key, "environment.current");
    /// assert!(notice.is_without_effect());
    /// # Ok::<(), fenderline_scenario::ScenarioError>(())
    /// ```
    #[must_use]
    pub fn is_without_effect(&self) -> bool {
        self.message.starts_with(NO_EFFECT)
    }
}

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (key, message) = (printable_line(&self.key), printable_line(&self.message));
        write!(f, "{}: `{key}`: {message}", self.place)
    }
}
