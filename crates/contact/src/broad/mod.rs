//! Stage 2 of a step, the broad phase: finds the bodies that are near enough to touch, in the order of their ranks.

pub(crate) mod bodies;
pub(crate) mod candidates;
pub(crate) mod neighbours;

use alloc::vec::Vec;

use crate::broad::bodies::Bodies;
use crate::broad::candidates::{Candidate, Candidates, Pairing};
use crate::geometry::extent::Extent;
use crate::model::Model;
use crate::model::fender::RankedFender;
use crate::model::pair::RankedPair;
use crate::state::memory::PatchMemory;

/// Bounding boxes with a smaller gap than this count as touching (m), because far from the chart's origin positions are
/// rounded.
const ROUNDING_M: f64 = 1e-6;

/// Lists the pairs of bodies that may touch in this step. The list of candidates stays empty if the model has no
/// fenders and no piles, no bodies touched in the last step (`past`), and no bodies can touch in this step.
pub(crate) fn pair(
    model: &Model,
    bodies: &Bodies,
    past: &[PatchMemory],
    Candidates { pairings, neighbours }: &mut Candidates,
) {
    pairings.clear();
    push_near(model, bodies, &model.pairs, 0, pairings);
    if let Some(material) = model.all_other_pairs {
        if !neighbours.holds(model, bodies) {
            neighbours.renew(model, material, bodies);
        }
        push_near(model, bodies, neighbours.pairs(), model.pairs.len() as u32, pairings);
        if !model.pairs.is_empty() {
            pairings.sort_unstable_by_key(|pairing| pairing.candidate.key());
        }
    }
    let is_apart = |pairing: &Pairing| are_apart(model, bodies, &pairing.candidate);
    let is_plain = model.faces.is_empty() && model.piles.is_empty();
    if past.is_empty() && is_plain && pairings.iter().all(is_apart) {
        pairings.clear();
    }
}

/// Returns true if the bounding boxes of the two outlines stay apart in this step. The circle around a long ship
/// includes bodies far off her side, but the bounding box does not.
pub(crate) fn are_apart(model: &Model, bodies: &Bodies, candidate: &Candidate) -> bool {
    let (a, b) = (candidate.a as usize, candidate.b as usize);
    let travel_m = |rank: usize| bodies.reach_m[rank] - model.ranked[rank].reach_m;
    let closing_m = travel_m(a) + travel_m(b) + ROUNDING_M;
    let b_in_a = bodies.poses[a].to(bodies.poses[b]);
    let box_b = model.ranked.extent(b).placed(b_in_a);
    candidate.face == 0 && !model.ranked.extent(a).widened(closing_m).overlaps(&box_b)
}

/// Returns true if one of the two outlines is one of parts, and no part of it is near the box around the other outline
/// in this step. The circle and the box around a coast contain the water and all ships on the water.
#[inline(never)]
fn is_off_all_parts(model: &Model, bodies: &Bodies, [a, b]: [usize; 2]) -> bool {
    let travel_m = |rank: usize| bodies.reach_m[rank] - model.ranked[rank].reach_m;
    let closing_m = travel_m(a) + travel_m(b) + ROUNDING_M;
    let is_off = |coast: usize, other: usize| {
        let other_in_coast = bodies.poses[coast].to(bodies.poses[other]);
        let place = model.ranked.extent(other).placed(other_in_coast).widened(closing_m);
        let tree = model.ranked.shapes(coast).tree.filter(|_| model.ranked[coast].is_of_parts);
        tree.is_some_and(|tree| tree.meeting(place).next().is_none())
    };
    is_off(a, b) || is_off(b, a)
}

/// Adds the candidates for each pair whose circles of reach meet: outline against outline, then each body's fenders
/// against the outline of the other body. `first` is the number of the first pair in `pairs`.
#[inline(never)]
fn push_near(
    model: &Model,
    bodies: &Bodies,
    pairs: &[RankedPair],
    first: u32,
    pairings: &mut Vec<Pairing>,
) {
    let count = model.ranked.len();
    // Slices of one known length, so that the compiler checks the bounds of each rank once.
    let (poses, reach_m) = (&bodies.poses[..count], &bodies.reach_m[..count]);
    let has_faces = !model.faces.is_empty();
    for (pair, number) in pairs.iter().zip(first..) {
        let &RankedPair { a, b, material, island } = pair;
        let (one, two) = (a as usize, b as usize);
        let reach = reach_m[one] + reach_m[two];
        let apart = poses[one].position_m - poses[two].position_m;
        if apart.length_squared() <= reach * reach {
            let is_of_parts = model.ranked[one].is_of_parts || model.ranked[two].is_of_parts;
            if !(is_of_parts && is_off_all_parts(model, bodies, [one, two])) {
                let candidate = Candidate { a, b, face: 0, material };
                pairings.push(Pairing { candidate, island, pair: number });
            }
            if has_faces {
                push_faces(model, bodies, pair, number, pairings);
            }
        }
    }
}

/// Adds the candidates for the fenders of both bodies of a pair.
#[inline(never)]
fn push_faces(
    model: &Model,
    bodies: &Bodies,
    pair: &RankedPair,
    number: u32,
    pairings: &mut Vec<Pairing>,
) {
    let &RankedPair { a, b, island, .. } = pair;
    for (host, other) in [(a, b), (b, a)] {
        let (from, to) = model.ranked.faces(host as usize);
        for index in from..to {
            let face = &model.faces[index as usize];
            if is_face_near(model, bodies, face, other) {
                let candidate = Candidate { a, b, face: index + 1, material: face.material };
                pairings.push(Pairing { candidate, island, pair: number });
            }
        }
    }
}

/// Returns true if the circle around a fender can meet the other body within this step: the circle around the other
/// body, and for an outline of parts the box around a part. The circle around a coast contains all ships on the water.
fn is_face_near(model: &Model, bodies: &Bodies, face: &RankedFender, other: u32) -> bool {
    let (host, other) = (face.host as usize, other as usize);
    let travel_m = bodies.reach_m[host] - model.ranked[host].reach_m;
    let reach_m = face.zone.radius_m() + travel_m + bodies.reach_m[other];
    let center_m = bodies.poses[host].apply(face.zone.center_m());
    let is_near = (center_m - bodies.poses[other].position_m).length_squared() <= reach_m * reach_m;
    is_near
        && !(model.ranked[other].is_of_parts && is_face_off_all_parts(model, bodies, face, other))
}

/// Returns true if no part of a coast is near the box around a fender in this step.
#[inline(never)]
fn is_face_off_all_parts(
    model: &Model,
    bodies: &Bodies,
    face: &RankedFender,
    coast: usize,
) -> bool {
    let host = face.host as usize;
    let travel_m = |rank: usize| bodies.reach_m[rank] - model.ranked[rank].reach_m;
    let radius_m = face.zone.radius_m() + travel_m(host) + travel_m(coast) + ROUNDING_M;
    let center_m = bodies.poses[host].apply(face.zone.center_m());
    let place = Extent::of_circle(bodies.poses[coast].apply_inverse(center_m), radius_m);
    model.ranked.shapes(coast).tree.is_some_and(|tree| tree.meeting(place).next().is_none())
}
