//! Start, check sum and fields of a sentence.

use core::fmt;

/// Why a line is no sentence that can be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SentenceFault {
    /// The line has no `$` or `!` with a sentence behind it.
    NoSentence,
    /// The line has no check sum, so nobody knows whether it is whole.
    NoSum,
    /// The check sum of the line is not that of its characters.
    WrongSum,
    /// A field holds something else than the sentence's format says; the text names the field.
    Field(&'static str),
}

impl fmt::Display for SentenceFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SentenceFault::NoSentence => f.write_str("the line holds no sentence"),
            SentenceFault::NoSum => f.write_str("the sentence has no check sum"),
            SentenceFault::WrongSum => f.write_str("the check sum is wrong"),
            SentenceFault::Field(name) => write!(f, "the field `{name}` cannot be read"),
        }
    }
}

impl std::error::Error for SentenceFault {}

/// The characters of the sentence in a line between its start and `*`. Text before the start, such as the time stamp
/// of a logger, is not part of the sentence; [`body_of`] returns this text too.
///
/// # Errors
/// Fails if the line holds no sentence, or a sentence without or with a wrong check sum.
pub fn body_of(line: &str) -> Result<(&str, &str), SentenceFault> {
    let start = line.find(['$', '!']).ok_or(SentenceFault::NoSentence)?;
    let (before, sentence) = line.split_at(start);
    let (body, rest) = sentence[1..].split_once('*').ok_or(SentenceFault::NoSum)?;
    let digits = rest.trim_end().get(..2).ok_or(SentenceFault::NoSum)?;
    let sum = u8::from_str_radix(digits, 16).map_err(|_| SentenceFault::NoSum)?;
    let own = body.bytes().fold(0, |sum, byte| sum ^ byte);
    if own == sum { Ok((before, body)) } else { Err(SentenceFault::WrongSum) }
}

/// The fields of a sentence behind its kind.
pub(super) struct Fields<'a>(Vec<&'a str>);

impl<'a> Fields<'a> {
    /// The kind of a sentence, without the two characters of its talker, and its fields. `body` is the sentence as
    /// [`body_of`] returns it.
    pub(super) fn of(body: &'a str) -> (&'a str, Fields<'a>) {
        let mut fields = body.split(',');
        let kind = fields.next().and_then(|first| first.get(2..)).unwrap_or_default();
        (kind, Fields(fields.collect()))
    }

    pub(super) fn at(&self, index: usize) -> &'a str {
        self.0.get(index).copied().unwrap_or_default()
    }

    /// A number; `None` for an empty field.
    pub(super) fn number(
        &self,
        index: usize,
        name: &'static str,
    ) -> Result<Option<f64>, SentenceFault> {
        match self.at(index) {
            "" => Ok(None),
            text => number(text, name).map(Some),
        }
    }
}

/// A finite number.
pub(super) fn number(text: &str, name: &'static str) -> Result<f64, SentenceFault> {
    let value = text.parse::<f64>().ok().filter(|value| value.is_finite());
    value.ok_or(SentenceFault::Field(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_damaged_sentence_is_refused_and_a_time_stamp_is_kept() {
        let good = "2025-03-01T10:00:00Z $HEHDT,274.1,T*2F\r\n";
        assert_eq!(body_of(good), Ok(("2025-03-01T10:00:00Z ", "HEHDT,274.1,T")));
        assert_eq!(body_of("$HEHDT,275.1,T*2F"), Err(SentenceFault::WrongSum));
        assert_eq!(body_of("$HEHDT,274.1,T"), Err(SentenceFault::NoSum));
        assert_eq!(body_of("$HEHDT,274.1,T*"), Err(SentenceFault::NoSum));
        assert_eq!(body_of("heading 274"), Err(SentenceFault::NoSentence));
        assert_eq!(body_of("$HEHDT,274.1,T*é"), Err(SentenceFault::NoSum));
    }
}
