//! Events. An event is reported when its cause begins, and not again while the cause lasts.

use alloc::vec::Vec;

use crate::inherit::inherited::Inherited;
use crate::inherit::matching::Heirs;
use crate::maths::number::lesser;
use crate::model::Model;
use crate::model::fender::RankedFender;
use crate::model::material::FenderId;
use crate::overlap::patch::Patch;
use crate::state::memory::PatchMemory;
use crate::state::report::{Event, EventKind};
use crate::touch::Touch;

/// Adds the events of a pair's old patches that end or split: a patch ends if no new patch continues it, and splits if
/// several new patches continue it.
pub(crate) fn report_ends_and_splits(
    model: &Model,
    events: &mut Vec<Event>,
    old: &[PatchMemory],
    heirs: &[Heirs],
) {
    for (m, heirs) in old.iter().zip(heirs) {
        match heirs.count {
            0 => note(model, events, m.a, m.b, EventKind::ContactEnded),
            1 => {}
            _ => note(model, events, m.a, m.b, EventKind::PatchSplit),
        }
    }
}

/// Adds the events of one patch of contact. An event that lasts is reported only once. Returns the flags that the
/// memory must keep, so that an event is not reported again.
#[inline(always)]
pub(crate) fn report_patch(
    model: &Model,
    events: &mut Vec<Event>,
    patch: &Patch,
    face: Option<&RankedFender>,
    touch: &Touch,
    inherited: Inherited,
    old: Option<&PatchMemory>,
) -> u32 {
    let (a, b) = (patch.candidate.a, patch.candidate.b);
    match inherited {
        Inherited::Nothing => note(model, events, a, b, EventKind::ContactBegan),
        Inherited::Merged(_) => note(model, events, a, b, EventKind::PatchesMerged),
        Inherited::One(_) | Inherited::Part(_) => {}
    }
    let reported = old.map_or(0, |m| m.flags);
    if let Some(face) = face {
        return report_fender(model, events, patch, face.id, touch.depth_m, reported);
    }
    // Shortcut for most patches: their area is less than half of any body's area.
    if !patch.contained && patch.area_m2 <= 0.5 * model.ranked.smallest_m2() {
        return 0;
    }
    report_deep_overlap(model, events, patch, reported)
}

/// Reports that one body, or half of its area, lies within the other body.
#[inline(never)]
fn report_deep_overlap(
    model: &Model,
    events: &mut Vec<Event>,
    patch: &Patch,
    reported: u32,
) -> u32 {
    let (a, b) = (patch.candidate.a, patch.candidate.b);
    let [a_m2, b_m2] = [a, b].map(|rank| model.ranked.rest(rank as usize).area_m2);
    let smaller_m2 = lesser(a_m2, b_m2);
    // The tolerance is for a body that overlaps several pieces of another: the area is then a sum with rounding errors.
    let contained = patch.contained || patch.area_m2 >= smaller_m2 * (1.0 - 1e-9);
    let deep = patch.area_m2 > 0.5 * smaller_m2;
    let flags = u32::from(contained) * PatchMemory::CONTAINED + u32::from(deep) * PatchMemory::DEEP;
    let kinds = [EventKind::Contained, EventKind::DeepOverlap];
    report_new(model, events, patch, flags & !reported, kinds);
    flags
}

/// Reports that a fender is beyond its rated deflection, or in its stop.
#[inline(never)]
fn report_fender(
    model: &Model,
    events: &mut Vec<Event>,
    patch: &Patch,
    id: FenderId,
    deflection_m: f64,
    reported: u32,
) -> u32 {
    let fender = &model.fenders()[id.0 as usize];
    let travel_m = fender.stop.map_or(fender.projection_m, |stop| stop.from_m);
    let over = deflection_m > fender.rated_deflection_m;
    let failed = deflection_m > travel_m;
    // Reported once per contact: a failed fender is not reported again when its deflection returns.
    let now = u32::from(over) * PatchMemory::CONTAINED + u32::from(failed) * PatchMemory::DEEP;
    let flags = now | (reported & (PatchMemory::CONTAINED | PatchMemory::DEEP));
    let kinds = [EventKind::FenderRatingExceeded(id), EventKind::FenderFailed(id)];
    report_new(model, events, patch, flags & !reported, kinds);
    flags
}

/// Adds the events of a patch whose flags are set in `news`: the flags that this step sets for the first time.
#[inline]
fn report_new(
    model: &Model,
    events: &mut Vec<Event>,
    patch: &Patch,
    news: u32,
    [contained, deep]: [EventKind; 2],
) {
    let (a, b) = (patch.candidate.a, patch.candidate.b);
    if news & PatchMemory::CONTAINED != 0 {
        note(model, events, a, b, contained);
    }
    if news & PatchMemory::DEEP != 0 {
        note(model, events, a, b, deep);
    }
}

/// Adds an event between two bodies, given by rank.
#[cold]
#[inline(never)]
pub(crate) fn note(model: &Model, events: &mut Vec<Event>, a: u32, b: u32, kind: EventKind) {
    let [a, b] = model.ids_of([a, b]);
    events.push(Event { bodies: [a.min(b), a.max(b)], kind });
}
