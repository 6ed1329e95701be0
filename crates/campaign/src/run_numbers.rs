//! A set of run numbers, kept as a few ranges, so that a plan of many runs takes little memory.

use std::ops::Range;

/// A set of run numbers in rising order, each number once.
///
/// ```
/// use fenderline_campaign::RunNumbers;
/// let all = RunNumbers::from(0..100_000_000);
/// assert_eq!((all.count(), all.get(7), all.get(100_000_000)), (100_000_000, Some(7), None));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RunNumbers {
    /// The first run number of the share of a campaign to which the set belongs.
    first: u64,
    /// Step from one run number of the share to the next.
    stride: u64,
    /// The places in the share whose run numbers are in the set, as ranges; each range comes with the count of the
    /// set's numbers before the range.
    ranges: Vec<(u64, Range<u64>)>,
    count: u64,
}

impl RunNumbers {
    /// The numbers `first`, `first + stride`, … below `all` for which `is_wanted`.
    #[must_use]
    pub fn among(first: u64, stride: u64, all: u64, is_wanted: impl Fn(u64) -> bool) -> RunNumbers {
        let RunNumbers { stride, count: places, .. } = RunNumbers::every(first, stride, all);
        let mut numbers = RunNumbers { first, stride, ranges: Vec::new(), count: 0 };
        for place in 0..places {
            if is_wanted(numbers.at(place)) {
                numbers.push(place);
            }
        }
        numbers
    }

    /// The numbers `first`, `first + stride`, … below `all`.
    #[must_use]
    pub fn every(first: u64, stride: u64, all: u64) -> RunNumbers {
        let stride = stride.max(1);
        let count = all.saturating_sub(first).div_ceil(stride);
        let ranges = if count > 0 { vec![(0, 0..count)] } else { Vec::new() };
        RunNumbers { first, stride, ranges, count }
    }

    /// How many run numbers there are.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The run number at the place `place` of the set, counted from 0.
    #[must_use]
    pub fn get(&self, place: u64) -> Option<u64> {
        if place >= self.count {
            return None;
        }
        let range = self.ranges.partition_point(|(before, _)| *before <= place) - 1;
        let (before, range) = &self.ranges[range];
        Some(self.at(range.start + (place - before)))
    }

    fn at(&self, place: u64) -> u64 {
        self.first + place * self.stride
    }

    /// Adds a run, given by its place in the share, after all others.
    fn push(&mut self, place: u64) {
        match self.ranges.last_mut() {
            Some((_, last)) if last.end == place => last.end += 1,
            _ => self.ranges.push((self.count, place..place + 1)),
        }
        self.count += 1;
    }
}

impl From<Range<u64>> for RunNumbers {
    fn from(range: Range<u64>) -> RunNumbers {
        RunNumbers::every(range.start, 1, range.end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_that_are_wanted() {
        for (first, stride, all) in [(0, 1, 20), (2, 3, 20), (0, 7, 7), (5, 2, 5), (0, 1, 0)] {
            let is_wanted = |run: u64| !(6..9).contains(&run) && run % 5 != 1;
            let numbers = RunNumbers::among(first, stride, all, is_wanted);
            let wanted: Vec<u64> =
                (first..all).step_by(stride as usize).filter(|run| is_wanted(*run)).collect();
            let found: Vec<u64> = (0..).map_while(|place| numbers.get(place)).collect();
            assert_eq!(found, wanted);
            assert_eq!(numbers.count(), wanted.len() as u64);
        }
        assert_eq!(RunNumbers::from(3..3).get(0), None);
        assert_eq!(RunNumbers::from(3..5), RunNumbers::among(3, 1, 5, |_| true));
    }
}
