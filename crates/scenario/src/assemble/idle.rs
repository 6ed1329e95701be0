//! Warns of keys that have no effect in a scenario, whatever happens in the run. `docs/design/files.md` says when a key
//! counts as without effect; `crates/wasm/tests/keys_without_effect.rs` looks for keys without effect that get no
//! warning.

use std::collections::BTreeSet;

use fenderline_contact::FenderLaw;
use fenderline_sim::statistics::Limited;
use fenderline_sim::{ChainKind, Change, FenderSetup, Setup};

use super::assembly::Assembly;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::error::NO_EFFECT;
use fenderline_keys::held::Number;
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::anchor::{AnchorKey, BowSide};
use fenderline_keys::keys::body::BodyKey;
use fenderline_keys::keys::environment::{EnvironmentKey, WavesKey, WindKey};
use fenderline_keys::keys::event::EventKey;
use fenderline_keys::keys::fender::FenderKey;
use fenderline_keys::keys::load::LoadKey;
use fenderline_keys::keys::material::MaterialKey;
use fenderline_keys::keys::mooring::LineKey;
use fenderline_keys::keys::order::OrderKey;
use fenderline_keys::keys::passing::{InteractionKey, PassingKey};
use fenderline_keys::keys::vessel::VesselKey;
use fenderline_keys::typed_key::Key;

impl Assembly<'_, '_> {
    /// Adds warnings about all keys that the set-up does not use.
    pub(super) fn note_idle_keys(
        &mut self,
        file: Of<'_, ScenarioKey>,
        setup: &Setup,
        fender_tables: Tables<'_, FenderKey>,
    ) {
        self.note_idle_weather(file, setup);
        self.note_idle_flow(file, setup);
        self.note_idle_vessels(file, setup);
        self.note_idle_anchors(file);
        self.note_idle_fenders(fender_tables, setup);
        self.note_idle_limits(file, setup);
        self.note_after_the_end(file, setup.duration_s);
    }

    /// Adds a warning that a key has no effect, if the file gives the key.
    pub(super) fn note_idle<T, V>(&mut self, table: Of<'_, T>, key: Key<T, V>, why: &str) {
        if let Some(item) = table.item_if_any(key).filter(|item| !item.is_default) {
            self.note_at(&item.span, table.path_of(key), format!("{NO_EFFECT}{why}"));
        }
    }

    /// Adds a warning that a table has no effect.
    pub(super) fn note_idle_table<T>(&mut self, table: Of<'_, T>, why: &str) {
        self.note_at(&table.span, table.path.clone(), format!("{NO_EFFECT}{why}"));
    }

    /// Warns of numbers of materials that pairs and fenders do not use.
    pub(super) fn note_idle_materials(
        &mut self,
        file: Of<'_, ScenarioKey>,
        used_by_pairs: &BTreeSet<usize>,
        (fenders, fender_tables): (&[FenderSetup], Tables<'_, FenderKey>),
    ) {
        for (index, (name, table)) in file.given(ScenarioKey::MATERIAL).named().iter().enumerate() {
            let with_tables = fenders.iter().zip(fender_tables.iter().map(|(_, table)| table));
            let own: Vec<(&FenderSetup, Of<'_, FenderKey>)> = with_tables
                .filter(|(_, of)| of.given(FenderKey::MATERIAL).name() == name)
                .collect();
            let is_of_pair = used_by_pairs.contains(&index);
            if !is_of_pair && own.is_empty() {
                self.note_idle_table(table, "no pair or fender uses this material");
                continue;
            }
            let has_area_law = own.iter().any(|(fender, _)| fender.law == FenderLaw::Area);
            if !is_of_pair && !has_area_law && *table.given(MaterialKey::STIFFNESS).number() > 0.0 {
                let why = "the fenders of this material have their own laws of reaction, and no \
                           pair uses the material; write stiffness = 0";
                self.note_idle(table, MaterialKey::STIFFNESS, why);
            }
            let resistance = |of: Of<'_, FenderKey>| {
                of.item(FenderKey::ROLLING_RESISTANCE).map(|item| *item.number())
            };
            let slides = is_of_pair || own.iter().any(|(_, of)| resistance(*of).is_none());
            if !slides {
                let why =
                    "all fenders of this material have a `rolling_resistance` in place of friction";
                self.note_idle(table, MaterialKey::FRICTION_STATIC, why);
                self.note_idle(table, MaterialKey::FRICTION_DYNAMIC, why);
            }
            let friction = *table.given(MaterialKey::FRICTION_STATIC).number();
            let rolls = own.iter().filter_map(|(_, of)| resistance(*of)).any(|of| of > 0.0);
            if !(rolls || slides && friction > 0.0) {
                let why = "the material has no `friction_static`, and the shear spring carries no \
                           more than friction allows";
                self.note_idle(table, MaterialKey::SHEAR_STIFFNESS, why);
            }
        }
    }

    /// Warns of wind, current and waves that act on nothing, and of their numbers that are not used.
    fn note_idle_weather(&mut self, file: Of<'_, ScenarioKey>, setup: &Setup) {
        let environment = file.given(ScenarioKey::ENVIRONMENT).table();
        let vessels = &setup.world.vessels;
        if vessels.is_empty() {
            let why = "this key acts on vessels only, and no body has a `vessel`";
            let keys = any_keys![EnvironmentKey: WIND, AIR_DENSITY, CURRENT, WAVES, SQUAT, BANK];
            for &key in keys {
                self.note_idle(environment, key, why);
            }
        } else if vessels.iter().all(|vessel| vessel.windage.is_none()) {
            let why = "no vessel has wind areas (`windage`)";
            self.note_idle(environment, EnvironmentKey::WIND, why);
            self.note_idle(environment, EnvironmentKey::AIR_DENSITY, why);
        } else if setup.world.environment.wind.is_none() && !has_wind_event(setup) {
            let why = "there is no wind, and no event sets a wind";
            self.note_idle(environment, EnvironmentKey::AIR_DENSITY, why);
        }
        if let Some(wind) = environment.item(EnvironmentKey::WIND).map(Entry::table)
            && !wind.item(WindKey::GUSTS).is_some_and(|item| *item.flag())
        {
            let why = "the wind has no gusts; write gusts = true";
            self.note_idle(wind, WindKey::GUST_ADMITTANCE, why);
            self.note_idle(wind, WindKey::SEED, why);
        }
        if let Some(waves) = environment.item(EnvironmentKey::WAVES).map(Entry::table)
            && *waves.given(WavesKey::REGULAR).flag()
        {
            self.note_idle(waves, WavesKey::PEAKEDNESS, "a regular wave has no spectrum");
            self.note_idle(waves, WavesKey::SEED, "a regular wave has no random phases");
        }
    }

    /// Warns of numbers for the flow about ships if there is no such flow.
    fn note_idle_flow(&mut self, file: Of<'_, ScenarioKey>, setup: &Setup) {
        let interaction =
            file.given(ScenarioKey::ENVIRONMENT).table().given(EnvironmentKey::INTERACTION).table();
        if setup.world.flow.hulls.is_empty() {
            let why =
                "there are no passing ships, no bank by \"image\", and `between_vessels` is false";
            self.note_idle(interaction, InteractionKey::MIDSHIP_COEFFICIENT, why);
            self.note_idle(interaction, InteractionKey::SECTIONS, why);
        }
        if setup.world.vessels.len() < 2 {
            let why = "interaction needs two vessels, and the scenario has fewer";
            self.note_idle(interaction, InteractionKey::BETWEEN_VESSELS, why);
        }
        for (_, ship) in file.given(ScenarioKey::PASSING).named() {
            if ship.item(PassingKey::WAYPOINTS).is_some_and(|item| item.outline().len() == 2) {
                let why = "a track of two waypoints has no bend";
                self.note_idle(ship, PassingKey::TURNING_RADIUS, why);
            }
        }
    }

    /// Warns of kinds of vessels that no body has, and of numbers of vessels that other numbers replace.
    fn note_idle_vessels(&mut self, file: Of<'_, ScenarioKey>, setup: &Setup) {
        let has_waves = setup.world.environment.sea.is_some();
        let bodies = file.given(ScenarioKey::BODY).named().iter();
        let of_bodies = bodies.filter_map(|(_, body)| body.item(BodyKey::VESSEL));
        let passing = file.given(ScenarioKey::PASSING).named().iter();
        let of_passing = passing.filter_map(|(_, ship)| ship.item(PassingKey::VESSEL));
        let named: BTreeSet<&str> = of_bodies.chain(of_passing).map(Entry::text).collect();
        for (name, table) in file.given(ScenarioKey::VESSEL).named() {
            if !named.contains(name.as_str()) {
                self.note_idle_table(table, "no body and no passing ship is of this kind");
                continue;
            }
            if table.item(VesselKey::HYDRODYNAMICS).is_some() {
                self.note_idle(
                    table,
                    VesselKey::STABILITY,
                    "the stability data of `hydrodynamics` are used instead",
                );
            }
            if !has_waves {
                self.note_idle(table, VesselKey::WAVE_RESPONSE, "`[environment]` has no `waves`");
            }
        }
        if setup.fenders.is_empty()
            && let Some(study) = file.item(ScenarioKey::BERTHING)
        {
            self.note_idle_table(
                study.table(),
                "the scenario has no fenders against which the ship could berth",
            );
        }
    }

    /// Warns of keys of anchors that other keys replace.
    fn note_idle_anchors(&mut self, file: Of<'_, ScenarioKey>) {
        for (_, anchor) in file.given(ScenarioKey::ANCHOR).named() {
            if anchor.item(AnchorKey::HOLDING_FACTOR).is_some() {
                self.note_idle(anchor, AnchorKey::TYPE, "`holding_factor` gives the holding power");
            }
            let side: BowSide = anchor.given(AnchorKey::SIDE).choice();
            if let Some(hawse) = anchor.item(AnchorKey::HAWSE) {
                let across_m = hawse.vector().y;
                let is_other = match side {
                    BowSide::Port => across_m > 0.0,
                    BowSide::Starboard => across_m < 0.0,
                };
                if is_other {
                    let why = "the key `hawse` puts the hawse pipe on the other side of the bow";
                    self.note_idle(anchor, AnchorKey::SIDE, why);
                }
            }
        }
    }

    /// Warns of keys for parts of a fender that the fender does not have.
    fn note_idle_fenders(&mut self, tables: Tables<'_, FenderKey>, setup: &Setup) {
        let level_m = setup.world.environment.level_range_m();
        for ((_, table), fender) in tables.iter().zip(&setup.fenders) {
            let has_weight_chain =
                fender.chains.iter().any(|chain| chain.kind == ChainKind::Weight);
            if !has_weight_chain {
                self.note_idle(table, FenderKey::PANEL_MASS, "no weight chain carries the panel");
            }
            if *table.given(FenderKey::FLOATING).flag() {
                if !setup.bodies[fender.body].is_fixed() {
                    let why = "the body that carries the fender floats";
                    self.note_idle(table, FenderKey::FLOATING, why);
                } else if level_m == [0.0, 0.0] {
                    self.note_idle(
                        table,
                        FenderKey::FLOATING,
                        "the level of the water stays at datum",
                    );
                }
            }
        }
    }

    /// Warns of limits of mooring lines or fenders if the scenario has no lines or fenders.
    fn note_idle_limits(&mut self, file: Of<'_, ScenarioKey>, setup: &Setup) {
        let limits =
            file.given(ScenarioKey::LIMIT).named().iter().zip(&setup.world.statistics.limits);
        for ((_, table), limit) in limits {
            match limit.what {
                Limited::Lines if setup.world.lines.is_empty() => {
                    self.note_idle_table(table, "there are no lines");
                }
                Limited::Fenders if setup.fenders.is_empty() => {
                    self.note_idle_table(table, "there are no fenders");
                }
                _ => {}
            }
        }
    }

    /// Warns of orders, events, loads and mooring lines that are planned for a time after the end of the run.
    fn note_after_the_end(&mut self, file: Of<'_, ScenarioKey>, duration_s: f64) {
        let why = format!("the run ends before this time, at {duration_s} s");
        for load in file.given(ScenarioKey::LOAD).list() {
            if load.item(LoadKey::UNTIL).is_some_and(|item| *item.number() >= duration_s) {
                self.note_idle(load, LoadKey::UNTIL, &why);
            }
        }
        for order in file.given(ScenarioKey::ORDER).list() {
            self.note_late(order, OrderKey::AT, duration_s, &why);
        }
        for event in file.given(ScenarioKey::EVENT).list() {
            self.note_late(event, EventKey::AT, duration_s, &why);
        }
        for load in file.given(ScenarioKey::LOAD).list() {
            self.note_late(load, LoadKey::FROM, duration_s, &why);
        }
        for (_, line) in file.given(ScenarioKey::LINE).named() {
            self.note_late(line, LineKey::MADE_FAST, duration_s, &why);
        }
    }

    fn note_late<T>(&mut self, table: Of<'_, T>, key: Key<T, Number>, duration_s: f64, why: &str) {
        if *table.given(key).number() >= duration_s {
            self.note_idle_table(table, why);
        }
    }
}

/// Whether an event of the scenario sets a wind.
fn has_wind_event(setup: &Setup) -> bool {
    setup.world.planned.iter().any(|planned| matches!(planned.change, Change::Wind { .. }))
}
