//! The lesser and the greater of two numbers.

/// The lesser of two numbers, neither of which is NaN: one instruction, where `f64::min` has to ask.
#[inline(always)]
pub(crate) fn lesser(p: f64, q: f64) -> f64 {
    if p < q { p } else { q }
}

/// The greater of two numbers, neither of which is NaN.
#[inline(always)]
pub(crate) fn greater(p: f64, q: f64) -> f64 {
    if p > q { p } else { q }
}
