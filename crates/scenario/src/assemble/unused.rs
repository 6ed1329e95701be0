//! Warnings about parts of a scenario that have no effect.

use std::collections::BTreeSet;

use fenderline_sim::{BodySetup, FenderSetup, Method};

use super::assembly::Assembly;
use super::pairs::Pairs;
use fenderline_keys::checked::{Of, Tables};
use fenderline_keys::error::{NO_EFFECT, Notice};
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::fender::FenderKey;
use fenderline_keys::keys::material::MaterialKey;
use fenderline_keys::keys::run::ContactKey;

impl Assembly<'_, '_> {
    /// Warns of bodies that touch nothing, and of materials that nothing uses. If the scenario has no pair, there is a
    /// single warning.
    pub(super) fn note_unused(
        &mut self,
        file: Of<'_, ScenarioKey>,
        bodies: &[BodySetup],
        pairs: &Pairs,
        (fenders, fender_tables): (&[FenderSetup], Tables<'_, FenderKey>),
    ) {
        if pairs.named.is_empty() && pairs.every_other.is_none() && bodies.len() > 1 {
            self.notices.push(Notice {
                place: self.sources.place(&file.given(ScenarioKey::BODY).span),
                key: ScenarioKey::PAIR.name().to_owned(),
                message: "there are no pairs, so no bodies can touch".to_owned(),
            });
            return;
        }
        let mut used_materials: BTreeSet<usize> =
            pairs.named.iter().map(|pair| pair.material).collect();
        used_materials.extend(pairs.every_other);
        self.note_idle_materials(file, &used_materials, (fenders, fender_tables));
        self.note_restitution(file, pairs, fenders);
        if pairs.every_other.is_some() {
            return;
        }
        let paired: BTreeSet<usize> = pairs.named.iter().flat_map(|pair| pair.bodies).collect();
        for (index, (_, table)) in file.given(ScenarioKey::BODY).named().iter().enumerate() {
            if !paired.contains(&index) && bodies.len() > 1 {
                self.note(table, "no pair names this body, so the body touches nothing");
            }
        }
        for (fender, (_, table)) in fenders.iter().zip(fender_tables) {
            if !paired.contains(&fender.body) {
                self.note(
                    table,
                    "no pair names the body that carries this fender, so nothing touches the \
                     fender",
                );
            }
        }
    }

    /// Warns of materials whose restitution has no effect, because only fenders with an unloading law use the material.
    fn note_restitution(
        &mut self,
        file: Of<'_, ScenarioKey>,
        pairs: &Pairs,
        fenders: &[FenderSetup],
    ) {
        let method: Method =
            file.given(ScenarioKey::CONTACT).table().given(ContactKey::METHOD).choice();
        if method == Method::Paper {
            return;
        }
        let mut asked: BTreeSet<usize> = pairs.named.iter().map(|pair| pair.material).collect();
        asked.extend(pairs.every_other);
        let by_restitution = fenders.iter().filter(|fender| fender.unloading.is_none());
        asked.extend(by_restitution.map(|fender| fender.material));
        for (index, (_, table)) in file.given(ScenarioKey::MATERIAL).named().iter().enumerate() {
            let item = table.given(MaterialKey::RESTITUTION);
            let is_of_fenders = fenders.iter().any(|fender| fender.material == index);
            if !item.is_default && is_of_fenders && !asked.contains(&index) {
                self.notices.push(Notice {
                    place: self.sources.place(&item.span),
                    key: table.path_of(MaterialKey::RESTITUTION),
                    message: format!(
                        "{NO_EFFECT}the fenders of this material return energy by their unloading \
                         law; set `returned_energy` of the fenders instead, or remove this key"
                    ),
                });
            }
        }
    }

    pub(super) fn note<T>(&mut self, table: Of<'_, T>, message: &str) {
        self.notices.push(Notice {
            place: self.sources.place(&table.span),
            key: table.path.clone(),
            message: message.to_owned(),
        });
    }
}
