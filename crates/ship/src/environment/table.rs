//! Linear interpolation on an increasing axis.

use super::error::EnvironmentError;
use crate::range::within;

/// Checks the axis of a table: it must have at least `least` entries, all finite, in increasing order.
pub(super) fn check_axis(
    axis: &'static str,
    entries: impl ExactSizeIterator<Item = f64>,
    least: usize,
) -> Result<(), EnvironmentError> {
    if entries.len() < least {
        return Err(EnvironmentError::Length {
            table: axis,
            expected: least,
            found: entries.len(),
        });
    }
    let mut last = f64::NEG_INFINITY;
    for (entry, value) in entries.enumerate() {
        within(axis, value, -1e12, 1e12)?;
        if value <= last {
            return Err(EnvironmentError::NotIncreasing { axis, entry });
        }
        last = value;
    }
    Ok(())
}

/// The position of a value on the axis of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    /// Index of the axis entry at or below the value.
    pub(super) low: usize,
    /// Index of the axis entry at or above the value.
    pub(super) high: usize,
    /// Weight of the upper axis entry, 0 to 1.
    pub(super) share: f64,
}

/// Whether a value is off an axis of a table, so that [`place`] returns an end of the axis. No value is off an axis of
/// one entry, because such an axis means that nothing changes along it.
pub(super) fn is_off(count: usize, at: impl Fn(usize) -> f64, value: f64) -> bool {
    count > 1 && (value < at(0) || value > at(count - 1))
}

/// Finds the position of a value on an axis of `count` entries. Values outside the axis are clamped to its ends.
pub(super) fn place(count: usize, at: impl Fn(usize) -> f64, value: f64) -> Place {
    let last = count - 1;
    if value <= at(0) {
        return Place { low: 0, high: 0, share: 0.0 };
    }
    if value >= at(last) {
        return Place { low: last, high: last, share: 0.0 };
    }
    // Invariant: at(low) ≤ value < at(high).
    let (mut low, mut high) = (0, last);
    while high - low > 1 {
        let middle = low.midpoint(high);
        if at(middle) <= value {
            low = middle;
        } else {
            high = middle;
        }
    }
    Place { low, high, share: (value - at(low)) / (at(high) - at(low)) }
}
