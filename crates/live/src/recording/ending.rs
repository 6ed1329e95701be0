//! How a recording ends.

/// How a recording ends. Whichever way a recording ends, the lines before its end are sound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The recording ends with the line that ends a session, so that it is complete.
    Whole,
    /// The recording ends with another whole line: the writer was killed or is still writing, or lines were cut off.
    Open,
    /// The recording ends within a line, which is dropped: the writer was killed, or the file was cut off.
    Torn {
        /// Length of the dropped last line (bytes).
        bytes: u64,
    },
}
