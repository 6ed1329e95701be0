//! Notices of fenders whose numbers do not fit each other: newtons for kilonewtons, a face nearer to the quay than the
//! fender is high.

use fenderline_sim::FenderSetup;

use super::assembly::Assembly;
use super::rows::rounded;
use crate::library::FenderLibrary;
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::rating::odd_reaction;

/// Fenders are usually less high than this (m): the largest pneumatic fenders of ISO 17357 have 4.5 m.
const HIGH_M: f64 = 6.0;

impl Assembly<'_, '_> {
    /// Notes fenders whose reaction, height and projection do not fit each other.
    pub(super) fn note_odd_fenders(
        &mut self,
        tables: &[(String, Table)],
        fenders: &[FenderSetup],
        library: &FenderLibrary,
    ) {
        for ((_, table), fender) in tables.iter().zip(fenders) {
            match table.item("type") {
                Some(family) => self.note_odd_size(table, family, library),
                None => self.note_weak_law(table, fender),
            }
        }
    }

    /// Notes a rated reaction that does not fit the height of a fender of the library, and a projection that does not
    /// fit.
    fn note_odd_size(&mut self, table: &Table, family: &Item, library: &FenderLibrary) {
        let Ok(fender) = self.catalogue(table, family, library) else { return };
        let height_m = fender.height_m;
        if fender.angle_reaction_factors.is_empty() && fender.angle_energy_factors.is_empty() {
            self.note_idle(table, "angle_factor", "no factors by angle are known for this type");
        }
        if fender.velocity_factors.is_empty() {
            let why = "no factors by speed are known for this type";
            self.note_idle(table, "velocity_factor", why);
        }
        if let Some(item) = table.item("rated_reaction") {
            let message = odd_reaction(*item.number(), height_m, "a height");
            self.note_if(item, table, message);
        }
        if let Some(item) = table.item("height").filter(|_| height_m > HIGH_M) {
            let message = format!(
                "a fender {} m high is higher than those of catalogues; the height is measured in the direction of \
                 compression, in metres",
                rounded(height_m)
            );
            self.note_at(&item.span, table.path_of(item.name), message);
        }
        if let Some(item) = table.item("projection").filter(|item| *item.number() < height_m - 1e-9)
        {
            let message = format!(
                "the face is {} m from the mounting, but the fender itself is {} m high: at least \
                 the fender's height plus the panel's thickness was expected",
                rounded(*item.number()),
                rounded(height_m)
            );
            self.note_at(&item.span, table.path_of(item.name), message);
        }
    }

    /// Notes a fender with a `stiffness` or a `curve` whose reaction at the rated deflection, or whose end of the
    /// curve, is unusual.
    fn note_weak_law(&mut self, table: &Table, fender: &FenderSetup) {
        let Some(item) = table.item("curve").or_else(|| table.item("stiffness")) else { return };
        if let Some(rated) = fender.rated {
            let message = odd_reaction(rated.reaction_n, fender.projection_m, "a projection");
            self.note_if(item, table, message);
        }
        let end_m = match item.name {
            "curve" => item.curve().last().map_or(0.0, |row| row.0),
            _ => 0.0,
        };
        if let Some(projection) = table.item("projection").filter(|_| end_m > fender.projection_m) {
            let message = format!(
                "the curve goes on to a deflection of {} m, but the face is only {} m from the \
                 mounting: the hull would strike the body itself before that",
                rounded(end_m),
                rounded(fender.projection_m)
            );
            self.note_at(&projection.span, table.path_of("projection"), message);
        }
    }

    fn note_if(&mut self, item: &Item, table: &Table, message: Option<String>) {
        if let Some(message) = message {
            self.note_at(&item.span, table.path_of(item.name), message);
        }
    }
}
