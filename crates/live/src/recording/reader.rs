//! Reads a recording line by line.

use std::io::BufRead;

use super::ending::Ending;
use super::error::{Fault, RecordingError};
use super::sealed::{Sealed, SealedLines};
use super::shape::Shape;
use super::{BEGINNING, Chain, FORMAT, Header, Line};
use crate::limits::{LONGEST_HEADER_BYTES, LONGEST_LINE_BYTES};
use crate::source::Source;

/// A recording that is being read. Each line of the recording is checked by itself and against the lines before it.
#[derive(Debug)]
pub struct RecordingReader<R> {
    lines: SealedLines<R>,
    header: Header,
    shape: Shape,
    ending: Option<Ending>,
    /// Length (bytes) and check sum of the part of the recording that a continued session keeps: all whole lines except
    /// the line that ends the session.
    kept: (u64, Chain),
}

impl<R: BufRead> RecordingReader<R> {
    /// Reads the first line.
    ///
    /// # Errors
    /// Fails if the file is not a recording, has another format, or is damaged.
    pub fn open(input: R) -> Result<RecordingReader<R>, RecordingError> {
        let mut lines = SealedLines::new(input);
        let first = match lines.raw(LONGEST_HEADER_BYTES)? {
            Sealed::Object(first) => first,
            Sealed::Torn(_) => return Err(RecordingError { line: 1, fault: Fault::NoFirstLine }),
            Sealed::Nothing => return Err(RecordingError { line: 1, fault: Fault::NoRecording }),
        };
        let number = first.strip_prefix(BEGINNING).map(|rest| {
            let digits = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
            rest[..digits.min(10)].to_owned()
        });
        match number {
            None => return Err(lines.error(Fault::NoRecording)),
            Some(number) if number != FORMAT.to_string() => {
                return Err(lines.error(Fault::Format(number)));
            }
            Some(_) => {}
        }
        let header = serde_json::from_str(lines.unsealed()?);
        let header = header.map_err(|e| lines.error(Fault::Invalid(e.to_string())))?;
        let kept = (lines.bytes, lines.chain);
        Ok(RecordingReader { lines, header, shape: Shape::new(), ending: None, kept })
    }

    /// The version of the program that recorded the session.
    #[must_use]
    pub fn version(&self) -> &str {
        &self.header.version
    }

    /// The recorded scenario with its files.
    #[must_use]
    pub fn source(&self) -> &Source {
        &self.header.source
    }

    /// Number of the last line that was read, counted from 1.
    #[must_use]
    pub fn line_number(&self) -> usize {
        self.lines.line
    }

    /// Number of bytes read.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.lines.bytes
    }

    /// The next line. The next line is `None` at the end of the recording, and if the last line is cut off.
    ///
    /// # Errors
    /// Fails for a line that is damaged, or that cannot follow the lines before it.
    pub fn next_line(&mut self) -> Result<Option<Line>, RecordingError> {
        if self.ending.is_some() {
            return Ok(None);
        }
        let object = match self.lines.next(LONGEST_LINE_BYTES)? {
            Sealed::Object(object) => object,
            Sealed::Torn(bytes) => return Ok(self.end(Ending::Torn { bytes })),
            Sealed::Nothing => return Ok(self.end(Ending::Open)),
        };
        let line = serde_json::from_str::<Line>(object).map_err(|e| e.to_string());
        let line = line.and_then(|line| self.shape.take(&line).map(|()| line));
        let line = line.map_err(|why| self.lines.error(Fault::Invalid(why)))?;
        if line == (Line::End {}) {
            let Sealed::Nothing = self.lines.raw(LONGEST_LINE_BYTES)? else {
                return Err(self.lines.error(Fault::AfterEnd));
            };
            return Ok(self.end(Ending::Whole));
        }
        self.kept = (self.lines.bytes, self.lines.chain);
        Ok(Some(line))
    }

    fn end(&mut self, ending: Ending) -> Option<Line> {
        self.ending = Some(ending);
        None
    }

    /// How the recording ends; known once all lines have been read.
    pub(super) fn ending(&self) -> Option<Ending> {
        self.ending
    }

    pub(super) fn shape(&self) -> &Shape {
        &self.shape
    }

    pub(crate) fn kept(&self) -> (u64, Chain) {
        self.kept
    }
}
