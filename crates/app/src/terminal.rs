//! Output to the terminal. Writing never panics: if the reader of a pipe has closed it, the command ends quietly. This
//! module removes control characters from users' names and titles.

mod colour;

use std::io::{self, Write as _};
use std::sync::atomic::{AtomicBool, Ordering};

use fenderline_scenario::{escaped_json, printable_text};

use crate::failure::Failure;

/// Whether the user wants only errors and answers; an answer is the output that the user asked for, such as a list.
static IS_QUIET: AtomicBool = AtomicBool::new(false);

/// Whether only answers go to standard output, and no words about what a command has done.
static IS_ANSWER_ONLY: AtomicBool = AtomicBool::new(false);

/// From now on only errors are printed, and answers: the output that the user asked for.
pub(crate) fn be_quiet() {
    IS_QUIET.store(true, Ordering::Relaxed);
}

/// Whether only errors are printed, and answers: the output that the user asked for.
pub(crate) fn is_quiet() -> bool {
    IS_QUIET.load(Ordering::Relaxed)
}

/// From now on only the output that the user asked for goes to standard output, so that all of the output is JSON.
pub(crate) fn answer_only() {
    IS_ANSWER_ONLY.store(true, Ordering::Relaxed);
}

/// Prints `text`, which tells what a command has done, to standard output; with `--quiet` or `--json` it prints
/// nothing.
///
/// # Errors
/// [`Failure::ReaderGone`] if the pipe is closed; a failed run if standard output cannot be written, as on a full disk.
pub(crate) fn say(text: &str) -> Result<(), Failure> {
    if is_quiet() || IS_ANSWER_ONLY.load(Ordering::Relaxed) { Ok(()) } else { answer(text) }
}

/// Prints `text`, which the user asked for, to standard output; with `--quiet` too.
///
/// # Errors
/// Fails like [`say`].
pub(crate) fn answer(text: &str) -> Result<(), Failure> {
    put(&printable_text(text))
}

/// Prints JSON to standard output; with `--quiet` too. Control characters are escaped, so that no value changes.
///
/// # Errors
/// Fails like [`say`].
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

/// Prints an error to standard error; in colour on a terminal, unless `NO_COLOR` is set. A failure is ignored.
pub(crate) fn tell(text: &str) {
    let text = printable_text(text.trim_end());
    // Takes the colours out where they are not wanted.
    let _ = writeln!(anstream::stderr().lock(), "{}", colour::painted(&text));
}

/// Prints to standard error like [`tell`], but nothing with `--quiet`.
pub(crate) fn remark(text: &str) {
    if !is_quiet() {
        tell(text);
    }
}

/// Prints a notice about something that looks unintended to standard error; with `--quiet` it prints nothing.
pub(crate) fn notice(text: impl core::fmt::Display) {
    remark(&format!("notice: {text}"));
}
