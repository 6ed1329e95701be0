//! Turns the tables of fenders and the fender data into the set-up of the fenders.

use fenderline_contact::{Rotation, Stop, vec2};
use fenderline_sim::{BodySetup, FenderSetup, HullPressure, NamedMaterial};

use super::assembly::{Assembly, Checked, Names};
use super::edge::{facing_rad, is_inside};
use super::performance::Performance;
use super::rows::rounded;
use super::vessel::{Decks, Kind};
use crate::library::FenderLibrary;
use crate::vessels::Belting;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::Number;
use fenderline_keys::keys::fender::{FenderKey, StopKey};
use fenderline_keys::sources::quoted;
use fenderline_keys::typed_key::{AnyKey, Key};

/// What fenders refer to.
pub(super) struct FenderParts<'p> {
    pub(super) library: &'p FenderLibrary,
    pub(super) materials: &'p [NamedMaterial],
    pub(super) decks: &'p Decks<'p>,
    pub(super) bodies: &'p [BodySetup],
}

impl Assembly<'_, '_> {
    pub(super) fn fenders(
        &self,
        fenders: Tables<'_, FenderKey>,
        parts: &FenderParts<'_>,
        names: &Names,
    ) -> Checked<Vec<FenderSetup>> {
        let read = |(name, table): (&String, Of<'_, _>)| self.fender(name, table, parts, names);
        fenders.iter().map(read).collect()
    }

    fn fender(
        &self,
        name: &str,
        table: Of<'_, FenderKey>,
        parts: &FenderParts<'_>,
        names: &Names,
    ) -> Checked<FenderSetup> {
        let FenderParts { library, materials, decks, bodies } = parts;
        self.refuse_what_does_not_go_together(table)?;
        let on = table.given(FenderKey::ON);
        let body = self.body_named(table, on, on.name(), names)?;
        let material = self.material_named(table, table.given(FenderKey::MATERIAL), names)?;
        let face = self.face(table, decks[body], &bodies[body])?;
        let given = |name: Key<_, Number>| table.item(name).map(|item| *item.number());
        let stiffness_npm2 = materials[material].material.stiffness_npm2;
        let performance = self.performance(table, library, stiffness_npm2, face.width_m)?;
        let projection_m =
            given(FenderKey::PROJECTION).or(performance.height_m).ok_or_else(|| {
                self.missing(table, FenderKey::PROJECTION, "write projection = \"1.5 m\"")
            })?;
        self.refuse_facing_its_own_body(table, &bodies[body], &face, projection_m)?;
        let stop = match table.item(FenderKey::STOP).map(Entry::table) {
            Some(stop) => Stop {
                from_m: *stop.given(StopKey::FROM).number(),
                stiffness_npm: *stop.given(StopKey::STIFFNESS).number(),
            },
            None => {
                Stop { from_m: performance.end_m, stiffness_npm: performance.stop_stiffness_npm }
            }
        };
        let (height_m, hull_pressure) = face_height(table, &face, &performance);
        let mut unloading = self.unloading(table, &performance)?;
        let panel = self.panel(table, &face, &performance)?;
        let (chains, panel_mass_kg) = self.chains(table, &face)?;
        let (mut rated, mut source, mut above_water_m) =
            (performance.rated, performance.source.clone(), face.above_water_m);
        if let Some(panel) = &panel {
            (unloading, rated) = (panel.unloading(unloading, &performance), panel.rated(rated));
            above_water_m += panel.reaction_above_m;
            if let Some(source) = &mut source {
                let designation = core::mem::take(&mut source.designation);
                source.designation = format!("{} × {designation}", panel.panel.cones_m.len());
            }
        }
        Ok(FenderSetup {
            name: name.to_owned(),
            body,
            position_m: face.middle_m,
            facing_rad: face.facing_rad,
            width_m: face.width_m,
            height_m,
            above_water_m,
            floating: *table.given(FenderKey::FLOATING).flag(),
            projection_m,
            law: performance.law,
            unloading,
            material,
            rated,
            stop: Some(stop),
            factors: performance.factors,
            energy_by_angle: performance.energy_by_angle,
            hull_pressure,
            hull_pressure_limit_npm2: self.hull_pressure_limit_npm2(table, library)?,
            source,
            panel: panel.map(|parts| parts.panel),
            chains,
            panel_mass_kg,
        })
    }

    /// The fender's face: from the fender's keys, or from a belting of the vessel that carries the fender.
    fn face(
        &self,
        table: Of<'_, FenderKey>,
        deck: Option<&Kind>,
        body: &BodySetup,
    ) -> Checked<Belting> {
        const OWN: &[AnyKey<FenderKey>] =
            any_keys![FenderKey: POSITION, FACING, WIDTH, FACE_HEIGHT, ABOVE_WATER];
        if let Some(item) = table.item(FenderKey::BELTING) {
            if let Some(own) = OWN.iter().find_map(|key| table.item(*key)) {
                let path = table.path_to(own);
                let message = format!("`{path}` does not go together with `belting`");
                let error = self.sources.error(&own.key_span, &path, message);
                return Err(error.with_help("keep only one of the two keys"));
            }
            return self.belting(table, item, deck);
        }
        let given = |name: Key<_, Number>| table.item(name).map(|item| *item.number());
        let missing = |key: AnyKey<FenderKey>| {
            self.missing(table, key, "give the fender a `position` and a `width`, or a `belting`")
        };
        let position_m = *table
            .item(FenderKey::POSITION)
            .ok_or_else(|| missing(FenderKey::POSITION.any()))?
            .vector();
        let facing_rad = match given(FenderKey::FACING) {
            Some(facing_rad) => facing_rad,
            None => facing_rad(&body.outline, position_m).ok_or_else(|| {
                let help = "the fender does not stand on an edge or at a corner of its body's \
                            outline: give its direction in `facing`";
                self.missing(table, FenderKey::FACING, help)
            })?,
        };
        let width_m =
            *table.item(FenderKey::WIDTH).ok_or_else(|| missing(FenderKey::WIDTH.any()))?.number();
        Ok(Belting {
            name: String::new(),
            middle_m: position_m,
            facing_rad,
            width_m,
            above_water_m: given(FenderKey::ABOVE_WATER).unwrap_or(0.0),
            extent_m: given(FenderKey::FACE_HEIGHT).unwrap_or(width_m),
        })
    }

    /// Refuses a fender whose face lies inside the body that carries the fender.
    fn refuse_facing_its_own_body(
        &self,
        table: Of<'_, FenderKey>,
        body: &BodySetup,
        face: &Belting,
        projection_m: f64,
    ) -> Checked<()> {
        let out = Rotation::from_angle(face.facing_rad).apply(vec2(projection_m, 0.0));
        // The belting of a vessel may lie inside a simplified outline of the vessel.
        if table.item(FenderKey::BELTING).is_some() || !is_inside(body, face.middle_m + out) {
            return Ok(());
        }
        let path = table.path_of(FenderKey::FACING);
        let span = table.item(FenderKey::FACING).map_or(&table.span, |item| &item.item().span);
        let name = quoted(&body.name);
        let message = format!(
            "`{path}`: the fender faces into {name}, which is the body that carries the fender"
        );
        let error = self.sources.error(span, &path, message);
        let out_of_edge = facing_rad(&body.outline, face.middle_m);
        Err(error.with_help(match out_of_edge {
            Some(rad) => format!("out of the edge is {} deg", rounded(rad.to_degrees())),
            None => "a fender faces away from its body: 0 is forward, 90 deg starboard".to_owned(),
        }))
    }

    /// Refuses two keys that give the same thing, and keys of catalogue fenders on a fender without a type.
    fn refuse_what_does_not_go_together(&self, table: Of<'_, FenderKey>) -> Checked<()> {
        const TWICE: [&[AnyKey<FenderKey>; 2]; 12] = [
            any_keys![FenderKey: COUNT, CONES],
            any_keys![FenderKey: TYPE, STIFFNESS],
            any_keys![FenderKey: TYPE, CURVE],
            any_keys![FenderKey: STIFFNESS, CURVE],
            any_keys![FenderKey: SIZE, HEIGHT],
            any_keys![FenderKey: SIZE, RATED_REACTION],
            any_keys![FenderKey: TYPE, RATED_DEFLECTION],
            any_keys![FenderKey: HULL, HULL_PRESSURE_LIMIT],
            any_keys![FenderKey: TYPE, UNLOADING],
            any_keys![FenderKey: RETURNED_ENERGY, UNLOADING],
            any_keys![FenderKey: RETURNED_ENERGY, UNLOADING_LAW],
            any_keys![FenderKey: UNLOADING, UNLOADING_LAW],
        ];
        for &[one, two] in TWICE {
            if let (Some(_), Some(item)) = (table.item(one), table.item(two)) {
                let path = table.path_of(two);
                let message = format!("`{path}` does not go together with `{one}`");
                let error = self.sources.error(&item.key_span, &path, message);
                return Err(error.with_help("keep only one of the two keys"));
            }
        }
        if table.item(FenderKey::TYPE).is_some() {
            return Ok(());
        }
        const OF_A_TYPE: &[AnyKey<FenderKey>] = any_keys![
            FenderKey: SIZE, HEIGHT, RATED_REACTION, COUNT, TEMPERATURE, VELOCITY_FACTOR,
            ANGLE_FACTOR
        ];
        for &name in OF_A_TYPE {
            if let Some(item) = table.item(name) {
                let path = table.path_of(name);
                let message =
                    format!("`{path}` is for fenders of a `type`, but this fender has no `type`");
                let error = self.sources.error(&item.key_span, &path, message);
                return Err(error.with_help(format!("remove `{name}` or give a `type`")));
            }
        }
        Ok(())
    }

    fn hull_pressure_limit_npm2(
        &self,
        table: Of<'_, FenderKey>,
        library: &FenderLibrary,
    ) -> Checked<Option<f64>> {
        if let Some(item) = table.item(FenderKey::HULL) {
            let limit = library.hull_pressure_limit(item.text());
            let limit = limit.map_err(|error| self.looked_up(table, item, &error))?;
            return Ok(Some(limit.limit_npm2));
        }
        Ok(table.item(FenderKey::HULL_PRESSURE_LIMIT).map(|item| *item.number()))
    }

    pub(super) fn missing<T, V>(
        &self,
        table: Of<'_, T>,
        key: Key<T, V>,
        help: &str,
    ) -> ScenarioError {
        let path = table.path_of(key);
        self.sources.error(&table.span, &path, format!("`{path}` is missing")).with_help(help)
    }
}

/// Height of the fender's face (m), and how the pressure on the hull is computed. A pneumatic fender has no panel: the
/// height of its face is the diameter, unless the scenario gives another height. For a panel without a given height the
/// program computes no pressure, unless the scenario gives a permissible pressure: then the height equals the width.
fn face_height(
    table: Of<'_, FenderKey>,
    face: &Belting,
    performance: &Performance,
) -> (f64, HullPressure) {
    let has = |key: AnyKey<_>| table.item(key).is_some();
    let is_given = has(FenderKey::FACE_HEIGHT.any()) || has(FenderKey::BELTING.any());
    match performance.hull_pressure {
        HullPressure::Inner { .. } | HullPressure::Unknown if !is_given => {
            (performance.height_m.unwrap_or(face.extent_m), performance.hull_pressure)
        }
        HullPressure::OverFace
            if !is_given
                && !has(FenderKey::HULL.any())
                && !has(FenderKey::HULL_PRESSURE_LIMIT.any()) =>
        {
            (face.extent_m, HullPressure::Unknown)
        }
        pressure => (face.extent_m, pressure),
    }
}
