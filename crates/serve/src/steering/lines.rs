//! Splits the bytes of a controller into lines, with a limit on their length.

/// Longest line (bytes). A sentence has at most 82 characters; a time stamp or a tag block may stand before it.
pub(super) const LONGEST: usize = 200;

/// A line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Line<'a> {
    /// A whole line, without its end.
    Whole(&'a str),
    /// A line that is longer than [`LONGEST`].
    TooLong,
    /// A line that is no text.
    NoText,
}

/// The line that has begun.
#[derive(Clone, Debug, Default)]
pub(super) struct Lines {
    begun: Vec<u8>,
    is_too_long: bool,
}

impl Lines {
    /// Adds bytes, and gives each line that ends in them. Empty lines are left out.
    pub(super) fn push(&mut self, bytes: &[u8], mut each: impl FnMut(Line<'_>)) {
        for byte in bytes {
            match byte {
                b'\r' | b'\n' => {
                    if std::mem::take(&mut self.is_too_long) {
                        each(Line::TooLong);
                    } else if !self.begun.is_empty() {
                        let text = std::str::from_utf8(&self.begun);
                        each(text.map_or(Line::NoText, Line::Whole));
                    }
                    self.begun.clear();
                }
                _ if self.is_too_long => {}
                _ if self.begun.len() == LONGEST => self.is_too_long = true,
                byte => self.begun.push(*byte),
            }
        }
    }

    /// True if a line has begun that never ended.
    pub(super) fn end(&self) -> bool {
        self.is_too_long || !self.begun.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(blocks: &[&[u8]]) -> (Vec<String>, bool) {
        let (mut lines, mut all) = (Lines::default(), Vec::new());
        for block in blocks {
            lines.push(block, |line| all.push(format!("{line:?}")));
        }
        (all, lines.end())
    }

    #[test]
    fn lines_are_whole_whatever_the_blocks() {
        let whole = |text: &str| format!("{:?}", Line::Whole(text));
        let expected = vec![whole("$A*00"), whole("$B*11")];
        assert_eq!(lines(&[b"$A*00\r\n$B*11\r\n"]), (expected.clone(), false));
        assert_eq!(lines(&[b"$A", b"*00\r", b"\n\n$B*1", b"1\n"]), (expected.clone(), false));
        assert_eq!(lines(&[b"$A*00\r\n$B*11\n$C"]), (expected, true));
        assert_eq!(lines(&[b"\xff\xfe\n"]).0, ["NoText"]);
    }

    #[test]
    fn a_long_line_is_one_line_that_is_too_long_and_takes_no_room() {
        let long = vec![b'$'; 100_000];
        let (all, has_begun) = lines(&[&long, &long, b"\n$A*00\n", &long]);
        assert_eq!((all, has_begun), (vec!["TooLong".into(), "Whole(\"$A*00\")".into()], true));
        let just: Vec<u8> = std::iter::repeat_n(b'x', LONGEST).chain(*b"\n").collect();
        assert!(lines(&[&just]).0[0].starts_with("Whole"));
        let mut more = Lines::default();
        more.push(&long, |_| {});
        assert_eq!(more.begun.len(), LONGEST);
    }
}
