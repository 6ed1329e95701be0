//! Fenders as the plan views draw them.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Rotation, vec2};
use fenderline_sim::FenderSetup;

use crate::plot::{FenderBox, Label, Place, Use, shortened};
use fenderline_results::FenderVerdict;
use fenderline_results::Outcome;

/// Largest number of fenders with names.
const NAMED: usize = 12;
/// Longest name (characters).
const NAME_LENGTH: usize = 20;

/// Draws all fenders of those bodies for which `state_of` gives a state, compressed by `deflections_m` (index of the
/// fender and deflection).
pub(in crate::run_page) fn boxes<'a>(
    outcome: &Outcome<'_>,
    deflections_m: &[(usize, f64)],
    state_of: impl Fn(usize) -> Option<&'a BodyState>,
) -> Vec<FenderBox> {
    let fenders = outcome.setup.fenders.iter().enumerate();
    let boxes = fenders.filter_map(|(index, fender)| {
        let state = state_of(fender.body)?;
        let pressed = deflections_m.iter().find(|(i, _)| *i == index).map_or(0.0, |(_, m)| *m);
        Some(placed(fender, state, pressed, used(outcome, index)))
    });
    boxes.collect()
}

/// The names of fenders, placed behind the fenders; none if so many names would cover the view.
pub(in crate::run_page) fn names<'a>(
    outcome: &Outcome<'_>,
    state_of: impl Fn(usize) -> Option<&'a BodyState>,
) -> Vec<Label> {
    let fenders = &outcome.setup.fenders;
    if fenders.len() > NAMED {
        return Vec::new();
    }
    // The fender of a dolphin often has the dolphin's name, which stands there already.
    let other = fenders.iter().filter(|of| of.name != outcome.setup.bodies[of.body].name);
    let names = other.filter_map(|fender| {
        let at = placed(fender, state_of(fender.body)?, 0.0, Use::Untouched);
        let length_m = at.out_m.length();
        let side = if length_m > 0.0 { at.out_m * (-1.0 / length_m) } else { vec2(0.0, 1.0) };
        Some(Label {
            text: shortened(&fender.name, NAME_LENGTH),
            place: Place::Beside { point_m: at.mount_m, side },
        })
    });
    names.collect()
}

fn placed(fender: &FenderSetup, state: &BodyState, pressed_m: f64, used: Use) -> FenderBox {
    let pose = state.pose();
    let facing = Rotation::from_angle(fender.facing_rad);
    let outward = pose.rotation.apply(facing.apply(vec2(1.0, 0.0)));
    FenderBox {
        mount_m: pose.apply(fender.position_m),
        out_m: outward * greater(fender.projection_m - pressed_m, 0.0),
        half_width_m: outward.quarter_turn() * (0.5 * fender.width_m),
        used,
    }
}

pub(in crate::run_page) fn used(outcome: &Outcome<'_>, index: usize) -> Use {
    let Some(summary) = outcome.fenders.iter().find(|f| f.fender == index) else {
        return Use::Untouched;
    };
    match FenderVerdict::of(&outcome.setup.fenders[index], summary) {
        FenderVerdict::Failed => Use::Failed,
        _ => summary.governing().map_or(Use::NotRated, |(_, share)| Use::Share(share)),
    }
}
