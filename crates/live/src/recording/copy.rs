//! The beginning of a session that goes on where its recording ended.

use std::fmt;
use std::io::{self, BufRead, Write};

use super::error::RecordingError;
use super::outline::Outline;
use super::sealed::{Sealed, SealedLines};
use crate::limits::{LONGEST_HEADER_BYTES, LONGEST_LINE_BYTES};

/// Why a recording was not copied.
#[derive(Debug)]
pub enum CopyError {
    /// It cannot be read.
    Read(RecordingError),
    /// It is not what it was when it was checked.
    Changed,
    /// The copy cannot be written.
    Write(io::Error),
}

impl fmt::Display for CopyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CopyError::Read(error) => error.fmt(f),
            CopyError::Changed => f.write_str("it was changed while it was read"),
            CopyError::Write(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for CopyError {}

/// Copies what a session that goes on keeps of a recording, holding it against what was checked.
///
/// # Errors
/// [`CopyError`]; what was written until then is no recording to go on with.
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
