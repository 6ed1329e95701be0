//! Makes a recording's lines, within its limits.

use super::{Chain, FORMAT, Header, Line};
use crate::limits::{Full, LARGEST_RECORDING_BYTES, LONGEST_HEADER_BYTES, LONGEST_LINE_BYTES};
use crate::source::Source;

/// Room that is kept for the line that ends it, and for one that says how far it has come (bytes).
const END_BYTES: u64 = 512;
const MARK_BYTES: u64 = 512;
/// More than a check sum adds to a line (bytes).
const SUM_BYTES: u64 = 64;

/// The lines that a session's owner has not taken yet, and what was written before them.
#[derive(Clone, Debug)]
pub(crate) struct Writer {
    text: String,
    chain: Chain,
    bytes: u64,
    /// A replay writes nothing.
    is_silent: bool,
    /// Branch and tick of the last line, where that says how far a branch has come.
    marked: Option<(usize, u64)>,
}

impl Writer {
    /// With the first line. `None` where that is too long to be read again.
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

    /// Goes on after lines that stand already.
    pub(crate) fn after(chain: Chain, bytes: u64) -> Writer {
        Writer { text: String::new(), chain, bytes, is_silent: false, marked: None }
    }

    /// Writes nothing.
    pub(crate) fn silent() -> Writer {
        Writer { is_silent: true, ..Writer::after(Chain::default(), 0) }
    }

    /// Is there room for a line, whatever it says?
    pub(crate) fn has_room(&self) -> bool {
        self.bytes + LONGEST_LINE_BYTES + MARK_BYTES + END_BYTES <= LARGEST_RECORDING_BYTES
    }

    /// A line as JSON, if it may be written: to be given to [`Writer::put`] when it counts.
    pub(crate) fn prepare(&self, line: &Line) -> Result<String, Full> {
        if self.is_silent {
            return Ok(String::new());
        }
        let json = line.json();
        let fits = json.len() as u64 + SUM_BYTES <= LONGEST_LINE_BYTES;
        if fits && self.has_room() { Ok(json) } else { Err(Full::Bytes) }
    }

    /// Writes a line that was prepared.
    pub(crate) fn put(&mut self, json: &str) {
        if self.is_silent {
            return;
        }
        let line = self.chain.seal(json);
        self.bytes += line.len() as u64;
        self.text += &line;
        self.marked = None;
    }

    /// Writes how far a branch has come, unless the last line says so already. Where commands have left no room for it
    /// the recording is readable without.
    pub(crate) fn mark(&mut self, branch: usize, tick: u64, bits: impl FnOnce() -> String) {
        if self.is_silent || self.marked == Some((branch, tick)) {
            return;
        }
        if self.bytes + MARK_BYTES + END_BYTES <= LARGEST_RECORDING_BYTES {
            self.put(&Line::Reached { branch, tick, bits: bits() }.json());
            self.marked = Some((branch, tick));
        }
    }

    /// The line that would end the recording here.
    pub(crate) fn end_line(&self) -> String {
        let mut chain = self.chain;
        chain.seal(&Line::End {}.json())
    }

    /// Length of all lines so far (bytes).
    pub(crate) fn bytes(&self) -> u64 {
        self.bytes
    }

    pub(crate) fn take(&mut self) -> String {
        std::mem::take(&mut self.text)
    }
}
