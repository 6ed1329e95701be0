//! Stage 3, narrow phase: area, centroid, normal and depth of every patch of contact (§3.1 of the paper).

use alloc::vec::Vec;
use core::slice;

use crate::bodies::Bodies;
use crate::candidates::{Candidate, Pairing};
use crate::face::{self, Press};
use crate::fender::RankedFender;
use crate::geometry::clip::{self, ClipBuffers, Corners, Hint};
use crate::geometry::convex::ConvexPolygon;
use crate::geometry::lens::{Lens, per_chord_m};
use crate::memory::{HintMemory, PatchMemory};
use crate::model::Model;
use crate::number::{greater, lesser};
use crate::panel::law::PanelLaw;
use crate::patch::{Extent, NOWHERE, Parts, Patch, Place};
use crate::vec2::{Pose, Vec2, vec2};

/// Corners nearer than this are one corner of two lenses that share a seam (m). Seam corners are computed twice, to about
/// 1e-12 m; features of a hull are centimetres.
const SAME_CORNER_M: f64 = 1e-7;

/// The overlap of one piece of A with one piece of B.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PieceLens {
    lens: Lens,
    contained: bool,
    piece_a: u32,
    piece_b: u32,
    /// Vertices in [`Overlap::outline_m`].
    vertices: (u32, u32),
    /// Number of the connected patch, within the pair.
    patch: u32,
}

/// The overlaps of a (sub-)step. Computed by [`overlap`].
#[derive(Clone, Debug, Default)]
pub(crate) struct Overlap {
    pub(crate) patches: Vec<Patch>,
    /// Where the patches of non-convex bodies lie.
    pub(crate) places: Vec<Place>,
    lenses: Vec<PieceLens>,
    outline_m: Vec<Vec2>,
}

impl Overlap {
    fn clear(&mut self) {
        self.patches.clear();
        self.places.clear();
        self.lenses.clear();
        self.outline_m.clear();
    }
}

/// Computes the patches of candidates into `found`, in the candidates' order, and the hints for the next step. `first` is
/// the place of the first candidate in `Candidates::pairings`.
///
/// Returns true if all old hints stay as they are. Then no hints are added, and the caller keeps the old list.
#[must_use]
pub(crate) fn overlap(
    model: &Model,
    bodies: &Bodies,
    candidates: &[Pairing],
    first: usize,
    mut hints: Hints<'_>,
    clip: &mut ClipBuffers,
    found: &mut Overlap,
) -> bool {
    found.clear();
    let outlines = Outlines { model, bodies, candidates, first };
    if model.slices.is_empty() {
        outlines.clip::<false>(&mut hints, clip, found);
    } else {
        outlines.clip_by_height(&mut hints, clip, found);
    }
    hints.finish()
}

/// What [`overlap`] computes patches from.
#[derive(Clone, Copy)]
struct Outlines<'w> {
    model: &'w Model,
    bodies: &'w Bodies,
    candidates: &'w [Pairing],
    first: usize,
}

impl Outlines<'_> {
    /// Clips all candidates. The parameter says whether fenders may meet outlines by height: without them the compiler
    /// leaves that question out.
    #[inline(always)]
    fn clip<const BY_HEIGHT: bool>(
        self,
        hints: &mut Hints<'_>,
        clip: &mut ClipBuffers,
        found: &mut Overlap,
    ) {
        let Outlines { model, bodies, candidates, first } = self;
        // A slice of one known length, so that each rank is bounds-checked once.
        let poses = &bodies.poses[..model.ranked.len()];
        for (of, Pairing { candidate, .. }) in (first as u32..).zip(candidates) {
            let (a, b) = (candidate.a as usize, candidate.b as usize);
            let b_in_a = poses[a].to(poses[b]);
            let [mut a, mut b] = [a, b].map(|rank| model.ranked.convex(rank));
            if let Some(face) = candidate.fender(model) {
                *(if face.host == candidate.a { &mut a } else { &mut b }) = Some(&face.zone);
                if BY_HEIGHT {
                    [a, b] = convex_met(model, candidate, face);
                }
            }
            let pair = PosedPair { candidate, of, b_in_a };
            if let (Some(a), Some(b)) = (a, b) {
                clip_convex([a, b], pair, hints, clip, found);
            } else {
                clip_several(model, pair, hints, clip, found);
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn clip_by_height(self, hints: &mut Hints<'_>, clip: &mut ClipBuffers, found: &mut Overlap) {
        self.clip::<true>(hints, clip, found);
    }
}

/// The two sides of a fender's candidate in a model with outlines by height, each if it is one convex piece.
fn convex_met<'m>(
    model: &'m Model,
    candidate: &Candidate,
    face: &'m RankedFender,
) -> [Option<&'m ConvexPolygon>; 2] {
    [candidate.a, candidate.b].map(|rank| match model.pieces_met(candidate.face, rank) {
        _ if rank == face.host => Some(&face.zone),
        [only] => Some(only),
        _ => None,
    })
}

/// A candidate, its place among the candidates, and the pose of B in A's frame.
#[derive(Clone, Copy)]
struct PosedPair<'w> {
    candidate: &'w Candidate,
    of: u32,
    b_in_a: Pose,
}

/// Reads the last step's hints and writes the next one's: where each clip begins.
///
/// Most hints stay as they are and are copied in runs. If all of them stay nothing is copied: that saves 4 % of the
/// instructions of a step in which all contacts continue.
pub(crate) struct Hints<'h> {
    /// What is neither written nor dropped yet, sorted.
    old: &'h [HintMemory],
    /// What of it is still to be read.
    unread: &'h [HintMemory],
    next: &'h mut Vec<HintMemory>,
    /// Nothing has been written or dropped yet.
    all_stay: bool,
}

/// Ranks, face and pieces, as of [`HintMemory::key`].
type HintKey = (u32, u32, u32, u32, u32);

impl<'h> Hints<'h> {
    /// Reads `old` and adds to `next`. Reserves room for all hints, so that a later step does not allocate.
    pub(crate) fn new(old: &'h [HintMemory], next: &'h mut Vec<HintMemory>) -> Hints<'h> {
        next.reserve(old.len());
        Hints { old, unread: old, next, all_stay: true }
    }

    /// The last step's hint for these pieces. It is kept unless [`Hints::replace`] follows. Both lists are sorted, so one
    /// pass finds all.
    #[inline(always)]
    fn read(&mut self, wanted: HintKey) -> Option<Hint> {
        match self.unread {
            [first, rest @ ..] if first.key() == wanted => {
                self.unread = rest;
                Some(first.hint)
            }
            _ => self.search(wanted),
        }
    }

    /// As [`Hints::read`], if others come before it or there is none.
    #[inline(never)]
    fn search(&mut self, wanted: HintKey) -> Option<Hint> {
        let skipped = self.unread.iter().take_while(|hint| hint.key() < wanted).count();
        if skipped > 0 {
            self.write();
            self.unread = &self.unread[skipped..];
            self.old = self.unread;
        }
        let (first, rest) = self.unread.split_first()?;
        (first.key() == wanted).then(|| {
            self.unread = rest;
            first.hint
        })
    }

    /// Copies all that was read.
    fn write(&mut self) {
        let (read, unread) = self.old.split_at(self.old.len() - self.unread.len());
        self.next.extend_from_slice(read);
        (self.old, self.all_stay) = (unread, false);
    }

    /// Replaces the hint that was read last. [`Hint::None`] is not stored.
    #[inline]
    fn replace(&mut self, of: HintKey, before: Option<Hint>, hint: Hint) {
        let hint = (hint != Hint::None).then_some(hint);
        if hint != before {
            self.write_other(of, before, hint);
        }
    }

    #[inline(never)]
    fn write_other(&mut self, of: HintKey, before: Option<Hint>, hint: Option<Hint>) {
        let (a, b, face, piece_a, piece_b) = of;
        self.write();
        if before.is_some() {
            self.next.pop();
        }
        self.next.extend(hint.map(|hint| HintMemory { a, b, face, piece_a, piece_b, hint }));
    }

    /// Writes the rest. Returns true, and writes nothing, if all hints stay as they are.
    fn finish(mut self) -> bool {
        let all_stay = self.all_stay && self.unread.is_empty();
        if !all_stay {
            self.write();
        }
        all_stay
    }
}

/// Clips one convex piece against another: they have at most one patch.
#[inline(always)]
fn clip_convex(
    [a, b]: [&ConvexPolygon; 2],
    PosedPair { candidate, of, b_in_a }: PosedPair<'_>,
    hints: &mut Hints<'_>,
    buffers: &mut ClipBuffers,
    found: &mut Overlap,
) {
    let Overlap { patches, outline_m, .. } = found;
    let from = outline_m.len();
    let key = (candidate.a, candidate.b, candidate.face, 0, 0);
    let hint = hints.read(key);
    // Two outlines need no corners if there is a chord: normal and depth follow from it.
    let corners = if candidate.face == 0 { Corners::WithoutChord } else { Corners::Always };
    let wanted = (corners, &mut *outline_m);
    let clip = match clip::clip_through(a, b, b_in_a, hint.unwrap_or_default()) {
        Some(through) => through.clip(a, b, b_in_a, wanted),
        None => {
            let mut next = hint.unwrap_or_default();
            let clip = clip::clip_otherwise(a, b, b_in_a, &mut next, buffers, wanted);
            hints.replace(key, hint, next);
            let Some(clip) = clip else { return outline_m.truncate(from) };
            clip
        }
    };
    patches.push(Patch {
        candidate: *candidate,
        of,
        number: 0,
        b_in_a,
        area_m2: clip.lens.area_m2,
        centroid_m: clip.lens.centroid_m,
        chord_m: clip.lens.chord_m,
        per_chord_m: clip.lens.per_chord_m,
        contained: clip.contained,
        spread_m2: clip.lens.spread_m2,
        parts: [from as u32, outline_m.len() as u32],
        place: NOWHERE,
    });
}

/// Clips bodies of several convex pieces: they may have several patches.
#[inline(never)]
fn clip_several(
    model: &Model,
    pair: PosedPair<'_>,
    hints: &mut Hints<'_>,
    buffers: &mut ClipBuffers,
    found: &mut Overlap,
) {
    let PosedPair { candidate, of, b_in_a } = pair;
    let (first, first_patch) = (found.lenses.len(), found.patches.len());
    clip_pieces(model, pair, hints, buffers, found);
    match found.lenses.len() - first {
        0 => {}
        // A panel meets the whole hull at once.
        count if count == 1 || is_panel(model, candidate) => {
            new_patch(*candidate, b_in_a, 0, first, first + count, found);
        }
        _ => connect(*candidate, b_in_a, first, found),
    }
    found.patches[first_patch..].iter_mut().for_each(|patch| patch.of = of);
}

/// Is the fender of a candidate one with a panel?
fn is_panel(model: &Model, candidate: &Candidate) -> bool {
    candidate.fender(model).is_some_and(|face| face.panel.is_some())
}

/// The convex pieces of both sides of a candidate: of an outline, or the one of a fender.
pub(crate) fn pieces_of<'m>(
    model: &'m Model,
    candidate: &Candidate,
) -> (&'m [ConvexPolygon], &'m [ConvexPolygon]) {
    if !model.slices.is_empty() && candidate.face != 0 {
        return pieces_by_height(model, candidate);
    }
    let of_body = |rank: u32| model.ranked.pieces(rank as usize);
    let of_side = |rank: u32| match candidate.fender(model) {
        Some(face) if face.host == rank => slice::from_ref(&face.zone),
        _ => of_body(rank),
    };
    (of_side(candidate.a), of_side(candidate.b))
}

/// As [`pieces_of`], at a fender of a model with outlines by height.
#[cold]
#[inline(never)]
fn pieces_by_height<'m>(
    model: &'m Model,
    candidate: &Candidate,
) -> (&'m [ConvexPolygon], &'m [ConvexPolygon]) {
    let of_side = |rank: u32| match candidate.fender(model) {
        Some(face) if face.host == rank => slice::from_ref(&face.zone),
        _ => model.pieces_met(candidate.face, rank),
    };
    (of_side(candidate.a), of_side(candidate.b))
}

/// Clips every piece of A against every piece of B that is near it.
fn clip_pieces(
    model: &Model,
    PosedPair { candidate, b_in_a, .. }: PosedPair<'_>,
    hints: &mut Hints<'_>,
    buffers: &mut ClipBuffers,
    Overlap { outline_m, lenses, .. }: &mut Overlap,
) {
    let (pieces_a, pieces_b) = pieces_of(model, candidate);
    for (piece_a, a) in (0..).zip(pieces_a) {
        for (piece_b, b) in (0..).zip(pieces_b) {
            let start = outline_m.len();
            let key = (candidate.a, candidate.b, candidate.face, piece_a, piece_b);
            let hint = hints.read(key);
            let wanted = (Corners::Always, &mut *outline_m);
            let mut next = hint.unwrap_or_default();
            let found = clip::clip(a, b, b_in_a, &mut next, buffers, wanted);
            hints.replace(key, hint, next);
            match found {
                Some(clip) => lenses.push(PieceLens {
                    lens: clip.lens,
                    contained: clip.contained,
                    piece_a,
                    piece_b,
                    vertices: (start as u32, outline_m.len() as u32),
                    patch: 0,
                }),
                None => outline_m.truncate(start),
            }
        }
    }
}

/// Joins the lenses of a pair that share a seam into patches. The seams' parts of the chords
/// cancel, so that a patch's area, centroid and chord are those of the whole outlines.
fn connect(candidate: Candidate, b_in_a: Pose, first: usize, found: &mut Overlap) {
    let end = found.lenses.len();
    for i in first..end {
        found.lenses[i].patch = (i - first) as u32;
    }
    for i in first..end {
        for j in i + 1..end {
            let (one, two) = (found.lenses[i].patch, found.lenses[j].patch);
            if one != two && share_a_seam(found, i, j) {
                let (keep, drop) = (one.min(two), one.max(two));
                for lens in &mut found.lenses[first..end] {
                    if lens.patch == drop {
                        lens.patch = keep;
                    }
                }
            }
        }
    }
    // Stable, so that each patch's sums are taken in the order of the pieces.
    found.lenses[first..end].sort_by_key(|l| l.patch);
    let mut start = first;
    let mut number = 0;
    while start < end {
        let patch = found.lenses[start].patch;
        let stop = (start..end).find(|&k| found.lenses[k].patch != patch).unwrap_or(end);
        new_patch(candidate, b_in_a, number, start, stop, found);
        number += 1;
        start = stop;
    }
}

/// Do two lenses lie on both sides of a seam? Then they share the two ends of their common edge.
///
/// If one of the two pieces is the same, one common corner is enough, however short the edge: a convex piece that reaches
/// a common corner of two others lies on the seam that starts there. If both differ, the seams of both bodies would have
/// to lie on one another. Two corners are needed to distinguish that from four lenses that meet where seams cross.
fn share_a_seam(found: &Overlap, i: usize, j: usize) -> bool {
    let corners = |k: usize| {
        let (start, end) = found.lenses[k].vertices;
        &found.outline_m[start as usize..end as usize]
    };
    let (one, two) = (&found.lenses[i], &found.lenses[j]);
    let same_piece = one.piece_a == two.piece_a || one.piece_b == two.piece_b;
    let limit = SAME_CORNER_M * SAME_CORNER_M;
    let mut shared: Option<Vec2> = None;
    for &p in corners(i) {
        if !corners(j).iter().any(|&q| (p - q).length_squared() <= limit) {
            continue;
        }
        match shared {
            None if same_piece => return true,
            None => shared = Some(p),
            Some(other) if (other - p).length_squared() > limit => return true,
            Some(_) => {}
        }
    }
    false
}

/// Adds a patch of several pieces' lenses, with its place.
fn new_patch(
    candidate: Candidate,
    b_in_a: Pose,
    number: u32,
    start: usize,
    stop: usize,
    found: &mut Overlap,
) {
    let mut patch = sum(candidate, b_in_a, number, start, stop, found);
    let in_a = extent(found.lenses[start..stop].iter().flat_map(|lens| outline(found, lens)));
    patch.place = found.places.len() as u32;
    found.places.push(Place { in_a, in_b: seen_from_b(&in_a, b_in_a) });
    found.patches.push(patch);
}

/// Area, centroid and chord of a patch: the sums over its lenses.
fn sum(
    candidate: Candidate,
    b_in_a: Pose,
    number: u32,
    start: usize,
    stop: usize,
    found: &Overlap,
) -> Patch {
    let lenses = &found.lenses[start..stop];
    let mut patch = Patch {
        candidate,
        of: 0,
        number,
        b_in_a,
        area_m2: lenses[0].lens.area_m2,
        centroid_m: lenses[0].lens.centroid_m,
        chord_m: lenses[0].lens.chord_m,
        per_chord_m: 0.0,
        contained: lenses.len() == 1 && lenses[0].contained,
        spread_m2: lenses[0].lens.spread_m2,
        parts: [start as u32, stop as u32],
        place: NOWHERE,
    };
    let mut collinear = lenses[0].lens.collinear;
    if lenses.len() > 1 {
        let mut moment = Vec2::ZERO;
        let origin = lenses[0].lens.centroid_m;
        for piece in &lenses[1..] {
            patch.area_m2 += piece.lens.area_m2;
            moment += (piece.lens.centroid_m - origin) * piece.lens.area_m2;
            patch.chord_m += piece.lens.chord_m;
            collinear |= piece.lens.collinear;
        }
        patch.centroid_m = origin + moment * (1.0 / patch.area_m2);
    }
    patch.per_chord_m = per_chord_m(patch.chord_m, collinear);
    patch
}

fn outline<'a>(found: &'a Overlap, lens: &PieceLens) -> &'a [Vec2] {
    &found.outline_m[lens.vertices.0 as usize..lens.vertices.1 as usize]
}

/// The outlines of all lenses of a patch.
#[inline]
fn outlines<'a>(found: &'a Overlap, patch: &Patch) -> impl Iterator<Item = &'a [Vec2]> + Clone {
    let (one, lenses) = match patch.parts() {
        Parts::One { from, to } => {
            (Some(&found.outline_m[from as usize..to as usize]), [].as_slice())
        }
        Parts::Lenses { from, to } => (None, &found.lenses[from as usize..to as usize]),
    };
    one.into_iter().chain(lenses.iter().map(|lens| outline(found, lens)))
}

/// The box about some points.
fn extent<'v>(points_m: impl Iterator<Item = &'v Vec2>) -> Extent {
    let (low_m, high_m) =
        (vec2(f64::INFINITY, f64::INFINITY), vec2(f64::NEG_INFINITY, f64::NEG_INFINITY));
    let mut extent = Extent { low_m, high_m };
    for v in points_m {
        extent.low_m = vec2(lesser(extent.low_m.x, v.x), lesser(extent.low_m.y, v.y));
        extent.high_m = vec2(greater(extent.high_m.x, v.x), greater(extent.high_m.y, v.y));
    }
    extent
}

/// The box in B's frame about a box in A's.
fn seen_from_b(extent: &Extent, b_in_a: Pose) -> Extent {
    let center = b_in_a.apply_inverse((extent.low_m + extent.high_m) * 0.5);
    let half = (extent.high_m - extent.low_m) * 0.5;
    let (cos, sin) = (b_in_a.rotation.cos.abs(), b_in_a.rotation.sin.abs());
    let half = vec2(cos * half.x + sin * half.y, sin * half.x + cos * half.y);
    Extent { low_m: center - half, high_m: center + half }
}

/// A's outward normal in its frame, and δ, the extent of the patch along it (m).
///
/// The normal is the chord's if there is a chord, else the contact's last good one, else the axis of least penetration.
#[inline]
pub(crate) fn normal_in_a(
    model: &Model,
    found: &Overlap,
    buffers: &mut ClipBuffers,
    patch: &Patch,
    old: Option<&PatchMemory>,
) -> (Vec2, f64) {
    let per_m = patch.per_chord_m;
    if per_m > 0.0 {
        let normal = patch.chord_m.quarter_turn_back() * per_m;
        let depth_m = match patch.parts() {
            Parts::One { .. } => patch.spread_m2 * per_m,
            Parts::Lenses { .. } => depth_m(found, patch, normal),
        };
        return (normal, depth_m);
    }
    let remembered = old.map(|m| (m.normal_in_a, m.normal_in_b()));
    let normal = normal_without_chord(model, found, buffers, patch, remembered);
    (normal, depth_m(found, patch, normal))
}

#[cold]
#[inline(never)]
fn normal_without_chord(
    model: &Model,
    found: &Overlap,
    buffers: &mut ClipBuffers,
    patch: &Patch,
    remembered: Option<(Vec2, Vec2)>,
) -> Vec2 {
    if let Some((in_a, in_b)) = remembered {
        // Half from each body, so that neither is preferred when they turn.
        let mean = in_a + patch.b_in_a.rotation.apply(in_b);
        let length = mean.length();
        if length > 1e-3 {
            return mean * (1.0 / length);
        }
    }
    let [pieces_a, pieces_b] =
        [patch.candidate.a, patch.candidate.b].map(|rank| model.ranked.pieces(rank as usize));
    if (pieces_a.len() > 1 || pieces_b.len() > 1)
        && let Some(normal) = nearest_side(model, found, patch)
    {
        return normal;
    }
    let (piece_a, piece_b) = match patch.parts() {
        Parts::One { .. } => (0, 0),
        Parts::Lenses { from, to } => {
            let lenses = &found.lenses[from as usize..to as usize];
            let largest = lenses.iter().fold(lenses[0], |largest, lens| {
                if lens.lens.area_m2 > largest.lens.area_m2 { *lens } else { largest }
            });
            (largest.piece_a as usize, largest.piece_b as usize)
        }
    };
    let (a, b) = (&pieces_a[piece_a], &pieces_b[piece_b]);
    clip::least_penetration(a, b, patch.b_in_a, buffers)
}

/// The axis of least penetration of whole outlines. Seams between pieces do not count: a body is not pushed out of another
/// through a seam. `None` if no side faces the patch.
fn nearest_side(model: &Model, found: &Overlap, patch: &Patch) -> Option<Vec2> {
    let outline_of = |rank: u32| &model.bodies()[model.id_of[rank as usize].0 as usize].outline;
    let corners = || outlines(found, patch).flatten().copied();
    // A body that lies within the other is pushed out by the other's sides, not by its own.
    let is_all_of = |rank: u32| patch.area_m2 >= outline_of(rank).area_m2() * (1.0 - 1e-9);
    let (a, b) = (patch.candidate.a, patch.candidate.b);
    let by_sides_of = |rank: u32, other: u32| is_all_of(other) || !is_all_of(rank);
    let of_a = by_sides_of(a, b)
        .then(|| least_sunk_side(outline_of(a).vertices(), patch.centroid_m, corners()))
        .flatten();
    let b_in_a = patch.b_in_a;
    let seen_from_b = corners().map(|v| b_in_a.apply_inverse(v));
    let of_b = by_sides_of(b, a)
        .then(|| {
            let centroid_m = b_in_a.apply_inverse(patch.centroid_m);
            least_sunk_side(outline_of(b).vertices(), centroid_m, seen_from_b)
        })
        .flatten();
    match (of_a, of_b) {
        (Some((depth_m, outward)), Some((other_m, _))) if depth_m <= other_m => Some(outward),
        (Some((_, outward)), None) => Some(outward),
        (_, of_b) => of_b.map(|(_, outward)| -b_in_a.rotation.apply(outward)),
    }
}

/// The side of an outline behind which the patch's corners reach least deep, among those that its centroid faces from
/// inside: that depth (m) and the side's outward normal.
fn least_sunk_side(
    sides: &[Vec2],
    centroid_m: Vec2,
    corners: impl Iterator<Item = Vec2> + Clone,
) -> Option<(f64, Vec2)> {
    let mut best: Option<(f64, Vec2)> = None;
    for (&start, &end) in sides.iter().zip(sides.iter().cycle().skip(1)) {
        let (along, to) = (end - start, centroid_m - start);
        let share = to.dot(along);
        if !(0.0..=along.length_squared()).contains(&share) || along.cross(to) < 0.0 {
            continue;
        }
        let outward = along.quarter_turn_back() * (1.0 / along.length());
        let depth_m = corners.clone().fold(0.0, |d, v| greater(d, -outward.dot(v - start)));
        if best.is_none_or(|(least_m, _)| depth_m < least_m) {
            best = Some((depth_m, outward));
        }
    }
    best
}

/// The press of a patch on its fender, in A's frame.
pub(crate) fn press(
    model: &Model,
    found: &Overlap,
    clip: &mut ClipBuffers,
    patch: &Patch,
    face: &RankedFender,
) -> Press {
    if let Some(law) = &face.panel {
        return press_panel((model, law), found, clip, patch, face);
    }
    let host = if face.host == patch.candidate.a { Pose::IDENTITY } else { patch.b_in_a };
    let within = (patch.area_m2, patch.centroid_m);
    let fender = &model.fenders()[face.id.0 as usize];
    let stiffness_npm2 = model.materials()[face.material.0 as usize].stiffness_npm2;
    face::press(face, fender, stiffness_npm2, host, within, outlines(found, patch))
}

/// Presses a fender's panel with the whole outline of the other body of a patch.
#[inline(never)]
fn press_panel(
    (model, law): (&Model, &PanelLaw),
    found: &Overlap,
    clip: &mut ClipBuffers,
    patch: &Patch,
    face: &RankedFender,
) -> Press {
    let hull_is_a = face.host != patch.candidate.a;
    let (host, hull, rank) = if hull_is_a {
        (patch.b_in_a, Pose::IDENTITY, patch.candidate.a)
    } else {
        (Pose::IDENTITY, patch.b_in_a, patch.candidate.b)
    };
    let edges = model.edges_met(patch.candidate.face, rank);
    let to_face = face.hull_to_face(host, hull);
    let pressed = clip.panel.press(law, edges, to_face, face.panel_reach());
    let within = (patch.area_m2, patch.centroid_m);
    face::press_panel(face, pressed, host, within, outlines(found, patch))
}

/// δ, the extent of the patch along a direction (m).
fn depth_m(found: &Overlap, patch: &Patch, along: Vec2) -> f64 {
    let origin = patch.centroid_m;
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for &v in outlines(found, patch).flatten() {
        let s = (v - origin).dot(along);
        (low, high) = (lesser(s, low), greater(s, high));
    }
    high - low
}
