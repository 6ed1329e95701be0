//! Warnings about fenders whose numbers do not fit each other, such as newtons in place of kilonewtons, or a face
//! nearer to the quay than the fender is high.

use fenderline_sim::FenderSetup;

use super::assembly::Assembly;
use super::rows::rounded;
use crate::library::FenderLibrary;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::held::Text;
use fenderline_keys::keys::fender::FenderKey;
use fenderline_keys::rating::odd_reaction;

/// Height below which fenders usually are (m); the largest pneumatic fenders of ISO 17357 have 4.5 m.
const HIGH_M: f64 = 6.0;

impl Assembly<'_, '_> {
    /// Warns of fenders whose reaction, height and projection do not fit each other.
    pub(super) fn note_odd_fenders(
        &mut self,
        tables: Tables<'_, FenderKey>,
        fenders: &[FenderSetup],
        library: &FenderLibrary,
    ) {
        for ((_, table), fender) in tables.iter().zip(fenders) {
            match table.item(FenderKey::TYPE) {
                Some(family) => self.note_odd_size(table, family, library),
                None => self.note_weak_law(table, fender),
            }
        }
    }

    /// For a fender of the library: warns of a rated reaction or a projection that does not fit the fender's height.
    fn note_odd_size(
        &mut self,
        table: Of<'_, FenderKey>,
        family: Entry<'_, Text>,
        library: &FenderLibrary,
    ) {
        let Ok(fender) = self.catalogue(table, family, library) else { return };
        let height_m = fender.height_m;
        if fender.angle_reaction_factors.is_empty() && fender.angle_energy_factors.is_empty() {
            self.note_idle(
                table,
                FenderKey::ANGLE_FACTOR,
                "no factors by angle are known for this type",
            );
        }
        if fender.velocity_factors.is_empty() {
            let why = "no factors by speed are known for this type";
            self.note_idle(table, FenderKey::VELOCITY_FACTOR, why);
        }
        if let Some(item) = table.item(FenderKey::RATED_REACTION) {
            let message = odd_reaction(*item.number(), height_m, "a height");
            self.note_if(item, table, message);
        }
        if let Some(item) = table.item(FenderKey::HEIGHT).filter(|_| height_m > HIGH_M) {
            let message = format!(
                "a fender {} m high is higher than the fenders of catalogues; the height is \
                 measured in the direction of compression, in metres",
                rounded(height_m)
            );
            self.note_at(&item.span, table.path_to(item), message);
        }
        if let Some(item) =
            table.item(FenderKey::PROJECTION).filter(|item| *item.number() < height_m - 1e-9)
        {
            let message = format!(
                "the face is {} m from the mounting, but the fender itself is {} m high: the \
                 distance should be at least the fender's height plus the panel's thickness",
                rounded(*item.number()),
                rounded(height_m)
            );
            self.note_at(&item.span, table.path_to(item), message);
        }
    }

    /// For a fender with a `stiffness` or a `curve`: warns of an unusual reaction at the rated deflection, or an
    /// unusual end of the curve.
    fn note_weak_law(&mut self, table: Of<'_, FenderKey>, fender: &FenderSetup) {
        let curve = table.item(FenderKey::CURVE);
        let Some(item) = table.first_of(any_keys![FenderKey: CURVE, STIFFNESS]) else { return };
        if let Some(rated) = fender.rated {
            let message = odd_reaction(rated.reaction_n, fender.projection_m, "a projection");
            self.note_if(item, table, message);
        }
        let end = curve.and_then(|item| item.curve().last());
        let end_m = end.map_or(0.0, |row| row.0);
        if let Some(projection) =
            table.item(FenderKey::PROJECTION).filter(|_| end_m > fender.projection_m)
        {
            let message = format!(
                "the curve goes on to a deflection of {} m, but the face is only {} m from the \
                 mounting: the hull would strike the body behind the fender before the end of the \
                 curve",
                rounded(end_m),
                rounded(fender.projection_m)
            );
            self.note_at(&projection.span, table.path_of(FenderKey::PROJECTION), message);
        }
    }

    fn note_if<T, V>(&mut self, item: Entry<'_, V>, table: Of<'_, T>, message: Option<String>) {
        if let Some(message) = message {
            self.note_at(&item.span, table.path_to(item), message);
        }
    }
}
