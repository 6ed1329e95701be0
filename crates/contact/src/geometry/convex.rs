//! A convex polygon, prepared for clipping.

use alloc::vec::Vec;

use super::edge::Edge;
use super::extent::Extent;
use super::ring::after;
use crate::maths::number::greater;
use crate::maths::vec2::{Pose, Vec2};

/// A vertex at which the boundary turns by less than this (sine of the angle) counts as straight and is dropped. The
/// computed sine of a turn has a rounding error of about 1e-15. The limit for a straight vertex is well above this
/// rounding error, and moves the boundary of a 300 m hull by less than 1e-10 m.
const STRAIGHT: f64 = 1e-12;

/// A convex polygon in the frame of its body, with its vertices in the positive sense of turning.
#[derive(Clone, Debug, PartialEq)]
pub struct ConvexPolygon {
    /// The vertices, with the first vertex repeated at the end, so that edge `i` runs from vertex `i` to vertex `i +
    /// 1`.
    closed: Vec<Vec2>,
    /// Start and end of each edge, so that one look-up gives both.
    ends: Vec<[Vec2; 2]>,
    /// The edges of the polygon; edge `i` starts at corner `i`.
    edges: Vec<Edge>,
    /// Index of the edge whose direction has the smallest angle in the range [0, 2π).
    first_by_angle: u32,
    /// Number of edges whose direction has an angle in the range [0, π).
    upper: u32,
    /// Centre of the bounding box, and radius of the polygon about this centre (m).
    center_m: Vec2,
    radius_m: f64,
    area_m2: f64,
}

impl ConvexPolygon {
    /// Makes a polygon from the vertices of a convex polygon, which must be in the positive sense of turning. Straight
    /// vertices are dropped.
    ///
    /// # Panics
    /// Panics if fewer than three corners are left. No piece of an [`Outline`](crate::model::outline::Outline) has so few
    /// corners.
    #[must_use]
    pub fn new(vertices_m: &[Vec2]) -> ConvexPolygon {
        let corners = without_straight_vertices(vertices_m);
        let count = corners.len();
        assert!(count >= 3, "a convex piece has at least three corners");
        let closed: Vec<Vec2> = corners.iter().chain(&corners[..1]).copied().collect();
        let ends = closed.windows(2).map(|two| [two[0], two[1]]).collect();
        let center_m = Extent::of(&closed).center_m();
        let radius_m =
            closed.iter().fold(0.0, |r, &v| greater(r, (v - center_m).length())) * (1.0 + 1e-12);
        let first_by_angle = first_by_angle(&closed) as u32;
        let upper = closed.windows(2).filter(|two| upper_half(two[1] - two[0])).count() as u32;
        let (area_m2, edges) = (signed_area(&corners), Edge::of_all(&corners));
        ConvexPolygon { closed, ends, edges, first_by_angle, upper, center_m, radius_m, area_m2 }
    }

    /// Moves a polygon: `corners_m` are its corners at the new place, in the same order. Allocates nothing.
    ///
    /// # Panics
    /// Panics if `corners_m` has another number of corners than the polygon.
    pub(crate) fn move_to(&mut self, corners_m: &[Vec2]) {
        let count = self.count();
        assert!(corners_m.len() == count, "a moved polygon has the same corners");
        for (index, &corner) in corners_m.iter().enumerate() {
            self.closed[index] = corner;
            self.ends[index] = [corner, corners_m[after(index, count)]];
            self.edges[index] = Edge::of(corners_m, index);
        }
        self.closed[count] = corners_m[0];
        self.center_m = Extent::of(&self.closed).center_m();
        let radius = |r: f64, &v: &Vec2| greater(r, (v - self.center_m).length());
        self.radius_m = self.closed.iter().fold(0.0, radius) * (1.0 + 1e-12);
    }

    /// Number of corners.
    #[must_use]
    #[inline]
    pub fn count(&self) -> usize {
        self.ends.len()
    }

    /// The corners of the polygon in the positive sense of turning (m).
    #[must_use]
    pub fn vertices(&self) -> &[Vec2] {
        &self.closed[..self.count()]
    }

    /// The corners of the polygon, with the first corner repeated at the end (m).
    #[inline]
    pub(crate) fn closed(&self) -> &[Vec2] {
        &self.closed
    }

    /// A corner of the polygon by its index; the index `count` gives the first corner again (m).
    #[inline]
    pub(crate) fn corner(&self, index: usize) -> Vec2 {
        self.closed[index]
    }

    /// Start and end of an edge of the polygon (m); `None` beyond the last edge.
    #[inline(always)]
    pub(crate) fn ends(&self, edge: u32) -> Option<&[Vec2; 2]> {
        self.ends.get(edge as usize)
    }

    /// The corners of the ring from the end of one edge to the start of a later edge (m).
    #[inline(always)]
    pub(crate) fn between(&self, first: u32, last: u32) -> impl Iterator<Item = Vec2> {
        let (last, count) = (last as usize, self.count());
        let mut edge = after(first as usize, count);
        core::iter::from_fn(move || {
            edge = if edge == last { last } else { after(edge, count) };
            (edge != last).then(|| self.corner(edge))
        })
    }

    /// The edges of the polygon, each with its own frame.
    #[inline]
    pub(crate) fn edges(&self) -> &[Edge] {
        &self.edges
    }

    #[inline]
    pub(crate) fn first_by_angle(&self) -> usize {
        self.first_by_angle as usize
    }

    /// The corner of the polygon that is farthest in a direction. The edges before the farthest corner are turned by
    /// less than a quarter turn from the direction, and the edges after it by more.
    #[inline]
    pub(crate) fn farthest(&self, direction: Vec2) -> usize {
        let along = direction.quarter_turn();
        let (count, upper) = (self.count(), self.upper as usize);
        let edge = |by_angle: usize| {
            let index = self.first_by_angle as usize + by_angle;
            if index >= count { index - count } else { index }
        };
        let (mut from, mut to) = if upper_half(along) { (0, upper) } else { (upper, count) };
        while from < to {
            let middle = (from + to) / 2;
            let [start, end] = self.ends[edge(middle)];
            if (end - start).cross(along) >= 0.0 {
                from = middle + 1;
            } else {
                to = middle;
            }
        }
        edge(from)
    }

    /// Centre of the bounding circle of the polygon (m).
    #[must_use]
    #[inline]
    pub fn center_m(&self) -> Vec2 {
        self.center_m
    }

    /// Radius of the bounding circle of the polygon (m).
    #[must_use]
    #[inline]
    pub fn radius_m(&self) -> f64 {
        self.radius_m
    }

    /// Area (m²).
    #[must_use]
    pub fn area_m2(&self) -> f64 {
        self.area_m2
    }
}

/// Returns true for a direction with an angle in the range [0, π), the first half of a walk through the edges by angle.
#[inline]
pub(crate) fn upper_half(direction: Vec2) -> bool {
    direction.y > 0.0 || (direction.y == 0.0 && direction.x > 0.0)
}

/// Finds the edge of a closed ring of corners whose direction has the smallest angle in the range [0, 2π).
pub(crate) fn first_by_angle(closed: &[Vec2]) -> usize {
    let count = closed.len() - 1;
    let upper = |i: usize| upper_half(closed[i + 1] - closed[i]);
    let mut before = upper(count - 1);
    for i in 0..count {
        let here = upper(i);
        if here && !before {
            return i;
        }
        before = here;
    }
    0
}

/// Returns true if a convex polygon of these vertices has three corners left when straight vertices are dropped. A
/// needle whose width is below 1e-12 of its length has fewer than three corners left.
pub(crate) fn has_width(vertices_m: &[Vec2]) -> bool {
    without_straight_vertices(vertices_m).len() >= 3
}

fn without_straight_vertices(vertices: &[Vec2]) -> Vec<Vec2> {
    let count = vertices.len();
    let mut kept: Vec<Vec2> = Vec::with_capacity(count + 1);
    for i in 0..count {
        let before = kept.last().copied().unwrap_or(vertices[count - 1]);
        let here = vertices[i];
        let (a, b) = (here - before, vertices[(i + 1) % count] - here);
        if a.cross(b) > STRAIGHT * a.length() * b.length() {
            kept.push(here);
        }
    }
    kept
}

/// The signed area of a polygon (m²), by the shoelace formula about the first vertex.
pub(crate) fn signed_area(vertices: &[Vec2]) -> f64 {
    let origin = vertices[0];
    let twice: f64 = vertices[1..].windows(2).map(|w| (w[0] - origin).cross(w[1] - origin)).sum();
    0.5 * twice
}

/// The second polygon of a pair, placed in the frame of the first polygon. The vertices of the second polygon are
/// transformed into the frame of the first polygon one by one, when they are needed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed<'a> {
    pub(crate) polygon: &'a ConvexPolygon,
    pub(crate) pose: Pose,
}

impl Placed<'_> {
    /// Vertex `i` of the second polygon's closed list, in the frame of the first polygon.
    #[inline]
    pub(crate) fn vertex(&self, i: usize) -> Vec2 {
        self.pose.apply(self.polygon.corner(i))
    }

    #[inline]
    pub(crate) fn count(&self) -> usize {
        self.polygon.count()
    }
}
