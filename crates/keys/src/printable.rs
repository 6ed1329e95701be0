//! Makes texts from users safe to print, by removing characters that control a terminal.

use core::fmt::Write as _;
use std::borrow::Cow;

use fenderline_contact::DisplayNumber;

/// The character that replaces a character that must not be printed.
const REPLACED: char = '\u{FFFD}';

/// Makes a text of one line safe to print: U+FFFD replaces control characters, line breaks and characters that reorder
/// a line.
#[must_use]
pub fn printable_line(text: &str) -> Cow<'_, str> {
    without(text, is_control)
}

/// Makes a text of several lines safe to print; line breaks and tabs stay.
#[must_use]
pub fn printable_text(text: &str) -> Cow<'_, str> {
    without(text, |c| !matches!(c, '\n' | '\t') && is_control(c))
}

fn without(text: &str, is_bad: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.contains(&is_bad) {
        return Cow::Borrowed(text);
    }
    Cow::Owned(text.chars().map(|c| if is_bad(c) { REPLACED } else { c }).collect())
}

/// Makes a JSON text safe to print without changing its value. Characters that control a terminal occur only within
/// strings, so the function escapes them there.
#[must_use]
pub fn escaped_json(text: &str) -> Cow<'_, str> {
    let is_bad = |c: char| c != '\n' && is_control(c);
    if !text.contains(is_bad) {
        return Cow::Borrowed(text);
    }
    let mut escaped = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_bad(c) {
            // All of them are below U+10000, so four digits suffice.
            let _ = write!(escaped, "\\u{:04x}", u32::from(c));
        } else {
            escaped.push(c);
        }
    }
    Cow::Owned(escaped)
}

/// Writes a number in the shortest form that reads back to the same number, in scientific notation if it would have
/// many digits.
#[must_use]
pub fn printable_number(value: f64) -> String {
    DisplayNumber(value).to_string()
}

/// The form in which a character is printed in a line of a file that an error shows. A tab becomes a space, so that the
/// marks below a line stay aligned.
pub fn printable_char(c: char) -> char {
    match c {
        '\t' => ' ',
        c if is_control(c) => REPLACED,
        c => c,
    }
}

/// Whether a character controls a terminal or reorders a line: control characters, line and paragraph separators, and
/// the marks, overrides and isolates of writing direction (Unicode Standard Annex 9).
fn is_control(c: char) -> bool {
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
    fn very_large_and_small_numbers_are_printed_in_scientific_notation() {
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
