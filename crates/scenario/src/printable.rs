//! Texts of users as a terminal may have them: nothing in them that it would obey.

use core::fmt::Write as _;
use std::borrow::Cow;

use fenderline_contact::DisplayNumber;

/// What stands for a character that is not shown.
const REPLACED: char = '\u{FFFD}';

/// A text of one line without what a terminal would obey: control characters and those that reorder a line are
/// replaced by U+FFFD, line breaks too.
#[must_use]
pub fn printable_line(text: &str) -> Cow<'_, str> {
    without(text, is_obeyed)
}

/// A text of several lines without what a terminal would obey; its line breaks and tabs stay.
#[must_use]
pub fn printable_text(text: &str) -> Cow<'_, str> {
    without(text, |c| !matches!(c, '\n' | '\t') && is_obeyed(c))
}

fn without(text: &str, is_bad: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.contains(&is_bad) {
        return Cow::Borrowed(text);
    }
    Cow::Owned(text.chars().map(|c| if is_bad(c) { REPLACED } else { c }).collect())
}

/// A text of JSON in which no character is left that a terminal would obey, of the same value: such characters stand in
/// strings alone there, and are escaped.
#[must_use]
pub fn escaped_json(text: &str) -> Cow<'_, str> {
    let is_bad = |c: char| c != '\n' && is_obeyed(c);
    if !text.contains(is_bad) {
        return Cow::Borrowed(text);
    }
    let mut escaped = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_bad(c) {
            // All of them are of the plane that four digits reach.
            let _ = write!(escaped, "\\u{:04x}", u32::from(c));
        } else {
            escaped.push(c);
        }
    }
    Cow::Owned(escaped)
}

/// A number in the shortest form that reads back to it, by powers of ten where its digits would run away.
#[must_use]
pub fn printable_number(value: f64) -> String {
    DisplayNumber(value).to_string()
}

/// One character as it is printed in a snippet of a file: a tab is a space there, so that marks stay below what
/// they mark.
pub(crate) fn printable_char(c: char) -> char {
    match c {
        '\t' => ' ',
        c if is_obeyed(c) => REPLACED,
        c => c,
    }
}

/// Whether a terminal would obey a character, or show the line in another order because of it: controls, line and
/// paragraph separators, and the marks, overrides and isolates of writing direction (Unicode Standard Annex 9).
fn is_obeyed(c: char) -> bool {
    c.is_control()
        || matches!(
            c,
            '\u{061C}' | '\u{200E}' | '\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2066}'..='\u{206F}'
        )
}

#[cfg(test)]
mod tests {
    use super::{escaped_json, printable_line, printable_number, printable_text};

    #[test]
    fn a_number_has_no_three_hundred_digits() {
        let numbers = [0.0, -0.1, 1e-5, 1852.0, 1e308, 5e-324, -1e15].map(printable_number);
        assert_eq!(numbers, ["0", "-0.1", "0.00001", "1852", "1e308", "5e-324", "-1e15"]);
    }

    #[test]
    fn a_right_to_left_override_and_its_relatives_are_replaced() {
        for c in "\u{202e}\u{202d}\u{2066}\u{2069}\u{200f}\u{61c}\u{2028}\u{1b}\u{9b}\u{7f}\r\u{0}"
            .chars()
        {
            assert_eq!(printable_line(&format!("a{c}b")), "a\u{FFFD}b", "{c:?}");
            assert_eq!(printable_text(&format!("a{c}b")), "a\u{FFFD}b", "{c:?}");
        }
        assert_eq!(
            escaped_json("{\n\"a\": \"\u{202e}b\u{9b}\"\n}"),
            "{\n\"a\": \"\\u202eb\\u009b\"\n}"
        );
        assert_eq!(printable_line("a\nb\tc"), "a\u{FFFD}b\u{FFFD}c");
        assert_eq!(printable_text("a\nb\tc"), "a\nb\tc");
        assert_eq!(printable_line("Übersee 大阪 نص 1 % 👍"), "Übersee 大阪 نص 1 % 👍");
    }
}
