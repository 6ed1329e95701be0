//! Puts start, checksum and line end around the fields of an NMEA or AIS sentence.

use core::fmt::Write as _;

/// A sentence with its start, checksum and line end. The checksum of a sentence is the exclusive or of all characters
/// between its start and `*`.
pub(crate) fn sentence(start: char, body: &str) -> String {
    let sum = body.bytes().fold(0, |sum, byte| sum ^ byte);
    let mut text = format!("{start}{body}*");
    let written = write!(text, "{sum:02X}\r\n");
    debug_assert!(written.is_ok(), "writing to a `String` cannot fail");
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The usual example of NMEA 0183.
    #[test]
    fn the_checksum_matches_a_published_sentence() {
        let body = "GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W";
        assert_eq!(sentence('$', body), format!("${body}*6A\r\n"));
    }
}
