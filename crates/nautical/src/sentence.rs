//! A sentence on the wire.

use core::fmt::Write as _;

/// A sentence with its start, its checksum (the exclusive or of what lies between start and `*`) and its end.
pub(crate) fn sentence(start: char, body: &str) -> String {
    let sum = body.bytes().fold(0, |sum, byte| sum ^ byte);
    let mut text = format!("{start}{body}*");
    let written = write!(text, "{sum:02X}\r\n");
    debug_assert!(written.is_ok(), "a String takes everything");
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sentence of every tutorial on NMEA 0183.
    #[test]
    fn the_checksum_is_that_of_a_published_sentence() {
        let body = "GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W";
        assert_eq!(sentence('$', body), format!("${body}*6A\r\n"));
    }
}
