//! Outlines of a hull at the heights of fenders, and the slope of the hull's side at these heights
//! (docs/contact_model.md, section 8).
//!
//! A body with outlines by height has no single outline for fenders: each fender meets the outline at its own height.
//! The host, the program that moves the hull, cuts these slices at the heights of the fenders. The host renews the
//! slices between steps when tide, heave, roll or pitch have changed the height of the hull: see
//! [`crate::Model::renew_slice`].

use alloc::vec::Vec;

use crate::geometry::convex::{ConvexPolygon, signed_area};
use crate::maths::number::{greater, lesser};
use crate::maths::vec2::{Pose, Vec2};
use crate::model::fender::RankedFender;
use crate::model::outline::{Outline, OutlineError};
use crate::touch::face_frame::Frame;

/// Depth behind a hull's nearest point within which sides give the slope if the hull does not yet reach a fender's face
/// (m).
const NEAREST_M: f64 = 1e-6;

/// The outline of a body at the height of a fender.
#[derive(Clone, Debug, PartialEq)]
pub struct Slice {
    pub(crate) pieces: Vec<ConvexPolygon>,
    edges: Vec<Edge>,
}

/// The side of a hull that is before a fender's face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideMet {
    /// The tangent of the angle by which the side leans out over the fender. The tangent of the angle is the growth of
    /// the overlap with height, divided by its growth with the hull's motion along the force. The slope is positive if
    /// the side flares out upwards.
    pub slope: f64,
    /// The middle of the part of the hull's side that is before the fender's face, in the frame of the hull (m).
    pub place_m: Vec2,
}

/// An edge of a slice, in the positive sense of turning: its two ends (m), and how the ends move with height (m/m).
#[derive(Clone, Copy, Debug, PartialEq)]
struct Edge {
    ends_m: [Vec2; 2],
    rates: [Vec2; 2],
}

impl Slice {
    /// Makes a slice from its vertices in the frame of the body (m), in either direction, and from the rate at which
    /// each vertex moves as the height rises (m/m). Missing rates are zero, which means a vertical side.
    ///
    /// # Errors
    /// As [`Outline::new`].
    pub fn new(vertices_m: &[Vec2], rates: &[Vec2]) -> Result<Slice, OutlineError> {
        let (outline, _) = Outline::new(vertices_m)?;
        let pieces = outline.pieces().iter().map(|piece| ConvexPolygon::new(piece)).collect();
        let rate = |index: usize| rates.get(index).copied().unwrap_or(Vec2::ZERO);
        let count = vertices_m.len();
        let turned = signed_area(vertices_m) < 0.0;
        let edge = |index: usize| {
            let next = (index + 1) % count;
            let (from, to) = if turned { (next, index) } else { (index, next) };
            Edge { ends_m: [vertices_m[from], vertices_m[to]], rates: [rate(from), rate(to)] }
        };
        Ok(Slice { pieces, edges: (0..count).map(edge).collect() })
    }

    /// The edges of the slice, each given by its two ends (m).
    pub(crate) fn edges_m(&self) -> impl Iterator<Item = [Vec2; 2]> {
        self.edges.iter().map(|edge| edge.ends_m)
    }

    /// Finds the side of the hull before a fender's face: where hull and face touch, or where the hull is nearest to
    /// the face. Returns `None` if no side of the hull is before the face.
    ///
    /// The slope is ∫ p v′·n ds / |∫ p n ds| over the sides before the face, with the pressure p on the face. The slope
    /// is the ratio of two gradients of the stored energy: by height, and in the plane. The pressure p is uniform for a
    /// reaction curve, and grows with the depth for the area law. `hull` and `host` are the poses of the hull and of
    /// the body that carries the fender, in one frame.
    pub(crate) fn side(
        &self,
        face: &RankedFender,
        grows_with_depth: bool,
        hull: Pose,
        host: Pose,
    ) -> Option<SideMet> {
        let frame = Frame::of(face.inward, face.face_m, host);
        let turned = |v: Vec2| frame.turned_to_face(hull.rotation.apply(v));
        let place = |v: Vec2| frame.to_face(hull.apply(v));
        let half_m = 0.5 * face.width_m;
        // Sides that face the fender, cut to the strip before the fender.
        let sides = || {
            self.edges.iter().filter_map(|edge| {
                let ends_m = edge.ends_m.map(place);
                let faces_it = (ends_m[1] - ends_m[0]).quarter_turn_back().x > 0.0;
                let whole = Part { ends_m, rates: edge.rates.map(turned) };
                if faces_it { whole.within(|v| v.y, -half_m, half_m) } else { None }
            })
        };
        let deepest_m =
            sides().flat_map(|side| side.ends_m.map(|end| end.x)).fold(f64::NEG_INFINITY, greater);
        let presses = deepest_m > 0.0;
        let (from_m, to_m) = if presses {
            (0.0, 2.0 * face.bounds.projection_m)
        } else {
            (deepest_m - NEAREST_M, deepest_m)
        };
        let by_depth = grows_with_depth && presses;
        let (mut by_height, mut by_motion) = (0.0, Vec2::ZERO);
        let (mut moment, mut weight) = (Vec2::ZERO, 0.0);
        for side in sides().filter_map(|side| side.within(|v| v.x, from_m, to_m)) {
            let (height, motion) = side.gradients(by_depth);
            by_height += height;
            by_motion += motion;
            let size = motion.length();
            moment += (side.ends_m[0] + side.ends_m[1]) * (0.5 * size);
            weight += size;
        }
        let size = by_motion.length();
        (size > 0.0).then(|| {
            let at = moment * (1.0 / weight);
            let place_m =
                hull.apply_inverse(frame.face_m + frame.inward * at.x + frame.along * at.y);
            SideMet { slope: by_height / size, place_m }
        })
    }
}

/// A part of a hull's side in the frame of the face: x inwards, y along the face.
#[derive(Clone, Copy, Debug)]
struct Part {
    ends_m: [Vec2; 2],
    rates: [Vec2; 2],
}

impl Part {
    /// The piece of this part whose coordinate lies from `low_m` to `high_m`; `None` if there is no such piece.
    fn within(&self, coordinate: impl Fn(Vec2) -> f64, low_m: f64, high_m: f64) -> Option<Part> {
        let [from_m, to_m] = self.ends_m.map(coordinate);
        let (mut first, mut last) = (0.0, 1.0);
        let length_m = to_m - from_m;
        if length_m == 0.0 {
            return (low_m..=high_m).contains(&from_m).then_some(*self);
        }
        let [one, two] = [low_m, high_m].map(|bound_m| (bound_m - from_m) / length_m);
        first = greater(first, lesser(one, two));
        last = lesser(last, greater(one, two));
        let at = |[from, to]: [Vec2; 2]| [first, last].map(|share| from + (to - from) * share);
        (first < last).then(|| Part { ends_m: at(self.ends_m), rates: at(self.rates) })
    }

    /// Computes the integrals ∫ p v′·n ds and ∫ p n ds over the part, with p = 1 or p = x. Simpson's rule is exact for
    /// these integrals, because the integrands are polynomials of the second degree at most.
    fn gradients(&self, by_depth: bool) -> (f64, Vec2) {
        let [from, to] = self.ends_m;
        let normal = (to - from).quarter_turn_back();
        let [first, last] = self.rates;
        let points =
            [(from, first, 1.0), ((from + to) * 0.5, (first + last) * 0.5, 4.0), (to, last, 1.0)];
        let (mut height, mut motion) = (0.0, 0.0);
        for (at, rate, weight) in points {
            let p = if by_depth { at.x } else { 1.0 } * weight * (1.0 / 6.0);
            height += p * rate.dot(normal);
            motion += p;
        }
        (height, normal * motion)
    }
}

/// The slices of all bodies with outlines by height in a model.
#[derive(Clone, Debug, Default)]
pub(crate) struct Slices {
    /// For each body by rank: its number among the bodies with outlines by height, counted from 1; 0 for other bodies.
    /// The list of numbers is empty if no body has outlines by height.
    numbers: Vec<u32>,
    /// Number of bodies with outlines by height.
    count: u32,
    /// The slice that each face meets of each body with outlines by height. `None` means that the body has no side at
    /// the height of the face.
    slots: Vec<Option<Slice>>,
}

impl Slices {
    /// Makes room for the slices of the bodies with these ranks, and of this number of faces.
    pub(crate) fn new(bodies: usize, ranks: &[u32], faces: usize) -> Slices {
        if ranks.is_empty() {
            return Slices::default();
        }
        let mut numbers = alloc::vec![0; bodies];
        for (number, &rank) in (1..).zip(ranks) {
            numbers[rank as usize] = number;
        }
        let slots = (0..faces * ranks.len()).map(|_| None).collect();
        Slices { numbers, count: ranks.len() as u32, slots }
    }

    /// Returns true for a model without outlines by height.
    #[inline(always)]
    pub(crate) fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// The ranks of the bodies with outlines by height.
    pub(crate) fn ranks(&self) -> impl Iterator<Item = u32> {
        (0..).zip(&self.numbers).filter(|&(_, &number)| number > 0).map(|(rank, _)| rank)
    }

    /// The index of the slice of a body that a fender's face meets; `None` for a body with one outline. `face` is the
    /// number of the fender's face, counted from 1.
    #[inline]
    pub(crate) fn place(&self, face: u32, rank: u32) -> Option<usize> {
        let number = self.numbers.get(rank as usize)?.checked_sub(1)?;
        Some(((face - 1) * self.count + number) as usize)
    }

    /// The slice with this index in the list of slices; `None` if the body has no side at the height of the face.
    #[inline]
    pub(crate) fn at(&self, place: usize) -> Option<&Slice> {
        self.slots[place].as_ref()
    }

    pub(crate) fn slot(&mut self, place: usize) -> &mut Option<Slice> {
        &mut self.slots[place]
    }
}
