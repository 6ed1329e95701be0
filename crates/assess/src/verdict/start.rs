//! Finds bodies that start a run inside each other.

use fenderline_contact::{self as contact, BodyState, Memory, Model, Workspace};

use super::finding::Finding;
use fenderline_world::setup::Setup;

/// Penetration of a hull into structure from which a start inside each other is reported (m); we chose the accuracy of
/// an engineer's drawing.
const PENETRATION_M: f64 = 0.001;

/// The pairs of bodies whose overlap at the start cannot come from a berthing: a hull inside a structure that fenders
/// protect, or a fender compressed beyond its rated deflection (without a rating: beyond half its projection). A moored
/// ship that starts on compressed fenders is not in the list, unless a fender is compressed that far.
///
/// `memory` must be the memory of bodies that have never touched. The function uses and changes `memory` and `work`.
///
/// The list is also empty if the engine refuses the states of the bodies. The first step of the run then gives the
/// reason why the engine refuses the states.
pub fn starts_inside(
    setup: &Setup,
    model: &Model,
    states: &[BodyState],
    (memory, work): (&mut Memory, &mut Workspace),
    is_protected: impl Fn([usize; 2]) -> bool,
) -> Vec<Finding> {
    // Any Δt will do: only depths are used, and they follow from the given states.
    if contact::step(model, memory, work, states, setup.step_s).is_err() {
        return Vec::new();
    }
    let mut found: Vec<Finding> = Vec::new();
    for contact in work.contacts() {
        let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
        let fender = contact.fender.map(|id| id.0 as usize);
        let limit_m = match fender.map(|index| &setup.fenders[index]) {
            None if is_protected(bodies) => PENETRATION_M,
            None => continue,
            Some(fender) => fender.rated.map_or(0.5 * fender.projection_m, |r| r.deflection_m),
        };
        if contact.depth_m > limit_m {
            let depth_m = contact.depth_m;
            // If a pair has several patches, the deepest is kept.
            let same = found.iter_mut().find_map(|other| match other {
                Finding::StartInside { bodies: b, fender: f, depth_m }
                    if (*b, *f) == (bodies, fender) =>
                {
                    Some(depth_m)
                }
                _ => None,
            });
            match same {
                Some(deepest_m) => *deepest_m = contact::number::greater(*deepest_m, depth_m),
                None => found.push(Finding::StartInside { bodies, fender, depth_m }),
            }
        }
    }
    found
}
