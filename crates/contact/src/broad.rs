//! Stage 2, pair: which bodies are near enough to touch, in a fixed order (by the ranks of the
//! first and then the second body).

use alloc::vec::Vec;

use crate::fender::RankedFender;
use crate::model::Model;
use crate::pairing::RankedPair;
use crate::workspace::{Candidate, Pairing, Workspace};

/// Leaves the candidates of this step in `work.candidates`. `all_held`: all bodies are within their circles in the
/// list of those that are near.
pub(crate) fn pair(model: &Model, work: &mut Workspace, all_held: bool) {
    let mut candidates = core::mem::take(&mut work.candidates);
    candidates.clear();
    push_near(model, work, &model.pairs, 0, &mut candidates);
    if let Some(material) = model.all_other_pairs {
        let mut list = core::mem::take(&mut work.near);
        if !all_held {
            list.renew(model, material, &work.poses, &work.reach_m);
        }
        push_near(model, work, list.pairs(), model.pairs.len() as u32, &mut candidates);
        work.near = list;
        if !model.pairs.is_empty() {
            candidates.sort_unstable_by_key(|pairing| pairing.candidate.key());
        }
    }
    work.candidates = candidates;
}

/// The candidates of those pairs that are near, in their order: outline against outline, and each body's fenders
/// that are near against the other's outline (faces are numbered by the rank of their bodies). The first pair has
/// that number.
#[inline(never)]
fn push_near(
    model: &Model,
    work: &Workspace,
    pairs: &[RankedPair],
    first: u32,
    candidates: &mut Vec<Pairing>,
) {
    let count = model.ranked.len();
    // Of one length, so that it is asked for once.
    let (poses, reach_m) = (&work.poses[..count], &work.reach_m[..count]);
    let has_faces = !model.faces.is_empty();
    for (pair, number) in pairs.iter().zip(first..) {
        let &RankedPair { a, b, material, island } = pair;
        let (one, two) = (a as usize, b as usize);
        // Do the circles about the centres of gravity meet, or may they in this step?
        let reach = reach_m[one] + reach_m[two];
        let apart = poses[one].position_m - poses[two].position_m;
        if apart.length_squared() <= reach * reach {
            let candidate = Candidate { a, b, face: 0, material };
            candidates.push(Pairing { candidate, island, pair: number });
            if has_faces {
                push_faces(model, work, pair, number, candidates);
            }
        }
    }
}

/// The candidates of a pair that have to do with the fenders of either.
#[inline(never)]
fn push_faces(
    model: &Model,
    work: &Workspace,
    pair: &RankedPair,
    number: u32,
    candidates: &mut Vec<Pairing>,
) {
    let &RankedPair { a, b, island, .. } = pair;
    for (host, other) in [(a, b), (b, a)] {
        let (from, to) = model.ranked.faces(host as usize);
        for index in from..to {
            let face = &model.faces[index as usize];
            if face_near(model, work, face, other) {
                let candidate = Candidate { a, b, face: index + 1, material: face.material };
                candidates.push(Pairing { candidate, island, pair: number });
            }
        }
    }
}

/// Does a fender's circle meet that of the other body, or may it in this step?
fn face_near(model: &Model, work: &Workspace, face: &RankedFender, other: u32) -> bool {
    let (host, other) = (face.host as usize, other as usize);
    let travel_m = work.reach_m[host] - model.ranked[host].reach_m;
    let reach_m = face.zone.radius_m() + travel_m + work.reach_m[other];
    let center_m = work.poses[host].apply(face.zone.center_m());
    (center_m - work.poses[other].position_m).length_squared() <= reach_m * reach_m
}
