//! Tugs and lines.

use std::collections::BTreeMap;
use std::fmt::Display;

use fenderline_contact::Vec2;
use fenderline_sim::environment::Tide;
use fenderline_sim::mooring::{
    InboardEnd, InitialLength, LineKind, LineSetup, Rope, RopeCurve, Tail, Winch,
};
use fenderline_sim::tug::{TugEnvelope, VectorTug};
use fenderline_sim::{BodySetup, LineEnd, MooringSetup, TugSetup, VesselSetup};

use super::orders::places;
use super::vessel::Decks;
use super::{Assembly, Checked, Names, listed};
use crate::checked::{Item, Table};
use crate::error::ScenarioError;
use crate::sources::quoted;
use crate::suggest::nearest;

impl Assembly<'_, '_> {
    /// An error at a key's value.
    pub(super) fn refused(&self, table: &Table, item: &Item, error: &dyn Display) -> ScenarioError {
        let path = table.path_of(item.name);
        self.sources.error(&item.span, &path, format!("`{path}`: {error}"))
    }

    pub(super) fn unknown<'n>(
        &self,
        what: &str,
        table: &Table,
        item: &Item,
        name: &str,
        known: impl Iterator<Item = &'n str> + Clone,
    ) -> ScenarioError {
        let path = table.path_of(item.name);
        let message = format!("`{path}`: there is no {what} {}", quoted(name));
        let error = self.sources.error(&item.span, &path, message);
        error.with_help(match nearest(name, known.clone()) {
            Some(near) => format!("did you mean \"{near}\"?"),
            None => match known.clone().next() {
                None => format!("the scenario has no {what}s"),
                Some(_) => format!("there are {}", listed(known)),
            },
        })
    }

    /// The index of the vessel that a key names by its body.
    pub(super) fn vessel_named(
        &self,
        table: &Table,
        item: &Item,
        vessel_of_body: &BTreeMap<usize, usize>,
        names: &Names,
    ) -> Checked<usize> {
        let body = self.body_named(table, item, item.name(), names)?;
        vessel_of_body.get(&body).copied().ok_or_else(|| {
            let path = table.path_of(item.name);
            let message = format!("`{path}`: body {} is not a vessel", quoted(item.name()));
            let error = self.sources.error(&item.span, &path, message);
            error.with_help("give it a `vessel` in its own table")
        })
    }

    pub(super) fn tugs(
        &self,
        tugs: &[(String, Table)],
        vessels: &[VesselSetup],
        names: &Names,
    ) -> Checked<Vec<TugSetup>> {
        let of_body = places(vessels.iter().map(|vessel| vessel.body));
        tugs.iter()
            .map(|(name, table)| {
                let vessel = self.vessel_named(table, table.given("vessel"), &of_body, names)?;
                let number = |name: &str| *table.given(name).number();
                let push_at_m = *table.given("push_at").vector();
                let tug = VectorTug {
                    name: name.clone(),
                    envelope: TugEnvelope {
                        bollard_pull_n: number("bollard_pull"),
                        length_m: number("length"),
                        beam_m: number("beam"),
                        draught_m: number("draught"),
                        drag_coefficient: 0.73,
                    },
                    push_at_m,
                    pull_at_m: table.item("pull_at").map_or(push_at_m, |item| *item.vector()),
                    delay_s: number("delay"),
                    force_lag_s: number("lag"),
                    direction_lag_s: number("lag"),
                };
                tug.check().map_err(|error| self.wrong(table, &error))?;
                Ok(TugSetup { vessel, tug })
            })
            .collect()
    }

    pub(super) fn lines(
        &self,
        lines: &[(String, Table)],
        start: (&[BodySetup], &Tide),
        decks: &Decks<'_>,
        names: &Names,
    ) -> Checked<Vec<MooringSetup>> {
        lines.iter().map(|(name, table)| self.line(name, table, start, decks, names)).collect()
    }

    fn line(
        &self,
        name: &str,
        table: &Table,
        (bodies, tide): (&[BodySetup], &Tide),
        decks: &Decks<'_>,
        names: &Names,
    ) -> Checked<MooringSetup> {
        let number = |name: &str| *table.given(name).number();
        let (from, to) = (table.given("from"), table.given("to"));
        let ship = self.body_named(table, from, from.name(), names)?;
        let body = self.body_named(table, to, to.name(), names)?;
        if ship == body {
            let path = table.path_of("to");
            let message = format!("`{path}`: both ends are on body {}", quoted(to.name()));
            return Err(self.sources.error(&to.span, &path, message));
        }
        let (fairlead_m, fairlead_above_water_m) =
            match self.one_of(table, "fairlead", "fairlead_height", "chock")? {
                LinePoint::At(at_m, above_water_m) => (at_m, above_water_m),
                LinePoint::Named(item) => self.chock(table, item, decks[ship])?,
            };
        let (bollard_m, bollard_above_water_m) =
            match self.one_of(table, "bollard", "bollard_height", "bitts")? {
                LinePoint::At(at_m, above_water_m) => (at_m, above_water_m),
                LinePoint::Named(item) => self.bitts(table, item, decks[body])?,
            };
        let initial_length = match (table.item("length"), table.item("pretension")) {
            (Some(length), None) => InitialLength::Outboard(*length.number()),
            (None, Some(tension)) => InitialLength::FromPretension(*tension.number()),
            (given, _) => {
                let path = table.path_of("pretension");
                let both = given.is_some();
                let message = if both {
                    format!("`{path}` does not go together with `length`")
                } else {
                    format!("`{path}` is missing")
                };
                let error = self.sources.error(&table.span, &path, message);
                return Err(error.with_help("give the line a `length` or a `pretension`"));
            }
        };
        let break_load_n = number("break_load");
        let tail = table
            .item("tail")
            .map(Item::table)
            .map(|tail| Tail { rope: rope(tail), length_m: *tail.given("length").number() });
        let winch = Winch::of_design(break_load_n, 100.0);
        let setup = MooringSetup {
            line: LineSetup {
                name: name.to_owned(),
                kind: LineKind::Light { main: rope(table), tail },
                inboard_end: match table.given("winch").flag() {
                    true => InboardEnd::Winch(winch),
                    false => InboardEnd::Bitts,
                },
                initial_length,
            },
            ship,
            fairlead_m,
            fairlead_above_water_m,
            end: LineEnd::OnBody { body, at_m: bollard_m, above_water_m: bollard_above_water_m },
            from_s: number("made_fast"),
        };
        if setup.from_s <= 0.0 {
            setup.check_at_start(bodies, tide).map_err(|error| self.wrong(table, &error))?;
        }
        Ok(setup)
    }

    /// A line's end, by coordinates or by the name of a point of the vessel.
    fn one_of<'t>(
        &self,
        table: &'t Table,
        place: &str,
        height: &str,
        name: &str,
    ) -> Checked<LinePoint<'t>> {
        let height = table.given(height);
        match (table.item(place), table.item(name)) {
            (Some(at), None) => Ok(LinePoint::At(*at.vector(), *height.number())),
            (None, Some(item)) if height.is_default => Ok(LinePoint::Named(item)),
            (None, Some(_)) => Err(self.beside(table, height, name)),
            (Some(_), Some(item)) => Err(self.beside(table, item, place)),
            (None, None) => {
                let path = table.path_of(place);
                let error = self.sources.error(&table.span, &path, format!("`{path}` is missing"));
                Err(error.with_help(format!("give it, or `{name}` by name")))
            }
        }
    }

    fn beside(&self, table: &Table, item: &Item, other: &str) -> ScenarioError {
        let path = table.path_of(item.name);
        let message = format!("`{path}` does not go together with `{other}`");
        let error = self.sources.error(&item.key_span, &path, message);
        error.with_help("keep one of the two")
    }
}

/// Where a line ends.
enum LinePoint<'t> {
    /// From the body's origin, and above the water (m).
    At(Vec2, f64),
    /// A chock or bitts.
    Named(&'t Item),
}

fn rope(table: &Table) -> Rope {
    let curve: fn() -> RopeCurve = table.given("rope").choice();
    Rope { break_load_n: *table.given("break_load").number(), curve: curve() }
}
