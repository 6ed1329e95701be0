//! Stage 3 of a step, the narrow phase: computes area, centroid, normal and depth of every patch of contact (§3.1 of
//! the paper).

pub(crate) mod hints;
pub(crate) mod lenses;
pub(crate) mod met;
pub(crate) mod patch;
pub(crate) mod several;

use crate::broad::bodies::Bodies;
use crate::broad::candidates::{Candidate, Pairing};
use crate::geometry::clip::{self, ClipBuffers, Corners};
use crate::geometry::convex::ConvexPolygon;
use crate::maths::number::{greater, lesser};
use crate::maths::vec2::{Pose, Vec2};
use crate::model::Model;
use crate::model::fender::RankedFender;
use crate::model::outline::Outline;
use crate::overlap::hints::Hints;
use crate::overlap::lenses::{Overlap, outlines};
use crate::overlap::patch::{NOWHERE, Parts, Patch};
use crate::overlap::several::{PosedPair, clip_several};
use crate::panel::law::PanelLaw;
use crate::state::memory::PatchMemory;
use crate::touch::face::{self, Press};

/// Computes the patches of the candidates, in the order of the candidates, into `found`, and the hints for the next
/// step. `first` is the place of the first candidate in `Candidates::pairings`.
///
/// Returns true if all old hints stay unchanged. If all hints stay unchanged, no hints are added, and the caller keeps
/// the old list of hints.
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

/// The outlines from which [`overlap`] computes patches.
#[derive(Clone, Copy)]
struct Outlines<'w> {
    model: &'w Model,
    bodies: &'w Bodies,
    candidates: &'w [Pairing],
    first: usize,
}

impl Outlines<'_> {
    /// Clips all candidates. `BY_HEIGHT` says whether fenders may meet outlines by height. If fenders cannot meet
    /// outlines by height, the compiler leaves out the test for such outlines.
    #[inline(always)]
    fn clip<const BY_HEIGHT: bool>(
        self,
        hints: &mut Hints<'_>,
        clip: &mut ClipBuffers,
        found: &mut Overlap,
    ) {
        let Outlines { model, bodies, candidates, first } = self;
        // A slice of one known length, so that the compiler checks the bounds of each rank once.
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

/// The two shapes of a fender's candidate, in a model with outlines by height, if each of them is one convex piece.
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

/// Clips one convex piece against another. Two convex pieces have at most one patch.
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
    // If two outlines have a chord, the clip needs no corners: normal and depth follow from the chord.
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

/// The outward normal of body A in the frame of A, and the depth δ, which is the extent of the patch along the normal
/// (m).
///
/// The normal of a patch is that of its chord, if it has a chord. If the patch has no chord, the normal is the last
/// valid normal of the contact. If there is no last valid normal either, the normal is along the axis of least
/// penetration.
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
        // Half of the normal comes from each body, so that neither is preferred when the bodies turn.
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

/// The axis of least penetration of whole outlines. Seams between pieces of an outline do not count, because no body is
/// pushed out through a seam. Returns `None` if no side of the outlines faces the patch.
fn nearest_side(model: &Model, found: &Overlap, patch: &Patch) -> Option<Vec2> {
    let outline_of = |rank: u32| &model.bodies()[model.id_of[rank as usize].0 as usize].outline;
    let corners = || outlines(found, patch).flatten().copied();
    // A body that lies within another is pushed out by the other body's sides, not by its own.
    let is_all_of = |rank: u32| patch.area_m2 >= outline_of(rank).area_m2() * (1.0 - 1e-9);
    let (a, b) = (patch.candidate.a, patch.candidate.b);
    let by_sides_of = |rank: u32, other: u32| is_all_of(other) || !is_all_of(rank);
    let of_a = by_sides_of(a, b)
        .then(|| least_sunk_side(outline_of(a), patch.centroid_m, corners()))
        .flatten();
    let b_in_a = patch.b_in_a;
    let seen_from_b = corners().map(|v| b_in_a.apply_inverse(v));
    let of_b = by_sides_of(b, a)
        .then(|| {
            let centroid_m = b_in_a.apply_inverse(patch.centroid_m);
            least_sunk_side(outline_of(b), centroid_m, seen_from_b)
        })
        .flatten();
    match (of_a, of_b) {
        (Some((depth_m, outward)), Some((other_m, _))) if depth_m <= other_m => Some(outward),
        (Some((_, outward)), None) => Some(outward),
        (_, of_b) => of_b.map(|(_, outward)| -b_in_a.rotation.apply(outward)),
    }
}

/// Finds, among the sides of an outline that the patch's centroid faces from inside, the side behind which the corners
/// of the patch reach least deep. Returns the depth (m) behind the side that was found, and the outward normal of this
/// side.
fn least_sunk_side(
    outline: &Outline,
    centroid_m: Vec2,
    corners: impl Iterator<Item = Vec2> + Clone,
) -> Option<(f64, Vec2)> {
    let mut best: Option<(f64, Vec2)> = None;
    for [start, end] in outline.edges() {
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

/// Computes how the hull presses on the fender in a patch, in the frame of body A.
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

/// Presses the panel of a fender with the whole outline of the other body of a patch.
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

/// Depth δ of a patch, its extent along a direction (m).
fn depth_m(found: &Overlap, patch: &Patch, along: Vec2) -> f64 {
    let origin = patch.centroid_m;
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for &v in outlines(found, patch).flatten() {
        let s = (v - origin).dot(along);
        (low, high) = (lesser(s, low), greater(s, high));
    }
    high - low
}
