//! Where a key or value that is set from outside of a scenario's file comes from.

use crate::place::{Place, Snippet, cut};

/// Where a key or a value of an [`Override`](crate::overrides::Override) comes from: a line of a campaign's file, a row of a table. Errors about
/// the override point there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// Where the value was written.
    pub place: Place,
    /// The line of the value.
    pub snippet: Option<Snippet>,
    /// Information that the place does not show, such as the value that was drawn.
    pub note: Option<String>,
}

impl Origin {
    /// Text in a line of a file: `text` is the whole line, `column` (from 1, in characters) and `length` are the place
    /// and length of the text in the line.
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

    /// A file that has no lines.
    #[must_use]
    pub fn file(name: &str) -> Origin {
        Origin { place: Place::WholeFile { name: name.to_owned() }, snippet: None, note: None }
    }

    /// The same with a sentence that errors print below the place.
    #[must_use]
    pub fn with_note(mut self, note: impl Into<String>) -> Origin {
        self.note = Some(note.into());
        self
    }
}
