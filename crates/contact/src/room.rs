//! Lists whose memory is there before the first step.

use alloc::vec::Vec;
use core::mem::MaybeUninit;

use crate::geometry::convex::ConvexPolygon;
use crate::model::Model;

/// An empty list with room for `count` entries. All of its memory is written once: a system gives pages when they are first
/// written, and the first step of many contacts would else wait for thousands of them.
pub(crate) fn room_for<T>(count: usize) -> Vec<T> {
    // Unseen by the compiler, which would else ask the system for memory that is zero unwritten.
    let mut list = core::hint::black_box(Vec::with_capacity(count));
    list.spare_capacity_mut().fill_with(MaybeUninit::zeroed);
    list
}

/// Fewer contacts than this wait for a page or two: their lists begin empty.
const LEAST_WITH_ROOM: usize = 64;

/// How many contacts get room before the first step: one a floating body and one a fender, none for a few. Lists grow where there
/// are more.
pub(crate) fn expected_contacts(model: &Model) -> usize {
    let floating = (0..model.ranked.len()).filter(|&rank| !model.ranked[rank].is_fixed()).count();
    let contacts = floating + model.fenders().len();
    if contacts < LEAST_WITH_ROOM { 0 } else { contacts }
}

/// The most corners that a convex piece of a body or the zone of a fender has.
pub(crate) fn most_corners(model: &Model) -> usize {
    let pieces = (0..model.ranked.len()).flat_map(|rank| model.ranked.pieces(rank));
    pieces.map(ConvexPolygon::count).fold(4, usize::max)
}
