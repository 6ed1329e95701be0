//! Stage 2, pair: which bodies are near enough to touch, in a fixed order (by the ranks of the
//! first and then the second body).

use crate::fender::RankedFender;
use crate::model::Model;
use crate::pairing::RankedPair;
use crate::workspace::{Candidate, Pairing, Workspace};

/// Leaves the candidates of this step in `work.candidates`.
pub(crate) fn pair(model: &Model, work: &mut Workspace) {
    work.candidates.clear();
    for (pair, number) in model.pairs.iter().zip(0..) {
        if near(work, pair.a, pair.b) {
            push(model, work, pair, number);
        }
    }
    if let Some(material) = model.every_other_pair {
        let mut list = core::mem::take(&mut work.near);
        list.refresh(model, material, &work.poses, &work.reach_m, &work.active);
        for (pair, number) in list.pairs().iter().zip(model.pairs.len() as u32..) {
            if near(work, pair.a, pair.b) {
                push(model, work, pair, number);
            }
        }
        work.near = list;
        if !model.pairs.is_empty() {
            work.candidates.sort_unstable_by_key(|pairing| pairing.candidate.key());
        }
    }
}

/// The candidates of a pair, in their order: outline against outline, and each body's fenders that are
/// near against the other's outline (faces are numbered by the rank of their bodies).
#[inline(always)]
fn push(model: &Model, work: &mut Workspace, pair: &RankedPair, number: u32) {
    let &RankedPair { a, b, material, island } = pair;
    let candidate = Candidate { a, b, face: 0, material };
    work.candidates.push(Pairing { candidate, island, pair: number });
    if !model.faces.is_empty() {
        push_faces(model, work, pair, number);
    }
}

/// The candidates of a pair that have to do with the fenders of either.
#[inline(never)]
fn push_faces(model: &Model, work: &mut Workspace, pair: &RankedPair, number: u32) {
    let &RankedPair { a, b, island, .. } = pair;
    for (host, other) in [(a, b), (b, a)] {
        let (from, to) = model.ranked[host as usize].faces;
        for index in from..to {
            let face = &model.faces[index as usize];
            if face_near(model, work, face, other) {
                let candidate = Candidate { a, b, face: index + 1, material: face.material };
                work.candidates.push(Pairing { candidate, island, pair: number });
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

/// Do the circles about the centres of gravity meet, or may they in this step?
#[inline]
fn near(work: &Workspace, a: u32, b: u32) -> bool {
    let (a, b) = (a as usize, b as usize);
    let reach = work.reach_m[a] + work.reach_m[b];
    let apart = work.poses[a].position_m - work.poses[b].position_m;
    apart.length_squared() <= reach * reach
}
