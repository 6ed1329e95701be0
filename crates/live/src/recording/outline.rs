//! The outline of a recording: its number of branches and ticks, and how it ends. To find the outline, all lines of a
//! recording are read and checked, but not replayed.

use std::io::BufRead;

use super::ending::Ending;
use super::error::RecordingError;
use super::reader::RecordingReader;
use super::{Chain, Fault};

/// Number of lines that are read between two calls of `go_on`.
const LINES_AT_A_TIME: usize = 4096;

/// What a recording contains, as its lines say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outline {
    /// How the recording ends.
    pub ending: Ending,
    /// Number of commands.
    pub commands: usize,
    /// Number of branches in the recording, including the first.
    pub branches: usize,
    /// Number of ticks of all branches of the recording together. A replay computes the ticks of all branches.
    pub ticks: u64,
    /// Length of the part of the recording that a continued session keeps (bytes): all whole lines except the line that
    /// ends the session.
    pub kept_bytes: u64,
    pub(crate) chain: Chain,
}

impl Outline {
    /// Reads a recording from start to end. While the recording is read, the function `go_on` gets the number of bytes
    /// read from time to time. The function `go_on` stops the reading by returning an error.
    ///
    /// # Errors
    /// Fails with the first invalid line, or with [`Fault::Unreadable`] if `go_on` returns an error.
    pub fn read(
        input: impl BufRead,
        mut go_on: impl FnMut(u64) -> Result<(), String>,
    ) -> Result<Outline, RecordingError> {
        let mut reader = RecordingReader::open(input)?;
        while reader.next_line()?.is_some() {
            if reader.line_number().is_multiple_of(LINES_AT_A_TIME) {
                let line = reader.line_number();
                go_on(reader.bytes())
                    .map_err(|why| RecordingError { line, fault: Fault::Unreadable(why) })?;
            }
        }
        let Some(ending) = reader.ending() else {
            unreachable!("the reader has read the recording to its end")
        };
        let (kept_bytes, chain) = reader.kept();
        let shape = reader.shape();
        Ok(Outline {
            ending,
            commands: shape.commands,
            branches: shape.branches(),
            ticks: shape.ticks,
            kept_bytes,
            chain,
        })
    }
}
