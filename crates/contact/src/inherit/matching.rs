//! Finds the patches of a pair of bodies that lie where the old patches of the pair lay.

use alloc::vec::Vec;

use crate::geometry::extent::Extent;
use crate::maths::vec2::Vec2;
use crate::overlap::patch::{Patch, Place};
use crate::state::memory::{PatchMemory, PlaceMemory};

/// The patches of a pair of bodies that continue old patches. Computed by [`Matching::find`].
#[derive(Clone, Debug, Default)]
pub(crate) struct Matching {
    /// Pairs of a patch and the old patch that it continues, by their indices in the lists of the pair of bodies;
    /// sorted.
    pub(crate) matches: Vec<(u32, u32)>,
    /// For each old patch, the patches that continue it.
    pub(crate) heirs: Vec<Heirs>,
    /// For each old patch, its place on the bodies; `None` if the bodies are convex.
    old_places: Vec<Option<Place>>,
    /// The old and the new patches, sorted by the low ends of their bounding boxes.
    by_low_end: [Vec<(f64, u32)>; 2],
}

/// The patches that continue an old patch.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Heirs {
    pub(crate) count: u32,
    /// Sum of the areas of the patches that continue the old patch (m²).
    pub(crate) area_m2: f64,
}

impl Matching {
    /// Matches all patches of a pair of bodies with all old patches of the pair. A patch continues an old patch if
    /// their bounding boxes meet in the frame of one of the two bodies: a sliding contact stays in place on at least
    /// one of the bodies. Patches of convex bodies need no place: all patches continue an old patch without a place.
    pub(crate) fn find(
        &mut self,
        patches: &[Patch],
        places: &[Place],
        old: &[PatchMemory],
        old_places: &[PlaceMemory],
    ) {
        self.matches.clear();
        self.set_old_places(old, old_places);
        let places = patches
            .first()
            .and_then(Patch::place)
            .map_or(&[][..], |first| &places[first as usize..first as usize + patches.len()]);
        if places.is_empty() || self.old_places.contains(&None) {
            let by_place =
                |patch: usize, old: usize| match (places.get(patch), self.old_places[old]) {
                    (Some(place), Some(old)) => place.meets(&old),
                    _ => true,
                };
            let all = (0..patches.len()).flat_map(|patch| (0..old.len()).map(move |o| (patch, o)));
            let met = all.filter(|&(patch, old)| by_place(patch, old));
            self.matches.extend(met.map(|(patch, old)| (patch as u32, old as u32)));
        } else {
            self.sweep(places, |place| place.in_a, |_, _| true);
            self.sweep(places, |place| place.in_b, |one, two| !one.in_a.overlaps(&two.in_a));
            self.matches.sort_unstable();
        }
        self.heirs.clear();
        self.heirs.resize(old.len(), Heirs::default());
        for &(patch, old) in &self.matches {
            let heirs = &mut self.heirs[old as usize];
            heirs.count += 1;
            heirs.area_m2 += patches[patch as usize].area_m2;
        }
    }

    /// Sets the places of the old patches. The lists of old and new patches are both in the order of the patches.
    fn set_old_places(&mut self, old: &[PatchMemory], places: &[PlaceMemory]) {
        self.old_places.clear();
        let Some(first) = old.first() else { return };
        let mut rest = &places[places.partition_point(|place| place.key() < first.key())..];
        self.old_places.extend(old.iter().map(|memory| match rest {
            [place, others @ ..] if place.key() == memory.key() => {
                rest = others;
                Some(place.place)
            }
            _ => None,
        }));
    }

    /// Sweeps along the longer side of the box around the patches, and adds the pairs of patch and old patch whose
    /// bounding boxes meet in one frame. The function adds only pairs for which `counts` returns true.
    fn sweep(
        &mut self,
        places: &[Place],
        of_frame: impl Fn(&Place) -> Extent,
        counts: impl Fn(&Place, &Place) -> bool,
    ) {
        let Matching { matches, old_places, by_low_end: [by_old, by_new], .. } = self;
        let old_place = |old: u32| old_places[old as usize].unwrap_or_default();
        let all = places.iter().fold(Extent::EMPTY, |all, place| all.and(of_frame(place)));
        let size_m = all.high_m - all.low_m;
        let is_north = size_m.x >= size_m.y;
        let along = |v: Vec2| if is_north { v.x } else { v.y };
        let low_end = |place: &Place| along(of_frame(place).low_m);
        let high_end = |place: &Place| along(of_frame(place).high_m);
        by_old.clear();
        by_old.extend((0..old_places.len() as u32).map(|old| (low_end(&old_place(old)), old)));
        by_new.clear();
        by_new.extend((0..).zip(places).map(|(patch, place)| (low_end(place), patch)));
        for list in [&mut *by_old, &mut *by_new] {
            list.sort_unstable_by(|p, q| p.0.total_cmp(&q.0).then(p.1.cmp(&q.1)));
        }
        let mut note = |patch: u32, old: u32| {
            let (place, old_place) = (&places[patch as usize], &old_place(old));
            if of_frame(place).overlaps(&of_frame(old_place)) && counts(place, old_place) {
                matches.push((patch, old));
            }
        };
        // Of two boxes that meet, the box that begins first finds the other.
        let (mut rest_old, mut rest_new) = (by_old.as_slice(), by_new.as_slice());
        while let ([(old_m, old), others_old @ ..], [(new_m, patch), others_new @ ..]) =
            (rest_old, rest_new)
        {
            if old_m <= new_m {
                let high_m = high_end(&old_place(*old));
                let met = rest_new.iter().take_while(|(low_m, _)| *low_m <= high_m);
                met.for_each(|(_, patch)| note(*patch, *old));
                rest_old = others_old;
            } else {
                let high_m = high_end(&places[*patch as usize]);
                let met = rest_old.iter().take_while(|(low_m, _)| *low_m <= high_m);
                met.for_each(|(_, old)| note(*patch, *old));
                rest_new = others_new;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::maths::vec2::vec2;

    /// Boxes in a fixed pattern, in both frames. Many boxes meet none of the others, one or several.
    fn place(number: u32, shift: u32) -> Place {
        let extent = |seed: u32| {
            let at = |factor: u32| f64::from((seed.wrapping_mul(factor) >> 7) % 400);
            let low_m = vec2(at(2_654_435_761), at(40_503));
            Extent { low_m, high_m: low_m + vec2(at(97) % 23.0, at(193) % 31.0) }
        };
        Place { in_a: extent(number * 7919 + shift), in_b: extent(number * 104_729 + shift) }
    }

    #[test]
    fn the_sweep_finds_what_a_comparison_of_all_finds() {
        for (count, old_count, shift) in [(1, 5, 3), (40, 1, 5), (150, 90, 11), (300, 300, 17)] {
            let places: Vec<Place> = (0..count).map(|k| place(k, 0)).collect();
            let old: Vec<Place> = (0..old_count).map(|k| place(k, shift)).collect();
            let mut matching = Matching {
                old_places: old.iter().copied().map(Some).collect(),
                ..Matching::default()
            };
            matching.sweep(&places, |place| place.in_a, |_, _| true);
            matching.sweep(&places, |place| place.in_b, |p, q| !p.in_a.overlaps(&q.in_a));
            matching.matches.sort_unstable();
            let all = (0..count).flat_map(|k| (0..old_count).map(move |o| (k, o)));
            let met = |&(k, o): &(u32, u32)| places[k as usize].meets(&old[o as usize]);
            let expected: Vec<(u32, u32)> = all.filter(met).collect();
            assert_eq!(matching.matches, expected);
            assert!(count < 100 || expected.len() > 50, "{}", expected.len());
        }
    }
}
