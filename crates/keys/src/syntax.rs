//! Parses a text into a TOML tree, and turns the errors of the TOML parser into errors of this crate.

use toml::de::DeTable;

use crate::error::ScenarioError;
use crate::nesting::too_deep;
use crate::place::{Span, quoted};
use crate::sources::Sources;

/// Size of the largest scenario file that the program reads, in bytes.
const LARGEST_FILE: usize = 16 << 20;

/// Parses the file.
pub fn parse<'a>(sources: &Sources<'a>) -> Result<DeTable<'a>, ScenarioError> {
    let bytes = sources.text.len();
    if bytes > LARGEST_FILE {
        let message = format!(
            "the file has {bytes} bytes, but a scenario may have at most {} MiB",
            LARGEST_FILE >> 20
        );
        return Err(sources.file_error(message));
    }
    let document = DeTable::parse(sources.text).map_err(|error| broken(sources, &error))?;
    Ok(document.into_inner())
}

/// Turns an error of the TOML parser into an error of this crate.
fn broken(sources: &Sources<'_>, error: &toml::de::Error) -> ScenarioError {
    let is_too_deep = error.message().contains("recursion");
    let at = if is_too_deep { too_deep(sources.text) } else { error.span() };
    let span = at.unwrap_or(0..0);
    let key = enclosing_key(sources.text, span.start);
    if error.message() == "duplicate key" {
        return given_twice(sources, &span, key);
    }
    let message = match error.message() {
        _ if is_too_deep => "values are nested too deeply for a scenario".to_owned(),
        message => format!("this is not TOML: {message}"),
    };
    let error = sources.syntax_error(&span, key, message);
    let unquoted = error.message().contains("must be quoted");
    if unquoted || follows_a_number(&sources.text[..sources.text.floor_char_boundary(span.start)]) {
        return error.with_help(
            "put a text or a number with a unit in quotes, \"0.1 s\"; write a decimal point, 0.1",
        );
    }
    error
}

/// The error for a key or table that the file gives twice; the error names the line of the first one.
fn given_twice(sources: &Sources<'_>, span: &Span, key: Option<String>) -> ScenarioError {
    let quotes = ['"', '\''];
    let name = sources.text.get(span.clone()).unwrap_or_default().trim_matches(quotes);
    let is_named =
        |key: &&str| key.rsplit('.').next().is_some_and(|last| last.trim_matches(quotes) == name);
    let message = match key.as_deref().filter(is_named) {
        None => format!("{} is given twice", quoted(name)),
        Some(key) => match first_line(&sources.text[..span.start], key) {
            None => format!("`{key}` is given twice"),
            Some(line) => format!("`{key}` is given twice; it is first given in line {line}"),
        },
    };
    sources
        .syntax_error(span, key, message)
        .with_help("give the key or table only once, or rename one of the two")
}

/// Number, from 1, of the line that first gives a key or a table, within the text `before` the second occurrence of the
/// key or table.
fn first_line(before: &str, key: &str) -> Option<usize> {
    let (above, _) = before.rsplit_once('\n')?;
    let second = &before[above.len() + 1..];
    if header(second).is_some() || second.trim_start().starts_with('[') {
        return above
            .lines()
            .position(|line| header(line).is_some_and(|it| it == key))
            .map(|i| i + 1);
    }
    // A key is given twice in one table. Search only this table, because the tables of a list have the same keys.
    let name = key.rsplit('.').next().unwrap_or(key);
    let own = above.lines().enumerate().collect::<Vec<_>>();
    let own = own.iter().rev().take_while(|(_, line)| header(line).is_none());
    let is_it = |line: &str| line.split_once('=').is_some_and(|(key, _)| key.trim() == name);
    own.filter(|(_, line)| is_it(line)).last().map(|(index, _)| index + 1)
}

/// True if the text ends after a number, as in `step = 0.1 ` or `step = 0`, so that an unquoted unit or a decimal comma
/// is likely to follow.
fn follows_a_number(before: &str) -> bool {
    let line = before.rsplit('\n').next().unwrap_or_default();
    line.rsplit_once(['=', '[', ',']).is_some_and(|(_, value)| {
        value.trim().trim_end_matches(char::is_alphabetic).trim().parse::<f64>().is_ok()
    })
}

/// The key to which a place in broken text most likely belongs: the text before the `=` in the line of the place, in
/// the table whose header stands last above this line.
fn enclosing_key(text: &str, position: usize) -> Option<String> {
    let position = text.floor_char_boundary(position.min(text.len()));
    let line_start = text[..position].rfind('\n').map_or(0, |newline| newline + 1);
    let line = text[line_start..].lines().next().unwrap_or_default();
    if let Some(header) = header(line) {
        return Some(header);
    }
    let table = text[..line_start].lines().rev().find_map(header);
    let key = line.split_once('=').and_then(|(key, _)| plausible_key(key));
    match (table, key) {
        (Some(table), Some(key)) => Some(format!("{table}.{key}")),
        (table, key) => table.or(key),
    }
}

/// The table's name in a header line like `[body.tug]` or `[[pair]]`, even if the closing bracket is missing. The names
/// of a scenario's tables start with a letter, unlike a line with points of an outline.
fn header(line: &str) -> Option<String> {
    let inner = line.trim_start().strip_prefix('[')?.trim_start_matches('[');
    let inner = inner.split(']').next().filter(|inner| inner.starts_with(char::is_alphabetic));
    plausible_key(inner?)
}

/// Returns the text if it may be a dotted key.
fn plausible_key(text: &str) -> Option<String> {
    const LONGEST: usize = 120;
    let text = text.trim();
    let is_key_char = |c: char| c.is_alphanumeric() || "_-. \"'".contains(c);
    let first_fits = text.starts_with(|c: char| c.is_alphanumeric() || "_\"'".contains(c));
    (first_fits && text.len() <= LONGEST && text.chars().all(is_key_char)).then(|| text.to_owned())
}

#[cfg(test)]
mod tests {
    use super::enclosing_key;

    #[test]
    fn broken_text_is_placed_under_its_key() {
        let text = "title = 1\n[body.tug]\nmass = = 2\nx\n[[pair]\n";
        let key = |part: &str| enclosing_key(text, text.find(part).unwrap());
        assert_eq!(key("1").as_deref(), Some("title"));
        assert_eq!(key("= 2").as_deref(), Some("body.tug.mass"));
        assert_eq!(key("x").as_deref(), Some("body.tug"));
        assert_eq!(key("[pair").as_deref(), Some("pair"));
        assert_eq!(enclosing_key("[[[[", 2), None);
        assert_eq!(enclosing_key("", 0), None);
    }
}
