//! What the program says. Writing never panics: a reader that went away ends the command quietly.

use std::io::{self, Write as _};

use crate::failure::Failure;

/// Prints `text` to standard output.
///
/// # Errors
/// [`Failure::ReaderGone`] where the pipe is closed; a failed case where it cannot be written, as
/// on a full disk.
pub(crate) fn say(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|e| match e.kind() {
        io::ErrorKind::BrokenPipe => Failure::ReaderGone,
        _ => Failure::case(format_args!("cannot write to standard output: {e}")),
    })
}

/// Prints a line to standard error, where nothing better can be done if that fails.
pub(crate) fn tell(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", line.trim_end());
}
