//! Finds the convex pieces of two bodies that are near each other.

use core::ops::Range;

use super::box_tree::{BoxTree, Meeting};
use super::convex::ConvexPolygon;
use super::extent::Extent;
use crate::maths::vec2::Pose;

/// Least number of pieces of an outline with a tree: of an outline with fewer pieces, all pieces count as near.
pub(crate) const LEAST_WITH_TREE: usize = 8;

/// Rounding error of a box that is turned into another frame, relative to the coordinates.
const ROUNDING: f64 = 1e-13;

/// The convex pieces of the outline of one body of a pair.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shapes<'m> {
    pub(crate) pieces: &'m [ConvexPolygon],
    /// The tree over the convex pieces; `None` if there are few pieces.
    pub(crate) tree: Option<&'m BoxTree>,
}

/// A convex piece, and its number in the outline.
pub(crate) type Piece<'m> = (u32, &'m ConvexPolygon);

impl<'m> Shapes<'m> {
    /// Makes the shapes of an outline with few pieces, which needs no tree.
    pub(crate) fn few(pieces: &'m [ConvexPolygon]) -> Shapes<'m> {
        Shapes { pieces, tree: None }
    }

    /// A bounding box around all pieces.
    fn extent(&self) -> Extent {
        match self.tree {
            Some(tree) => tree.extent(),
            None => self.pieces.iter().fold(Extent::EMPTY, |all, piece| all.and(circled(piece))),
        }
    }

    /// The pieces near a place, in ascending order, with boxes around them. Without a tree the result is all pieces.
    #[inline]
    fn near(self, place: impl FnOnce() -> Extent) -> Near<'m> {
        match self.tree {
            Some(tree) => Near::Some(tree.meeting(place())),
            None => Near::All(self.pieces, 0..self.pieces.len()),
        }
    }
}

fn circled(piece: &ConvexPolygon) -> Extent {
    Extent::of_circle(piece.center_m(), piece.radius_m())
}

/// The pairs of a piece of `a` and a piece of `b` that may be `apart_m` or less apart, in the order of the pieces of
/// `a`, then of the pieces of `b`. The test compares bounding boxes, so some of the pairs may be farther apart.
#[inline]
pub(crate) fn near_pairs<'m>(
    a: Shapes<'m>,
    b: Shapes<'m>,
    b_in_a: Pose,
    apart_m: f64,
) -> impl Iterator<Item = [Piece<'m>; 2]> {
    let from_m = b_in_a.position_m.x.abs() + b_in_a.position_m.y.abs();
    let wider =
        move |place: Extent| place.widened(apart_m + ROUNDING * (from_m + place.farthest_m()));
    let of_a = a.near(move || wider(b.extent().placed(b_in_a)));
    of_a.flat_map(move |(piece_a, in_a)| {
        let of_b = b.near(move || wider(in_a.seen_from(b_in_a)));
        let shape_a = &a.pieces[piece_a as usize];
        of_b.map(move |(piece_b, _)| [(piece_a, shape_a), (piece_b, &b.pieces[piece_b as usize])])
    })
}

/// See [`Shapes::near`].
enum Near<'m> {
    All(&'m [ConvexPolygon], Range<usize>),
    Some(Meeting<'m>),
}

impl Iterator for Near<'_> {
    type Item = (u32, Extent);

    #[inline]
    fn next(&mut self) -> Option<(u32, Extent)> {
        match self {
            Near::All(pieces, left) => {
                left.next().map(|piece| (piece as u32, circled(&pieces[piece])))
            }
            Near::Some(meeting) => meeting.next(),
        }
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;
    use crate::geometry::clip::PairClip;
    use crate::maths::vec2::{Pose, Rotation, Vec2, vec2};
    use crate::model::outline::Outline;

    /// Numbers from 0 to 1 in a fixed order (Knuth's multiplicative congruential generator).
    struct Numbers(u64);

    impl Numbers {
        fn between(&mut self, low: f64, high: f64) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
        }

        /// An outline with a random radius at each corner.
        fn pieces(&mut self, corners: usize) -> Vec<ConvexPolygon> {
            let ring: Vec<Vec2> = (0..corners)
                .map(|k| {
                    let angle = core::f64::consts::TAU * k as f64 / corners as f64;
                    let radius_m = self.between(8.0, 20.0);
                    Rotation::from_angle(angle).apply(vec2(radius_m, 0.0))
                })
                .collect();
            let outline = Outline::new(&ring).expect("a star crosses itself nowhere").0;
            outline.pieces().iter().map(|piece| ConvexPolygon::new(piece)).collect()
        }
    }

    #[test]
    fn every_two_pieces_that_overlap_or_are_near_are_among_the_near_pairs() {
        let mut numbers = Numbers(3);
        let (mut clip, mut overlapping, mut left_out) = (PairClip::default(), 0, 0);
        for round in 0..60 {
            let (of_a, of_b) = (numbers.pieces(20 + 3 * round), numbers.pieces(24 + 2 * round));
            let trees = [BoxTree::new(&of_a), BoxTree::new(&of_b)];
            let place_m = vec2(numbers.between(-30.0, 30.0), numbers.between(-30.0, 30.0));
            let b_in_a = Pose::new(place_m, numbers.between(0.0, 6.3));
            let with_trees = [
                Shapes { pieces: &of_a, tree: Some(&trees[0]) },
                Shapes { pieces: &of_b, tree: Some(&trees[1]) },
            ];
            let without = [Shapes::few(&of_a), Shapes::few(&of_b)];
            let near = |[a, b]: [Shapes<'_>; 2], apart_m: f64| {
                let pairs = near_pairs(a, b, b_in_a, apart_m);
                pairs.map(|[one, two]| (one.0, two.0)).collect::<Vec<_>>()
            };
            let (found, all) = (near(with_trees, 0.0), near(without, 0.0));
            assert_eq!(all.len(), of_a.len() * of_b.len());
            assert!(found.is_sorted() && all.is_sorted());
            // Only one side has a tree, as at a fender.
            let one_tree = near([with_trees[0], without[1]], 0.0);
            let wider = near(with_trees, 1.5);
            let shifted = Pose { position_m: b_in_a.position_m + vec2(0.9, -1.1), ..b_in_a };
            for (a, b) in all {
                let shapes = (&of_a[a as usize], &of_b[b as usize]);
                let overlap = clip.clip(shapes.0, Pose::IDENTITY, shapes.1, b_in_a).is_some();
                let is_found = found.binary_search(&(a, b)).is_ok();
                assert!(is_found || !overlap, "{a} {b} in round {round}");
                assert!(one_tree.binary_search(&(a, b)).is_ok() || !overlap);
                // After a shift by 1.42 m the pieces overlap, so they were no farther apart than that.
                let later = clip.clip(shapes.0, Pose::IDENTITY, shapes.1, shifted).is_some();
                assert!(wider.binary_search(&(a, b)).is_ok() || !later, "{a} {b}");
                overlapping += u32::from(overlap);
                left_out += u32::from(!is_found);
            }
        }
        assert!(overlapping > 1_000 && left_out > 10 * overlapping, "{overlapping} {left_out}");
    }
}
