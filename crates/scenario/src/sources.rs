//! The texts that a scenario comes from, as one line of positions: the file first, then one position
//! for each override. Every span in the merged document says by its start which of them it is from.

use core::ops::Range;

use crate::error::{Place, ScenarioError, Snippet};
use crate::overrides::Override;
use crate::printable::printable_char;

/// A range of positions: bytes of the file, or the one position of an override.
pub(crate) type Span = Range<usize>;

/// The file and the overrides on top of it.
#[derive(Clone, Copy)]
pub(crate) struct Sources<'a> {
    pub(crate) file_name: &'a str,
    pub(crate) text: &'a str,
    pub(crate) overrides: &'a [Override],
}

impl Sources<'_> {
    /// The span of everything that the override of this number brings.
    pub(crate) fn override_span(&self, index: usize) -> Span {
        let position = self.text.len() + 1 + index;
        position..position
    }

    /// Where a span starts.
    pub(crate) fn place(&self, span: &Span) -> Place {
        if let Some(index) = span.start.checked_sub(self.text.len() + 1) {
            return Place::Option { text: self.overrides[index].shown().to_owned() };
        }
        let before = &self.text[..self.boundary(span.start)];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Place::File {
            name: self.file_name.to_owned(),
            line: before.bytes().filter(|byte| *byte == b'\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
        }
    }

    /// An error about `key` at a span.
    pub(crate) fn error(
        &self,
        span: &Span,
        key: &str,
        message: impl Into<String>,
    ) -> ScenarioError {
        self.syntax_error(span, Some(key.to_owned()), message.into())
    }

    /// An error that need not belong to a key.
    pub(crate) fn syntax_error(
        &self,
        span: &Span,
        key: Option<String>,
        message: String,
    ) -> ScenarioError {
        ScenarioError::new(self.place(span), key, message).with_snippet(self.snippet(span))
    }

    /// An error about the file as a whole.
    pub(crate) fn file_error(&self, message: impl Into<String>) -> ScenarioError {
        let place = Place::WholeFile { name: self.file_name.to_owned() };
        ScenarioError::new(place, None, message.into())
    }

    /// The line that a span starts in; `None` for an override, which its place shows in full.
    fn snippet(&self, span: &Span) -> Option<Snippet> {
        if span.start > self.text.len() {
            return None;
        }
        let (start, end) = (self.boundary(span.start), self.boundary(span.end));
        let line_start = self.text[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let line_end = self.text[start..].find('\n').map_or(self.text.len(), |n| start + n);
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

/// A line in three parts, cut on both sides so that the marked part shows in a line of a terminal.
fn cut(before: &str, marked: &str, after: &str) -> Snippet {
    const BEFORE: usize = 40;
    const MARKED: usize = 40;
    const AFTER: usize = 30;
    let mut line = String::new();
    let kept: Vec<char> = before.chars().rev().take(BEFORE + 1).collect();
    if kept.len() > BEFORE {
        line.push('…');
        line.extend(kept[..BEFORE].iter().rev().copied().map(printable_char));
    } else {
        line.extend(kept.iter().rev().copied().map(printable_char));
    }
    let before_count = line.chars().count();
    let (marked, marked_cut) = first(marked, MARKED);
    line.push_str(&marked);
    let marked_count = line.chars().count() - before_count;
    if marked_cut {
        line.push('…');
    } else {
        let (after, after_cut) = first(after, AFTER);
        line.push_str(&after);
        if after_cut {
            line.push('…');
        }
    }
    Snippet { line: line.trim_end().to_owned(), before: before_count, marked: marked_count.max(1) }
}

/// The first `count` characters, fit to print, and whether there are more.
pub(crate) fn first(text: &str, count: usize) -> (String, bool) {
    let mut chars = text.chars();
    let kept = chars.by_ref().take(count).map(printable_char).collect();
    (kept, chars.next().is_some())
}

/// A short form of a user's text for a message: in quotes, cut, nothing in it that a terminal would
/// obey.
pub(crate) fn quoted(text: &str) -> String {
    let (kept, is_cut) = first(text, 40);
    if is_cut { format!("\"{kept}…\"") } else { format!("\"{kept}\"") }
}

#[cfg(test)]
mod tests {
    use super::{cut, quoted};

    #[test]
    fn long_lines_are_cut_on_both_sides_of_the_mark() {
        let snippet = cut(&"a".repeat(1_000_000), "key", &"b".repeat(1_000_000));
        assert_eq!(snippet.line.chars().count(), 1 + 40 + 3 + 30 + 1);
        assert_eq!((snippet.before, snippet.marked), (41, 3));
        assert_eq!(cut("", &"k".repeat(99), "").line, format!("{}…", "k".repeat(40)));
        assert_eq!(cut("x = ", "", "").marked, 1);
    }

    #[test]
    fn nothing_reaches_the_terminal_that_it_would_obey() {
        assert_eq!(cut("a\tb\u{1b}[31m", "c\u{202e}", "").line, "a b\u{FFFD}[31mc\u{FFFD}");
        assert_eq!(quoted("\u{7}x"), "\"\u{FFFD}x\"");
    }
}
