//! Notices about parts of a scenario that have no effect.

use std::collections::BTreeSet;

use fenderline_sim::{BodySetup, FenderSetup};

use super::Assembly;
use super::pairs::Pairs;
use crate::checked::Table;
use crate::error::Notice;
use crate::sources::quoted;

impl Assembly<'_, '_> {
    /// Bodies that touch nothing, and materials that nothing uses; one notice where there is no pair at all.
    pub(super) fn note_unused(
        &mut self,
        file: &Table,
        bodies: &[BodySetup],
        pairs: &Pairs,
        fenders: &[FenderSetup],
    ) {
        if pairs.named.is_empty() && pairs.every_other.is_none() && bodies.len() > 1 {
            self.notices.push(Notice {
                place: self.sources.place(&file.given("body").span),
                key: "pair".to_owned(),
                message: "there are no pairs, so no bodies can touch".to_owned(),
            });
            return;
        }
        let mut used_materials: BTreeSet<usize> =
            pairs.named.iter().map(|pair| pair.material).collect();
        used_materials.extend(pairs.every_other);
        used_materials.extend(fenders.iter().map(|fender| fender.material));
        for (index, (_, table)) in file.given("material").named().iter().enumerate() {
            if !used_materials.contains(&index) {
                self.note(table, "no pair or fender uses this material");
            }
        }
        if pairs.every_other.is_some() {
            return;
        }
        let paired: BTreeSet<usize> = pairs.named.iter().flat_map(|pair| pair.bodies).collect();
        for (index, (_, table)) in file.given("body").named().iter().enumerate() {
            if !paired.contains(&index) && bodies.len() > 1 {
                self.note(table, "no pair names this body: it touches nothing");
            }
        }
        for (fender, (_, table)) in fenders.iter().zip(file.given("fender").named()) {
            if !paired.contains(&fender.body) {
                self.note(
                    table,
                    "no pair names the body that carries this fender: nothing touches it",
                );
            }
        }
    }

    pub(super) fn note(&mut self, table: &Table, message: &str) {
        self.notices.push(Notice {
            place: self.sources.place(&table.span),
            key: table.path.clone(),
            message: message.to_owned(),
        });
    }
}

/// The first few names, in quotes.
pub(super) fn listed<'n>(names: impl Iterator<Item = &'n str> + Clone) -> String {
    const SHOWN: usize = 8;
    let left_out = names.clone().count().saturating_sub(SHOWN);
    let shown = names.take(SHOWN).map(quoted).collect::<Vec<_>>().join(", ");
    if left_out == 0 { shown } else { format!("{shown} and {left_out} more") }
}
