//! Colours errors and notices in the manner of rustc. The places to colour are found in the finished text, so that the
//! text without colours is the same.

use core::fmt::Write as _;

use anstyle::{AnsiColor, Style};

const ERROR: Style = AnsiColor::Red.on_default().bold();
const NOTICE: Style = AnsiColor::Yellow.on_default().bold();
const MARGIN: Style = AnsiColor::Blue.on_default().bold();
const HELP: Style = AnsiColor::Cyan.on_default().bold();

/// Words that a line may begin with after spaces, each with its colour.
const BEGINNINGS: [(&str, Style); 5] = [
    ("error:", ERROR),
    ("notice:", NOTICE),
    ("interrupted:", NOTICE),
    ("-->", MARGIN),
    ("= help:", HELP),
];

/// Colours a text: the words `error`, `notice` and `help`, the margin of a quoted line of a file, and the marks below
/// that line.
pub(super) fn painted(text: &str) -> String {
    text.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

fn line(line: &str) -> String {
    let bare = line.trim_start();
    let indent = &line[..line.len() - bare.len()];
    let beginning = BEGINNINGS.iter().find(|(word, _)| bare.starts_with(word));
    if let Some((word, style)) = beginning {
        return format!("{indent}{style}{word}{style:#}{}", &bare[word.len()..]);
    }
    let Some((margin, quoted)) = quoted(line) else { return line.to_owned() };
    let mut painted = format!("{MARGIN}{margin}{MARGIN:#}");
    let is_marks = quoted.contains('^') && quoted.chars().all(|c| c == ' ' || c == '^');
    let style = if is_marks { ERROR } else { Style::new() };
    let _ = write!(painted, "{style}{quoted}{style:#}");
    painted
}

/// Splits a quoted line of a file into its margin (spaces, perhaps a line number, and a bar) and the rest.
fn quoted(line: &str) -> Option<(&str, &str)> {
    let bar = line.find('|')?;
    let number = line[..bar].strip_suffix(' ')?.trim_start();
    number.chars().all(|c| c.is_ascii_digit()).then(|| line.split_at(bar + 1))
}

#[cfg(test)]
mod tests {
    use super::painted;

    #[test]
    fn an_error_with_its_place_is_coloured_and_else_unchanged() {
        let plain = "error: `a|b` is no key\n   --> tug.toml:12:1\n   |\n12 | a|b = 1\n   | ^^^\n   = help: write c";
        let coloured = painted(plain);
        let lines: Vec<&str> = coloured.lines().collect();
        assert_eq!(lines[0], "\u{1b}[1m\u{1b}[31merror:\u{1b}[0m `a|b` is no key");
        assert_eq!(lines[1], "   \u{1b}[1m\u{1b}[34m-->\u{1b}[0m tug.toml:12:1");
        assert_eq!(lines[3], "\u{1b}[1m\u{1b}[34m12 |\u{1b}[0m a|b = 1");
        assert_eq!(lines[4], "\u{1b}[1m\u{1b}[34m   |\u{1b}[0m\u{1b}[1m\u{1b}[31m ^^^\u{1b}[0m");
        assert_eq!(lines[5], "   \u{1b}[1m\u{1b}[36m= help:\u{1b}[0m write c");
        assert_eq!(anstream::adapter::strip_str(&coloured).to_string(), plain);
    }

    #[test]
    fn other_lines_stay() {
        for text in ["", "a | b", "12x | y", "the end\n"] {
            assert_eq!(painted(text), text);
        }
    }
}
