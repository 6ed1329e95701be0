//! Tugs, lines and orders.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Display;

use fenderline_contact::Vec2;
use fenderline_sim::environment::Tide;
use fenderline_sim::hydro::actuator::Telegraph;
use fenderline_sim::mooring::{
    InboardEnd, InitialLength, LineKind, LineSetup, Rope, RopeCurve, Tail, Winch, WinchOrder,
};
use fenderline_sim::tug::{TugEnvelope, TugOrder, VectorTug};
use fenderline_sim::{
    Action, BodySetup, LineEnd, MooringSetup, Order, Station, TugSetup, VesselSetup,
};

use super::azimuth::{Afloat, places};
use super::vessel::Decks;
use super::{Assembly, Checked, Names, listed};
use crate::checked::{Item, Table};
use crate::error::ScenarioError;
use crate::keys::{LINE_ORDERS, TUG_ORDERS, VESSEL_ORDERS};
use crate::sources::quoted;
use crate::suggest::nearest;

impl Assembly<'_, '_> {
    /// An error of a computation about a key.
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

    /// The place among the vessels of the body that an item names.
    fn vessel_named(
        &self,
        table: &Table,
        item: &Item,
        vessel_of_body: &BTreeMap<usize, usize>,
        names: &Names,
    ) -> Checked<usize> {
        let body = self.body_named(table, item, item.name(), names)?;
        vessel_of_body.get(&body).copied().ok_or_else(|| {
            let path = table.path_of(item.name);
            let message = format!("`{path}`: body {} is no vessel", quoted(item.name()));
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

    /// A line's end by its coordinates or by name, one of the two.
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

    pub(super) fn orders(
        &self,
        orders: &[Table],
        world: &WorldNames<'_>,
        names: &Names,
    ) -> Checked<Vec<Order>> {
        orders.iter().map(|table| self.order(table, world, names)).collect()
    }

    pub(super) fn order(
        &self,
        table: &Table,
        world: &WorldNames<'_>,
        names: &Names,
    ) -> Checked<Order> {
        let at_s = *table.given("at").number();
        let who = ["vessel", "tug", "line"].map(|name| table.item(name));
        let (item, asked) = match who {
            [Some(item), None, None] => (item, VESSEL_ORDERS),
            [None, Some(item), None] => (item, TUG_ORDERS),
            [None, None, Some(item)] => (item, LINE_ORDERS),
            _ => {
                let message =
                    format!("`{}` must be for one of `vessel`, `tug` and `line`", table.path);
                return Err(self.sources.error(&table.span, &table.path, message));
            }
        };
        let given: Vec<&Item> = table
            .items
            .iter()
            .filter(|i| ![item.name, "at", "direction"].contains(&i.name))
            .collect();
        let what = match given.as_slice() {
            [what] if asked.contains(&what.name) => *what,
            [what, ..] if !asked.contains(&what.name) => {
                let path = table.path_of(what.name);
                let message = format!("`{path}` is no order to a {}", item.name);
                let error = self.sources.error(&what.key_span, &path, message);
                return Err(error.with_help(format!("there are {}", asked.join(", "))));
            }
            [_, second, ..] => {
                let path = table.path_of(second.name);
                let message = format!("`{path}`: an order asks for one thing");
                let error = self.sources.error(&second.key_span, &path, message);
                return Err(error.with_help("write a second [[order]]"));
            }
            [] | [_] => {
                let message = format!("`{}` asks for nothing", table.path);
                let error = self.sources.error(&table.span, &table.path, message);
                return Err(error.with_help(format!("there are {}", asked.join(", "))));
            }
        };
        if ["hands", "stand_by", "hold", "let_go"].contains(&what.name) {
            self.only_true(table, what)?;
        }
        let direction = table.item("direction");
        if let Some(direction) = direction.filter(|_| item.name != "tug") {
            let path = table.path_of("direction");
            let message = format!("`{path}` is for tugs");
            return Err(self.sources.error(&direction.key_span, &path, message));
        }
        match item.name {
            "vessel" => {
                let vessel = self.vessel_named(table, item, &world.vessel_of_body, names)?;
                let action = self.to_vessel(table, what, &world.vessels[vessel], world, names)?;
                Ok(Order { at_s, vessel, action })
            }
            "tug" => {
                let known = || world.tugs.iter().map(|tug| tug.tug.name.as_str());
                let index = world.tug_places.get(item.text()).copied();
                let index =
                    index.ok_or_else(|| self.unknown("tug", table, item, item.text(), known()))?;
                let tug = &world.tugs[index];
                let order = to_tug(tug, what, direction.map(|item| *item.number()));
                Ok(Order { at_s, vessel: tug.vessel, action: Action::Tug(index, order) })
            }
            _ => {
                let known = || world.afloat.lines.iter().map(|line| line.line.name.as_str());
                let index = world.afloat.line_place(item.text());
                let index =
                    index.ok_or_else(|| self.unknown("line", table, item, item.text(), known()))?;
                Ok(Order { at_s, vessel: 0, action: to_line(index, what) })
            }
        }
    }

    fn to_vessel(
        &self,
        table: &Table,
        what: &Item,
        vessel: &VesselSetup,
        world: &WorldNames<'_>,
        names: &Names,
    ) -> Checked<Action> {
        self.refuse_without_gear(table, what, vessel)?;
        Ok(match what.name {
            "rudder" => Action::Rudder(*what.number()),
            "engine" => Action::Engine(*what.number()),
            "telegraph" => Action::Engine(what.choice::<Telegraph>().revolutions_ratio()),
            "thruster" => {
                let of = what.table();
                let name = of.given("name");
                let known = || vessel.thrusters.iter().map(|thruster| thruster.name.as_str());
                let index = known().position(|known| known == name.text());
                let index = index
                    .ok_or_else(|| self.unknown("thruster", of, name, name.text(), known()))?;
                Action::Thruster(index, *of.given("power").number())
            }
            "course" => Action::Course(*what.number()),
            "speed" => Action::Speed(*what.number()),
            "station" => {
                let of = what.table();
                Action::Station(Station {
                    position_m: *of.given("position").vector(),
                    heading_rad: *of.given("heading").number(),
                    fastest_mps: [*of.given("surge").number(), *of.given("sway").number()],
                })
            }
            "azimuth" => self.to_azimuth(what.table(), vessel)?,
            "push_ship" | "pull_ship" | "follow_ship" => {
                self.to_tug_vessel(what, vessel, &world.afloat, names)?
            }
            "hands" => Action::Hands,
            other => unreachable!("{other} is no order to a vessel"),
        })
    }

    /// What she has nothing to carry out with would ask for nothing.
    fn refuse_without_gear(&self, table: &Table, what: &Item, vessel: &VesselSetup) -> Checked<()> {
        let (has_it, needed) = match what.name {
            "rudder" | "engine" | "telegraph" => {
                (vessel.ship.propulsion.is_some(), "propeller and rudder")
            }
            "course" | "speed" => (
                vessel.ship.propulsion.is_some() || vessel.steers_with_azimuths(),
                "propeller and rudder, nor azimuth units",
            ),
            _ => return Ok(()),
        };
        if has_it {
            return Ok(());
        }
        let path = table.path_of(what.name);
        let message = format!("`{path}`: the vessel has no {needed}");
        Err(self.sources.error(&what.key_span, &path, message))
    }

    /// `let_go = false` would ask for nothing.
    fn only_true(&self, table: &Table, what: &Item) -> Checked<()> {
        if *what.flag() {
            return Ok(());
        }
        let path = table.path_of(what.name);
        Err(self.sources.error(&what.span, &path, format!("`{path}` can only be true")))
    }
}

/// Where a line ends.
enum LinePoint<'t> {
    /// From the body's origin, and above the water (m).
    At(Vec2, f64),
    /// A chock or bitts.
    Named(&'t Item),
}

/// What orders refer to.
pub(super) struct WorldNames<'w> {
    pub(super) vessels: &'w [VesselSetup],
    pub(super) tugs: &'w [TugSetup],
    pub(super) afloat: Afloat<'w>,
    vessel_of_body: BTreeMap<usize, usize>,
    tug_places: BTreeMap<&'w str, usize>,
}

impl<'w> WorldNames<'w> {
    pub(super) fn new(
        vessels: &'w [VesselSetup],
        tugs: &'w [TugSetup],
        afloat: Afloat<'w>,
    ) -> WorldNames<'w> {
        WorldNames {
            vessels,
            tugs,
            afloat,
            vessel_of_body: places(vessels.iter().map(|vessel| vessel.body)),
            tug_places: places(tugs.iter().map(|tug| tug.tug.name.as_str())),
        }
    }
}

fn to_tug(tug: &TugSetup, what: &Item, direction_rad: Option<f64>) -> TugOrder {
    // Away from her own side when she pushes, towards it when she pulls.
    let away_rad = -FRAC_PI_2.copysign(tug.tug.push_at_m.y);
    match what.name {
        "push" => TugOrder::Push {
            force_n: *what.number(),
            direction_rad: direction_rad.unwrap_or(away_rad),
        },
        "pull" => TugOrder::Pull {
            force_n: *what.number(),
            direction_rad: direction_rad.unwrap_or(-away_rad),
        },
        _ => TugOrder::StandBy,
    }
}

fn to_line(index: usize, what: &Item) -> Action {
    match what.name {
        "heave" => Action::Winch(index, WinchOrder::Heave(*what.number())),
        "pay_out" => Action::Winch(index, WinchOrder::PayOut(*what.number())),
        "hold" => Action::Winch(index, WinchOrder::Hold),
        _ => Action::LetGo(index),
    }
}

fn rope(table: &Table) -> Rope {
    let curve: fn() -> RopeCurve = table.given("rope").choice();
    Rope { break_load_n: *table.given("break_load").number(), curve: curve() }
}
