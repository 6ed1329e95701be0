//! Flexible dolphins: from their tables to a set-up.

use fenderline_sim::{DolphinSetup, SteelPiles};

use super::assembly::{Assembly, Checked};
use super::plausible::figures;
use fenderline_keys::checked::Table;

/// Keys of steel piles, and keys whose values follow from them.
const OF_PILES: [&str; 7] =
    ["diameter", "wall", "length", "piles", "modulus", "yield_stress", "head_mass"];
const GIVEN_BY_PILES: [&str; 2] = ["mass", "yield_load"];

/// Plausible periods (s). A slender monopile with a heavy head has some 2 s.
const PERIODS_S: [f64; 2] = [0.05, 20.0];
/// A softer dolphin would bend by metres under a ship (N/m).
const SOFTEST_NPM: f64 = 1e5;

impl Assembly<'_, '_> {
    /// The pile of a body that is a flexible dolphin.
    pub(super) fn dolphin(&mut self, body: &Table) -> Checked<Option<DolphinSetup>> {
        let Some(item) = body.item("dolphin") else { return Ok(None) };
        let fixed = body.given("fixed");
        if *fixed.flag() && !fixed.is_default {
            let path = body.path_of("fixed");
            let message = format!("`{path}` does not go together with `dolphin`, which bends");
            let error = self.sources.error(&fixed.key_span, &path, message);
            return Err(error.with_help("remove one of the two"));
        }
        let table = item.table();
        let damping_ratio = *table.given("damping").number();
        let given = |name: &str| table.item(name).map(|item| *item.number());
        let dolphin = if let Some(stiffness_npm) = given("stiffness") {
            self.refuse(table, &OF_PILES, "`stiffness`, which they would give")?;
            let mass_kg = given("mass")
                .ok_or_else(|| self.missing(table, "mass", "write mass = \"60 t\""))?;
            let yield_load_n = given("yield_load");
            DolphinSetup { mass_kg, stiffness_npm, damping_ratio, yield_load_n }
        } else {
            let piles = self.steel_piles(table)?;
            self.refuse(table, &GIVEN_BY_PILES, "`diameter`: it follows from the piles")?;
            DolphinSetup {
                mass_kg: given("head_mass").unwrap_or(0.0) + piles.moving_mass_kg(),
                stiffness_npm: piles.stiffness_npm(),
                damping_ratio,
                yield_load_n: piles.yield_load_n(),
            }
        };
        self.note_dolphin(table, &dolphin);
        Ok(Some(dolphin))
    }

    fn steel_piles(&self, table: &Table) -> Checked<SteelPiles> {
        let given = |name: &str| table.item(name).map(|item| *item.number());
        let need = |name: &str| {
            let help =
                "give `stiffness` and `mass`, or `diameter`, `wall` and `length` of the piles";
            given(name).ok_or_else(|| self.missing(table, name, help))
        };
        let any_of_piles = OF_PILES.iter().any(|name| table.item(name).is_some());
        if !any_of_piles {
            need("stiffness")?;
        }
        let piles = SteelPiles {
            diameter_m: need("diameter")?,
            wall_m: need("wall")?,
            length_m: need("length")?,
            number: self.whole(table, "piles")?,
            modulus_npm2: given("modulus").unwrap_or(210e9),
            yield_stress_npm2: given("yield_stress"),
        };
        if 2.0 * piles.wall_m > piles.diameter_m {
            let path = table.path_of("wall");
            let message = format!(
                "`{path}` of {} m is more than half of the `diameter` of {} m",
                piles.wall_m, piles.diameter_m
            );
            let error = self.sources.error(&table.given("wall").span, &path, message);
            return Err(error.with_help("the wall of a tube, as \"40 mm\""));
        }
        Ok(piles)
    }

    /// A whole number; 1 unless given.
    fn whole(&self, table: &Table, name: &str) -> Checked<u32> {
        let Some(item) = table.item(name) else { return Ok(1) };
        let number = *item.number();
        if libm::rint(number) != number {
            let path = table.path_of(name);
            let message = format!("`{path}` must be a whole number, but is {number}");
            return Err(self.sources.error(&item.span, &path, message));
        }
        Ok(number as u32)
    }

    fn refuse(&self, table: &Table, names: &[&str], with: &str) -> Checked<()> {
        let Some(item) = names.iter().find_map(|name| table.item(name)) else { return Ok(()) };
        let path = table.path_of(item.name);
        let message = format!("`{path}` does not go together with {with}");
        let error = self.sources.error(&item.key_span, &path, message);
        Err(error.with_help("give `stiffness` and `mass`, or `diameter`, `wall` and `length`"))
    }

    /// Notes a stiffness or mass that does not fit a dolphin.
    fn note_dolphin(&mut self, table: &Table, dolphin: &DolphinSetup) {
        let key = if table.item("stiffness").is_some() { "stiffness" } else { "diameter" };
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
