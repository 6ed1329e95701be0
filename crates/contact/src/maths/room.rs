//! Makes lists whose memory is reserved and written before the first step.

use alloc::vec::Vec;
use core::mem::MaybeUninit;

use crate::geometry::convex::ConvexPolygon;
use crate::model::Model;

/// Makes an empty list with room for `count` entries. All memory of the list is written once beforehand. The operating
/// system provides a page of memory only when the page is first written; the first step with many contacts would
/// otherwise wait for thousands of pages.
pub(crate) fn room_for<T>(count: usize) -> Vec<T> {
    // Hidden from the compiler, which would otherwise ask the system for zeroed memory and write nothing.
    let mut list = core::hint::black_box(Vec::with_capacity(count));
    list.spare_capacity_mut().fill_with(MaybeUninit::zeroed);
    list
}

/// Least number of contacts that get room beforehand; with fewer contacts the lists begin empty, because their first
/// step waits for only a page or two.
const LEAST_WITH_ROOM: usize = 64;

/// Number of contacts that get room before the first step: one per floating body and one per fender, and none if the
/// sum is small. The lists grow if there are more contacts.
pub(crate) fn expected_contacts(model: &Model) -> usize {
    let floating = (0..model.ranked.len()).filter(|&rank| !model.ranked[rank].is_fixed()).count();
    let contacts = floating + model.fenders().len();
    if contacts < LEAST_WITH_ROOM { 0 } else { contacts }
}

/// The largest number of corners of a convex piece of a body, or of the zone of a fender.
pub(crate) fn most_corners(model: &Model) -> usize {
    let pieces = (0..model.ranked.len()).flat_map(|rank| model.ranked.pieces(rank));
    pieces.map(ConvexPolygon::count).fold(4, usize::max)
}
