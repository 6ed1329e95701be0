//! Writes the lines of a recording within its limits.

use super::{Chain, FORMAT, Header, Line};
use crate::limits::{Full, LARGEST_RECORDING_BYTES, LONGEST_HEADER_BYTES, LONGEST_LINE_BYTES};
use crate::source::Source;

/// Space reserved in a recording for the last line and for a `reached` line (bytes).
const END_BYTES: u64 = 512;
const MARK_BYTES: u64 = 512;
/// The most that a check sum adds to the length of a line (bytes).
const SUM_BYTES: u64 = 64;

/// The lines of a recording that the owner of the session has not taken yet, and the totals over all lines.
#[derive(Clone, Debug)]
pub(crate) struct Writer {
    text: String,
    chain: Chain,
    bytes: u64,
    /// True during a replay, when the writer writes nothing.
    is_silent: bool,
    /// Branch and tick of the last line, if the last line is a `reached` line.
    marked: Option<(usize, u64)>,
}

impl Writer {
    /// A writer that has written the first line of a recording. The result is `None` if the first line is longer than
    /// the limit.
    pub(crate) fn begin(source: &Source) -> Option<Writer> {
        let header = Header {
            fenderline_session: FORMAT,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            source: source.clone(),
        };
        let json = serde_json::to_string(&header).unwrap_or_else(|e| unreachable!("{e}"));
        let mut writer = Writer::after(Chain::default(), 0);
        writer.put(&json);
        (writer.bytes <= LONGEST_HEADER_BYTES).then_some(writer)
    }

    /// A writer that continues a recording after its present lines.
    pub(crate) fn after(chain: Chain, bytes: u64) -> Writer {
        Writer { text: String::new(), chain, bytes, is_silent: false, marked: None }
    }

    /// A writer that writes nothing.
    pub(crate) fn silent() -> Writer {
        Writer { is_silent: true, ..Writer::after(Chain::default(), 0) }
    }

    /// True if the recording has space for a line of any length.
    pub(crate) fn has_room(&self) -> bool {
        self.bytes + LONGEST_LINE_BYTES + MARK_BYTES + END_BYTES <= LARGEST_RECORDING_BYTES
    }

    /// The JSON of a line, if the recording has space for it. [`Writer::put`] writes the line.
    pub(crate) fn prepare(&self, line: &Line) -> Result<String, Full> {
        if self.is_silent {
            return Ok(String::new());
        }
        let json = line.json();
        let fits = json.len() as u64 + SUM_BYTES <= LONGEST_LINE_BYTES;
        if fits && self.has_room() { Ok(json) } else { Err(Full::Bytes) }
    }

    /// Writes the JSON of a line from [`Writer::prepare`].
    pub(crate) fn put(&mut self, json: &str) {
        if self.is_silent {
            return;
        }
        let line = self.chain.seal(json);
        self.bytes += line.len() as u64;
        self.text += &line;
        self.marked = None;
    }

    /// Writes a `reached` line, unless the last line is already the same. If the recording has no space for the
    /// `reached` line, the line is left out, and the recording is still valid.
    pub(crate) fn mark(&mut self, branch: usize, tick: u64, bits: impl FnOnce() -> String) {
        if self.is_silent || self.marked == Some((branch, tick)) {
            return;
        }
        if self.bytes + MARK_BYTES + END_BYTES <= LARGEST_RECORDING_BYTES {
            self.put(&Line::Reached { branch, tick, bits: bits() }.json());
            self.marked = Some((branch, tick));
        }
    }

    /// The line that would end the recording at this point.
    pub(crate) fn end_line(&self) -> String {
        let mut chain = self.chain;
        chain.seal(&Line::End {}.json())
    }

    /// Length of all lines of the recording so far (bytes).
    pub(crate) fn bytes(&self) -> u64 {
        self.bytes
    }

    pub(crate) fn take(&mut self) -> String {
        std::mem::take(&mut self.text)
    }
}
