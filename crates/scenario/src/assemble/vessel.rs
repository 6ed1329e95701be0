//! Kinds of vessels, and the vessels that bodies are.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fmt::Display;

use fenderline_sim::attitude::{FloatParticulars, Hydrostatics};
use fenderline_sim::environment::waves::{BoxShip, DriftHull, MotionResponse};
use fenderline_sim::hydro::actuator::RateLimited;
use fenderline_sim::hydro::{Mmg, Particulars, SternGear, TunnelThruster, estimated, vessels};
use fenderline_sim::{Environment, Float, MassProperties, VesselSetup};

use super::{Assembly, Checked};
use crate::checked::{Item, Table};
use crate::error::ScenarioError;

/// A kind of vessel, without a body.
pub(super) struct Kind {
    setup: VesselSetup,
    pub(super) mass: MassProperties,
}

/// Names of thrusters, in their order.
pub(super) type Thrusters = BTreeMap<String, Vec<String>>;

impl Assembly<'_, '_> {
    /// Every kind of vessel, in the order of the file.
    pub(super) fn kinds(
        &self,
        tables: &[(String, Table)],
        environment: &Environment,
    ) -> Checked<Vec<(String, Kind)>> {
        let read =
            |(name, table): &(String, Table)| Ok((name.clone(), self.kind(table, environment)?));
        tables.iter().map(read).collect()
    }

    fn kind(&self, table: &Table, environment: &Environment) -> Checked<Kind> {
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
                .map(|(_, thruster)| TunnelThruster {
                    bollard_n: *thruster.given("force").number(),
                    along_m: *thruster.given("along").number(),
                })
                .collect(),
            thruster_lags_s: thrusters.iter().map(|(_, t)| *t.given("lag").number()).collect(),
            windage: self.windage(table, &particulars)?,
            response: float.map(|float| response(&particulars, &float)),
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

    pub(super) fn wrong(&self, table: &Table, error: &dyn Display) -> ScenarioError {
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

    /// The vessels that bodies name, in the order of the bodies, and their thrusters' names.
    pub(super) fn vessels(
        &self,
        bodies: &[(String, Table)],
        kinds: &[(String, Kind)],
        tables: &[(String, Table)],
    ) -> Checked<(Vec<VesselSetup>, Thrusters)> {
        let (mut vessels, mut thrusters) = (Vec::new(), Thrusters::new());
        for (index, (name, body)) in bodies.iter().enumerate() {
            let Some(item) = body.item("vessel") else { continue };
            let place = self.kind_named(body, item, kinds)?;
            let mut setup = kinds[place].1.setup.clone();
            setup.body = index;
            vessels.push(setup);
            let own = tables[place].1.given("thruster").named();
            thrusters.insert(name.clone(), own.iter().map(|(name, _)| name.clone()).collect());
        }
        Ok((vessels, thrusters))
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
}

fn response(ship: &Particulars, float: &Float) -> MotionResponse {
    MotionResponse::Estimate(BoxShip {
        length_m: ship.length_m,
        beam_m: ship.beam_m,
        draught_m: ship.draught_m,
        block_coefficient: ship.block_coefficient(),
        roll_period_s: float.hydrostatics.roll.period_s(),
        roll_damping: float.hydrostatics.roll.damping,
    })
}
