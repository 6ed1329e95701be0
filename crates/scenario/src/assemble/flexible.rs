//! Turns the tables of flexible dolphins into their set-up.

use fenderline_sim::{DolphinSetup, SteelPiles};

use super::assembly::{Assembly, Checked};
use super::plausible::figures;
use fenderline_keys::any_keys;
use fenderline_keys::checked::Of;
use fenderline_keys::held::Number;
use fenderline_keys::keys::body::BodyKey;
use fenderline_keys::keys::dolphin::DolphinKey;
use fenderline_keys::typed_key::{AnyKey, Key};

/// Keys of steel piles, and keys of a dolphin whose values follow from the piles.
const OF_PILES: &[AnyKey<DolphinKey>] = any_keys![
    DolphinKey: DIAMETER, WALL, LENGTH, PILES, MODULUS, YIELD_STRESS, HEAD_MASS
];
const GIVEN_BY_PILES: &[AnyKey<DolphinKey>] = any_keys![DolphinKey: MASS, YIELD_LOAD];

/// Plausible natural periods of a dolphin (s). A slender monopile with a heavy head has a natural period of about 2 s.
const PERIODS_S: [f64; 2] = [0.05, 20.0];
/// Least plausible stiffness of a dolphin (N/m); a softer dolphin would bend by metres under a ship.
const SOFTEST_NPM: f64 = 1e5;

impl Assembly<'_, '_> {
    /// Reads the piles of a body that is a flexible dolphin; `None` for any other body.
    pub(super) fn dolphin(&mut self, body: Of<'_, BodyKey>) -> Checked<Option<DolphinSetup>> {
        let Some(item) = body.item(BodyKey::DOLPHIN) else { return Ok(None) };
        let fixed = body.given(BodyKey::FIXED);
        if *fixed.flag() && !fixed.is_default {
            let path = body.path_of(BodyKey::FIXED);
            let message =
                format!("`{path}` does not go together with `dolphin`, because a dolphin bends");
            let error = self.sources.error(&fixed.key_span, &path, message);
            return Err(error.with_help("remove one of the two keys"));
        }
        let table = item.table();
        let damping_ratio = *table.given(DolphinKey::DAMPING).number();
        let given = |name: Key<_, Number>| table.item(name).map(|item| *item.number());
        let dolphin = if let Some(stiffness_npm) = given(DolphinKey::STIFFNESS) {
            self.refuse(table, OF_PILES, |path| {
                format!(
                    "`{path}` does not go together with `stiffness`, which follows from the piles"
                )
            })?;
            let mass_kg = given(DolphinKey::MASS)
                .ok_or_else(|| self.missing(table, DolphinKey::MASS, "write mass = \"60 t\""))?;
            let yield_load_n = given(DolphinKey::YIELD_LOAD);
            DolphinSetup { mass_kg, stiffness_npm, damping_ratio, yield_load_n }
        } else {
            let piles = self.steel_piles(table)?;
            self.refuse(table, GIVEN_BY_PILES, |path| {
                format!("`{path}` does not go together with `diameter`: the piles give this value")
            })?;
            DolphinSetup {
                mass_kg: given(DolphinKey::HEAD_MASS).unwrap_or(0.0) + piles.moving_mass_kg(),
                stiffness_npm: piles.stiffness_npm(),
                damping_ratio,
                yield_load_n: piles.yield_load_n(),
            }
        };
        self.note_dolphin(table, &dolphin);
        Ok(Some(dolphin))
    }

    fn steel_piles(&self, table: Of<'_, DolphinKey>) -> Checked<SteelPiles> {
        let given = |name: Key<_, Number>| table.item(name).map(|item| *item.number());
        let need = |name: Key<DolphinKey, Number>| {
            let help =
                "give `stiffness` and `mass`, or `diameter`, `wall` and `length` of the piles";
            given(name).ok_or_else(|| self.missing(table, name, help))
        };
        let any_of_piles = OF_PILES.iter().any(|key| table.item(*key).is_some());
        if !any_of_piles {
            need(DolphinKey::STIFFNESS)?;
        }
        let piles = SteelPiles {
            diameter_m: need(DolphinKey::DIAMETER)?,
            wall_m: need(DolphinKey::WALL)?,
            length_m: need(DolphinKey::LENGTH)?,
            number: self.whole(table, DolphinKey::PILES)?,
            modulus_npm2: given(DolphinKey::MODULUS).unwrap_or(210e9),
            yield_stress_npm2: given(DolphinKey::YIELD_STRESS),
        };
        if 2.0 * piles.wall_m > piles.diameter_m {
            let path = table.path_of(DolphinKey::WALL);
            let message = format!(
                "`{path}` of {} m is more than half of the `diameter` of {} m",
                piles.wall_m, piles.diameter_m
            );
            let error = self.sources.error(&table.given(DolphinKey::WALL).span, &path, message);
            return Err(error.with_help("give the thickness of the tube's wall, as \"40 mm\""));
        }
        Ok(piles)
    }

    /// Reads a whole number; 1 if the file does not give the key.
    fn whole(&self, table: Of<'_, DolphinKey>, name: Key<DolphinKey, Number>) -> Checked<u32> {
        let Some(item) = table.item(name) else { return Ok(1) };
        let number = *item.number();
        if libm::rint(number) != number {
            let path = table.path_of(name);
            let message = format!("`{path}` must be a whole number, but is {number}");
            return Err(self.sources.error(&item.span, &path, message));
        }
        Ok(number as u32)
    }

    fn refuse(
        &self,
        table: Of<'_, DolphinKey>,
        keys: &[AnyKey<DolphinKey>],
        message: fn(&str) -> String,
    ) -> Checked<()> {
        let Some(item) = keys.iter().find_map(|key| table.item(*key)) else { return Ok(()) };
        let path = table.path_to(item);
        let error = self.sources.error(&item.key_span, &path, message(&path));
        Err(error.with_help(
            "give the dolphin `stiffness` and `mass`, or `diameter`, `wall` and \
                             `length` of its piles",
        ))
    }

    /// Warns of a stiffness or mass that does not fit a dolphin.
    fn note_dolphin(&mut self, table: Of<'_, DolphinKey>, dolphin: &DolphinSetup) {
        let is_by_stiffness = table.item(DolphinKey::STIFFNESS).is_some();
        let key = if is_by_stiffness { DolphinKey::STIFFNESS } else { DolphinKey::DIAMETER };
        let span = table.given(key).span.clone();
        let period_s = dolphin.period_s();
        if dolphin.stiffness_npm < SOFTEST_NPM {
            let message = format!(
                "a dolphin of {} kN/m bends by 1 m under {} kN: kN/m in place of N/m?",
                figures(dolphin.stiffness_npm / 1e3),
                figures(dolphin.stiffness_npm / 1e3)
            );
            self.note_at(&span, table.path_of(key), message);
        } else if !(PERIODS_S[0]..=PERIODS_S[1]).contains(&period_s) {
            let message = format!(
                "a mass of {} t on {} MN/m has a period of {} s; from {} to {} s was expected",
                figures(dolphin.mass_kg / 1e3),
                figures(dolphin.stiffness_npm / 1e6),
                figures(period_s),
                PERIODS_S[0],
                PERIODS_S[1]
            );
            self.note_at(&span, table.path_of(key), message);
        }
    }
}
