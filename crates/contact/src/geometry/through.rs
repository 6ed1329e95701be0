//! The commonest overlap: a few corners of one polygon have come through a single edge of the other, as a
//! fender's do through a hull's side.
//!
//! Seen along that edge the overlap is what of the first polygon lies behind the edge's line. The ring of a
//! convex polygon crosses a line twice at most, so that two crossings and the corners between them are all of
//! it, if they lie within the polygon whose edge it is: that the two crossings lie on the edge, and that the
//! corners lie within a quadrilateral inscribed behind it, is enough. Where it is not so [`super::warm`] answers.

use alloc::vec::Vec;

use super::convex::{ConvexPolygon, after};
use super::lens::{Lens, Stretch};
use super::warm::FLAT;
use crate::number::greater;
use crate::vec2::{Pose, Vec2, vec2};

/// A shorter chord has no direction to speak of [m].
const SHORTEST_M: f64 = 1e-9;

/// An edge of a convex polygon, and the part of it that lies behind the edge.
///
/// In the edge's frame x runs along it and y into the polygon. x is counted from where the polygon's origin lies,
/// not from the edge's start: a contact amidships loses nothing to the length of the ship.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Edge {
    /// Unit vector.
    along: Vec2,
    /// x of its start and end [m].
    from_m: f64,
    to_m: f64,
    /// y of the polygon's origin, negated [m].
    offset_m: f64,
    /// The sides of an inscribed quadrilateral from the edge's start and end: x − from ≥ y times the one, and
    /// to − x ≥ y times the other.
    from_start: f64,
    from_end: f64,
    /// And the side between them: its inner normal, not a unit vector, and −normal·x on it.
    top: Vec2,
    top_offset: f64,
}

impl Edge {
    /// The edges of a ring of corners.
    pub(crate) fn of_all(corners_m: &[Vec2]) -> Vec<Edge> {
        (0..corners_m.len()).map(|index| Edge::of(corners_m, index)).collect()
    }

    fn of(corners_m: &[Vec2], index: usize) -> Edge {
        let count = corners_m.len();
        let start_m = corners_m[index];
        let chord = corners_m[after(index, count)] - start_m;
        let length_m = chord.length();
        // Divided, so that along an axis it is one exactly.
        let along = vec2(chord.x / length_m, chord.y / length_m);
        let (from_m, offset_m) = (along.dot(start_m), along.cross(start_m));
        let to_m = from_m + length_m;
        // The two corners a third of the ring from either end.
        let third = (count / 3).max(1);
        let [of_start, of_end] = [index + count - third, index + 1 + third].map(|corner| {
            let corner_m = corners_m[corner % count];
            vec2(along.dot(corner_m), along.cross(corner_m) - offset_m)
        });
        let top = (of_start - of_end).quarter_turn();
        Edge {
            along,
            from_m,
            to_m,
            offset_m,
            from_start: (of_start.x - from_m) / of_start.y,
            from_end: (to_m - of_end.x) / of_end.y,
            top,
            top_offset: -top.dot(of_end),
        }
    }

    /// Is a point of the edge's frame within the inscribed quadrilateral, if it is behind the edge?
    #[inline(always)]
    fn holds(&self, at_m: Vec2) -> bool {
        (at_m.x - self.from_m >= self.from_start * at_m.y)
            & (self.to_m - at_m.x >= self.from_end * at_m.y)
            & (self.top.dot(at_m) + self.top_offset >= 0.0)
    }
}

/// An overlap of this kind, in A's frame, and where A's boundary enters and leaves it [m].
pub(crate) struct Through {
    pub(crate) lens: Lens,
    pub(crate) enters_m: Vec2,
    pub(crate) leaves_m: Vec2,
}

/// The overlap of `a` and `b`, placed in `a`'s frame, if the last one was of this kind and it still is.
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
        let (along, place_m) = (edge.along, b_in_a.position_m);
        let seen = Frame {
            along: b_in_a.rotation.apply_inverse(along),
            origin_m: vec2(along.dot(place_m), along.cross(place_m) - edge.offset_m),
        };
        let behind = behind(edge, seen, b, leave.b, enter.b)?;
        // A's boundary runs along the edge, into B where B's runs out of A.
        let own = Frame { along, origin_m: vec2(0.0, -edge.offset_m) };
        Some(behind.through(own, [behind.last_m, behind.first_m]))
    } else if enter.b == leave.b {
        let edge = b.edges().get(enter.b as usize)?;
        let along = b_in_a.rotation.apply(edge.along);
        let place_m = b_in_a.position_m;
        let origin_m = vec2(-along.dot(place_m), -along.cross(place_m) - edge.offset_m);
        let seen = Frame { along, origin_m };
        let behind = behind(edge, seen, a, enter.a, leave.a)?;
        Some(behind.through(seen, [behind.first_m, behind.last_m]))
    } else {
        None
    }
}

/// The edge's frame as one of the polygons sees it.
#[derive(Clone, Copy)]
struct Frame {
    along: Vec2,
    /// Origin of the polygon's frame in the edge's [m].
    origin_m: Vec2,
}

impl Frame {
    #[inline(always)]
    fn of(self, corner_m: Vec2) -> Vec2 {
        vec2(self.along.dot(corner_m), self.along.cross(corner_m)) + self.origin_m
    }

    /// Back from the edge's frame.
    #[inline(always)]
    fn back(self, at_m: Vec2) -> Vec2 {
        let Vec2 { x, y } = at_m - self.origin_m;
        self.along * x + self.along.quarter_turn() * y
    }
}

/// What lies behind an edge, in its frame.
struct Behind {
    /// Where the polygon comes in through the edge and goes out again [m]: first > last.
    first_m: f64,
    last_m: f64,
    area_m2: f64,
    centroid_m: Vec2,
    deepest_m: f64,
}

/// What of `polygon` lies behind the edge, if its edge number `first` comes in through it, number `last` goes
/// out again, and all between lies within the edge's polygon.
#[inline(always)]
fn behind(
    edge: &Edge,
    frame: Frame,
    polygon: &ConvexPolygon,
    first: u32,
    last: u32,
) -> Option<Behind> {
    let (corners_m, count) = (polygon.closed(), polygon.count());
    let (first, last) = (first as usize, last as usize);
    if first >= count || last >= count || first == last {
        return None;
    }
    let outside = frame.of(corners_m[first]);
    let mut here = frame.of(corners_m[first + 1]);
    let first_m = crossing_m(outside, here)?;
    let mut within = edge.holds(here);
    let mut deepest_m = here.y;
    let mut twice_m2 = 0.0;
    let mut moment = Vec2::ZERO;
    // About the first crossing: what is small is measured against what is near.
    let mut from = vec2(here.x - first_m, here.y);
    let mut index = after(first, count);
    while index != last {
        here = frame.of(corners_m[index + 1]);
        index = after(index, count);
        within &= edge.holds(here);
        deepest_m = greater(here.y, deepest_m);
        let to = vec2(here.x - first_m, here.y);
        let cross = from.cross(to);
        twice_m2 += cross;
        moment += (from + to) * cross;
        from = to;
    }
    let beyond = frame.of(corners_m[last + 1]);
    let last_m = crossing_m(beyond, here)?;
    let to = vec2(last_m - first_m, 0.0);
    let cross = from.cross(to);
    twice_m2 += cross;
    moment += (from + to) * cross;
    let on_edge =
        (last_m >= edge.from_m) & (first_m <= edge.to_m) & (first_m - last_m > SHORTEST_M);
    if !(within & on_edge & (twice_m2 > 0.0)) {
        return None;
    }
    let centroid_m = vec2(first_m, 0.0) + moment * (1.0 / (3.0 * twice_m2));
    Some(Behind { first_m, last_m, area_m2: 0.5 * twice_m2, centroid_m, deepest_m })
}

/// Where an edge crosses the line, if it does, from a corner outside to one behind it. Flat ones are left to
/// the cold path, which knows of edges that lie on one another.
#[inline(always)]
fn crossing_m(outside: Vec2, inside: Vec2) -> Option<f64> {
    let along = inside - outside;
    let crosses = (outside.y < 0.0) & (inside.y >= 0.0);
    let steep = along.y * along.y > FLAT * FLAT * along.length_squared();
    (crosses & steep).then(|| outside.x - along.x * (outside.y / along.y))
}

impl Behind {
    /// As A sees it, whose boundary runs along the edge from the one x to the other.
    #[inline(always)]
    fn through(&self, of_a: Frame, [enters, leaves]: [f64; 2]) -> Through {
        let width_m = self.first_m - self.last_m;
        let lens = Lens {
            area_m2: self.area_m2,
            centroid_m: of_a.back(self.centroid_m),
            chord_m: of_a.along * (leaves - enters),
            per_chord_m: 1.0 / width_m,
            spread_m2: self.deepest_m * width_m,
            collinear: false,
        };
        let [enters_m, leaves_m] = [enters, leaves].map(|x| of_a.back(vec2(x, 0.0)));
        Through { lens, enters_m, leaves_m }
    }
}

#[cfg(test)]
mod tests {
    use super::super::lens::{Crossing, assemble};
    use super::*;
    use crate::geometry::convex::Placed;

    /// A hull of 60 m whose starboard side is edge 3, and a fender's block at it.
    fn hull_and_block() -> (ConvexPolygon, ConvexPolygon) {
        let hull = [(-30.0, 8.0), (-30.0, -8.0), (20.0, -8.0), (30.0, 0.0), (20.0, 8.0)];
        let block = [(-2.0, -0.5), (2.0, -0.5), (2.0, 0.5), (-2.0, 0.5)];
        let [hull, block] = [hull.as_slice(), &block]
            .map(|corners| corners.iter().map(|&(x, y)| vec2(x, y)).collect::<Vec<_>>());
        (ConvexPolygon::new(&hull), ConvexPolygon::new(&block))
    }

    /// Edges of the hull and of the block at whose crossings one enters and leaves the other.
    fn at(enter: (u32, u32), leave: (u32, u32)) -> Stretch {
        let [enter, leave] = [enter, leave].map(|(a, b)| Crossing { a, b });
        Stretch { enter, leave }
    }

    #[track_caller]
    fn same(one: &Lens, other: &Lens) {
        let apart = |p: f64, q: f64| (p - q).abs() / q.abs().max(1e-3);
        assert!(apart(one.area_m2, other.area_m2) < 1e-13, "{one:?}, {other:?}");
        assert!((one.centroid_m - other.centroid_m).length() < 1e-13, "{one:?}, {other:?}");
        assert!((one.chord_m - other.chord_m).length() < 1e-13, "{one:?}, {other:?}");
        assert!(apart(one.spread_m2, other.spread_m2) < 1e-12, "{one:?}, {other:?}");
        assert!(apart(one.per_chord_m, other.per_chord_m) < 1e-13, "{one:?}, {other:?}");
    }

    /// As the walk round the overlap finds it, to rounding, whichever of the two has the edge.
    #[test]
    fn corners_through_an_edge_are_what_the_walk_finds() {
        let (hull, block) = hull_and_block();
        for (along_m, depth_m, heading_rad) in
            [(3.0, 0.2, 0.0), (-21.0, 0.45, 0.07), (12.0, 0.9, -0.2), (7.0, 0.1, 0.6)]
        {
            let pose = Pose::new(vec2(along_m, 8.5 - depth_m), heading_rad);
            let mut found = Vec::new();
            // The hull's side is its last edge; which of the block's are crossed turns with it.
            for (enter, leave) in (0..16).map(|k| (k / 4, k % 4)) {
                let hint = at((4, enter), (4, leave));
                found.extend(find(&hull, &block, pose, hint).map(|through| (hint, through)));
            }
            let [(hint, through)] = found.as_slice() else { panic!("{} at {pose:?}", found.len()) };
            let mut corners_m = Vec::new();
            let placed = Placed { polygon: &block, pose };
            same(&through.lens, &assemble(&hull, &placed, &[*hint], &mut corners_m));
            assert!((corners_m[0] - through.enters_m).length() < 1e-13);

            // The same seen from the block.
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

    /// Else what sticks out of the other side, or past the edge's end, would be counted.
    #[test]
    fn corners_that_go_further_than_the_polygon_behind_are_left_to_others() {
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
        // The long side of the block goes in by the hull's port side and out by her starboard side.
        let long: Vec<Vec2> = [(-2.0, -20.0), (2.0, -20.0), (2.0, 20.0), (-2.0, 20.0)]
            .map(|(x, y)| vec2(x, y))
            .into();
        let long = ConvexPolygon::new(&long);
        for hint in [side, at((4, 3), (4, 1))] {
            let pose = Pose::new(vec2(-10.0, 10.0), 0.0);
            assert!(find(&hull, &long, pose, hint).is_none());
        }
    }

    #[test]
    fn an_edge_along_the_edge_is_left_to_the_path_that_knows_of_such() {
        let (hull, block) = hull_and_block();
        // On it, and turned so little that it crosses it flat.
        for heading_rad in [0.0, 1e-10, -1e-10] {
            let pose = Pose::new(vec2(3.0, 8.5), heading_rad);
            for (enter, leave) in (0..16).map(|k| (k / 4, k % 4)) {
                let found = find(&hull, &block, pose, at((4, enter), (4, leave)));
                assert!(found.is_none(), "{enter} {leave} at {heading_rad}");
            }
        }
    }
}
