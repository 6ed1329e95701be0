//! Copies the part of a recording that a continued session keeps.

use std::fmt;
use std::io::{self, BufRead, Write};

use super::error::RecordingError;
use super::outline::Outline;
use super::sealed::{Sealed, SealedLines};
use crate::limits::{LONGEST_HEADER_BYTES, LONGEST_LINE_BYTES};

/// Why a recording was not copied.
#[derive(Debug)]
pub enum CopyError {
    /// The recording cannot be read.
    Read(RecordingError),
    /// The recording has changed since the program checked it.
    Changed,
    /// The copy of the recording cannot be written.
    Write(io::Error),
}

impl fmt::Display for CopyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CopyError::Read(error) => error.fmt(f),
            CopyError::Changed => f.write_str("the recording was changed while it was read"),
            CopyError::Write(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for CopyError {}

/// Copies the lines of a recording that a continued session keeps, and compares them with the checked outline.
///
/// # Errors
/// [`CopyError`]. If the lines differ from the checked outline, the copy is incomplete and cannot be used.
pub fn copy_kept(
    input: impl BufRead,
    outline: &Outline,
    output: &mut impl Write,
) -> Result<(), CopyError> {
    let mut lines = SealedLines::new(input);
    let mut longest = LONGEST_HEADER_BYTES;
    while lines.bytes < outline.kept_bytes {
        let mut before = lines.chain;
        let Sealed::Object(object) = lines.next(longest).map_err(CopyError::Read)? else {
            return Err(CopyError::Changed);
        };
        output.write_all(before.seal(object).as_bytes()).map_err(CopyError::Write)?;
        longest = LONGEST_LINE_BYTES;
    }
    if lines.chain != outline.chain || lines.bytes != outline.kept_bytes {
        return Err(CopyError::Changed);
    }
    Ok(())
}
