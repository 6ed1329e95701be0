//! Errors and warnings about a scenario file: what is wrong with the file, and at which place.

use core::fmt;

use crate::origin::Origin;
pub use crate::place::Place;
use crate::place::Snippet;
use crate::printable::printable_line;

/// The error for a scenario that cannot be run: one mistake, its place in the file, and if possible what to write
/// instead. `Display` prints the error as several lines, one of which is the line of the file with the mistake.
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
    /// Makes an error with the place of the mistake, the key that has the mistake, and a message.
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

    /// Makes the error for a mistake in a row of a file that a campaign names; `key` is the key of the campaign under
    /// which the file is named.
    #[must_use]
    pub fn in_row(origin: &Origin, key: &str, message: impl Into<String>) -> ScenarioError {
        ScenarioError::new(origin.place.clone(), Some(key.to_owned()), message.into())
            .at_origin(origin)
    }

    /// Adds to the error a suggestion of what to write instead.
    pub fn with_help(mut self, help: impl Into<String>) -> ScenarioError {
        self.0.help = Some(help.into());
        self
    }

    /// Moves the error to the place from which a key or value came that does not stand in the scenario file, such as a
    /// command-line option.
    pub fn at_origin(mut self, origin: &Origin) -> ScenarioError {
        self.0.place = origin.place.clone();
        self.0.snippet.clone_from(&origin.snippet);
        self.0.note.clone_from(&origin.note);
        self
    }

    /// Adds to the error the line of the file that contains the mistake.
    pub fn with_snippet(mut self, snippet: Option<Snippet>) -> ScenarioError {
        self.0.snippet = snippet;
        self
    }

    /// Where the mistake is.
    #[must_use]
    pub fn place(&self) -> &Place {
        &self.0.place
    }

    /// Number of the line with the mistake in the file, counted from 1; `None` if the mistake does not belong to one
    /// line.
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

    /// Further information about the mistake that the place in the file does not show, such as the random value that a
    /// campaign drew for the key.
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

/// Prints the error as [`Display`](fmt::Display) does, so that a failing `unwrap` in a test shows the place of the
/// mistake.
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

/// The first words of every warning about a key or table that has no effect.
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
