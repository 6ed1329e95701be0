//! The origin of a key or value that does not stand in the scenario file itself.

use crate::place::{Place, Snippet, cut};

/// The origin of a key or value of an [`Override`](crate::overrides::Override), such as a line of a campaign's file or
/// a row of a table. Errors about the override point to this origin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// Place at which the key or value was written.
    pub place: Place,
    /// The line of the file in which the key or value was written.
    pub snippet: Option<Snippet>,
    /// Further information that the place does not show, such as the random value that a campaign drew.
    pub note: Option<String>,
}

impl Origin {
    /// The origin of a key or value in a line of a file. `text` is the whole line; the key or value starts at the
    /// character `column` (from 1) and is `length` characters long.
    #[must_use]
    pub fn line(name: &str, line: usize, column: usize, text: &str, length: usize) -> Origin {
        let start = |characters: usize| {
            text.char_indices().nth(characters).map_or(text.len(), |(byte, _)| byte)
        };
        let (begin, end) = (start(column - 1), start(column - 1 + length));
        let snippet = cut(&text[..begin], &text[begin..end], text[end..].trim_end());
        let place = Place::File { name: name.to_owned(), line, column };
        Origin { place, snippet: Some(snippet), note: None }
    }

    /// The origin of a value in a file without lines of text.
    #[must_use]
    pub fn file(name: &str) -> Origin {
        Origin { place: Place::WholeFile { name: name.to_owned() }, snippet: None, note: None }
    }

    /// Adds a sentence that errors print below the place of the origin.
    #[must_use]
    pub fn with_note(mut self, note: impl Into<String>) -> Origin {
        self.note = Some(note.into());
        self
    }
}
