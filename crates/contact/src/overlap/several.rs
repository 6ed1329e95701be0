//! Computes the overlap of bodies with several convex pieces: a lens for each pair of pieces, and patches of lenses
//! that share seams.

use crate::broad::candidates::Candidate;
use crate::geometry::clip::{self, ClipBuffers, Corners};
use crate::geometry::extent::Extent;
use crate::geometry::lens::per_chord_m;
use crate::geometry::shapes::near_pairs;
use crate::maths::vec2::{Pose, Vec2};
use crate::model::Model;
use crate::overlap::hints::Hints;
use crate::overlap::lenses::{Overlap, PieceLens};
use crate::overlap::patch::{NOWHERE, Patch, Place};

/// Corners of two lenses on a seam that are nearer to each other than this count as the same corner (m). Each corner on
/// a seam is computed twice, to about 1e-12 m, and the features of a hull are larger than a centimetre.
const SAME_CORNER_M: f64 = 1e-7;

/// A candidate, its place in the list of candidates, and the pose of body B in the frame of body A.
#[derive(Clone, Copy)]
pub(crate) struct PosedPair<'w> {
    pub(crate) candidate: &'w Candidate,
    pub(crate) of: u32,
    pub(crate) b_in_a: Pose,
}

/// Clips two bodies of several convex pieces, which may touch in several patches.
#[inline(never)]
pub(crate) fn clip_several(
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

/// Returns true if the fender of a candidate has a panel.
fn is_panel(model: &Model, candidate: &Candidate) -> bool {
    candidate.fender(model).is_some_and(|face| face.panel.is_some())
}

/// Clips every convex piece of body A against every near convex piece of body B.
fn clip_pieces(
    model: &Model,
    PosedPair { candidate, b_in_a, .. }: PosedPair<'_>,
    hints: &mut Hints<'_>,
    buffers: &mut ClipBuffers,
    Overlap { outline_m, lenses, .. }: &mut Overlap,
) {
    let [of_a, of_b] = model.shapes_of(candidate);
    for [(piece_a, a), (piece_b, b)] in near_pairs(of_a, of_b, b_in_a, 0.0) {
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
                extent: Extent::of(&outline_m[start..]),
                patch: 0,
            }),
            None => outline_m.truncate(start),
        }
    }
}

/// Joins the lenses of a pair of bodies that share a seam into patches. The parts of the chords along the seam cancel,
/// so a patch has the area, centroid and chord of the overlap of whole outlines.
fn connect(candidate: Candidate, b_in_a: Pose, first: usize, found: &mut Overlap) {
    let end = found.lenses.len();
    number_by_seams(found, first);
    // Within a patch the lenses are in the order of the pieces, and the patch's sums are taken in that order.
    found.lenses[first..].sort_unstable_by_key(|l| (l.patch, l.piece_a, l.piece_b));
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

/// Gives each lens of a pair of bodies the number of its patch. All lenses that seams connect get the number of the
/// first of these lenses. The lenses are compared in a sweep along the longer side of the box around all lenses: only
/// lenses whose boxes meet can share a corner.
fn number_by_seams(found: &mut Overlap, first: usize) {
    let Overlap { lenses, outline_m, by_low_end, .. } = found;
    let lenses = &mut lenses[first..];
    let all = lenses.iter().fold(Extent::EMPTY, |all, lens| all.and(lens.extent));
    let size_m = all.high_m - all.low_m;
    let is_north = size_m.x >= size_m.y;
    let along = |v: Vec2| if is_north { v.x } else { v.y };
    by_low_end.clear();
    for (number, lens) in (0..).zip(&mut *lenses) {
        lens.patch = number;
        by_low_end.push((along(lens.extent.low_m), number));
    }
    by_low_end.sort_unstable_by(|p, q| p.0.total_cmp(&q.0).then(p.1.cmp(&q.1)));
    for (index, &(_, one)) in by_low_end.iter().enumerate() {
        let extent = lenses[one as usize].extent.widened(2.0 * SAME_CORNER_M);
        for &(low_m, two) in &by_low_end[index + 1..] {
            if low_m > along(extent.high_m) {
                break;
            }
            let (i, j) = (one.min(two), one.max(two));
            if !extent.overlaps(&lenses[two as usize].extent) {
                continue;
            }
            let (of_i, of_j) = (first_of(lenses, i), first_of(lenses, j));
            if of_i != of_j && share_a_seam(outline_m, &lenses[i as usize], &lenses[j as usize]) {
                lenses[of_i.max(of_j) as usize].patch = of_i.min(of_j);
            }
        }
    }
    for number in 0..lenses.len() as u32 {
        lenses[number as usize].patch = first_of(lenses, number);
    }
}

/// The first lens that is known to be connected with the lens `number`.
fn first_of(lenses: &mut [PieceLens], mut number: u32) -> u32 {
    while lenses[number as usize].patch != number {
        let next = lenses[number as usize].patch;
        // This halves the path for the next search.
        lenses[number as usize].patch = lenses[next as usize].patch;
        number = lenses[number as usize].patch;
    }
    number
}

/// Returns true if two lenses lie on the two sides of a seam. Two lenses on the two sides of a seam share both ends of
/// their common edge.
///
/// If the two lenses have a piece in common, one common corner is enough, however short the edge is: a convex piece
/// that reaches a common corner of two other pieces lies on the seam that starts there. If the two lenses have no piece
/// in common, the seams of both bodies would have to lie on one another. If both pieces differ, two common corners are
/// needed, to tell lenses on a seam from four lenses that meet where two seams cross.
fn share_a_seam(outline_m: &[Vec2], one: &PieceLens, two: &PieceLens) -> bool {
    let corners = |lens: &PieceLens| lens.corners_m(outline_m);
    let same_piece = one.piece_a == two.piece_a || one.piece_b == two.piece_b;
    let limit = SAME_CORNER_M * SAME_CORNER_M;
    let mut shared: Option<Vec2> = None;
    for &p in corners(one) {
        if !corners(two).iter().any(|&q| (p - q).length_squared() <= limit) {
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

/// Adds a patch that consists of the lenses of several pieces, and adds the place of the patch.
fn new_patch(
    candidate: Candidate,
    b_in_a: Pose,
    number: u32,
    start: usize,
    stop: usize,
    found: &mut Overlap,
) {
    let mut patch = sum(candidate, b_in_a, number, start, stop, found);
    let lenses = &found.lenses[start..stop];
    let in_a = lenses.iter().fold(Extent::EMPTY, |all, lens| all.and(lens.extent));
    patch.place = found.places.len() as u32;
    found.places.push(Place { in_a, in_b: in_a.seen_from(b_in_a) });
    found.patches.push(patch);
}

/// Computes area, centroid and chord of a patch as sums over its lenses.
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
