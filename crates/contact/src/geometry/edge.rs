//! An edge of a convex polygon, with a frame of its own.

use alloc::vec::Vec;

use super::ring::after;
use crate::maths::number::{greater, lesser};
use crate::maths::vec2::{Pose, Rotation, Vec2, vec2};

/// An edge of a convex polygon, with a trapezoid behind the edge that lies within the polygon.
///
/// In the frame of the edge, x runs along the edge and y into the polygon. x is measured from the polygon's origin, not
/// from the edge's start, so that a contact amidships loses no digits to the length of the ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Edge {
    pub(super) frame: Frame,
    /// Coordinate x of the edge's start and of its end (m).
    from_m: f64,
    to_m: f64,
    /// How far the two slanted sides of the trapezoid lean inwards, for each metre of y above the edge (m/m). A point
    /// (x, y) of the trapezoid has x ≥ from_m + y · from_start and x ≤ to_m − y · from_end.
    from_start: f64,
    from_end: f64,
    /// Height of the trapezoid (m).
    height_m: f64,
}

impl Edge {
    /// Makes the edges of a polygon from its ring of corners.
    pub(crate) fn of_all(corners_m: &[Vec2]) -> Vec<Edge> {
        (0..corners_m.len()).map(|index| Edge::of(corners_m, index)).collect()
    }

    /// The edge of a ring of corners that starts at the corner `index`.
    pub(crate) fn of(corners_m: &[Vec2], index: usize) -> Edge {
        let count = corners_m.len();
        let start_m = corners_m[index];
        let chord = corners_m[after(index, count)] - start_m;
        let length_m = chord.length();
        // A division, which is exact for edges along an axis.
        let along = vec2(chord.x / length_m, chord.y / length_m);
        let from_m = along.dot(start_m);
        let to_m = from_m + length_m;
        let frame = Frame {
            of_x: vec2(along.x, -along.y),
            of_y: vec2(along.y, along.x),
            origin_m: vec2(0.0, -along.cross(start_m)),
        };
        // The corners a third of the ring away from either end.
        let third = (count / 3).max(1);
        let [of_start, of_end] = [index + count - third, index + 1 + third]
            .map(|corner| frame.of(corners_m[corner % count]));
        Edge {
            frame,
            from_m,
            to_m,
            from_start: (of_start.x - from_m) / of_start.y,
            from_end: (to_m - of_end.x) / of_end.y,
            height_m: lesser(of_start.y, of_end.y),
        }
    }

    /// Returns true if the part of another convex polygon behind this edge is within the trapezoid. The part of the
    /// other polygon behind the edge lies between the lines through the two crossings, and reaches down to `deepest_m`.
    #[inline(always)]
    pub(super) fn holds(&self, [first, last]: [&Crosses; 2], deepest_m: f64) -> bool {
        let to_start = greater(self.from_start - last.slope, 0.0) * deepest_m;
        let to_end = greater(self.from_end + first.slope, 0.0) * deepest_m;
        last.x_m - self.from_m >= to_start
            && self.to_m - first.x_m >= to_end
            && deepest_m <= self.height_m
    }
}

/// The map from the frame of a polygon to the frame of one of its edges.
// Stored by columns, so that the processor multiplies two numbers at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    /// Unit vectors and origin (m) of the polygon's frame, expressed in the edge's frame.
    of_x: Vec2,
    of_y: Vec2,
    origin_m: Vec2,
}

impl Frame {
    #[inline(always)]
    fn turned(&self, v: Vec2) -> Vec2 {
        self.of_x * v.x + self.of_y * v.y
    }

    #[inline(always)]
    pub(super) fn of(&self, corner_m: Vec2) -> Vec2 {
        self.turned(corner_m) + self.origin_m
    }

    /// Maps a point from the frame of the edge back to the frame of the polygon.
    #[inline(always)]
    pub(super) fn back(&self, at_m: Vec2) -> Vec2 {
        let v = at_m - self.origin_m;
        vec2(self.of_x.dot(v), self.of_y.dot(v))
    }

    /// Unit vector along the edge, in the frame of the polygon.
    #[inline(always)]
    pub(super) fn along(&self) -> Vec2 {
        vec2(self.of_x.x, self.of_y.x)
    }

    /// The map to the edge's frame from the frame of another polygon at `pose`.
    #[inline(always)]
    pub(super) fn seen_by(&self, pose: Pose) -> Frame {
        let Rotation { cos, sin } = pose.rotation;
        Frame {
            of_x: self.of_x * cos + self.of_y * sin,
            of_y: self.of_y * cos - self.of_x * sin,
            origin_m: self.of(pose.position_m),
        }
    }

    /// The map to the edge's frame from a frame in which the edge's polygon is at `pose`.
    #[inline(always)]
    pub(super) fn placed_at(&self, pose: Pose) -> Frame {
        let Rotation { cos, sin } = pose.rotation;
        let (of_x, of_y) = (self.of_x * cos - self.of_y * sin, self.of_x * sin + self.of_y * cos);
        let turned = Frame { of_x, of_y, ..*self };
        Frame { origin_m: self.origin_m - turned.turned(pose.position_m), ..turned }
    }

    /// The same map from the polygon's frame to the edge's frame, but with x measured from `x_m`.
    #[inline(always)]
    pub(super) fn measured_from(&self, x_m: f64) -> Frame {
        Frame { origin_m: vec2(self.origin_m.x - x_m, self.origin_m.y), ..*self }
    }
}

/// The place where an edge of another polygon crosses the line of this edge, and the slope dx/dy of the crossing edge.
pub(super) struct Crosses {
    pub(super) x_m: f64,
    pub(super) slope: f64,
}

impl Crosses {
    /// Computes where an edge crosses the line, from its corner outside the line to its corner behind the line. The
    /// caller must check that the two corners lie on both sides of the line, and that the edge is not nearly parallel
    /// to the line. Edges that coincide are left to the cold path of the clip.
    #[inline(always)]
    pub(super) fn between(outside: Vec2, inside: Vec2) -> Crosses {
        let along = inside - outside;
        let slope = along.x / along.y;
        Crosses { x_m: inside.x - inside.y * slope, slope }
    }
}
