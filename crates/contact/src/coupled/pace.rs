//! How many sub-steps an island needs in a step.

use core::ops::Range;

use crate::coupled::island::Island;
use crate::fender::{FenderBounds, FenderLaw, RankedFender};
use crate::geometry::clip::Hint;
use crate::geometry::gap::gap_m;
use crate::memory::HintMemory;
use crate::model::Model;
use crate::number::{bounded, greater, lesser};
use crate::overlap::{Patch, pieces_of};
use crate::pairing::{Bounds, Yielding};
use crate::ranked::RankedBody;
use crate::workspace::{Candidate, Pairing, Workspace};

/// Largest ωh of a sub-step. The contact that begins within a sub-step is felt up to h late, which
/// costs at most (ωh)²/2 of the depth: 0.5 % here, and less as the bounds on ω below are wide.
const TURN_PER_SUB_STEP: f64 = 0.1;

/// The same for the springs of a contact that stands already. Positions and velocities of the sub-steps
/// are a leapfrog's, whose swing on a linear spring has an amplitude right to (ωh)²/8 and a rate right to
/// (ωh)²/24: 0.3 % and 0.1 % here.
const TURN_IN_CONTACT: f64 = 0.15;

/// What the rate of a contact that stands counts for beside that of one that may begin.
const STANDING: f64 = (TURN_PER_SUB_STEP / TURN_IN_CONTACT) * (TURN_PER_SUB_STEP / TURN_IN_CONTACT);

/// Largest share of the thinner body's half-width that the two may close in a sub-step.
const TRAVEL_PER_SUB_STEP: f64 = 0.5;

/// Most sub-steps of a step: bounded work, whatever the host asks for.
pub(crate) const MOST_SUB_STEPS: u32 = 4096;

/// What candidates ask of the pace of their island.
#[derive(Clone, Copy, Default)]
struct Haste {
    /// Sum of the squares of the rates of their springs and dampers (1/s²).
    rate_squared: f64,
    /// What they may close in the step, in sub-steps of the largest travel.
    travel: f64,
}

impl Haste {
    /// Number of sub-steps, for a rate of 1 s⁻¹ that turns so far in the step.
    #[inline(always)]
    fn sub_steps(self, turn: f64) -> u32 {
        if self.rate_squared * (turn * turn) <= 1.0 && self.travel <= 1.0 {
            return 1;
        }
        let needed = greater(libm::sqrt(self.rate_squared) * turn, self.travel);
        libm::ceil(bounded(needed, 1.0, f64::from(MOST_SUB_STEPS))) as u32
    }
}

/// Each island's patches of the first overlap, which left `hints`, and how many sub-steps it needs.
#[inline(never)]
pub(crate) fn set_paces(
    model: &Model,
    work: &Workspace,
    islands: &mut [Island],
    hints: &[HintMemory],
    step_s: f64,
) {
    let count = model.ranked.len();
    let fastest_mps = &work.fastest_mps[..count];
    let turn = step_s * (1.0 / TURN_PER_SUB_STEP);
    let most_rate_squared = 1.0 / (turn * turn);
    let (all, candidates) = (work.found.patches.as_slice(), work.candidates.as_slice());
    let mut left = all;
    let mut from = 0;
    for island in islands {
        let Range { start, end } = island.candidates();
        // Most of one contact need no more than one: asked of these with nothing to add up.
        let sub_steps = if end - start == 1
            && let Some((only, others)) = alone(left, start)
            && is_slow(
                model,
                work,
                fastest_mps,
                (&candidates[start], only),
                (most_rate_squared, step_s),
            ) {
            left = others;
            1
        } else {
            sub_steps(model, work, fastest_mps, island, (&mut left, hints), step_s)
        };
        let to = all.len() - left.len();
        island.go(from..to, sub_steps);
        from = to;
    }
}

/// Is a contact of two outlines slow enough for one sub-step?
#[inline(always)]
fn is_slow(
    model: &Model,
    work: &Workspace,
    fastest_mps: &[f64],
    (pairing, only): (&Pairing, &Patch),
    (most_rate_squared, step_s): (f64, f64),
) -> bool {
    let Pairing { candidate, pair, .. } = pairing;
    if candidate.face != 0 {
        return false;
    }
    let bounds = work.bounds_of(model, *pair);
    let pair = [candidate.a as usize, candidate.b as usize];
    !may_travel(fastest_mps, pair, bounds, step_s)
        && standing_rate_squared(bounds, only, most_rate_squared) <= most_rate_squared
}

/// How many sub-steps an island needs; takes its patches off those that are left.
#[inline(never)]
fn sub_steps(
    model: &Model,
    work: &Workspace,
    fastest_mps: &[f64],
    island: &Island,
    (left, hints): (&mut &[Patch], &[HintMemory]),
    step_s: f64,
) -> u32 {
    let turn = step_s * (1.0 / TURN_PER_SUB_STEP);
    let pairings = &work.candidates[island.candidates()];
    // What each may add to the square of the rate without more sub-steps, whatever the others add.
    let share = 1.0 / (turn * turn * f64::from(pairings.len() as u32));
    let mut haste = Haste::default();
    for (index, pairing) in (island.candidates().start..).zip(pairings) {
        let Pairing { candidate, pair, .. } = pairing;
        let ranks = [candidate.a as usize, candidate.b as usize];
        match (alone(left, index), candidate.fender(model)) {
            (Some((only, others)), None) => {
                *left = others;
                let bounds = work.bounds_of(model, *pair);
                haste.rate_squared += standing_rate_squared(bounds, only, share);
                if may_travel(fastest_mps, ranks, bounds, step_s) {
                    haste.travel = greater(haste.travel, travel(work, candidate, bounds, step_s));
                }
            }
            (Some((only, others)), Some(face))
                if let Some(rate_squared) = slow_rate_squared(
                    model,
                    fastest_mps,
                    (candidate, face),
                    only,
                    (share, step_s),
                ) =>
            {
                *left = others;
                haste.rate_squared += rate_squared;
            }
            _ => {
                let own = patches_of(left, index);
                haste = with_others(model, work, haste, pairing, (own, hints), step_s);
            }
        }
    }
    haste.sub_steps(turn)
}

/// May two outlines close more than the largest travel of a sub-step?
#[inline(always)]
fn may_travel(fastest_mps: &[f64], pair: [usize; 2], bounds: &Bounds, step_s: f64) -> bool {
    let [fastest_a, fastest_b] = pair.map(|rank| fastest_mps[rank]);
    (fastest_a + fastest_b) * step_s > TRAVEL_PER_SUB_STEP * bounds.half_width_m
}

/// A bound on the square of the rate of a contact of two outlines that stands in one patch (1/s²).
#[inline(always)]
fn standing_rate_squared(bounds: &Bounds, only: &Patch, share: f64) -> f64 {
    let most = STANDING * bounds.spring_rate_squared + bounds.damping_rate_squared;
    // Where even the largest bound is small there is no more to find out.
    if most > share && only.per_chord_m > 0.0 {
        let felt = inverse_mass(bounds, only) / bounds.inverse_mass;
        return (STANDING * bounds.spring_rate_squared + bounds.damping_rate_squared * felt) * felt;
    }
    most
}

/// With a candidate that is not two outlines that touch in one patch.
#[inline(never)]
fn with_others(
    model: &Model,
    work: &Workspace,
    mut haste: Haste,
    pairing: &Pairing,
    (own, hints): (&[Patch], &[HintMemory]),
    step_s: f64,
) -> Haste {
    let Pairing { candidate, pair, .. } = pairing;
    if own.is_empty() && !may_touch(model, work, candidate, hints, step_s) {
        return haste;
    }
    let counts = if own.is_empty() { 1.0 } else { STANDING };
    if let Some(face) = candidate.fender(model) {
        let closing_m = closing_mps(work, candidate) * step_s;
        let fender = &model.fenders()[face.id.0 as usize];
        let (spring, damper) = rates_squared_of_face(model, work, own, candidate, face, closing_m);
        haste.rate_squared += counts * spring + damper;
        haste.travel =
            greater(haste.travel, closing_m / (TRAVEL_PER_SUB_STEP * 0.5 * fender.projection_m));
        return haste;
    }
    let bounds = work.bounds_of(model, *pair);
    haste.rate_squared += counts * bounds.spring_rate_squared + bounds.damping_rate_squared;
    haste.travel = greater(haste.travel, travel(work, candidate, bounds, step_s));
    haste
}

/// What two outlines may close in the step, in sub-steps of the largest travel.
#[cold]
fn travel(work: &Workspace, candidate: &Candidate, bounds: &Bounds, step_s: f64) -> f64 {
    closing_mps(work, candidate) * step_s / (TRAVEL_PER_SUB_STEP * bounds.half_width_m)
}

/// The first patch, where it is the only one of candidate number `index`, and those after it.
#[inline(always)]
fn alone(patches: &[Patch], index: usize) -> Option<(&Patch, &[Patch])> {
    let of_candidate = |patch: &Patch| patch.of as usize == index;
    let (first, others) = patches.split_first()?;
    let is_alone = of_candidate(first) && !others.first().is_some_and(of_candidate);
    is_alone.then_some((first, others))
}

/// The first patches, as far as they belong to candidate number `index`; moves on to what comes after.
fn patches_of<'p>(patches: &mut &'p [Patch], index: usize) -> &'p [Patch] {
    let count = patches.iter().take_while(|patch| patch.of as usize == index).count();
    let (own, rest) = patches.split_at(count);
    *patches = rest;
    own
}

/// A bound on the inverse mass that two bodies oppose to a contact of theirs (1/kg). Twice that without rotation
/// allows for a contact off the centre; its lever may tell that rotation adds less. The patch lies on the chord,
/// so that it moves by half of that at most; and within the smaller body, so that it comes no further from that
/// one's centre of gravity.
#[inline(always)]
fn inverse_mass(bounds: &Bounds, patch: &Patch) -> f64 {
    let of_body = |body: &Yielding, patch_m: f64, smaller_m: f64| {
        let lever_m = lesser(patch_m.abs(), smaller_m.abs()) + bounds.half_chord_m;
        let by_turning = body.of_turning * lever_m * lever_m;
        body.lightest_inverse_mass + lesser(by_turning, body.lightest_inverse_mass)
    };
    // Levers of the patch and of B's centre of gravity about A's, along the chord.
    let along = patch.chord_m * patch.per_chord_m;
    let (patch_m, b_m) = (patch.centroid_m.dot(along), patch.b_in_a.position_m.dot(along));
    let smaller_m = b_m * bounds.b_is_smaller;
    let [a, b] = &bounds.yields;
    // What is fixed adds nothing.
    if b.is_fixed() {
        return of_body(a, patch_m, smaller_m);
    }
    let of_b = of_body(b, patch_m - b_m, smaller_m - b_m);
    if a.is_fixed() { of_b } else { of_body(a, patch_m, smaller_m) + of_b }
}

/// A bound on the square of the rate of a fender that stands in one patch (1/s²): none where that is more than its
/// share, its stop may be met in this step, or more may be closed than in one sub-step.
#[inline(always)]
fn slow_rate_squared(
    model: &Model,
    fastest_mps: &[f64],
    (candidate, face): (&Candidate, &RankedFender),
    only: &Patch,
    (share, step_s): (f64, f64),
) -> Option<f64> {
    let (a, b) = (candidate.a as usize, candidate.b as usize);
    let FenderBounds { spring_npm, stop_from_m, damping_nspm, projection_m, arm_m, spread_m } =
        face.bounds;
    let closing_m = (fastest_mps[a] + fastest_mps[b]) * step_s;
    if closing_m > TRAVEL_PER_SUB_STEP * 0.5 * projection_m
        || only.area_m2 > (stop_from_m - closing_m) * face.width_m
    {
        return None;
    }
    // Some point of the other body lies in the fender's zone, or comes into it.
    let (host, other) = if face.host == candidate.a { (a, b) } else { (b, a) };
    let (host, other) = (&model.ranked[host], &model.ranked[other]);
    let of_body = |body: &RankedBody, arm_m: f64| {
        body.lightest_inverse_mass + body.inverse_of_turning * arm_m * arm_m
    };
    let inverse_mass = of_body(host, arm_m) + of_body(other, other.radius_m + spread_m + closing_m);
    let damping_rate = damping_nspm * inverse_mass;
    let rate_squared = STANDING * spring_npm * inverse_mass + damping_rate * damping_rate;
    (rate_squared <= share).then_some(rate_squared)
}

/// Bounds on the squares of the rates of a fender and its hull by spring and stop, for all deflections that
/// this step can reach, and by the damper (1/s²).
#[inline(never)]
fn rates_squared_of_face(
    model: &Model,
    work: &Workspace,
    own: &[Patch],
    candidate: &Candidate,
    face: &RankedFender,
    closing_m: f64,
) -> (f64, f64) {
    let fender = &model.fenders()[face.id.0 as usize];
    let material = &model.materials()[face.material.0 as usize];
    let area_m2: f64 = own.iter().map(|patch| patch.area_m2).sum();
    let deflection_m = area_m2 / face.width_m + closing_m;
    let spring_npm = match fender.law {
        FenderLaw::Area => material.stiffness_npm2 * face.width_m,
        FenderLaw::Curve(_) => fender.law.steepest_npm(deflection_m),
    };
    let stop_npm = match fender.stop {
        Some(stop) if deflection_m > stop.from_m => stop.stiffness_npm,
        _ => 0.0,
    };
    let face_m = work.poses[face.host as usize].apply(face.face_m);
    let inverse_mass: f64 = [candidate.a, candidate.b]
        .map(|rank| {
            let arm_m = face_m - work.poses[rank as usize].position_m;
            let body = &model.ranked[rank as usize];
            body.lightest_inverse_mass + body.inverse_of_turning * arm_m.length_squared()
        })
        .iter()
        .sum();
    let damping_rate = material.damping_nspm2 * face.width_m * inverse_mass;
    let spring = (spring_npm + stop_npm) * face.largest_factor * inverse_mass;
    (spring, damping_rate * damping_rate)
}

/// Could the pair touch in this step? By the gaps between its pieces.
#[inline(never)]
fn may_touch(
    model: &Model,
    work: &Workspace,
    candidate: &Candidate,
    hints: &[HintMemory],
    step_s: f64,
) -> bool {
    let (a, b) = (candidate.a as usize, candidate.b as usize);
    let b_in_a = work.poses[a].to(work.poses[b]);
    let reach_m = closing_mps(work, candidate) * step_s;
    let (pieces_a, pieces_b) = pieces_of(model, candidate);
    (0u32..).zip(pieces_a).any(|(piece_a, shape_a)| {
        (0u32..).zip(pieces_b).any(|(piece_b, shape_b)| {
            let key = (candidate.a, candidate.b, candidate.face, piece_a, piece_b);
            let hint = match hints.binary_search_by_key(&key, HintMemory::key) {
                Ok(index) => hints[index].hint,
                Err(_) => Hint::None,
            };
            gap_m(shape_a, shape_b, b_in_a, hint) <= reach_m
        })
    })
}

/// A bound on how fast any two points of the pair approach each other in this step (m/s).
fn closing_mps(work: &Workspace, candidate: &Candidate) -> f64 {
    let (a, b) = (candidate.a as usize, candidate.b as usize);
    let apart = (work.shown[a].velocity_mps - work.shown[b].velocity_mps).length();
    apart + work.room_mps[a] + work.room_mps[b]
}
