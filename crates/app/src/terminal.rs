//! What the program says. Writing never panics: a reader that went away ends the command quietly. Names and titles of
//! users reach the terminal here alone, and nothing of them that it would obey.

use std::io::{self, Write as _};

use fenderline_scenario::{escaped_json, printable_text};

use crate::failure::Failure;

/// Prints `text` to standard output.
///
/// # Errors
/// [`Failure::ReaderGone`] where the pipe is closed; a failed case where it cannot be written, as
/// on a full disk.
pub(crate) fn say(text: &str) -> Result<(), Failure> {
    put(&printable_text(text))
}

/// Prints a text of JSON to standard output, in which no value is changed: what a terminal would obey is escaped.
///
/// # Errors
/// As [`say`].
pub(crate) fn say_json(text: &str) -> Result<(), Failure> {
    put(&escaped_json(text))
}

fn put(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|e| match e.kind() {
        io::ErrorKind::BrokenPipe => Failure::ReaderGone,
        _ => Failure::case(format_args!("cannot write to standard output: {e}")),
    })
}

/// Prints a line to standard error, where nothing better can be done if that fails.
pub(crate) fn tell(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", printable_text(line.trim_end()));
}
