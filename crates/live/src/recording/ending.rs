//! How a recording ends.

/// How a recording ends. In all three cases the lines before are sound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// With the line that ends a session: it is complete.
    Whole,
    /// With another whole line: the writer was killed or is still writing, or lines were cut off.
    Open,
    /// Within a line, which is dropped: the writer was killed, or the file was cut off.
    Torn {
        /// Length of the dropped line (bytes).
        bytes: u64,
    },
}
