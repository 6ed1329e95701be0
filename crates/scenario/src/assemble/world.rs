//! Vessels, tugs, lines and orders.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt::Display;

use fenderline_sim::attitude::{FloatParticulars, Hydrostatics};
use fenderline_sim::environment::waves::DriftHull;
use fenderline_sim::hydro::actuator::{RateLimited, Telegraph};
use fenderline_sim::hydro::{Mmg, Particulars, SternGear, TunnelThruster, estimated, vessels};
use fenderline_sim::mooring::{
    Fitting, Holding, LineKind, LineSetup, Rope, RopeCurve, Tail, Winch, WinchOrder,
};
use fenderline_sim::tug::{TugEnvelope, TugOrder, VectorTug};
use fenderline_sim::{
    Action, BodySetup, Environment, Float, LineEnd, MassProperties, MooringSetup, Order, Station,
    ThrusterSetup, TugSetup, VesselSetup,
};

use super::azimuth::{Afloat, azimuths};
use super::{Assembly, Checked, Names};
use crate::checked::{Item, Table};
use crate::error::ScenarioError;
use crate::keys::{LINE_ORDERS, TUG_ORDERS, VESSEL_ORDERS};
use crate::sources::quoted;
use crate::suggest::nearest;

/// A kind of vessel, without a body.
pub(super) struct Kind {
    pub(super) setup: VesselSetup,
    pub(super) mass: MassProperties,
}

impl Assembly<'_, '_> {
    /// An error of a computation about a key.
    pub(super) fn refused(&self, table: &Table, item: &Item, error: &dyn Display) -> ScenarioError {
        let path = table.path_of(item.name);
        self.sources.error(&item.span, &path, format!("`{path}`: {error}"))
    }

    /// Every kind of vessel, in the order of the file.
    pub(super) fn kinds(
        &mut self,
        tables: &[(String, Table)],
        environment: &Environment,
    ) -> Checked<Vec<(String, Kind)>> {
        let read =
            |(name, table): &(String, Table)| Ok((name.clone(), self.kind(table, environment)?));
        tables.iter().map(read).collect()
    }

    fn kind(&mut self, table: &Table, environment: &Environment) -> Checked<Kind> {
        self.refuse_a_model_with_particulars(table)?;
        let (deep, mut rudder) = self.ship(table)?;
        let water = environment.water_density_kgpm3;
        let ship = match environment.depth_m {
            Some(depth_m) if depth_m > deep.particulars.draught_m => {
                deep.at_depth(depth_m).map_err(|error| self.wrong(table, &error))?
            }
            // Aground her hull coefficients are her least concern.
            _ => deep,
        };
        let mut shaft = RateLimited { value: 0.0, rate_per_s: 0.1, stop: 1.0 };
        if let Some(propeller) = table.item("propeller").map(Item::table) {
            let full_rps = propeller.given("full").number() / TAU;
            shaft = RateLimited {
                value: full_rps * propeller.given("running").number(),
                rate_per_s: 2.0 * full_rps / propeller.given("reversal").number(),
                stop: full_rps,
            };
        }
        if let Some(gear) = table.item("rudder").map(Item::table) {
            rudder = RateLimited {
                value: 0.0,
                rate_per_s: *gear.given("rate").number(),
                stop: *gear.given("stop").number(),
            };
        }
        let thrusters = table.given("thruster").named();
        let particulars = ship.particulars;
        let float = self.float(table, &particulars, water)?;
        let drift = DriftHull {
            length_m: particulars.length_m,
            beam_m: particulars.beam_m,
            bow_length_m: 0.2 * particulars.length_m,
        };
        let setup = VesselSetup {
            body: 0,
            ship,
            rudder,
            shaft,
            thrusters: thrusters
                .iter()
                .map(|(name, thruster)| ThrusterSetup {
                    name: name.clone(),
                    tunnel: TunnelThruster {
                        bollard_n: *thruster.given("force").number(),
                        along_m: *thruster.given("along").number(),
                    },
                    lag_s: *thruster.given("lag").number(),
                })
                .collect(),
            azimuths: azimuths(table.given("azimuth").named()),
            windage: self.windage(table, &particulars)?,
            response: self.response(table, &particulars, float.as_ref())?,
            float,
            drift: Some(drift),
        };
        let mass_kg = water * particulars.volume_m3;
        let mass = MassProperties {
            mass_kg,
            yaw_inertia_kgm2: water * particulars.yaw_inertia_m5(),
            added_surge_kg: water * ship.added_mass.surge_m3,
            added_sway_kg: water * ship.added_mass.sway_m3,
            added_yaw_kgm2: water * ship.added_mass.yaw_m5,
        };
        Ok(Kind { setup, mass })
    }

    fn refuse_a_model_with_particulars(&self, table: &Table) -> Checked<()> {
        if table.item("model").is_none() {
            for name in ["length_bp", "beam", "draught", "block_coefficient"] {
                if table.item(name).is_none() {
                    let path = table.path_of(name);
                    let message = format!("`{path}` is missing");
                    let error = self.sources.error(&table.span, &path, message);
                    return Err(error.with_help("give it, or a published `model`"));
                }
            }
            let gear = ["propeller", "rudder"].map(|name| table.item(name));
            if let [Some(alone), None] | [None, Some(alone)] = gear {
                let other = if alone.name == "rudder" { "propeller" } else { "rudder" };
                let path = table.path_of(alone.name);
                let message = format!("`{path}` needs `{other}` beside it");
                return Err(self.sources.error(&alone.key_span, &path, message));
            }
            return Ok(());
        }
        let own =
            ["length_bp", "beam", "draught", "block_coefficient", "centre_of_gravity", "gyradius"];
        for name in own {
            if let Some(item) = table.item(name) {
                let path = table.path_of(name);
                let message = format!("`{path}` does not go together with `model`");
                let error = self.sources.error(&item.key_span, &path, message);
                return Err(error.with_help("the model brings its own particulars"));
            }
        }
        let parts = [("propeller", "diameter"), ("rudder", "area"), ("rudder", "span")];
        for (part, name) in parts {
            let Some(of) = table.item(part).map(Item::table) else { continue };
            if let Some(item) = of.item(name) {
                let path = of.path_of(name);
                let message = format!("`{path}` does not go together with `model`");
                let error = self.sources.error(&item.key_span, &path, message);
                return Err(error.with_help("the model brings its own propeller and rudder"));
            }
        }
        Ok(())
    }

    /// The manoeuvring model in deep water, and her rudder.
    fn ship(&self, table: &Table) -> Checked<(Mmg, RateLimited)> {
        if let Some(model) = table.item("model") {
            let vessel = match model.choice() {
                0 => vessels::kvlcc2(),
                1 => vessels::kcs(),
                other => unreachable!("the key table has no model {other}"),
            };
            return Ok((vessel.ship, vessel.steering));
        }
        let number = |name: &str| *table.given(name).number();
        let particulars = Particulars::from_block(
            number("length_bp"),
            number("beam"),
            number("draught"),
            number("block_coefficient"),
        )
        .and_then(|ship| {
            let gyradius = table.item("gyradius").map(|item| item.number() / ship.length_m);
            Particulars {
                centre_of_gravity_m: table.item("centre_of_gravity").map_or(0.0, |i| *i.number()),
                yaw_gyradius_ratio: gyradius.unwrap_or(ship.yaw_gyradius_ratio),
                ..ship
            }
            .check()
        })
        .map_err(|error| self.wrong(table, &error))?;
        let gear = self.stern_gear(table)?;
        let ship =
            estimated(particulars, gear.as_ref()).map_err(|error| self.wrong(table, &error))?;
        Ok((ship, RateLimited { value: 0.0, rate_per_s: 0.04, stop: 0.6 }))
    }

    fn stern_gear(&self, table: &Table) -> Checked<Option<SternGear>> {
        let (Some(propeller), Some(rudder)) = (table.item("propeller"), table.item("rudder"))
        else {
            return Ok(None);
        };
        let of = |item: &Item, name: &str| {
            item.table().item(name).map(|item| *item.number()).ok_or_else(|| {
                let path = item.table().path_of(name);
                let message = format!("`{path}` is missing");
                let error = self.sources.error(&item.span, &path, message);
                error.with_help("a vessel without a published `model` needs it")
            })
        };
        Ok(Some(SternGear {
            propeller_m: of(propeller, "diameter")?,
            rudder_m2: of(rudder, "area")?,
            rudder_span_m: of(rudder, "span")?,
        }))
    }

    fn wrong(&self, table: &Table, error: &dyn Display) -> ScenarioError {
        self.sources.error(&table.span, &table.path, format!("`{}`: {error}", table.path))
    }

    fn float(&self, table: &Table, ship: &Particulars, water: f64) -> Checked<Option<Float>> {
        let Some(item) = table.item("stability") else { return Ok(None) };
        let of = item.table();
        let number = |name: &str| *of.given(name).number();
        let hydrostatics = Hydrostatics::of(&FloatParticulars {
            mass_kg: water * ship.volume_m3,
            length_m: ship.length_m,
            beam_m: ship.beam_m,
            draught_m: ship.draught_m,
            waterplane_m2: number("waterplane_area"),
            gm_m: number("gm"),
            water_kgpm3: water,
        });
        Ok(Some(Float {
            hydrostatics: hydrostatics.map_err(|error| self.refused(table, item, &error))?,
            gravity_above_water_m: number("gravity_above_keel") - ship.draught_m,
            draught_m: ship.draught_m,
        }))
    }

    /// The vessels that bodies name, in the order of the bodies.
    pub(super) fn vessels(
        &self,
        bodies: &[(String, Table)],
        kinds: &[(String, Kind)],
    ) -> Checked<Vec<VesselSetup>> {
        let mut vessels = Vec::new();
        for (index, (_, body)) in bodies.iter().enumerate() {
            let Some(item) = body.item("vessel") else { continue };
            let place = self.kind_named(body, item, kinds)?;
            let mut setup = kinds[place].1.setup.clone();
            setup.body = index;
            vessels.push(setup);
        }
        Ok(vessels)
    }

    /// The place among the kinds of the one that a body names.
    pub(super) fn kind_named(
        &self,
        body: &Table,
        item: &Item,
        kinds: &[(String, Kind)],
    ) -> Checked<usize> {
        let name = item.text();
        kinds.iter().position(|(kind, _)| kind == name).ok_or_else(|| {
            let known = kinds.iter().map(|(kind, _)| kind.as_str());
            self.unknown("vessel", body, item, name, known)
        })
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
            None => {
                let known: Vec<_> = known.map(quoted).collect();
                match known.is_empty() {
                    true => format!("the scenario has no {what}s"),
                    false => format!("there are {}", known.join(", ")),
                }
            }
        })
    }

    /// The place among the vessels of the body that an item names.
    fn vessel_named(
        &self,
        table: &Table,
        item: &Item,
        vessels: &[VesselSetup],
        names: &Names,
    ) -> Checked<usize> {
        let body = self.body_named(table, item, item.name(), names)?;
        vessels.iter().position(|vessel| vessel.body == body).ok_or_else(|| {
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
        tugs.iter()
            .map(|(name, table)| {
                let vessel = self.vessel_named(table, table.given("vessel"), vessels, names)?;
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
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<Vec<MooringSetup>> {
        lines.iter().map(|(name, table)| self.line(name, table, bodies, names)).collect()
    }

    fn line(
        &self,
        name: &str,
        table: &Table,
        bodies: &[BodySetup],
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
        let fitting = match (table.item("length"), table.item("pretension")) {
            (Some(length), None) => Fitting::Length(*length.number()),
            (None, Some(tension)) => Fitting::Pretension(*tension.number()),
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
                holding: match table.given("winch").flag() {
                    true => Holding::Winch(winch),
                    false => Holding::Bitts,
                },
                fitting,
            },
            ship,
            fairlead_m: *table.given("fairlead").vector(),
            fairlead_above_water_m: number("fairlead_height"),
            end: LineEnd::OnBody {
                body,
                at_m: *table.given("bollard").vector(),
                above_water_m: number("bollard_height"),
            },
            from_s: number("made_fast"),
        };
        if setup.from_s <= 0.0 {
            setup.check_at_start(bodies).map_err(|error| self.wrong(table, &error))?;
        }
        Ok(setup)
    }

    pub(super) fn orders(
        &self,
        orders: &[Table],
        world: &WorldNames<'_>,
        names: &Names,
    ) -> Checked<Vec<Order>> {
        orders.iter().map(|table| self.order(table, world, names)).collect()
    }

    fn order(&self, table: &Table, world: &WorldNames<'_>, names: &Names) -> Checked<Order> {
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
                let vessel = self.vessel_named(table, item, world.vessels, names)?;
                let action = self.to_vessel(table, what, &world.vessels[vessel], world, names)?;
                Ok(Order { at_s, vessel, action })
            }
            "tug" => {
                let known = || world.tugs.iter().map(|tug| tug.tug.name.as_str());
                let index = known().position(|name| name == item.text());
                let index =
                    index.ok_or_else(|| self.unknown("tug", table, item, item.text(), known()))?;
                let tug = &world.tugs[index];
                let order = to_tug(tug, what, direction.map(|item| *item.number()));
                Ok(Order { at_s, vessel: tug.vessel, action: Action::Tug(index, order) })
            }
            _ => {
                let known = || world.afloat.lines.iter().map(|line| line.line.name.as_str());
                let index = known().position(|name| name == item.text());
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
            "telegraph" => Action::Engine(Telegraph::ALL[*what.choice()].revolutions_ratio()),
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

/// What orders refer to.
pub(super) struct WorldNames<'w> {
    pub(super) vessels: &'w [VesselSetup],
    pub(super) tugs: &'w [TugSetup],
    pub(super) afloat: Afloat<'w>,
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
    let curve = match table.given("rope").choice() {
        0 => RopeCurve::wire(),
        1 => RopeCurve::hmpe(),
        2 => RopeCurve::polyester(),
        _ => RopeCurve::nylon(),
    };
    Rope { break_load_n: *table.given("break_load").number(), curve }
}
