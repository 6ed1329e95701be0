//! The fast path of the clip for the most common overlap: some corners of one polygon have passed through a single edge
//! of the other polygon, as the corners of a fender pass through a hull's side.
//!
//! If the overlap passes through one edge, it is the part of the first polygon behind the line of this edge. The
//! boundary of a convex polygon crosses a line at most twice. So two crossings, and the corners between them, bound the
//! whole part behind the edge, if this part lies within the polygon that has the edge. Two tests show that the part
//! lies within the polygon: the crossings are on the edge, and the region between the two crossing lines, down to the
//! deepest corner, is within a trapezoid inscribed behind the edge. Otherwise [`super::warm`] is used.

use super::convex::ConvexPolygon;
use super::edge::{Crosses, Edge, Frame};
use super::lens::{Lens, Located, Stretch};
use super::warm::FLAT;
use crate::maths::number::{greater, lesser};
use crate::maths::vec2::{Pose, Vec2, vec2};

/// Least length of a chord with a meaningful direction (m).
const SHORTEST_M: f64 = 1e-9;

/// An overlap of two polygons through a single edge.
pub(crate) struct Through {
    pub(crate) lens: Lens,
    at: Stretch,
    /// The map from the frame of polygon A to the frame of the edge, and the coordinate x at which the boundary of A
    /// enters and leaves the overlap (m).
    of_a: Frame,
    enters_m: f64,
    leaves_m: f64,
}

impl Through {
    /// The points where the boundary of polygon A enters and leaves the overlap, in the frame of A.
    #[inline(always)]
    pub(crate) fn located(&self) -> Located {
        let [enters_m, leaves_m] =
            [self.enters_m, self.leaves_m].map(|x| self.of_a.back(vec2(x, 0.0)));
        Located { at: self.at, enters_m, leaves_m }
    }
}

/// Finds the overlap of `a` and `b` if it passes through one edge in this step, as in the last step. `b` is placed in
/// the frame of `a`.
#[inline(always)]
pub(crate) fn find(
    a: &ConvexPolygon,
    b: &ConvexPolygon,
    b_in_a: Pose,
    hint: Stretch,
) -> Option<Through> {
    let Stretch { enter, leave } = hint;
    if enter.a == leave.a {
        let edge = a.edges().get(enter.a as usize)?;
        let behind = behind(edge, edge.frame.seen_by(b_in_a), b, leave.b, enter.b)?;
        // A's boundary runs along the edge, and enters B where B's boundary leaves A.
        Some(behind.through(hint, edge.frame, [behind.last_m, 0.0]))
    } else if enter.b == leave.b {
        let edge = b.edges().get(enter.b as usize)?;
        let of_a = edge.frame.placed_at(b_in_a);
        let behind = behind(edge, of_a, a, enter.a, leave.a)?;
        Some(behind.through(hint, of_a, [0.0, behind.last_m]))
    } else {
        None
    }
}

/// The part of a polygon behind an edge, in the frame of the edge. The coordinate x is measured from the place where
/// the boundary enters the part.
struct Behind {
    /// Place at which the boundary enters the part behind the edge, with x measured as in [`Edge`] (m).
    first_m: f64,
    /// Place at which the boundary leaves the part behind the edge (m); negative.
    last_m: f64,
    twice_m2: f64,
    centroid_m: Vec2,
    deepest_m: f64,
}

/// Computes the part of `polygon` behind the edge. Returns `None` unless the boundary enters by edge `first`, leaves by
/// edge `last`, and stays within the edge's polygon in between.
#[inline(always)]
fn behind(
    edge: &Edge,
    frame: Frame,
    polygon: &ConvexPolygon,
    first: u32,
    last: u32,
) -> Option<Behind> {
    let (between, [outside, inside], [before, beyond]) =
        (polygon.between(first, last), *polygon.ends(first)?, *polygon.ends(last)?);
    let [outside, inside, before, beyond] =
        [outside, inside, before, beyond].map(|corner_m| frame.of(corner_m));
    let (first, last) = (Crosses::between(outside, inside), Crosses::between(beyond, before));
    // Computed relative to the first crossing, so that small overlaps are accurate.
    let origin = vec2(first.x_m, 0.0);
    let frame = frame.measured_from(first.x_m);
    let mut sums = Sums { from: inside - origin, twice_m2: 0.0, moment: Vec2::ZERO };
    let mut deepest_m = greater(inside.y, before.y);
    for corner_m in between {
        let corner = frame.of(corner_m);
        deepest_m = greater(deepest_m, corner.y);
        sums.add(corner);
    }
    // For a single corner this adds zero.
    sums.add(before - origin);
    let last_m = last.x_m - first.x_m;
    let Sums { twice_m2, moment, .. } = sums.closed(last_m);
    let crosses = greater(outside.y, beyond.y) < 0.0
        && lesser(inside.y, before.y) >= 0.0
        && greater(first.slope.abs(), last.slope.abs()) < 1.0 / FLAT;
    let held = edge.holds([&first, &last], deepest_m);
    if !(crosses && held && last_m < -SHORTEST_M && twice_m2 > 0.0) {
        return None;
    }
    let centroid_m = moment * (1.0 / (3.0 * twice_m2));
    Some(Behind { first_m: first.x_m, last_m, twice_m2, centroid_m, deepest_m })
}

/// Sums for area and centroid over a walk round an area, which begins at the origin.
struct Sums {
    from: Vec2,
    twice_m2: f64,
    moment: Vec2,
}

impl Sums {
    /// Continues the walk round the area to another corner.
    #[inline(always)]
    fn add(&mut self, to: Vec2) {
        let cross = self.from.cross(to);
        self.twice_m2 += cross;
        self.moment += (self.from + to) * cross;
        self.from = to;
    }

    /// Closes the walk round the area at the point x = `x_m`, y = 0.
    #[inline(always)]
    fn closed(mut self, x_m: f64) -> Sums {
        let cross = -(self.from.y * x_m);
        self.twice_m2 += cross;
        self.moment += vec2(self.from.x + x_m, self.from.y) * cross;
        self
    }
}

impl Behind {
    /// Converts the overlap into the frame of A's polygon, whose boundary enters and leaves the overlap at the given x.
    #[inline(always)]
    fn through(&self, at: Stretch, of_a: Frame, [enters_m, leaves_m]: [f64; 2]) -> Through {
        let of_a = of_a.measured_from(self.first_m);
        let width_m = -self.last_m;
        let lens = Lens {
            area_m2: 0.5 * self.twice_m2,
            centroid_m: of_a.back(self.centroid_m),
            chord_m: of_a.along() * (leaves_m - enters_m),
            per_chord_m: 1.0 / width_m,
            spread_m2: self.deepest_m * width_m,
            collinear: false,
        };
        Through { lens, at, of_a, enters_m, leaves_m }
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::super::lens::{Crossing, assemble};
    use super::*;
    use crate::geometry::convex::Placed;

    /// A hull of 60 m whose starboard side is edge 3, and a fender's block at this side.
    fn hull_and_block() -> (ConvexPolygon, ConvexPolygon) {
        let hull = [(-30.0, 8.0), (-30.0, -8.0), (20.0, -8.0), (30.0, 0.0), (20.0, 8.0)];
        let block = [(-2.0, -0.5), (2.0, -0.5), (2.0, 0.5), (-2.0, 0.5)];
        let [hull, block] = [hull.as_slice(), &block]
            .map(|corners| corners.iter().map(|&(x, y)| vec2(x, y)).collect::<Vec<_>>());
        (ConvexPolygon::new(&hull), ConvexPolygon::new(&block))
    }

    /// A stretch given by the edges of hull and block at which one boundary enters and leaves the other.
    fn at(enter: (u32, u32), leave: (u32, u32)) -> Stretch {
        let [enter, leave] = [enter, leave].map(|(a, b)| Crossing { a, b });
        Stretch { enter, leave }
    }

    #[track_caller]
    fn same(one: &Lens, other: &Lens) {
        let apart = |p: f64, q: f64| (p - q).abs() / greater(q.abs(), 1e-3);
        assert!(apart(one.area_m2, other.area_m2) < 1e-13, "{one:?}, {other:?}");
        assert!((one.centroid_m - other.centroid_m).length() < 1e-13, "{one:?}, {other:?}");
        assert!((one.chord_m - other.chord_m).length() < 1e-13, "{one:?}, {other:?}");
        assert!(apart(one.spread_m2, other.spread_m2) < 1e-12, "{one:?}, {other:?}");
        assert!(apart(one.per_chord_m, other.per_chord_m) < 1e-13, "{one:?}, {other:?}");
    }

    /// The two results are equal to rounding, whichever polygon has the edge.
    #[test]
    fn the_fast_path_equals_the_walk() {
        let (hull, block) = hull_and_block();
        for (along_m, depth_m, heading_rad) in
            [(3.0, 0.2, 0.0), (-21.0, 0.45, 0.07), (12.0, 0.9, -0.2), (7.0, 0.1, 0.6)]
        {
            let pose = Pose::new(vec2(along_m, 8.5 - depth_m), heading_rad);
            let mut found = Vec::new();
            // The hull's side is its last edge; the crossed edges of the block depend on its heading.
            for (enter, leave) in (0..16).map(|k| (k / 4, k % 4)) {
                let hint = at((4, enter), (4, leave));
                found.extend(find(&hull, &block, pose, hint).map(|through| (hint, through)));
            }
            let [(hint, through)] = found.as_slice() else { panic!("{} at {pose:?}", found.len()) };
            let mut corners_m = Vec::new();
            let placed = Placed { polygon: &block, pose };
            same(&through.lens, &assemble(&hull, &placed, &[*hint], &mut corners_m));
            assert!((corners_m[0] - through.located().enters_m).length() < 1e-13);

            // The same overlap in the block's frame.
            let hull_in_block = pose.to(Pose::IDENTITY);
            let Stretch { enter, leave } = *hint;
            let hint = at((leave.b, leave.a), (enter.b, enter.a));
            let Some(through) = find(&block, &hull, hull_in_block, hint) else {
                panic!("{pose:?}")
            };
            let placed = Placed { polygon: &hull, pose: hull_in_block };
            same(&through.lens, &assemble(&block, &placed, &[hint], &mut Vec::new()));
        }
    }

    /// Otherwise the fast path would count a part beyond the other side or past the end of the edge.
    #[test]
    fn corners_beyond_the_edges_polygon_are_left_to_other_paths() {
        let (hull, block) = hull_and_block();
        let through = |north_m: f64, east_m: f64, hint: Stretch| {
            let pose = Pose::new(vec2(north_m, east_m), 0.0);
            find(&hull, &block, pose, hint).is_some()
        };
        let side = at((4, 1), (4, 3));
        assert!(through(-10.0, 8.3, side) || through(-10.0, 8.3, at((4, 3), (4, 1))));
        for hint in [side, at((4, 3), (4, 1))] {
            assert!(!through(-31.0, 8.3, hint), "half of it is past the stern");
            assert!(!through(-10.0, 9.0, hint), "it does not reach the side");
        }
        // The long block reaches from the hull's starboard side through her port side.
        let long: Vec<Vec2> = [(-2.0, -20.0), (2.0, -20.0), (2.0, 20.0), (-2.0, 20.0)]
            .map(|(x, y)| vec2(x, y))
            .into();
        let long = ConvexPolygon::new(&long);
        for hint in [side, at((4, 3), (4, 1))] {
            let pose = Pose::new(vec2(-10.0, 10.0), 0.0);
            assert!(find(&hull, &long, pose, hint).is_none());
        }
    }

    /// No counted corner is outside the hull, even near the ends of the side and deep in the hull.
    #[test]
    fn the_overlap_is_within_the_edges_polygon() {
        let (hull, block) = hull_and_block();
        let outside = |corner_m: Vec2| {
            hull.closed().windows(2).any(|e| (e[1] - e[0]).cross(corner_m - e[0]) < -1e-9)
        };
        let mut found = 0;
        let steps = |count: i32, from: f64, to: f64| {
            (0..=count).map(move |k| from + (to - from) * f64::from(k) / f64::from(count))
        };
        for along_m in steps(16, -32.0, -28.0).chain(steps(16, 18.0, 22.0)) {
            for (depth_m, heading_rad) in [0.1, 0.5, 1.1, 2.0]
                .into_iter()
                .flat_map(|d| steps(24, -1.5, 1.5).map(move |h| (d, h)))
            {
                let pose = Pose::new(vec2(along_m, 8.6 - depth_m), heading_rad);
                for (enter, leave) in (0..16).map(|k| (k / 4, k % 4)) {
                    let hint = at((4, enter), (4, leave));
                    let Some(_) = find(&hull, &block, pose, hint) else { continue };
                    found += 1;
                    let mut corners_m = Vec::new();
                    let placed = Placed { polygon: &block, pose };
                    assemble(&hull, &placed, &[hint], &mut corners_m);
                    assert!(!corners_m.iter().any(|&c| outside(c)), "{corners_m:?} at {pose:?}");
                }
            }
        }
        assert!(found > 500, "{found}");
    }

    #[test]
    fn nearly_parallel_edges_are_left_to_the_cold_path() {
        let (hull, block) = hull_and_block();
        // On the side, and turned so little that the block is nearly parallel to it.
        for heading_rad in [0.0, 1e-10, -1e-10] {
            let pose = Pose::new(vec2(3.0, 8.5), heading_rad);
            for (enter, leave) in (0..16).map(|k| (k / 4, k % 4)) {
                let found = find(&hull, &block, pose, at((4, enter), (4, leave)));
                assert!(found.is_none(), "{enter} {leave} at {heading_rad}");
            }
        }
    }
}
