//! Notices of keys that have no effect in this scenario, whatever happens in the run. The criterion is in
//! `docs/design/files.md`; `crates/wasm/tests/keys_without_effect.rs` looks for keys that are missing here.

use std::collections::BTreeSet;

use fenderline_contact::FenderLaw;
use fenderline_sim::statistics::Limited;
use fenderline_sim::{ChainKind, Change, FenderSetup, Setup};

use super::assembly::Assembly;
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::error::NO_EFFECT;
use fenderline_keys::keys::anchor::BowSide;

impl Assembly<'_, '_> {
    /// Notices of all keys that the set-up does not use.
    pub(super) fn note_idle_keys(
        &mut self,
        file: &Table,
        setup: &Setup,
        fender_tables: &[(String, Table)],
    ) {
        self.note_idle_weather(file, setup);
        self.note_idle_flow(file, setup);
        self.note_idle_vessels(file, setup);
        self.note_idle_anchors(file);
        self.note_idle_fenders(fender_tables, setup);
        self.note_idle_limits(file, setup);
        self.note_after_the_end(file, setup.duration_s);
    }

    /// A notice that a key has no effect, if the file gives the key.
    pub(super) fn note_idle(&mut self, table: &Table, key: &str, why: &str) {
        if let Some(item) = table.item_if_any(key).filter(|item| !item.is_default) {
            self.note_at(&item.span, table.path_of(key), format!("{NO_EFFECT}{why}"));
        }
    }

    /// A notice that a table has no effect.
    pub(super) fn note_idle_table(&mut self, table: &Table, why: &str) {
        self.note_at(&table.span, table.path.clone(), format!("{NO_EFFECT}{why}"));
    }

    /// Notes numbers of materials that pairs and fenders do not use.
    pub(super) fn note_idle_materials(
        &mut self,
        file: &Table,
        used_by_pairs: &BTreeSet<usize>,
        (fenders, fender_tables): (&[FenderSetup], &[(String, Table)]),
    ) {
        for (index, (name, table)) in file.given("material").named().iter().enumerate() {
            let is_of = |(_, of): &&(&FenderSetup, &Table)| of.given("material").name() == name;
            let with_tables = fenders.iter().zip(fender_tables.iter().map(|(_, table)| table));
            let own: Vec<(&FenderSetup, &Table)> =
                with_tables.filter(|pair| is_of(&pair)).collect();
            let is_of_pair = used_by_pairs.contains(&index);
            if !is_of_pair && own.is_empty() {
                self.note_idle_table(table, "no pair or fender uses this material");
                continue;
            }
            let has_area_law = own.iter().any(|(fender, _)| fender.law == FenderLaw::Area);
            if !is_of_pair && !has_area_law && *table.given("stiffness").number() > 0.0 {
                let why = "the fenders of this material have laws of their own, and no pair uses it; write stiffness = 0";
                self.note_idle(table, "stiffness", why);
            }
            let resistance = |of: &Table| of.item("rolling_resistance").map(|item| *item.number());
            let slides = is_of_pair || own.iter().any(|(_, of)| resistance(of).is_none());
            if !slides {
                let why = "all fenders of this material have a `rolling_resistance` instead";
                self.note_idle(table, "friction_static", why);
                self.note_idle(table, "friction_dynamic", why);
            }
            let friction = *table.given("friction_static").number();
            let rolls = own.iter().filter_map(|(_, of)| resistance(of)).any(|of| of > 0.0);
            if !(rolls || slides && friction > 0.0) {
                let why = "the material has no `friction_static`, and the shear spring carries no more than friction allows";
                self.note_idle(table, "shear_stiffness", why);
            }
        }
    }

    /// Notes wind, current and waves that act on nothing, and numbers of them that are not used.
    fn note_idle_weather(&mut self, file: &Table, setup: &Setup) {
        let environment = file.given("environment").table();
        let vessels = &setup.world.vessels;
        if vessels.is_empty() {
            let why = "it acts on vessels, and no body has a `vessel`";
            for key in ["wind", "air_density", "current", "waves", "squat", "bank"] {
                self.note_idle(environment, key, why);
            }
        } else if vessels.iter().all(|vessel| vessel.windage.is_none()) {
            let why = "no vessel has wind areas (`windage`)";
            self.note_idle(environment, "wind", why);
            self.note_idle(environment, "air_density", why);
        } else if setup.world.environment.wind.is_none() && !has_wind_event(setup) {
            let why = "there is no wind, and no event that lets it blow";
            self.note_idle(environment, "air_density", why);
        }
        if let Some(wind) = environment.item("wind").map(Item::table)
            && !wind.item("gusts").is_some_and(|item| *item.flag())
        {
            let why = "the wind has no gusts; write gusts = true";
            self.note_idle(wind, "gust_admittance", why);
            self.note_idle(wind, "seed", why);
        }
        if let Some(waves) = environment.item("waves").map(Item::table)
            && *waves.given("regular").flag()
        {
            self.note_idle(waves, "peakedness", "a regular wave has no spectrum");
            self.note_idle(waves, "seed", "a regular wave has no random phases");
        }
    }

    /// Notes numbers of the flow about ships that no flow uses.
    fn note_idle_flow(&mut self, file: &Table, setup: &Setup) {
        let interaction = file.given("environment").table().given("interaction").table();
        if setup.world.flow.hulls.is_empty() {
            let why =
                "there are no passing ships, no bank by \"image\", and `between_vessels` is false";
            self.note_idle(interaction, "midship_coefficient", why);
            self.note_idle(interaction, "sections", why);
        }
        if setup.world.vessels.len() < 2 {
            let why = "interaction needs two vessels, and there are fewer";
            self.note_idle(interaction, "between_vessels", why);
        }
        for (_, ship) in file.given("passing").named() {
            if ship.item("waypoints").is_some_and(|item| item.outline().len() == 2) {
                let why = "a track of two waypoints has no bend";
                self.note_idle(ship, "turning_radius", why);
            }
        }
    }

    /// Notes kinds of vessels that no body has, and numbers that other numbers replace.
    fn note_idle_vessels(&mut self, file: &Table, setup: &Setup) {
        let has_waves = setup.world.environment.sea.is_some();
        let of_bodies = file.given("body").named().iter().map(|(_, body)| body);
        let of_passing = file.given("passing").named().iter().map(|(_, ship)| ship);
        let named: BTreeSet<&str> = of_bodies
            .chain(of_passing)
            .filter_map(|table| Some(table.item("vessel")?.text()))
            .collect();
        for (name, table) in file.given("vessel").named() {
            if !named.contains(name.as_str()) {
                self.note_idle_table(table, "no body and no passing ship is of this kind");
                continue;
            }
            if table.item("hydrodynamics").is_some() {
                self.note_idle(
                    table,
                    "stability",
                    "the stability data of `hydrodynamics` are used",
                );
            }
            if !has_waves {
                self.note_idle(table, "wave_response", "`[environment]` has no `waves`");
            }
        }
        if setup.fenders.is_empty()
            && let Some(study) = file.item("berthing")
        {
            self.note_idle_table(
                study.table(),
                "there are no fenders, and the study is that of a berthing against them",
            );
        }
    }

    /// Notes keys of anchors that other keys replace.
    fn note_idle_anchors(&mut self, file: &Table) {
        for (_, anchor) in file.given("anchor").named() {
            if anchor.item("holding_factor").is_some() {
                self.note_idle(anchor, "type", "`holding_factor` gives the holding power");
            }
            let side: BowSide = anchor.given("side").choice();
            if let Some(hawse) = anchor.item("hawse") {
                let across_m = hawse.vector().y;
                let is_other = match side {
                    BowSide::Port => across_m > 0.0,
                    BowSide::Starboard => across_m < 0.0,
                };
                if is_other {
                    let why = "the hawse pipe of `hawse` is on the other side";
                    self.note_idle(anchor, "side", why);
                }
            }
        }
    }

    /// Notes keys of fenders for parts that the fender does not have.
    fn note_idle_fenders(&mut self, tables: &[(String, Table)], setup: &Setup) {
        let level_m = setup.world.environment.level_range_m();
        for ((_, table), fender) in tables.iter().zip(&setup.fenders) {
            let has_weight_chain =
                fender.chains.iter().any(|chain| chain.kind == ChainKind::Weight);
            if !has_weight_chain {
                self.note_idle(table, "panel_mass", "no weight chain carries the panel");
            }
            if *table.given("floating").flag() {
                if !setup.bodies[fender.body].is_fixed() {
                    let why = "the body that carries the fender floats";
                    self.note_idle(table, "floating", why);
                } else if level_m == [0.0, 0.0] {
                    self.note_idle(table, "floating", "the water stays at datum");
                }
            }
        }
    }

    /// Notes limits of things that the scenario does not have.
    fn note_idle_limits(&mut self, file: &Table, setup: &Setup) {
        let limits = file.given("limit").named().iter().zip(&setup.world.statistics.limits);
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

    /// What is planned for a time after the end of the run.
    fn note_after_the_end(&mut self, file: &Table, duration_s: f64) {
        let why = format!("the run ends before, at {duration_s} s");
        for load in file.given("load").list() {
            if load.item("until").is_some_and(|item| *item.number() >= duration_s) {
                self.note_idle(load, "until", &why);
            }
        }
        let lists = [("order", "at"), ("event", "at"), ("load", "from")];
        for (list, key) in lists {
            for table in file.given(list).list() {
                self.note_late(table, key, duration_s, &why);
            }
        }
        for (_, line) in file.given("line").named() {
            self.note_late(line, "made_fast", duration_s, &why);
        }
    }

    fn note_late(&mut self, table: &Table, key: &str, duration_s: f64, why: &str) {
        if *table.given(key).number() >= duration_s {
            self.note_idle_table(table, why);
        }
    }
}

/// Whether an event of the scenario lets the wind blow.
fn has_wind_event(setup: &Setup) -> bool {
    setup.world.planned.iter().any(|planned| matches!(planned.change, Change::Wind { .. }))
}
