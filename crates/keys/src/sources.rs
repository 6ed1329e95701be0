//! The texts from which a scenario is read, with one numbering of all positions: first the bytes of the file, then for
//! each override a position for its key and a position for its value. The start of a span therefore shows to which text
//! the span belongs.

use core::cell::OnceCell;

use crate::error::ScenarioError;
use crate::origin::Origin;
use crate::overrides::Override;
use crate::place::{Place, Snippet, cut};
pub use crate::place::{Span, quoted};

/// The text of a scenario file, and the overrides that replace values in the file.
#[derive(Clone)]
pub struct Sources<'a> {
    /// The name of the file.
    pub file_name: &'a str,
    /// The text of the file.
    pub text: &'a str,
    /// The overrides that replace values of keys in the file.
    pub overrides: &'a [Override],
    /// Marks for finding lines and columns. The marks are computed when the first place is asked for, because a
    /// scenario without errors and warnings needs no marks.
    marks: OnceCell<Vec<Mark>>,
}

/// A mark: a byte of the text whose line and column are known. The text has a mark at the start of each line, and every
/// few hundred bytes in a long line. The search for a line and column scans the text from the nearest mark; a scan from
/// the start of the text would take quadratic time in a file with a warning on every line.
#[derive(Clone, Copy, Debug)]
struct Mark {
    byte: usize,
    /// Number of the line, from 0.
    line: usize,
    /// Column in characters, from 0.
    column: usize,
}

/// Number of bytes between two marks in a long line, to within one character.
const BETWEEN_MARKS: usize = 256;

/// Computes all marks of a text in one pass.
fn marks(text: &str) -> Vec<Mark> {
    let mut marks = vec![Mark { byte: 0, line: 0, column: 0 }];
    let mut here = marks[0];
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        here.byte += c.len_utf8();
        here.column += 1;
        // A carriage return alone ends a line too.
        if c == '\n' || (c == '\r' && chars.peek() != Some(&'\n')) {
            here = Mark { line: here.line + 1, column: 0, ..here };
        }
        if here.column == 0 || here.byte >= marks[marks.len() - 1].byte + BETWEEN_MARKS {
            marks.push(here);
        }
    }
    marks
}

/// How many bytes before and after a place a snippet looks at: more than [`cut`] shows. A list of 20,000 values may
/// stand in one line, and each value has a snippet.
const NEAR: usize = 512;

impl<'a> Sources<'a> {
    /// Makes the sources from the text of a file and the overrides.
    pub fn new(file_name: &'a str, text: &'a str, overrides: &'a [Override]) -> Sources<'a> {
        Sources { file_name, text, overrides, marks: OnceCell::new() }
    }
}

impl Sources<'_> {
    /// The span of the key of the override with the index `index`.
    pub fn override_key_span(&self, index: usize) -> Span {
        let position = self.text.len() + 1 + 2 * index;
        position..position
    }

    /// The span of the value, and of every part of the value, of the override with the index `index`.
    pub fn override_span(&self, index: usize) -> Span {
        let position = self.text.len() + 2 + 2 * index;
        position..position
    }

    /// The override to which a span belongs, and the origin of the override's key or value if it is known.
    fn override_of(&self, span: &Span) -> Option<(&Override, Option<&Origin>)> {
        let position = span.start.checked_sub(self.text.len() + 1)?;
        let own = &self.overrides[position / 2];
        let origin = if position % 2 == 0 { own.key_origin() } else { own.origin() };
        Some((own, origin))
    }

    /// Makes the origin of values that stand in another file, which this file names at the span `span`: errors about
    /// these values point to the span.
    pub fn origin(&self, span: &Span) -> Origin {
        Origin { place: self.place(span), snippet: self.snippet(span), note: None }
    }

    /// The place at which a span starts.
    pub fn place(&self, span: &Span) -> Place {
        match self.override_of(span) {
            Some((_, Some(origin))) => return origin.place.clone(),
            Some((own, None)) => return Place::Option { text: own.shown().to_owned() },
            None => {}
        }
        let at = self.boundary(span.start);
        let marks = self.marks.get_or_init(|| marks(self.text));
        // The first mark is at byte 0, so some mark is at or before any place.
        let mark = marks[marks.partition_point(|mark| mark.byte <= at) - 1];
        Place::File {
            name: self.file_name.to_owned(),
            line: mark.line + 1,
            column: mark.column + self.text[mark.byte..at].chars().count() + 1,
        }
    }

    /// An error about the key `key` that points to the span `span`.
    pub fn error(&self, span: &Span, key: &str, message: impl Into<String>) -> ScenarioError {
        self.syntax_error(span, Some(key.to_owned()), message.into())
    }

    /// An error that points to the span `span` and need not belong to a key.
    pub fn syntax_error(&self, span: &Span, key: Option<String>, message: String) -> ScenarioError {
        let error = ScenarioError::new(self.place(span), key, message);
        match self.override_of(span) {
            Some((_, Some(origin))) => error.at_origin(origin),
            _ => error.with_snippet(self.snippet(span)),
        }
    }

    /// An error about the file as a whole.
    pub fn file_error(&self, message: impl Into<String>) -> ScenarioError {
        let place = Place::WholeFile { name: self.file_name.to_owned() };
        ScenarioError::new(place, None, message.into())
    }

    /// The line in which a span starts; `None` for an override, whose place shows the whole override.
    fn snippet(&self, span: &Span) -> Option<Snippet> {
        if span.start > self.text.len() {
            return None;
        }
        let (start, end) = (self.boundary(span.start), self.boundary(span.end));
        let (from, to) = (self.boundary(start.saturating_sub(NEAR)), self.boundary(start + NEAR));
        let ends = ['\n', '\r'];
        let line_start = self.text[from..start].rfind(ends).map_or(from, |n| from + n + 1);
        let line_end = self.text[start..to].find(ends).map_or(to, |n| start + n);
        let before = &self.text[line_start..start];
        let marked = &self.text[start..end.clamp(start, line_end)];
        let after = &self.text[start + marked.len()..line_end];
        Some(cut(before, marked, after.trim_end()))
    }

    /// The nearest character boundary at or before a position.
    fn boundary(&self, position: usize) -> usize {
        self.text.floor_char_boundary(position.min(self.text.len()))
    }
}

#[cfg(test)]
mod tests {
    use super::{BETWEEN_MARKS, NEAR, Place, Sources, cut, marks};

    #[test]
    fn a_place_agrees_with_counting_from_the_start() {
        let long = "x".repeat(BETWEEN_MARKS - 1);
        let text = format!("a\n\r\nüö{long}大{long}{long}\nlast 👍{long}{long}end");
        let sources = Sources::new("f", &text, &[]);
        for (byte, _) in text.char_indices().chain([(text.len(), ' ')]) {
            let before = &text[..byte];
            let start = before.rfind('\n').map_or(0, |newline| newline + 1);
            let place = Place::File {
                name: "f".to_owned(),
                line: before.matches('\n').count() + 1,
                column: before[start..].chars().count() + 1,
            };
            assert_eq!(sources.place(&(byte..byte)), place);
        }
    }

    /// However long the line is: a snippet looks only at what is near.
    #[test]
    fn a_snippet_is_that_of_the_whole_line() {
        let long = "ü".repeat(NEAR);
        let text = format!("a  \nb大{long}c d{long} \nlast {long}");
        let sources = Sources::new("f", &text, &[]);
        let places: Vec<usize> = text.char_indices().map(|(byte, _)| byte).collect();
        for (index, &start) in places.iter().enumerate() {
            for &end in [1, 3, 60].iter().filter_map(|more| places.get(index + more)) {
                let line_start = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
                let line_end = text[start..].find('\n').map_or(text.len(), |n| start + n);
                let end_here = end.min(line_end);
                let whole = cut(
                    &text[line_start..start],
                    &text[start..end_here],
                    text[end_here..line_end].trim_end(),
                );
                assert_eq!(sources.snippet(&(start..end)), Some(whole), "{start}..{end}");
            }
        }
    }

    #[test]
    fn finding_a_place_scans_a_bounded_number_of_bytes() {
        // In a text of one line and in one of many.
        for text in ["a".repeat(100_000), "大".repeat(50_000), "key = 1\n".repeat(10_000)] {
            let marks = marks(&text);
            let longest = marks.windows(2).map(|two| two[1].byte - two[0].byte).max();
            assert!(longest.is_some_and(|bytes| bytes <= BETWEEN_MARKS + 4), "{longest:?}");
            assert!(marks.len() <= text.len() / 8 + 2, "{} marks", marks.len());
        }
    }
}
