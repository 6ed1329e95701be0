//! Output to the terminal. Writing never panics: a reader that closed the pipe ends the command quietly. Control characters
//! in users' names and titles are removed here.

use std::io::{self, Write as _};

use fenderline_scenario::{escaped_json, printable_text};

use crate::failure::Failure;

/// Prints `text` to standard output.
///
/// # Errors
/// [`Failure::ReaderGone`] if the pipe is closed; a failed case if it cannot be written, as on a full disk.
pub(crate) fn say(text: &str) -> Result<(), Failure> {
    put(&printable_text(text))
}

/// Prints JSON to standard output. Control characters are escaped, so that no value changes.
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

/// Prints a line to standard error. A failure is ignored.
pub(crate) fn tell(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", printable_text(line.trim_end()));
}
