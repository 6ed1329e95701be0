//! Computes the overlap of two convex polygons, from the result of the last step (warm) or without it (cold).

use alloc::vec::Vec;

use super::apart;
use super::axis::{BestAxis, best_axis};
use super::convex::{ConvexPolygon, Placed, signed_area};
use super::halfplanes::{self, Buffers, Found};
use super::lens::{Crossing, Lens, Located, Stretch, assemble, measure, per_chord_m, trace};
use super::ring::climb;
use super::through::{self, Through};
use super::warm;
use crate::maths::number::lesser;
use crate::maths::vec2::{Pose, Vec2};
use crate::panel::press::PanelPress;

/// The result of the last clip of two polygons, from which the search starts in this step. A hint changes the speed of
/// the clip of two polygons, never its result.
// The tag is a whole word: a one-byte tag would be copied apart from the rest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub(crate) enum Hint {
    /// Nothing is known.
    #[default]
    None,
    /// The boundaries of the two polygons crossed at these edges.
    Lens(Stretch),
    /// The edge `edge` separated the two polygons from each other.
    Apart {
        /// True if the separating edge belongs to the first polygon.
        on_a: bool,
        /// The separating edge.
        edge: u32,
        /// The vertex of the other polygon that is deepest behind the separating edge.
        support: u32,
    },
}

impl Hint {
    /// Encodes the hint as five words for snapshots.
    pub(crate) fn to_words(self) -> [u32; 5] {
        match self {
            Hint::None => [0, 0, 0, 0, 0],
            Hint::Lens(s) => [1, s.enter.a, s.enter.b, s.leave.a, s.leave.b],
            Hint::Apart { on_a, edge, support } => [2, u32::from(on_a), edge, support, 0],
        }
    }

    /// Decodes a hint from the words of [`Hint::to_words`]; returns `None` for words that are not a hint.
    pub(crate) fn from_words(words: [u32; 5]) -> Option<Hint> {
        match words {
            [0, 0, 0, 0, 0] => Some(Hint::None),
            [1, enter_a, enter_b, leave_a, leave_b] => Some(Hint::Lens(Stretch {
                enter: Crossing { a: enter_a, b: enter_b },
                leave: Crossing { a: leave_a, b: leave_b },
            })),
            [2, on_a @ (0 | 1), edge, support, 0] => {
                Some(Hint::Apart { on_a: on_a == 1, edge, support })
            }
            _ => None,
        }
    }
}

/// Buffers of the clip of two polygons, kept between calls so that a step that starts from the last result allocates no
/// memory.
#[derive(Clone, Debug, Default)]
pub(crate) struct ClipBuffers {
    cold: Buffers,
    /// The panel pressed last.
    pub(crate) panel: PanelPress,
}

impl ClipBuffers {
    /// Makes buffers with room for polygons with this number of corners.
    pub(crate) fn with_room(corners: usize) -> ClipBuffers {
        ClipBuffers { cold: Buffers::with_room(corners), panel: PanelPress::default() }
    }
}

/// The overlap of two convex polygons, in the frame of the first polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clip {
    pub(crate) lens: Lens,
    /// True if one polygon lies wholly within the other.
    pub(crate) contained: bool,
}

impl Clip {
    /// Area S of the overlap (m²).
    #[must_use]
    pub fn area_m2(&self) -> f64 {
        self.lens.area_m2
    }

    /// Centroid C of the overlap, in the frame of the first polygon (m).
    #[must_use]
    pub fn centroid_m(&self) -> Vec2 {
        self.lens.centroid_m
    }

    /// Chord vector d = Σ (P_out − P_in): the sum from entry to exit over the stretches of the first polygon's boundary
    /// inside the second polygon, in the first polygon's frame (m). The normal n of the contact is the chord vector d,
    /// turned by −90°. The chord vector is zero if one polygon contains the other.
    #[must_use]
    pub fn chord_m(&self) -> Vec2 {
        self.lens.chord_m
    }
}

/// Tells whether the caller needs the corners of an overlap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Corners {
    Always,
    /// The caller needs the corners only if the overlap has no usable chord.
    WithoutChord,
}

/// Computes the overlap of the polygons `a` and `b`; returns `None` if they have no area in common. The pose of `b` is
/// given in the frame of `a`. The clip updates `hint` for the next step. The vertices of the overlap are appended to
/// the list if the caller wants them.
// Always inlined, so that arguments and result stay in registers.
#[inline(always)]
pub(crate) fn clip(
    a: &ConvexPolygon,
    b: &ConvexPolygon,
    b_in_a: Pose,
    hint: &mut Hint,
    buffers: &mut ClipBuffers,
    wanted: (Corners, &mut Vec<Vec2>),
) -> Option<Clip> {
    match clip_through(a, b, b_in_a, *hint) {
        Some(through) => Some(through.clip(a, b, b_in_a, wanted)),
        None => clip_otherwise(a, b, b_in_a, hint, buffers, wanted),
    }
}

/// The fast path of the clip, by [`through`]. The hint stays valid.
#[inline(always)]
pub(crate) fn clip_through(
    a: &ConvexPolygon,
    b: &ConvexPolygon,
    b_in_a: Pose,
    hint: Hint,
) -> Option<Through> {
    if let Hint::Lens(stretch) = hint { through::find(a, b, b_in_a, stretch) } else { None }
}

/// The part of [`clip`] for polygons in which [`clip_through`] finds no overlap.
// A function of its own, so that the fast path needs no room on the stack for it.
#[inline(never)]
pub(crate) fn clip_otherwise(
    a: &ConvexPolygon,
    b: &ConvexPolygon,
    b_in_a: Pose,
    hint: &mut Hint,
    buffers: &mut ClipBuffers,
    (corners, outline_m): (Corners, &mut Vec<Vec2>),
) -> Option<Clip> {
    let placed = Placed { polygon: b, pose: b_in_a };
    match *hint {
        Hint::Lens(stretch) => {
            let start = outline_m.len();
            if let Some(found) = warm::find(a, &placed, stretch, outline_m) {
                *hint = Hint::Lens(found.at);
                if found.at != stretch
                    && let Some(through) = through::find(a, b, b_in_a, found.at)
                {
                    outline_m.truncate(start);
                    return Some(through.clip(a, b, b_in_a, (corners, outline_m)));
                }
                let chord_m = found.leaves_m - found.enters_m;
                let lens = measure(&outline_m[start..], chord_m, false);
                return accept(lens, false);
            }
        }
        Hint::Apart { on_a, edge, support } => {
            if let Some(support) = still_apart(a, &placed, on_a, edge, support) {
                *hint = Hint::Apart { on_a, edge, support };
                return None;
            }
        }
        Hint::None => {
            if circles_apart(a, &placed) {
                return None;
            }
        }
    }
    let found;
    (found, *hint) = cold(a, &placed, &mut buffers.cold, (corners, outline_m));
    found
}

impl Through {
    /// The clip. The corners of the overlap are appended to the list if the caller wants them.
    #[inline(always)]
    pub(crate) fn clip(
        &self,
        a: &ConvexPolygon,
        b: &ConvexPolygon,
        b_in_a: Pose,
        (corners, outline_m): (Corners, &mut Vec<Vec2>),
    ) -> Clip {
        if corners == Corners::Always {
            let placed = Placed { polygon: b, pose: b_in_a };
            trace_through(a, &placed, &self.located(), outline_m);
        }
        Clip { lens: self.lens, contained: false }
    }
}

#[inline(never)]
fn trace_through(a: &ConvexPolygon, b: &Placed<'_>, found: &Located, outline_m: &mut Vec<Vec2>) {
    trace(a, b, found, found.at.enter.b, outline_m);
}

/// The axis of least penetration of two overlapping polygons, as the outward normal of the first body in the frame of
/// the first body.
pub(crate) fn least_penetration(
    a: &ConvexPolygon,
    b: &ConvexPolygon,
    b_in_a: Pose,
    buffers: &mut ClipBuffers,
) -> Vec2 {
    place(&Placed { polygon: b, pose: b_in_a }, &mut buffers.cold.b_m);
    best_axis(a, &buffers.cold.b_m).normal
}

fn place(b: &Placed<'_>, into_m: &mut Vec<Vec2>) {
    into_m.clear();
    into_m.extend(b.polygon.closed().iter().map(|&v| b.pose.apply(v)));
}

#[inline]
fn accept(lens: Lens, contained: bool) -> Option<Clip> {
    (lens.area_m2 > 0.0).then_some(Clip { lens, contained })
}

/// Returns true if the bounding circles of the two polygons do not meet.
#[inline]
pub(crate) fn circles_apart(a: &ConvexPolygon, b: &Placed<'_>) -> bool {
    let reach = a.radius_m() + b.polygon.radius_m();
    (b.pose.apply(b.polygon.center_m()) - a.center_m()).length_squared() > reach * reach
}

#[cold]
#[inline(never)]
fn cold(
    a: &ConvexPolygon,
    b: &Placed<'_>,
    buffers: &mut Buffers,
    (corners, outline_m): (Corners, &mut Vec<Vec2>),
) -> (Option<Clip>, Hint) {
    if let Some(BestAxis { on_a, edge, support, .. }) = apart::find(a, b) {
        return (None, Hint::Apart { on_a, edge, support });
    }
    place(b, &mut buffers.b_m);
    let mut hint = Hint::None;
    let start = outline_m.len();
    let found = match halfplanes::intersect(a, buffers) {
        Found::Nothing => None,
        Found::FirstInside => {
            outline_m.extend_from_slice(a.vertices());
            accept(measure(a.vertices(), Vec2::ZERO, false), true)
        }
        Found::SecondInside => {
            let inside = &buffers.b_m[..b.count()];
            outline_m.extend_from_slice(inside);
            accept(measure(inside, Vec2::ZERO, false), true)
        }
        Found::Crossings { collinear } => {
            if let ([stretch], false) = (buffers.stretches.as_slice(), collinear) {
                hint = Hint::Lens(*stretch);
                // The same code as on the warm path gives the same bits.
                if let Some(through) = through::find(a, b.polygon, b.pose, *stretch) {
                    let clip = through.clip(a, b.polygon, b.pose, (corners, outline_m));
                    return (Some(clip), hint);
                }
            }
            let mut lens = assemble(a, b, &buffers.stretches, outline_m);
            let swept_m2 = signed_area(buffers.swept_m());
            if (lens.area_m2 - swept_m2).abs() > rounding_m2(a, b) + 1e-9 * swept_m2 {
                // By rounding, nearly parallel edges may seem to cross where they do not. The walk between such
                // crossings would go round a whole polygon. The sweep's own corners are right.
                hint = Hint::None;
                outline_m.truncate(start);
                outline_m.extend_from_slice(buffers.swept_m());
                lens = measure(buffers.swept_m(), buffers.swept_chord_m(), collinear);
            }
            lens.collinear = collinear;
            lens.per_chord_m = per_chord_m(lens.chord_m, collinear);
            accept(lens, false)
        }
    };
    if let Some(clip) = found
        && lies_in_both(clip.lens.centroid_m, a, &buffers.b_m, rounding_m2(a, b))
    {
        return (found, hint);
    }
    outline_m.truncate(start);
    let BestAxis { gap_m, on_a, edge, support, .. } = best_axis(a, &buffers.b_m);
    let hint = if gap_m > 0.0 { Hint::Apart { on_a, edge, support } } else { Hint::None };
    (None, hint)
}

/// Returns true if the point lies in both polygons. If the polygons touch without a common area, rounding can make the
/// sweep find an overlap that does not exist.
fn lies_in_both(point_m: Vec2, a: &ConvexPolygon, b_m: &[Vec2], slack_m2: f64) -> bool {
    [a.closed(), b_m].iter().all(|ring| {
        ring.windows(2).all(|edge| (edge[1] - edge[0]).cross(point_m - edge[0]) >= -slack_m2)
    })
}

/// Largest error of the area of an overlap that rounding of the vertices can cause (m²).
fn rounding_m2(a: &ConvexPolygon, b: &Placed<'_>) -> f64 {
    let reach_m = a.center_m().length() + a.radius_m() + b.polygon.radius_m();
    256.0 * f64::EPSILON * reach_m * lesser(a.radius_m(), b.polygon.radius_m())
}

/// Finds out whether the edge of the last step still separates the polygons. Returns the new support.
#[inline]
fn still_apart(
    a: &ConvexPolygon,
    b: &Placed<'_>,
    on_a: bool,
    edge: u32,
    support: u32,
) -> Option<u32> {
    let (edge, support) = (edge as usize, support as usize);
    if on_a {
        let (n, m) = (a.count(), b.count());
        if edge >= n || support >= m {
            return None;
        }
        // In the second polygon's frame only two points have to be placed, instead of three.
        let start = b.pose.apply_inverse(a.corner(edge));
        let end = b.pose.apply_inverse(a.corner(edge + 1));
        deepest_outside(start, end, |j| b.polygon.corner(j), support, m)
    } else {
        let (n, m) = (b.count(), a.count());
        if edge >= n || support >= m {
            return None;
        }
        deepest_outside(b.vertex(edge), b.vertex(edge + 1), |j| a.corner(j), support, m)
    }
}

#[inline]
fn deepest_outside(
    start: Vec2,
    end: Vec2,
    vertex: impl Fn(usize) -> Vec2,
    support: usize,
    count: usize,
) -> Option<u32> {
    let along = end - start;
    let (deepest, depth) = climb(|j| along.cross(vertex(j) - start), support, count);
    (depth < 0.0).then_some(deepest as u32)
}

/// Clips a pair of convex polygons again and again while they move. The type `PairClip` is for callers that need only
/// the geometry of overlaps.
///
/// ```
/// use fenderline_contact::{ConvexPolygon, PairClip, Pose, vec2};
/// let square = [vec2(0.0, 0.0), vec2(2.0, 0.0), vec2(2.0, 2.0), vec2(0.0, 2.0)];
/// let (a, b) = (ConvexPolygon::new(&square), ConvexPolygon::new(&square));
/// let mut pair = PairClip::default();
/// let still = Pose::new(vec2(0.0, 0.0), 0.0);
/// let clip = pair.clip(&a, still, &b, Pose::new(vec2(1.5, 1.0), 0.0)).unwrap();
/// assert_eq!(clip.area_m2(), 0.5);
/// assert_eq!(clip.centroid_m(), vec2(1.75, 1.5));
/// assert_eq!(pair.outline_m().len(), 4);
/// ```
#[derive(Clone, Debug, Default)]
pub struct PairClip {
    hint: Hint,
    buffers: ClipBuffers,
    outline_m: Vec<Vec2>,
}

impl PairClip {
    /// Computes the overlap of the polygons `a` and `b` at their poses, in the frame of `a`; returns `None` if they
    /// have no area in common.
    #[inline]
    pub fn clip(
        &mut self,
        a: &ConvexPolygon,
        a_pose: Pose,
        b: &ConvexPolygon,
        b_pose: Pose,
    ) -> Option<Clip> {
        self.outline_m.clear();
        let b_in_a = a_pose.to(b_pose);
        let wanted = (Corners::Always, &mut self.outline_m);
        clip(a, b, b_in_a, &mut self.hint, &mut self.buffers, wanted)
    }

    /// Vertices of the last overlap, in the frame of the first polygon (m).
    #[must_use]
    pub fn outline_m(&self) -> &[Vec2] {
        &self.outline_m
    }

    /// Forgets the last result, so that the next call starts without a hint.
    pub fn forget(&mut self) {
        self.hint = Hint::None;
    }
}
