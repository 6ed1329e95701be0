//! A recording as a whole, checked from its first line to its last without playing it.

use std::io::BufRead;

use super::error::RecordingError;
use super::reader::RecordingReader;
use super::{Chain, Fault};

/// Lines between two looks at who asked.
const LINES_AT_A_TIME: usize = 4096;

/// How a recording ends. In all three cases every line of it is as it was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// With the line that ends a session: it is sound, and nothing is missing.
    Whole,
    /// With a whole line: its writer was killed or still writes, or lines were cut off.
    Open,
    /// Within a line, which is dropped: its writer was killed, or it was cut off there.
    Torn {
        /// Of the line that is dropped.
        bytes: u64,
    },
}

/// What a recording holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outline {
    /// How it ends.
    pub ending: Ending,
    /// Commands in it.
    pub commands: usize,
    /// Branches in it, the first among them.
    pub branches: usize,
    /// Ticks of all branches together: what a replay plays.
    pub ticks: u64,
    /// Length of what a session that goes on keeps (bytes): all whole lines but the end.
    pub kept_bytes: u64,
    pub(crate) chain: Chain,
}

impl Outline {
    /// Reads a recording from its start to its end. Every so often `go_on` is told how much has been read (bytes), and
    /// says whether to read on.
    ///
    /// # Errors
    /// The first line that is wrong; [`Fault::Unreadable`] where `go_on` said no.
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
        let Some(ending) = reader.ending() else { unreachable!("all of it was read") };
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
