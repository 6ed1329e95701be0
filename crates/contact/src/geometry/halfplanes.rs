//! The cold path of the clip: computes the overlap of two convex polygons as an intersection of half-planes.
//!
//! The edges of a convex polygon are already sorted by direction. So the cold path merges the two lists of edges and
//! makes one pass with a double-ended queue, which solves every case in O(n + m): any number of crossings, one polygon
//! within the other, no overlap.

use alloc::vec::Vec;

use super::convex::{ConvexPolygon, first_by_angle, upper_half};
use super::lens::{Crossing, Stretch};
use super::ring::after;
use crate::maths::vec2::Vec2;

/// Edges count as coincident if the sine of the angle between them is below this limit (–) and their distance is below
/// this limit (m). A chord between edges within these two limits would follow rounding, not the shape of the polygons.
const SAME_DIRECTION: f64 = 1e-9;
const SAME_LINE_M: f64 = 1e-9;
/// The computed crossing of two edges has no digit that rounding leaves right if the sine of their angle is below this
/// limit.
const PARALLEL: f64 = 1e-14;

/// The result of the cold path of the clip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Found {
    /// No common area.
    Nothing,
    /// The first polygon lies wholly within the second polygon.
    FirstInside,
    /// The second polygon lies wholly within the first polygon.
    SecondInside,
    /// The boundaries of the polygons cross, and the buffers hold the stretches between the crossings.
    Crossings {
        /// True if some edges of the two polygons coincide.
        collinear: bool,
    },
}

/// The half-plane to the left of an edge of a polygon.
#[derive(Clone, Copy, Debug)]
struct HalfPlane {
    start: Vec2,
    along: Vec2,
    edge: u32,
    of_a: bool,
    /// True if an edge of the other polygon coincides with the edge of this half-plane.
    doubled: bool,
}

/// Buffers of the cold path of the clip, kept between calls.
#[derive(Clone, Debug, Default)]
pub(crate) struct Buffers {
    /// The vertices of the second polygon as a closed list, in the frame of the first polygon (m).
    pub(crate) b_m: Vec<Vec2>,
    /// Stretches of the first polygon's boundary inside the second polygon, in the order in which the boundary is
    /// walked.
    pub(crate) stretches: Vec<Stretch>,
    queue: Vec<HalfPlane>,
    /// `corners[k]` is the point where `queue[k]` meets `queue[k − 1]`.
    corners: Vec<Vec2>,
    /// Index of the first bounding half-plane in `queue`, and of the first corner in `corners`. The first corner is the
    /// point where the last half-plane meets the first half-plane.
    front: usize,
}

impl Buffers {
    /// Makes buffers with room for two polygons with this number of corners. Few clips use the cold path, and the first
    /// of them may come long after the start: the room is made beforehand so that a step does not allocate memory.
    pub(crate) fn with_room(corners: usize) -> Buffers {
        Buffers {
            b_m: Vec::with_capacity(corners + 1),
            stretches: Vec::with_capacity(corners),
            queue: Vec::with_capacity(2 * corners),
            corners: Vec::with_capacity(2 * corners),
            front: 0,
        }
    }

    /// The corners of the overlap that the sweep found, in the positive sense of turning (m).
    pub(crate) fn swept_m(&self) -> &[Vec2] {
        &self.corners[self.front..]
    }

    /// Vector sum of those edges of the overlap that belong to the first polygon (m).
    pub(crate) fn swept_chord_m(&self) -> Vec2 {
        let corners = self.swept_m();
        let ends = corners.iter().zip(corners.iter().cycle().skip(1));
        let of_a = ends.zip(&self.queue[self.front..]).filter(|(_, h)| h.of_a);
        of_a.fold(Vec2::ZERO, |sum, ((&start, &end), _)| sum + (end - start))
    }
}

/// Finds all crossings of the boundary of `a` with the boundary of the polygon in `buffers.b_m`.
pub(crate) fn intersect(a: &ConvexPolygon, buffers: &mut Buffers) -> Found {
    let Some(front) = sweep(a, buffers) else { return Found::Nothing };
    buffers.front = front;
    let closing = {
        let (last, first) = (buffers.queue[buffers.queue.len() - 1], buffers.queue[front]);
        corner(a, &buffers.b_m, last, first, buffers.corners.last().copied())
    };
    buffers.corners[front] = closing;
    let boundary = &buffers.queue[front..];
    let collinear = boundary.iter().any(|h| h.doubled);
    buffers.stretches.clear();
    // Begin where the first polygon's boundary enters the second: at an edge of the first polygon that follows an edge
    // of the second.
    let count = boundary.len();
    let at = |k: usize| &boundary[k % count];
    let Some(first) = (0..count).find(|&k| at(k).of_a && !at(k + count - 1).of_a) else {
        let (inside, all) = if boundary[0].of_a {
            (Found::FirstInside, a.count())
        } else {
            (Found::SecondInside, buffers.b_m.len() - 1)
        };
        // A region bounded by only some of one polygon's edges is an artefact of rounding.
        return if count == all { inside } else { Found::Nothing };
    };
    let mut enter = Crossing::default();
    for k in first..first + count {
        let (previous, here, next) = (at(k + count - 1), at(k), at(k + 1));
        if here.of_a && !previous.of_a {
            enter = Crossing { a: here.edge, b: previous.edge };
        }
        if here.of_a && !next.of_a {
            let leave = Crossing { a: here.edge, b: next.edge };
            buffers.stretches.push(Stretch { enter, leave });
        }
    }
    Found::Crossings { collinear }
}

/// Makes one pass over all half-planes in the order of their directions. After the sweep, `queue[front..]` holds the
/// half-planes that bound the overlap.
fn sweep(a: &ConvexPolygon, buffers: &mut Buffers) -> Option<usize> {
    let Buffers { b_m, queue, corners, .. } = buffers;
    queue.clear();
    corners.clear();
    let mut front = 0;
    let mut merged = Merge::new(a, b_m);
    while let Some(new) = merged.next() {
        while queue.len() > front + 1 && outside(new, corners[corners.len() - 1]) {
            queue.pop();
            corners.pop();
        }
        while queue.len() > front + 1 && outside(new, corners[front + 1]) {
            if queue[front].along.cross(new.along) < 0.0 {
                front += 1;
            } else {
                // Within half a turn of the front, a half-plane that cuts off the front's corner cuts off all corners
                // after it. If the last corner passed the test above, that is rounding.
                queue.truncate(front + 1);
                corners.truncate(front + 1);
            }
        }
        if queue.len() == front {
            queue.push(new);
            corners.push(Vec2::ZERO);
            continue;
        }
        let back = queue.len() - 1;
        let last = queue[back];
        let turn = last.along.cross(new.along);
        let mut new = new;
        if turn <= 0.0 || is_flat(turn, &last, &new) {
            let lengths = last.along.length() * new.along.length();
            let ahead = last.along.dot(new.along) > 0.0;
            if turn < -PARALLEL * lengths || (turn <= 0.0 && !(ahead && last.of_a != new.of_a)) {
                return None; // a gap of half a turn or more: the intersection is empty
            }
            if ahead && last.of_a != new.of_a {
                let inward_m = last.along.cross(new.start - last.start) / last.along.length();
                if inward_m.abs() <= SAME_LINE_M {
                    queue[back].doubled = true;
                    new.doubled = true;
                }
                if turn <= PARALLEL * lengths {
                    // The two lines have no corner between them: the line further in bounds the overlap.
                    if inward_m > 0.0 {
                        queue[back] = new;
                        if back > front {
                            let from = (back > front + 1).then(|| corners[back - 1]);
                            corners[back] = corner(a, b_m, queue[back - 1], new, from);
                        }
                    }
                    continue;
                }
            }
        }
        let from = (back > front).then(|| corners[back]);
        corners.push(corner(a, b_m, last, new, from));
        queue.push(new);
    }
    while queue.len() > front + 2 && outside(queue[front], corners[corners.len() - 1]) {
        queue.pop();
        corners.pop();
    }
    while queue.len() > front + 2 && outside(queue[queue.len() - 1], corners[front + 1]) {
        front += 1;
    }
    if queue.len() < front + 3 { None } else { Some(front) }
}

/// Returns true if the turn between two edges (their cross product) is below [`SAME_DIRECTION`]. The first test for a
/// flat turn needs no square root, and decides for nearly all edges.
#[inline]
fn is_flat(turn: f64, last: &HalfPlane, new: &HalfPlane) -> bool {
    turn * turn
        <= SAME_DIRECTION
            * SAME_DIRECTION
            * last.along.length_squared()
            * new.along.length_squared()
}

#[inline]
fn outside(h: HalfPlane, point: Vec2) -> bool {
    h.along.cross(point - h.start) < 0.0
}

/// The point at which the lines of two half-planes meet. Neighbouring edges of one polygon meet in a vertex of the
/// polygon.
///
/// `from` is the point where the first half-plane's part of the boundary begins. The second half-plane meets the
/// boundary part of the first half-plane ahead of `from`. Because of rounding, nearly parallel lines may seem to meet
/// behind `from`; the result is then `from`.
#[inline]
fn corner(
    a: &ConvexPolygon,
    b_m: &[Vec2],
    first: HalfPlane,
    second: HalfPlane,
    from: Option<Vec2>,
) -> Vec2 {
    if first.of_a == second.of_a {
        let count = if first.of_a { a.count() } else { b_m.len() - 1 };
        if after(first.edge as usize, count) == second.edge as usize {
            return second.start;
        }
    }
    let turn = first.along.cross(second.along);
    let meets =
        first.start + first.along * ((second.start - first.start).cross(second.along) / turn);
    match from {
        Some(begin) if first.along.dot(meets - begin) < 0.0 => begin,
        _ => meets,
    }
}

/// The edges of both polygons, merged into one order by direction.
struct Merge<'a> {
    a: Ring<'a>,
    b: Ring<'a>,
}

/// The edges of one polygon in the order of their directions; `head` is the next edge.
struct Ring<'a> {
    closed: &'a [Vec2],
    of_a: bool,
    next: usize,
    left: usize,
    head: Option<HalfPlane>,
}

impl<'a> Ring<'a> {
    fn new(closed: &'a [Vec2], of_a: bool, first: usize) -> Ring<'a> {
        let mut ring = Ring { closed, of_a, next: first, left: closed.len() - 1, head: None };
        ring.pop();
        ring
    }

    /// Returns the head of the list and replaces it by the next edge.
    #[inline(always)]
    fn pop(&mut self) -> Option<HalfPlane> {
        let following = (self.left > 0).then(|| {
            let edge = self.next;
            let start = self.closed[edge];
            let along = self.closed[edge + 1] - start;
            self.next = after(edge, self.closed.len() - 1);
            self.left -= 1;
            HalfPlane { start, along, edge: edge as u32, of_a: self.of_a, doubled: false }
        });
        core::mem::replace(&mut self.head, following)
    }
}

impl<'a> Merge<'a> {
    fn new(a: &'a ConvexPolygon, b_m: &'a [Vec2]) -> Merge<'a> {
        Merge {
            a: Ring::new(a.closed(), true, a.first_by_angle()),
            b: Ring::new(b_m, false, first_by_angle(b_m)),
        }
    }

    #[inline(always)]
    fn next(&mut self) -> Option<HalfPlane> {
        let a_is_next = match (&self.a.head, &self.b.head) {
            (Some(of_a), Some(of_b)) => not_after(of_a.along, of_b.along),
            (of_a, _) => of_a.is_some(),
        };
        if a_is_next { self.a.pop() } else { self.b.pop() }
    }
}

/// Returns true if the angle of `u`, in the range [0, 2π), is not larger than the angle of `v`.
#[inline]
fn not_after(u: Vec2, v: Vec2) -> bool {
    match (upper_half(u), upper_half(v)) {
        (true, false) => true,
        (false, true) => false,
        _ => u.cross(v) >= 0.0,
    }
}
