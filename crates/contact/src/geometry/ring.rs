//! Index arithmetic for the corners of a closed ring.

/// Index before index `i` in a ring of `count` corners.
#[inline]
pub(crate) fn before(i: usize, count: usize) -> usize {
    if i == 0 { count - 1 } else { i - 1 }
}

/// Index after index `i` in a ring of `count` corners.
#[inline]
pub(crate) fn after(i: usize, count: usize) -> usize {
    if i + 1 == count { 0 } else { i + 1 }
}

/// The corner of a convex ring of `count` corners that is deepest behind a line, and its depth. The search climbs from
/// corner `from`, because the depth has a single maximum over the ring.
#[inline(always)]
pub(crate) fn climb(depth: impl Fn(usize) -> f64, from: usize, count: usize) -> (usize, f64) {
    let (mut here, mut deepest) = (from, depth(from));
    for _ in 0..count {
        let (next, previous) = (after(here, count), before(here, count));
        let (of_next, of_previous) = (depth(next), depth(previous));
        if of_next > deepest {
            (here, deepest) = (next, of_next);
        } else if of_previous > deepest {
            (here, deepest) = (previous, of_previous);
        } else {
            break;
        }
    }
    (here, deepest)
}

/// Number of vertices between an edge and a later edge in a ring of `count` edges.
#[inline(always)]
pub(crate) fn ring_distance(from: u32, to: u32, count: usize) -> usize {
    let (from, to) = (from as usize, to as usize);
    if to >= from { to - from } else { to + count - from }
}
