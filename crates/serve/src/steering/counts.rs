//! Counts what a controller has ordered, and what was dropped for which reason.

use core::fmt;

/// Why a line of a controller was dropped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dropped {
    /// The line is longer than any sentence.
    TooLong,
    /// The line holds no sentence, or no text.
    NoSentence,
    /// The sentence has no check sum: it is cut off.
    NoSum,
    /// The check sum is wrong.
    WrongSum,
    /// A field cannot be read, or asks for something that the ship cannot do.
    Field,
    /// The sentence reports a state and orders nothing.
    Report,
    /// The sentence is of a kind that orders nothing.
    Other,
    /// There are too many orders in a second.
    TooMany,
}

impl Dropped {
    const ALL: [(Dropped, &str); 8] = [
        (Dropped::TooLong, "too long"),
        (Dropped::NoSentence, "without a sentence"),
        (Dropped::NoSum, "without a check sum"),
        (Dropped::WrongSum, "with a wrong check sum"),
        (Dropped::Field, "with a field that cannot be obeyed"),
        (Dropped::Report, "that report and order nothing"),
        (Dropped::Other, "of other kinds"),
        (Dropped::TooMany, "beyond the rate of orders"),
    ];
}

/// What a controller has ordered, and what was dropped.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Counts {
    given: u64,
    refused: u64,
    /// Why the last refused order was refused.
    reason: String,
    dropped: [u64; Dropped::ALL.len()],
}

impl Counts {
    /// Counts an order that was passed on.
    pub(super) fn given(&mut self) {
        self.given += 1;
    }

    /// Counts an order that was passed on and refused.
    pub(super) fn refused(&mut self, reason: &str) {
        self.refused += 1;
        reason.clone_into(&mut self.reason);
    }

    /// Counts a line that was dropped.
    pub(super) fn drop(&mut self, why: Dropped) {
        self.dropped[why as usize] += 1;
    }

    /// True if something was dropped or refused since the counts `before`.
    pub(super) fn has_dropped_since(&self, before: &Counts) -> bool {
        self.dropped != before.dropped || self.refused != before.refused
    }
}

impl fmt::Display for Counts {
    /// `12 orders, 2 refused (why the last was refused); dropped lines: 1 too long, 30 with a wrong check sum`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} orders, {} refused", self.given, self.refused)?;
        if !self.reason.is_empty() {
            write!(f, " ({})", self.reason)?;
        }
        let all = Dropped::ALL.iter().map(|(why, words)| (self.dropped[*why as usize], words));
        for (index, (count, words)) in all.filter(|(count, _)| *count > 0).enumerate() {
            f.write_str(if index == 0 { "; dropped lines: " } else { ", " })?;
            write!(f, "{count} {words}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_dropped_is_counted_by_its_reason() {
        let mut counts = Counts::default();
        assert_eq!(counts.to_string(), "0 orders, 0 refused");
        let before = counts.clone();
        counts.given();
        assert!(!counts.has_dropped_since(&before));
        for (index, (why, words)) in Dropped::ALL.into_iter().enumerate() {
            counts.drop(why);
            counts.drop(why);
            assert_eq!(counts.dropped[index], 2);
            assert!(counts.to_string().contains(&format!("2 {words}")), "{counts}");
        }
        assert!(counts.has_dropped_since(&before));
        let before = counts.clone();
        counts.refused("no thruster");
        assert!(counts.has_dropped_since(&before));
        assert!(counts.to_string().starts_with("1 orders, 1 refused (no thruster); dropped"));
    }
}
