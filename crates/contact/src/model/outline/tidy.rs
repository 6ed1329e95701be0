//! Removes redundant vertices: repeated vertices, and vertices on a straight line.

use alloc::vec;
use alloc::vec::Vec;

use super::MERGE_DISTANCE_M;
use super::exact::turn;
use super::fault::{OutlineEdge, OutlineError};
use crate::maths::number::greater;
use crate::maths::vec2::{Vec2, vec2};

/// A vertex of an outline, and its number in the user's list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Numbered {
    pub(super) point: Vec2,
    pub(super) number: usize,
}

/// Coordinates below this size (m) are set to zero, because they are negligible and their products would underflow in
/// [`super::exact::turn`].
const NEGLIGIBLE_M: f64 = 1.0e-100;

/// Returns the vertices with their numbers, with each coordinate of negligible size set to zero.
pub(super) fn numbered(vertices: &[Vec2]) -> Vec<Numbered> {
    let flushed = |v: f64| if v.abs() < NEGLIGIBLE_M { 0.0 } else { v };
    vertices
        .iter()
        .enumerate()
        .map(|(number, p)| Numbered { point: vec2(flushed(p.x), flushed(p.y)), number })
        .collect()
}

/// Drops vertices within [`MERGE_DISTANCE_M`] of the last vertex kept or, at the end of the list, of the first vertex.
/// Returns the numbers of the dropped vertices, in ascending order.
pub(super) fn merge_duplicates(ring: &mut Vec<Numbered>) -> Vec<usize> {
    let mut dropped = Vec::new();
    let mut kept: Vec<Numbered> = Vec::with_capacity(ring.len());
    for &vertex in ring.iter() {
        match kept.last() {
            Some(last) if same_place(last.point, vertex.point) => dropped.push(vertex.number),
            _ => kept.push(vertex),
        }
    }
    while kept.len() > 1 && same_place(kept[kept.len() - 1].point, kept[0].point) {
        dropped.extend(kept.pop().map(|vertex| vertex.number));
    }
    dropped.sort_unstable();
    *ring = kept;
    dropped
}

fn same_place(a: Vec2, b: Vec2) -> bool {
    (a - b).length_squared() <= MERGE_DISTANCE_M * MERGE_DISTANCE_M
}

/// Returns true if all vertices are on one line, within 1e-12 of their extent.
pub(super) fn on_one_line(ring: &[Numbered]) -> bool {
    let origin = ring[0].point;
    let farthest = ring
        .iter()
        .map(|vertex| vertex.point - origin)
        .fold(Vec2::ZERO, |a, b| if b.length_squared() > a.length_squared() { b } else { a });
    let limit = 1.0e-12 * farthest.length_squared();
    ring.iter().all(|vertex| farthest.cross(vertex.point - origin).abs() <= limit)
}

/// Drops vertices that are on the straight line between their neighbours, until no such vertex is left. Returns the
/// numbers of the dropped vertices, in ascending order. "On the line" means within [`rounding_m`]: 1 pm for a ship of
/// 300 m. Even 10,000 dropped vertices in a row move the boundary of a ship of 300 m by no more than 1e-8 m. A vertex
/// of a circle of 10,000 vertices lies 1e7 times this limit off the line between its neighbours.
///
/// # Errors
///
/// Returns [`OutlineError::SelfIntersection`] if the outline doubles back, so that two successive edges lie on each
/// other.
pub(super) fn merge_collinear(ring: &mut Vec<Numbered>) -> Result<Vec<usize>, OutlineError> {
    let largest_m =
        ring.iter().map(|v| greater(v.point.x.abs(), v.point.y.abs())).fold(0.0, greater);
    let rounding_m = 16.0 * f64::EPSILON * largest_m;

    let count = ring.len();
    let mut next: Vec<usize> = (0..count).map(|i| (i + 1) % count).collect();
    let mut previous: Vec<usize> = (0..count).map(|i| (i + count - 1) % count).collect();
    let mut alive = vec![true; count];
    let mut left = count;
    let mut queue: Vec<usize> = (0..count).rev().collect();
    while let Some(i) = queue.pop() {
        if !alive[i] || left < 3 {
            continue;
        }
        let (before, after) = (previous[i], next[i]);
        if is_straight(ring[before].point, ring[i].point, ring[after].point, rounding_m) {
            alive[i] = false;
            left -= 1;
            next[before] = after;
            previous[after] = before;
            queue.push(after);
            queue.push(before);
        }
    }
    let dropped = ring.iter().zip(&alive).filter(|(_, a)| !**a).map(|(v, _)| v.number).collect();
    let mut still_there = alive.iter();
    ring.retain(|_| *still_there.next().expect("one flag a vertex"));
    refuse_spikes(ring, greater(MERGE_DISTANCE_M, rounding_m))?;
    Ok(dropped)
}

/// Largest distance from a line that rounding of the coordinates explains (m): 16 ε M, where M is the largest
/// coordinate. A point that was computed on a line as a + t(b − a), rotated by a heading or read from decimal text lies
/// 3 to 6 ε M off the line.
pub(super) fn rounding_m(points: impl Iterator<Item = Vec2>) -> f64 {
    16.0 * f64::EPSILON * points.map(|p| greater(p.x.abs(), p.y.abs())).fold(0.0, greater)
}

/// Returns true if the point b lies between a and c, within `limit_m` of the straight line.
pub(super) fn is_straight(a: Vec2, b: Vec2, c: Vec2, limit_m: f64) -> bool {
    let (to, from) = (b - a, c - b);
    to.dot(from) > 0.0 && to.cross(from).abs() <= limit_m * (c - a).length()
}

/// Returns true if the corner a, b, c turns in the negative sense by more than rounding explains. With the margin for
/// rounding, the answer for a seam in line with an edge is the same at any attitude of the outline.
pub(super) fn is_reflex([a, b, c]: [Vec2; 3], rounding_m: f64) -> bool {
    turn(a, b, c) < 0.0 && !is_straight(a, b, c, rounding_m)
}

fn refuse_spikes(ring: &[Numbered], limit_m: f64) -> Result<(), OutlineError> {
    let count = ring.len();
    for i in 0..count {
        let [a, b, c] = [ring[(i + count - 1) % count], ring[i], ring[(i + 1) % count]];
        let (to, from) = (b.point - a.point, c.point - b.point);
        let longer_m = greater(to.length(), from.length());
        if to.dot(from) < 0.0 && to.cross(from).abs() <= limit_m * longer_m {
            let edges = [
                OutlineEdge { from: a.number, to: b.number },
                OutlineEdge { from: b.number, to: c.number },
            ];
            return Err(OutlineError::SelfIntersection { edges });
        }
    }
    Ok(())
}
