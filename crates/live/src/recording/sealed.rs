//! Lines with check sums. The module seals and checks lines of recordings, but does not read what they contain.

use std::io::{BufRead, Read as _};

use super::error::{Fault, RecordingError};
use crate::limits::LARGEST_RECORDING_BYTES;

/// The text that stands between the fields of a line and its check sum. After its check sum, a line has a quotation
/// mark and a brace.
const KEY: &str = ",\"sum\":\"";
const DIGITS: usize = 8;
const TAIL: usize = KEY.len() + DIGITS + 2;

/// The check sum of a line and all lines before it: CRC-32 of IEEE 802.3. The check sum of each line starts from the
/// check sum of the line before. The check sum detects every change within 32 consecutive bits, and misses one in 2³²
/// of other changes. The check sum gives no protection against a forged recording.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Chain(u32);

impl Chain {
    /// Makes the next line from a JSON object by adding the check sum and the line end.
    pub(crate) fn seal(&mut self, object: &str) -> String {
        let Some(body) = object.strip_suffix('}') else { unreachable!("an object: {object}") };
        self.add(body);
        format!("{body}{KEY}{:08x}\"}}\n", self.0)
    }

    /// Length of the JSON object in the next line, without its last brace. The length is `None` if the check sum is
    /// wrong.
    fn unseal(&mut self, line: &str) -> Option<usize> {
        let at = line.len().checked_sub(TAIL)?;
        let (body, tail) = line.split_at_checked(at)?;
        let mut next = *self;
        next.add(body);
        // The digits are compared as text. A change of their case is therefore detected.
        (tail == format!("{KEY}{:08x}\"}}", next.0)).then(|| {
            *self = next;
            at
        })
    }

    fn add(&mut self, body: &str) {
        let mut sum = crc32fast::Hasher::new_with_initial(self.0);
        sum.update(body.as_bytes());
        self.0 = sum.finalize();
    }
}

/// What the reader of lines finds next in a file.
pub(super) enum Sealed<'b> {
    /// A line with a correct check sum. The text is the JSON object in the line.
    Object(&'b str),
    /// The last line of the file is cut off. The number is the length of the cut-off line (bytes).
    Torn(u64),
    /// The end of the file.
    Nothing,
}

/// Reads lines with check sums, one at a time.
#[derive(Debug)]
pub(super) struct SealedLines<R> {
    input: R,
    buffer: Vec<u8>,
    pub(super) chain: Chain,
    /// Number of the last line that was read.
    pub(super) line: usize,
    /// Length of all whole lines so far (bytes).
    pub(super) bytes: u64,
}

impl<R: BufRead> SealedLines<R> {
    pub(super) fn new(input: R) -> SealedLines<R> {
        SealedLines { input, buffer: Vec::new(), chain: Chain::default(), line: 0, bytes: 0 }
    }

    /// The next whole line of the file, without its line end. Reading a line in this way does not verify the line's
    /// check sum. The result is `Torn` if the line end is missing.
    pub(super) fn raw(&mut self, longest_bytes: u64) -> Result<Sealed<'_>, RecordingError> {
        self.line += 1;
        self.buffer.clear();
        let input = &mut self.input;
        let read = input.take(longest_bytes + 1).read_until(b'\n', &mut self.buffer);
        let length = read.map_err(|e| self.error(Fault::Unreadable(e.to_string())))? as u64;
        if length > longest_bytes {
            return Err(self.error(Fault::TooLong(longest_bytes)));
        }
        if self.bytes + length > LARGEST_RECORDING_BYTES {
            return Err(self.error(Fault::TooLarge));
        }
        if length == 0 {
            self.line -= 1;
            return Ok(Sealed::Nothing);
        }
        if self.buffer.pop() != Some(b'\n') {
            self.line -= 1;
            return Ok(Sealed::Torn(length));
        }
        self.bytes += length;
        let error = RecordingError { line: self.line, fault: Fault::Damaged };
        str::from_utf8(&self.buffer).map(Sealed::Object).map_err(|_| error)
    }

    /// The JSON object in the next line, after a check of the line's check sum.
    pub(super) fn next(&mut self, longest_bytes: u64) -> Result<Sealed<'_>, RecordingError> {
        match self.raw(longest_bytes)? {
            Sealed::Object(_) => self.unsealed().map(Sealed::Object),
            Sealed::Torn(bytes) => Ok(Sealed::Torn(bytes)),
            Sealed::Nothing => Ok(Sealed::Nothing),
        }
    }

    /// The JSON object in the last line that was read, after a check of the line's check sum.
    pub(super) fn unsealed(&mut self) -> Result<&str, RecordingError> {
        let error = RecordingError { line: self.line, fault: Fault::Damaged };
        let Ok(line) = str::from_utf8(&self.buffer) else { return Err(error) };
        let Some(length) = self.chain.unseal(line) else { return Err(error) };
        self.buffer.truncate(length);
        self.buffer.push(b'}');
        Ok(str::from_utf8(&self.buffer).unwrap_or_else(|e| {
            unreachable!(
                "the check sum follows the object, so that the text can be cut \
                                              between them: {e}"
            )
        }))
    }

    pub(super) fn error(&self, fault: Fault) -> RecordingError {
        RecordingError { line: self.line, fault }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &str) -> Result<Vec<String>, RecordingError> {
        let mut lines = SealedLines::new(text.as_bytes());
        let mut all = Vec::new();
        while let Sealed::Object(object) = lines.next(100)? {
            all.push(object.to_owned());
        }
        Ok(all)
    }

    #[test]
    fn swapped_removed_and_repeated_lines_are_detected() {
        let objects = ["{\"a\":1}", "{\"b\":2}", "{\"a\":1}", "{}", "{\"c\":\"ö\"}"];
        let mut chain = Chain::default();
        let sealed: Vec<String> = objects.iter().map(|object| chain.seal(object)).collect();
        assert_eq!(lines(&sealed.concat()).expect("sound"), objects);
        // The usual check value of CRC-32. Other programs can therefore verify a file.
        let mut check = Chain::default();
        check.add("123456789");
        assert_eq!(check, Chain(0xcbf4_3926));
        for at in 0..sealed.len() - 1 {
            let mut other = sealed.clone();
            other.swap(at, at + 1);
            assert_eq!(lines(&other.concat()).expect_err("swapped").fault, Fault::Damaged);
            other.clone_from(&sealed);
            other.remove(at);
            assert_eq!(lines(&other.concat()).expect_err("removed").line, at + 1);
            other.clone_from(&sealed);
            other.insert(at, sealed[at].clone());
            assert_eq!(lines(&other.concat()).expect_err("repeated").line, at + 2);
        }
    }
}
