//! Indices of a closed ring.

/// Index before `i` in a ring of `count`.
#[inline]
pub(crate) fn before(i: usize, count: usize) -> usize {
    if i == 0 { count - 1 } else { i - 1 }
}

/// Index after `i` in a ring of `count`.
#[inline]
pub(crate) fn after(i: usize, count: usize) -> usize {
    if i + 1 == count { 0 } else { i + 1 }
}

/// Vertices between an edge and a later one of a ring of `count`.
#[inline(always)]
pub(crate) fn ring_distance(from: u32, to: u32, count: usize) -> usize {
    let (from, to) = (from as usize, to as usize);
    if to >= from { to - from } else { to + count - from }
}
