//! Kinds of vessels, and the vessel of each body.

use std::collections::BTreeMap;
use std::fmt::Display;

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Vec2, vec2};
use fenderline_sim::environment::waves::{DriftHull, MotionResponse};
use fenderline_sim::hydro::actuator::RateLimited;
use fenderline_sim::hydro::{AddedMass, Mmg, Ratio};
use fenderline_sim::{
    BodySetup, Conning, Environment, Float, Looks, MassProperties, ShipModel, VesselSetup,
};

use super::assembly::{Assembly, Checked};
use super::response::estimate;
use crate::model;
use crate::vessels::{Belting, DeckPoint, VesselData, VesselLibrary, hydrostatics, own_vessel};
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::error::{Notice, ScenarioError};
use fenderline_keys::held::{Number, Text};
use fenderline_keys::keys::ScenarioKey;
use fenderline_keys::keys::body::BodyKey;
use fenderline_keys::keys::mooring::LineKey;
use fenderline_keys::keys::vessel::{ConningKey, VesselKey};
use fenderline_keys::sources::{Span, quoted};
use fenderline_keys::typed_key::Key;

/// A kind of vessel; several bodies may be of one kind.
pub(super) struct Kind {
    pub(super) setup: VesselSetup,
    /// Place to which warnings about this kind of vessel point: the table of the kind, or the body that names the kind.
    pub(super) place: (Span, String),
    pub(super) mass: MassProperties,
    /// Added mass of the vessel at the lowest water of the run.
    pub(super) low_water_mass: AddedMass,
    data: VesselData,
}

/// The kinds of vessels in a scenario, by their names.
#[derive(Default)]
pub(super) struct Kinds {
    /// All kinds of vessels, in the order in which the scenario first names each kind.
    pub(super) all: Vec<(String, Kind)>,
    /// Index of each kind in `all`, by its name.
    by_name: BTreeMap<String, usize>,
    /// Index in `all` of each body's kind; `None` for a body that is not a vessel.
    of_bodies: Vec<Option<usize>>,
}

impl Kinds {
    /// Adds a kind of vessel and returns the kind's index.
    fn add(&mut self, name: &str, kind: Kind) -> usize {
        let index = self.all.len();
        self.by_name.insert(name.to_owned(), index);
        self.all.push((name.to_owned(), kind));
        index
    }

    /// The data of a kind of vessel that the scenario has named or defined.
    pub(super) fn data(&self, name: &str) -> Option<&VesselData> {
        self.by_name.get(name).map(|index| &self.all[*index].1.data)
    }

    /// The kind of vessel of each body, in the order of the bodies; `None` for a body that is not a vessel.
    pub(super) fn of_bodies(&self) -> impl Iterator<Item = Option<&Kind>> {
        self.of_bodies.iter().map(|index| index.map(|index| &self.all[index].1))
    }
}

/// The kind of vessel of each body, by the index of the body; `None` for a body that is not a vessel.
pub(super) type Decks<'k> = Vec<Option<&'k Kind>>;

impl Kind {
    /// Makes a kind of vessel for the depth and density of the water in the scenario.
    fn new(
        data: VesselData,
        environment: &Environment,
        place: (Span, String),
    ) -> Result<Kind, Box<dyn Display>> {
        let deep = &data.ship;
        let water = environment.water_density_kgpm3;
        // Over a bottom by place, `Assembly::vessels` puts each vessel of the kind into the depth at her start.
        let in_depth = |level_m: f64| match environment.depth_m {
            Some(depth_m) => deep.at_depth(greater(depth_m + level_m, 0.0)),
            None => *deep,
        };
        let ship = in_depth(environment.tide.level_m(0.0));
        let low_water_mass = in_depth(environment.level_range_m()[0]).added_mass;
        let shaft = match data.shaft {
            Some(shaft) => RateLimited {
                value: 0.0,
                rate_per_s: 2.0 * shaft.full_rps / shaft.reversal_s,
                stop: shaft.full_rps,
            },
            None => RateLimited { value: 0.0, rate_per_s: 0.1, stop: 1.0 },
        };
        let particulars = ship.particulars;
        let float = match &data.stability {
            Some(stability) => Some(Float {
                hydrostatics: hydrostatics(stability, &particulars, water)
                    .map_err(|error| Box::new(error) as Box<dyn Display>)?,
                gravity_above_water_m: stability.gravity_above_keel_m - particulars.draught_m,
                draught_m: particulars.draught_m,
            }),
            None => None,
        };
        let drift = DriftHull::of(&particulars);
        let setup = VesselSetup {
            body: 0,
            origin: data.origin.clone(),
            ship,
            deep: *deep,
            rudder: data.rudder,
            shaft,
            thrusters: data.thrusters.clone(),
            azimuths: data.azimuths.clone(),
            current_table: None,
            windage: data.windage.clone(),
            response: float.map(|float| estimate(&particulars, &float)),
            float,
            drift: Some(drift),
            seakeeping: None,
            plan: None,
            looks: Looks::default(),
        };
        let mass = mass_of(&ship, water);
        Ok(Kind { setup, place, mass, low_water_mass, data })
    }

    /// Converts a point relative to midship into a point relative to the centre of gravity, which is a body's origin.
    fn about_gravity(&self, at_m: Vec2) -> Vec2 {
        at_m - vec2(self.data.ship.particulars.centre_of_gravity_m, 0.0)
    }

    /// The vessel's outline, with vertices relative to the centre of gravity.
    pub(super) fn outline_m(&self) -> Option<Vec<Vec2>> {
        let points = self.data.outline_m.as_ref()?;
        Some(points.iter().map(|point| self.about_gravity(*point)).collect())
    }

    /// Draught of the vessel (m).
    pub(super) fn draught_m(&self) -> f64 {
        self.data.ship.particulars.draught_m
    }

    /// Length of the vessel between perpendiculars (m).
    pub(super) fn length_m(&self) -> f64 {
        self.data.ship.particulars.length_m
    }

    /// Length overall and beam of the vessel (m).
    pub(super) fn size_m(&self) -> [f64; 2] {
        let hull = &self.data.ship.particulars;
        [self.data.length_overall_m.unwrap_or(hull.length_m), hull.beam_m]
    }
}

/// Mass and added mass of a ship in water of a density (kg/m³).
fn mass_of(ship: &Mmg, water: f64) -> MassProperties {
    MassProperties {
        mass_kg: water * ship.particulars.volume_m3,
        yaw_inertia_kgm2: water * ship.particulars.yaw_inertia_m5(),
        added_surge_kg: water * ship.added_mass.surge_m3,
        added_sway_kg: water * ship.added_mass.sway_m3,
        added_yaw_kgm2: water * ship.added_mass.yaw_m5,
    }
}

impl Assembly<'_, '_> {
    /// How the pages' view shows a vessel.
    fn looks(&self, table: Of<'_, VesselKey>) -> Checked<Looks> {
        let model = table.item(VesselKey::MODEL).map(|item| {
            let bytes = model::bytes_of(item.text(), self.files.text(item.text()));
            bytes.map(|bytes| ShipModel { file: item.text().to_owned(), bytes }).map_err(|why| {
                let path = table.path_to(item);
                let message = format!("`{path}`: {}: {why}", quoted(item.text()));
                self.sources.error(&item.item().span, &path, message).with_help(model::HELP)
            })
        });
        Ok(Looks {
            ship_type: table.item(VesselKey::KIND).map(|item| item.choice()),
            conning: table.item(VesselKey::CONNING).map(|item| Conning {
                at_m: *item.table().given(ConningKey::AT).vector(),
                eye_above_water_m: *item.table().given(ConningKey::EYE_HEIGHT).number(),
            }),
            model: model.transpose()?,
        })
    }
}

/// The key to which a notice about a ratio points.
fn key_of(ratio: Ratio) -> Key<VesselKey, Number> {
    match ratio {
        Ratio::BlockCoefficient => VesselKey::BLOCK_COEFFICIENT,
        Ratio::LengthOverBeam => VesselKey::LENGTH_BP,
        Ratio::BeamOverDraught => VesselKey::BEAM,
    }
}

impl Assembly<'_, '_> {
    /// Adds warnings for particulars outside the range of the formulas that estimate a vessel.
    fn note_outside_range(&mut self, table: Of<'_, VesselKey>, data: &VesselData) {
        for outside in &data.origin.outside {
            let item = table
                .item_if_any(key_of(outside.ratio))
                .map(Entry::any)
                .or(table.item_if_any(VesselKey::FROM.any()));
            let (span, key) = match item {
                Some(item) => (&item.item().span, table.path_to(item)),
                None => (&table.span, table.path.clone()),
            };
            let place = self.sources.place(span);
            self.notices.push(Notice { place, key, message: outside.to_string() });
        }
    }

    /// Every kind of vessel in a scenario: first the kinds that the scenario defines, in the order of the file, then
    /// the kinds of the library that bodies name.
    pub(super) fn kinds(
        &mut self,
        file: Of<'_, ScenarioKey>,
        library: &VesselLibrary,
        environment: &Environment,
        step_s: f64,
    ) -> Checked<Kinds> {
        let mut kinds = Kinds::default();
        for (name, table) in file.given(ScenarioKey::VESSEL).named() {
            if library.has(name) {
                let message = format!("the library has a vessel named {} already", quoted(name));
                let error = self.sources.error(&table.span, &table.path, message);
                return Err(error.with_help(format!(
                    "take another name, and write from = \"{name}\" if the library's vessel is \
                     meant"
                )));
            }
            let data = own_vessel(self.sources, name, table, library)?;
            self.note_outside_range(table, &data);
            let place = (table.span.clone(), table.path.clone());
            let mut kind =
                Kind::new(data, environment, place).map_err(|error| self.wrong(table, &error))?;
            if let Some((seakeeping, float)) = self.seakeeping(table, &kind, environment, step_s)? {
                kind.setup.seakeeping = Some(seakeeping);
                kind.setup.float = Some(float);
                kind.setup.response = None;
            }
            let particulars = kind.setup.ship.particulars;
            let own_wind = self.own_wind(table, &particulars, kind.setup.windage.as_ref())?;
            kind.setup.windage = own_wind.or(kind.setup.windage);
            kind.setup.looks = self.looks(table)?;
            kind.setup.current_table = self.own_current(table, &particulars, environment)?;
            if let Some(table) = self.rao_table(table)? {
                kind.setup.response = Some(MotionResponse::Table(table));
            }
            kinds.add(name, kind);
        }
        for (_, body) in file.given(ScenarioKey::BODY).named() {
            let Some(item) = body.item(BodyKey::VESSEL) else {
                kinds.of_bodies.push(None);
                continue;
            };
            let name = item.text();
            if let Some(index) = kinds.by_name.get(name) {
                kinds.of_bodies.push(Some(*index));
                continue;
            }
            let Ok(data) = library.vessel(name) else {
                let own = kinds.all.iter().map(|(known, _)| known.as_str());
                let known = own.chain(library.vessels().iter().map(|known| known.name.as_str()));
                return Err(self.unknown("vessel", body, item, name, known));
            };
            for outside in &data.origin.outside {
                self.notices.push(Notice {
                    place: self.sources.place(&item.span),
                    key: body.path_to(item),
                    message: outside.to_string(),
                });
            }
            let place = (item.span.clone(), body.path_to(item));
            let kind = Kind::new(data.clone(), environment, place)
                .map_err(|error| self.refused(body, item, &error))?;
            let index = kinds.add(name, kind);
            kinds.of_bodies.push(Some(index));
        }
        Ok(kinds)
    }

    pub(super) fn wrong<T>(&self, table: Of<'_, T>, error: &dyn Display) -> ScenarioError {
        self.sources.error(&table.span, &table.path, format!("`{}`: {error}", table.path))
    }

    /// The vessels that bodies name, in the order of the bodies. If the depth of the water depends on
    /// the place, the model and the mass of each vessel are computed for the depth where she starts.
    pub(super) fn vessels(
        &self,
        bodies: Tables<'_, BodyKey>,
        kinds: &Kinds,
        (all, environment): (&mut [BodySetup], &Environment),
    ) -> Checked<Vec<VesselSetup>> {
        let mut vessels = Vec::new();
        for (index, ((_, body), kind)) in bodies.iter().zip(kinds.of_bodies()).enumerate() {
            let Some(kind) = kind else { continue };
            let mut setup = kind.setup.clone();
            setup.body = index;
            if environment.bottom.is_some() {
                let own = &mut all[index];
                let state = BodyState {
                    position_m: own.position_m,
                    heading_rad: own.heading_rad,
                    ..BodyState::default()
                };
                let soundings = setup
                    .soundings(&state, environment, 0.0)
                    .map_err(|error| self.refused(body, body.given(BodyKey::POSITION), &error))?;
                if let Some(depth_m) = soundings.still_m {
                    setup.ship = setup.deep.at_depth(depth_m);
                }
                own.mass = Some(mass_of(&setup.ship, environment.water_density_kgpm3));
            }
            if let Some(running) = body.item(BodyKey::RUNNING) {
                if kind.data.shaft.is_none() {
                    let message = format!("{} has no propeller", kind.data.origin.title);
                    return Err(self.refused(body, running, &message));
                }
                setup.shaft.value = setup.shaft.stop * running.number();
            }
            vessels.push(setup);
        }
        Ok(vessels)
    }

    /// The place of a chock relative to the centre of gravity, and the chock's height above the water (m).
    pub(super) fn chock<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, Text>,
        deck: Option<&Kind>,
    ) -> Checked<(Vec2, f64)> {
        self.deck_point(table, item, LineKey::CHOCK.name(), deck, |data| &data.chocks)
    }

    /// The place of bitts relative to the centre of gravity, and the height of the bitts above the water (m).
    pub(super) fn bitts<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, Text>,
        deck: Option<&Kind>,
    ) -> Checked<(Vec2, f64)> {
        self.deck_point(table, item, LineKey::BITTS.name(), deck, |data| &data.bitts)
    }

    fn deck_point<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, Text>,
        what: &str,
        deck: Option<&Kind>,
        points: fn(&VesselData) -> &Vec<DeckPoint>,
    ) -> Checked<(Vec2, f64)> {
        let kind = self.deck(table, item, deck)?;
        let points = points(&kind.data);
        let point = points.iter().find(|point| point.name == item.text()).ok_or_else(|| {
            self.not_on_her(what, table, item, kind, points.iter().map(|point| point.name.as_str()))
        })?;
        Ok((kind.about_gravity(point.at_m), point.above_water_m))
    }

    /// A belting of a vessel, with the middle of the belting relative to the centre of gravity.
    pub(super) fn belting<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, Text>,
        deck: Option<&Kind>,
    ) -> Checked<Belting> {
        let kind = self.deck(table, item, deck)?;
        let all = &kind.data.beltings;
        let belting = all.iter().find(|belting| belting.name == item.text()).ok_or_else(|| {
            self.not_on_her("belting", table, item, kind, all.iter().map(|b| b.name.as_str()))
        })?;
        Ok(Belting { middle_m: kind.about_gravity(belting.middle_m), ..belting.clone() })
    }

    fn deck<'k, T, V>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, V>,
        deck: Option<&'k Kind>,
    ) -> Checked<&'k Kind> {
        deck.ok_or_else(|| {
            self.refused(table, item, &"the body that is named there is not a vessel")
        })
    }

    fn not_on_her<'n, T>(
        &self,
        what: &str,
        table: Of<'_, T>,
        item: Entry<'_, Text>,
        kind: &Kind,
        known: impl Iterator<Item = &'n str> + Clone,
    ) -> ScenarioError {
        let error = self.unknown(what, table, item, item.text(), known.clone());
        match known.clone().next() {
            None => {
                error.with_help(format!("the data of {} have no {what}", kind.data.origin.title))
            }
            Some(_) => error,
        }
    }
}
