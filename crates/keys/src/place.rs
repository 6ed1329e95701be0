//! Places in files, and the lines of files that errors show.

use core::fmt;
use core::ops::Range;

use crate::printable::{printable_char, printable_line};

/// A range of positions in the sources of a scenario: bytes of the file, or the position of an override's key or value.
pub type Span = Range<usize>;

/// The place to which an error or a warning points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// A place in a file.
    File {
        /// The name under which the caller passed the file.
        name: String,
        /// Number of the line, from 1.
        line: usize,
        /// Column in characters, from 1.
        column: usize,
    },
    /// A file as a whole.
    WholeFile {
        /// The name under which the caller passed the file.
        name: String,
    },
    /// An option of the command line, as the user may have written it: `--set time.step=0.5`.
    Option {
        /// The option.
        text: String,
    },
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::File { name, line, column } => {
                write!(f, "{}:{line}:{column}", printable_line(name))
            }
            Place::WholeFile { name } => f.write_str(&printable_line(name)),
            Place::Option { text } => f.write_str(&printable_line(text)),
        }
    }
}

/// A line of the file that an error shows, cut to the width of a terminal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Snippet {
    /// The text of the line.
    pub line: String,
    /// Number of characters in `line` before the marked characters.
    pub before: usize,
    /// Number of characters to mark.
    pub marked: usize,
}

/// Joins the three parts of a line and cuts it on both sides, so that its marked part can be shown in one line of a
/// terminal.
pub fn cut(before: &str, marked: &str, after: &str) -> Snippet {
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

/// The first `count` characters of a text, safe to print, and whether the text has more characters.
pub fn first(text: &str, count: usize) -> (String, bool) {
    let mut chars = text.chars();
    let kept = chars.by_ref().take(count).map(printable_char).collect();
    (kept, chars.next().is_some())
}

/// A user's text for a message: in quotes, shortened and safe to print.
pub fn quoted(text: &str) -> String {
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
    fn control_characters_do_not_reach_the_terminal() {
        assert_eq!(cut("a\tb\u{1b}[31m", "c\u{202e}", "").line, "a b\u{FFFD}[31mc\u{FFFD}");
        assert_eq!(quoted("\u{7}x"), "\"\u{FFFD}x\"");
    }
}
