//! Events: what a user should know of, told when it begins and not again while it lasts.

use alloc::vec::Vec;

use crate::fender::RankedFender;
use crate::inherited::Inherited;
use crate::material::FenderId;
use crate::memory::{PatchMemory, PlaceMemory, place_of};
use crate::model::Model;
use crate::number::lesser;
use crate::overlap::{Patch, Place, continues};
use crate::report::{Event, EventKind};
use crate::touch::Touch;

/// Events for the old patches of a pair that no new one continues, or more than one does.
pub(crate) fn tell_ends_and_splits(
    model: &Model,
    events: &mut Vec<Event>,
    patches: &[Patch],
    places: &[Place],
    own: &[PatchMemory],
    old_places: &[PlaceMemory],
) {
    if own.len() <= 1 && patches.len() == 1 {
        return; // one patch that goes on
    }
    for m in own {
        let place = place_of(m, old_places);
        let heirs = patches.iter().filter(|p| continues(place, p, places)).count();
        match heirs {
            0 => note(model, events, m.a, m.b, EventKind::ContactEnded),
            1 => {}
            _ => note(model, events, m.a, m.b, EventKind::PatchSplit),
        }
    }
}

/// Events of one patch; those that last are told once. Returns the flags to remember.
#[inline(always)]
pub(crate) fn tell_of_patch(
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
    let told = old.map_or(0, |m| m.flags);
    if let Some(face) = face {
        return tell_of_fender(model, events, patch, face.id, touch.depth_m, told);
    }
    // Most of them are less than half of any body.
    if !patch.contained && patch.area_m2 <= 0.5 * model.ranked.smallest_m2() {
        return 0;
    }
    tell_of_deep_overlap(model, events, patch, told)
}

/// One body within the other, or half of it.
#[inline(never)]
fn tell_of_deep_overlap(model: &Model, events: &mut Vec<Event>, patch: &Patch, told: u32) -> u32 {
    let (a, b) = (patch.candidate.a, patch.candidate.b);
    let smaller_m2 = lesser(model.ranked[a as usize].area_m2, model.ranked[b as usize].area_m2);
    // To a billionth: a body that lies in several pieces of another is summed from them.
    let contained = patch.contained || patch.area_m2 >= smaller_m2 * (1.0 - 1e-9);
    let deep = patch.area_m2 > 0.5 * smaller_m2;
    let flags = u32::from(contained) * PatchMemory::CONTAINED + u32::from(deep) * PatchMemory::DEEP;
    let kinds = [EventKind::Contained, EventKind::DeepOverlap];
    tell_news(model, events, patch, flags & !told, kinds);
    flags
}

/// A fender beyond its rated deflection, and one in its stop.
#[inline(never)]
fn tell_of_fender(
    model: &Model,
    events: &mut Vec<Event>,
    patch: &Patch,
    id: FenderId,
    deflection_m: f64,
    told: u32,
) -> u32 {
    let fender = &model.fenders()[id.0 as usize];
    let travel_m = fender.stop.map_or(fender.projection_m, |stop| stop.from_m);
    let over = deflection_m > fender.rated_deflection_m;
    let failed = deflection_m > travel_m;
    // Once a contact: a fender that has failed is not told again when it comes back.
    let now = u32::from(over) * PatchMemory::CONTAINED + u32::from(failed) * PatchMemory::DEEP;
    let flags = now | (told & (PatchMemory::CONTAINED | PatchMemory::DEEP));
    let kinds = [EventKind::FenderRatingExceeded(id), EventKind::FenderFailed(id)];
    tell_news(model, events, patch, flags & !told, kinds);
    flags
}

/// The events of the flags that are new.
#[inline]
fn tell_news(
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

/// Books an event of the bodies of two ranks.
#[cold]
#[inline(never)]
pub(crate) fn note(model: &Model, events: &mut Vec<Event>, a: u32, b: u32, kind: EventKind) {
    let [a, b] = model.ids_of([a, b]);
    events.push(Event { bodies: [a.min(b), a.max(b)], kind });
}
