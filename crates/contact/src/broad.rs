//! Stage 2, pair: which bodies are near enough to touch, in a fixed order (by the ranks of the
//! first and then the second body).

use crate::fender::RankedFender;
use crate::model::{MaterialId, Model};
use crate::workspace::{Candidate, Workspace};

/// Leaves the candidates of this step in `work.candidates`.
pub(crate) fn pair(model: &Model, work: &mut Workspace) {
    work.candidates.clear();
    for pair in &model.pairs {
        if near(work, pair.a, pair.b) {
            push(model, work, pair.a, pair.b, pair.material);
        }
    }
    if model.every_other_pair.is_some() {
        sweep_and_prune(model, work);
        work.candidates.sort_unstable_by_key(Candidate::key);
    }
}

/// The candidates of a pair, in their order: outline against outline, and each body's fenders that are
/// near against the other's outline (faces are numbered by the rank of their bodies).
fn push(model: &Model, work: &mut Workspace, a: u32, b: u32, material: MaterialId) {
    work.candidates.push(Candidate { a, b, face: 0, material });
    for (host, other) in [(a, b), (b, a)] {
        let (from, to) = model.ranked[host as usize].faces;
        for index in from..to {
            let face = &model.faces[index as usize];
            if face_near(model, work, face, other) {
                work.candidates.push(Candidate { a, b, face: index + 1, material: face.material });
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

/// Every pair that no `Pair` names: the bodies are kept sorted by the northern end of their
/// circles, which moves little from step to step, so that an insertion sort costs one pass.
fn sweep_and_prune(model: &Model, work: &mut Workspace) {
    let Some(material) = model.every_other_pair else { return };
    let count = model.ranked.len();
    if work.by_x.len() != count {
        work.by_x.clear();
        work.by_x.extend((0..count as u32).map(|rank| (0.0, rank)));
    }
    for entry in &mut work.by_x {
        let rank = entry.1 as usize;
        entry.0 = work.poses[rank].position_m.x - work.reach_m[rank];
    }
    insertion_sort(&mut work.by_x);
    for i in 0..count {
        let (_, one) = work.by_x[i];
        let body = &model.ranked[one as usize];
        let high = work.poses[one as usize].position_m.x + work.reach_m[one as usize];
        for j in i + 1..count {
            let (low, two) = work.by_x[j];
            if low > high {
                break;
            }
            let (a, b) = (one.min(two), one.max(two));
            let both_fixed = body.is_fixed() && model.ranked[two as usize].is_fixed();
            if !both_fixed && near(work, a, b) && !named(model, a, b) {
                push(model, work, a, b, material);
            }
        }
    }
}

fn named(model: &Model, a: u32, b: u32) -> bool {
    model.pairs.binary_search_by_key(&(a, b), |p| (p.a, p.b)).is_ok()
}

/// By position, then rank: a total order, so that the result does not depend on where the sort
/// began. Falls back to a full sort when the order is far off (first step, teleports).
fn insertion_sort(by_x: &mut [(f64, u32)]) {
    let mut moves = 0usize;
    for i in 1..by_x.len() {
        let mut j = i;
        while j > 0 && after(by_x[j - 1], by_x[j]) {
            by_x.swap(j - 1, j);
            j -= 1;
            moves += 1;
        }
        if moves > 32 * by_x.len() {
            by_x.sort_unstable_by(|p, q| p.0.total_cmp(&q.0).then(p.1.cmp(&q.1)));
            return;
        }
    }
}

#[inline]
fn after(p: (f64, u32), q: (f64, u32)) -> bool {
    p.0 > q.0 || (p.0 == q.0 && p.1 > q.1)
}
