//! Fenders: from their tables and the fender data to a set-up.

use fenderline_contact::Stop;
use fenderline_sim::FenderSetup;

use super::vessel::Kind;
use super::{Assembly, Checked, FenderParts, Names};
use crate::checked::{Item, Table};
use crate::error::ScenarioError;
use crate::library::FenderLibrary;
use crate::vessels::Belting;

impl Assembly<'_, '_> {
    pub(super) fn fenders(
        &self,
        fenders: &[(String, Table)],
        parts: &FenderParts<'_>,
        names: &Names,
    ) -> Checked<Vec<FenderSetup>> {
        let read = |(name, table): &(String, Table)| self.fender(name, table, parts, names);
        fenders.iter().map(read).collect()
    }

    fn fender(
        &self,
        name: &str,
        table: &Table,
        parts: &FenderParts<'_>,
        names: &Names,
    ) -> Checked<FenderSetup> {
        let FenderParts { library, materials, decks } = parts;
        self.refuse_what_does_not_go_together(table)?;
        let on = table.given("on");
        let body = self.body_named(table, on, on.name(), names)?;
        let material = self.material_named(table, table.given("material"), names)?;
        let face = self.face(table, decks[body])?;
        let given = |name: &str| table.item(name).map(|item| *item.number());
        let stiffness_npm2 = materials[material].material.stiffness_npm2;
        let performance = self.performance(table, library, stiffness_npm2, face.width_m)?;
        let projection_m = given("projection")
            .or(performance.height_m)
            .ok_or_else(|| self.missing(table, "projection", "write projection = \"1.5 m\""))?;
        let stop = match table.item("stop").map(Item::table) {
            Some(stop) => Stop {
                from_m: *stop.given("from").number(),
                stiffness_npm: *stop.given("stiffness").number(),
            },
            None => {
                Stop { from_m: performance.end_m, stiffness_npm: performance.stop_stiffness_npm }
            }
        };
        let unloading = self.unloading(table, &performance)?;
        Ok(FenderSetup {
            name: name.to_owned(),
            body,
            position_m: face.middle_m,
            facing_rad: face.facing_rad,
            width_m: face.width_m,
            height_m: face.extent_m,
            above_water_m: face.above_water_m,
            projection_m,
            law: performance.law,
            unloading,
            material,
            rated: performance.rated,
            stop: Some(stop),
            factors: performance.factors,
            energy_by_angle: performance.energy_by_angle,
            hull_pressure: performance.hull_pressure,
            hull_pressure_limit_npm2: self.hull_pressure_limit_npm2(table, library)?,
            source: performance.source,
        })
    }

    /// The fender's face: from its own keys, or from a belting of the vessel that carries it.
    fn face(&self, table: &Table, deck: Option<&Kind>) -> Checked<Belting> {
        const OWN: [&str; 5] = ["position", "facing", "width", "face_height", "above_water"];
        if let Some(item) = table.item("belting") {
            if let Some(own) = OWN.iter().find_map(|name| table.item(name)) {
                let path = table.path_of(own.name);
                let message = format!("`{path}` does not go together with `belting`");
                let error = self.sources.error(&own.key_span, &path, message);
                return Err(error.with_help("keep one of the two"));
            }
            return self.belting(table, item, deck);
        }
        let given = |name: &str| table.item(name).map(|item| *item.number());
        let need = |name: &str| {
            table.item(name).ok_or_else(|| {
                self.missing(table, name, "give position, facing and width, or a `belting`")
            })
        };
        let (position, facing) = (need("position")?, need("facing")?);
        let width_m = *need("width")?.number();
        Ok(Belting {
            name: String::new(),
            middle_m: *position.vector(),
            facing_rad: *facing.number(),
            width_m,
            above_water_m: given("above_water").unwrap_or(0.0),
            extent_m: given("face_height").unwrap_or(width_m),
        })
    }

    /// Refuses keys that give one thing twice, and keys of catalogue fenders on a fender without a type.
    fn refuse_what_does_not_go_together(&self, table: &Table) -> Checked<()> {
        const TWICE: [[&str; 2]; 10] = [
            ["type", "stiffness"],
            ["type", "curve"],
            ["stiffness", "curve"],
            ["size", "height"],
            ["size", "rated_reaction"],
            ["type", "rated_deflection"],
            ["hull", "hull_pressure_limit"],
            ["type", "unloading"],
            ["returned_energy", "unloading"],
            ["returned_energy", "unloading_law"],
        ];
        for [one, two] in TWICE {
            if let (Some(_), Some(item)) = (table.item(one), table.item(two)) {
                let path = table.path_of(two);
                let message = format!("`{path}` does not go together with `{one}`");
                let error = self.sources.error(&item.key_span, &path, message);
                return Err(error.with_help("keep one of the two"));
            }
        }
        if table.item("type").is_some() {
            return Ok(());
        }
        const OF_A_TYPE: [&str; 8] = [
            "size",
            "height",
            "rated_reaction",
            "count",
            "temperature",
            "velocity_factor",
            "angle_factor",
            "unloading_law",
        ];
        for name in OF_A_TYPE {
            if let Some(item) = table.item(name) {
                let path = table.path_of(name);
                let message = format!("`{path}` is for fenders of a `type`, but this one has none");
                let error = self.sources.error(&item.key_span, &path, message);
                return Err(error.with_help(format!("remove `{name}` or give a `type`")));
            }
        }
        Ok(())
    }

    fn hull_pressure_limit_npm2(
        &self,
        table: &Table,
        library: &FenderLibrary,
    ) -> Checked<Option<f64>> {
        if let Some(item) = table.item("hull") {
            let limit = library.hull_pressure_limit(item.text());
            let limit = limit.map_err(|error| self.looked_up(table, item, &error))?;
            return Ok(Some(limit.limit_npm2));
        }
        Ok(table.item("hull_pressure_limit").map(|item| *item.number()))
    }

    pub(super) fn missing(&self, table: &Table, name: &str, help: &str) -> ScenarioError {
        let path = table.path_of(name);
        self.sources.error(&table.span, &path, format!("`{path}` is missing")).with_help(help)
    }
}
