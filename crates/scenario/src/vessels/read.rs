//! From a checked table to a vessel: what the key table cannot say, because it holds between keys, and what no
//! ship can be.

use std::f64::consts::TAU;
use std::fmt::Display;

use fenderline_sim::attitude::{HydrostaticParticulars, Hydrostatics, oscillator_estimates};
use fenderline_sim::constants::SEA_WATER_KGPM3;
use fenderline_sim::hydro::actuator::RateLimited;
use fenderline_sim::hydro::vessels::{Figure, Origin, Source};
use fenderline_sim::hydro::{
    AddedMass, CrossFlow, DriftPolynomial, HydroError, Known, LowSpeedHull, Particulars,
    Polynomial, SternCoefficients, SternGear, SwayPolynomial, TunnelThruster, estimated,
};

use fenderline_sim::{AzimuthSetup, ThrusterSetup};

use super::VesselLibrary;
use super::data::{AddedMassForm, Coefficients, Shaft, Stability, VesselData};
use super::figures::digits;
use super::provenance;
use super::shape::{self, Hull};
use crate::assemble;
use crate::checked::{Item, Table};
use crate::error::ScenarioError;
use crate::library::LookUpError;
use crate::sources::Sources;

type Read<T> = Result<T, ScenarioError>;

/// Acceleration of gravity (m/s²) in the Froude numbers of vessel files: published trials round it so.
const FROUDE_GRAVITY_MPS2: f64 = 9.81;
/// Rate of a steering gear of which nothing is said (rad/s): 2.32 degrees a second, IMO's 65 degrees in 28 s.
const USUAL_RATE_RADPS: f64 = 2.32 * TAU / 360.0;
/// A rudder's stop of which nothing is said (rad): 35 degrees.
const USUAL_STOP_RAD: f64 = 35.0 * TAU / 360.0;
/// From full ahead to full astern where nothing is said (s).
const USUAL_REVERSAL_S: f64 = 40.0;

/// A vessel of a file.
pub(super) fn file_vessel(
    sources: &Sources<'_>,
    name: &str,
    table: &Table,
    known: &VesselLibrary,
) -> Read<VesselData> {
    let reading = Reading { sources, table };
    let base = match table.item("coefficients_of") {
        None => None,
        Some(item) => {
            Some(known.vessel(item.text()).map_err(|error| reading.looked_up(item, &error))?)
        }
    };
    let title = table.given("title").text().to_owned();
    reading.vessel(name, title, base, || {
        let mut all = provenance::of_file(sources, table)?;
        if let Some(base) = base {
            all.extend(provenance::inherited(table, base));
        }
        Ok(all)
    })
}

/// A vessel of a scenario, of her own particulars or made from one of the library.
///
/// # Errors
/// A vessel that is not known, particulars beside one, particulars that are missing or that no ship has.
pub(crate) fn own_vessel(
    sources: &Sources<'_>,
    name: &str,
    table: &Table,
    known: &VesselLibrary,
) -> Read<VesselData> {
    let reading = Reading { sources, table };
    match table.item("from") {
        Some(item) => {
            let base =
                known.vessel(item.text()).map_err(|error| reading.looked_up(item, &error))?;
            reading.changed(name, base)
        }
        None => {
            reading.refuse_what_is_missing()?;
            reading.vessel(name, name.to_owned(), None, || Ok(provenance::of_scenario(table)))
        }
    }
}

struct Reading<'r, 's> {
    sources: &'r Sources<'s>,
    table: &'r Table,
}

impl Reading<'_, '_> {
    fn at(&self, table: &Table, item: &Item, error: &dyn Display) -> ScenarioError {
        let path = table.path_of(item.name);
        self.sources.error(&item.span, &path, format!("`{path}`: {error}"))
    }

    fn looked_up(&self, item: &Item, error: &LookUpError) -> ScenarioError {
        self.at(self.table, item, error).with_help(error.help())
    }

    fn missing(&self, table: &Table, name: &str, help: &str) -> ScenarioError {
        let path = table.path_of(name);
        let message = format!("`{path}` is missing");
        self.sources.error(&table.span, &path, message).with_help(help)
    }

    fn together(&self, table: &Table, item: &Item, with: &str) -> ScenarioError {
        let path = table.path_of(item.name);
        let message = format!("`{path}` does not go together with `{with}`");
        self.sources.error(&item.key_span, &path, message)
    }

    /// The whole vessel, of her own; last of all, where her numbers come from.
    fn vessel(
        &self,
        name: &str,
        title: String,
        base: Option<&VesselData>,
        sources: impl FnOnce() -> Read<Vec<Source>>,
    ) -> Read<VesselData> {
        let table = self.table;
        let mut assumed = Vec::new();
        let particulars = self.particulars(&mut assumed)?;
        let coefficients = self.coefficients(base, &particulars)?;
        let added_mass = coefficients.added_mass.map(|form| form.of(&particulars));
        let gear = self.stern_gear(&particulars, &coefficients.stern)?;
        let estimate = estimated(&Known {
            particulars,
            added_mass,
            polynomial: coefficients.polynomial,
            low_speed: coefficients.low_speed,
            gear,
        })
        .map_err(|error| self.impossible(&error))?;
        let mut scaled = Vec::new();
        // What takes a ship a second takes her model so much less.
        let time_scale =
            base.map(|base| (base.ship.particulars.length_m / particulars.length_m).sqrt());
        let froude = base.zip(time_scale);
        let approach_mps = self.approach_mps(froude, &particulars, &mut scaled)?;
        let rudder = self.rudder(froude, &mut scaled, &mut assumed);
        let shaft = self.shaft(froude, &mut scaled, &mut assumed)?;
        let overall = table.item_if_any("length_overall");
        let has_shape = table.spec.key("outline").is_some();
        let outline_m = match has_shape {
            true => shape::outline(self.sources, table, &particulars, overall)?,
            false => None,
        };
        let hull = Hull { outline_m: outline_m.as_deref(), ship: &particulars };
        let points = |name: &str| match table.item_if_any(name) {
            Some(item) => shape::deck_points(self.sources, item.named(), &hull),
            None => Ok(Vec::new()),
        };
        let mut vessel = VesselData {
            name: name.to_owned(),
            is_model: table.item_if_any("tank_model").is_some_and(|item| *item.flag()),
            resistance_of_model_m: table
                .item_if_any("resistance_of_model")
                .map(|item| *item.number()),
            length_overall_m: overall.map(|item| *item.number()),
            ship: estimate.model,
            approach_mps,
            rudder,
            shaft,
            thrusters: self.thrusters(&particulars)?,
            azimuths: self.azimuths(&particulars)?,
            windage: assemble::windage(self.sources, table, &particulars)?,
            stability: self.stability(&particulars)?,
            chocks: points("chock")?,
            bitts: points("bitts")?,
            beltings: match table.item_if_any("belting") {
                Some(item) => shape::beltings(self.sources, item.named(), &hull)?,
                None => Vec::new(),
            },
            outline_m,
            coefficients,
            origin: Origin::default(),
        };
        let mut all = sources()?;
        all.extend(base.and_then(|base| provenance::scaled(scaled, base)));
        match all.iter_mut().find(|source| source.group == "defaults") {
            Some(defaults) => defaults.figures.append(&mut assumed),
            None => all.extend(provenance::defaults_of(assumed)),
        }
        all.extend(estimate.sources);
        all.extend(oscillators(vessel.stability.as_ref(), &particulars));
        vessel.origin = Origin {
            title,
            sources: all,
            estimate_method: estimate.method,
            outside: estimate.outside,
        };
        Ok(vessel)
    }

    /// A vessel of the library with other machinery, wind areas or stability.
    fn changed(&self, name: &str, base: &VesselData) -> Read<VesselData> {
        let table = self.table;
        self.refuse_other_particulars()?;
        let mut vessel = base.clone();
        vessel.name = name.to_owned();
        let given = |part: &str, key: &str| Some(*table.item(part)?.table().item(key)?.number());
        for part in ["propeller", "rudder"] {
            if let Some(item) = table.item(part).filter(|_| base.shaft.is_none()) {
                let message = format!("{} has no {part}", base.origin.title);
                return Err(self.at(table, item, &message));
            }
        }
        if let Some(shaft) = &mut vessel.shaft {
            shaft.full_rps = given("propeller", "full").map_or(shaft.full_rps, |full| full / TAU);
            shaft.reversal_s = given("propeller", "reversal").unwrap_or(shaft.reversal_s);
        }
        vessel.rudder.rate_per_s = given("rudder", "rate").unwrap_or(vessel.rudder.rate_per_s);
        vessel.rudder.stop = given("rudder", "stop").unwrap_or(vessel.rudder.stop);
        let particulars = &base.ship.particulars;
        if !table.given("thruster").is_default {
            vessel.thrusters = self.thrusters(particulars)?;
        }
        if !table.given("azimuth").is_default {
            vessel.azimuths = self.azimuths(particulars)?;
        }
        if table.item("windage").is_some() {
            vessel.windage = assemble::windage(self.sources, table, particulars)?;
        }
        if table.item("stability").is_some() {
            vessel.stability = self.stability(particulars)?;
        }
        vessel.origin = provenance::replaced(&base.origin, table);
        if table.item("stability").is_some() {
            let told = oscillators(vessel.stability.as_ref(), particulars);
            let all = &mut vessel.origin.sources;
            all.retain(|source| !told.iter().any(|own| own.group == source.group));
            all.extend(told);
        }
        Ok(vessel)
    }

    /// What a scenario's own vessel needs.
    fn refuse_what_is_missing(&self) -> Read<()> {
        for name in ["length_bp", "beam", "draught", "block_coefficient"] {
            if self.table.item(name).is_none() {
                let help = "give it, or say `from` which vessel of the library she is";
                return Err(self.missing(self.table, name, help));
            }
        }
        let needs = [("propeller", ["diameter", "full"].as_slice()), ("rudder", &["area", "span"])];
        for (part, names) in needs {
            let Some(inner) = self.table.item(part).map(Item::table) else { continue };
            for name in names {
                if inner.item(name).is_none() {
                    let help = "a vessel that is not `from` another needs it";
                    return Err(self.missing(inner, name, help));
                }
            }
        }
        Ok(())
    }

    /// A vessel of the library keeps her hull, propeller and rudder.
    fn refuse_other_particulars(&self) -> Read<()> {
        let table = self.table;
        const HERS: [&str; 6] =
            ["length_bp", "beam", "draught", "block_coefficient", "centre_of_gravity", "gyradius"];
        for name in HERS {
            if let Some(item) = table.item(name) {
                let error = self.together(table, item, "from");
                return Err(error.with_help("that vessel brings her own particulars"));
            }
        }
        for (part, name) in [("propeller", "diameter"), ("rudder", "area"), ("rudder", "span")] {
            let Some(inner) = table.item(part).map(Item::table) else { continue };
            if let Some(item) = inner.item(name) {
                let error = self.together(inner, item, "from");
                return Err(error.with_help("that vessel brings her own propeller and rudder"));
            }
        }
        Ok(())
    }

    fn particulars(&self, assumed: &mut Vec<Figure>) -> Read<Particulars> {
        let table = self.table;
        let number = |name: &str| *table.given(name).number();
        let (length_m, beam_m, draught_m) =
            (number("length_bp"), number("beam"), number("draught"));
        let mut said = VOLUMES.iter().filter_map(|name| table.item_if_any(name));
        let (first, second) = (said.next(), said.next());
        if let (Some(first), Some(second)) = (first, second) {
            return Err(self.together(table, second, first.name).with_help("keep one of the two"));
        }
        let Some(volume) = first else {
            let help =
                "give one of `volume`, `displacement`, `block_coefficient` and `mass_coefficient`";
            return Err(self.missing(table, "block_coefficient", help));
        };
        let value = *volume.number();
        let volume_m3 = match volume.name {
            "volume" => value,
            "displacement" => value / SEA_WATER_KGPM3,
            "mass_coefficient" => value * (0.5 * length_m * length_m * draught_m),
            _ => value * length_m * beam_m * draught_m,
        };
        let centre_of_gravity_m = table.number_if_any("centre_of_gravity").unwrap_or_else(|| {
            assumed.push(figure("centre_of_gravity", "0 m"));
            0.0
        });
        let gyradius_m = table.number_if_any("gyradius").unwrap_or_else(|| {
            assumed.push(figure("gyradius", &format!("{} m", digits(0.25 * length_m))));
            0.25 * length_m
        });
        let yaw_gyradius_ratio = gyradius_m / length_m;
        let ship = Particulars {
            length_m,
            beam_m,
            draught_m,
            volume_m3,
            centre_of_gravity_m,
            yaw_gyradius_ratio,
        };
        ship.check().map_err(|error| self.impossible(&error))
    }

    /// An error about particulars, at the key that it is about.
    fn impossible(&self, error: &HydroError) -> ScenarioError {
        const KEYS: [(&str, &[&str]); 6] = [
            ("length", &["length_bp"]),
            ("beam", &["beam"]),
            ("draught", &["draught"]),
            ("displaced volume", VOLUMES),
            ("block coefficient", VOLUMES),
            ("centre of gravity", &["centre_of_gravity"]),
        ];
        const LATER: [(&str, &[&str]); 9] = [
            ("yaw gyradius", &["gyradius"]),
            ("added", &["added_mass"]),
            ("diameter of the propeller", &["propeller"]),
            ("thrust", &["propeller"]),
            ("wake", &["propeller"]),
            ("area of the rudder", &["rudder"]),
            ("rudder", &["rudder"]),
            ("cross-flow", &["low_speed"]),
            ("resistance", &["low_speed", "sway_polynomial", "drift_polynomial"]),
        ];
        if let HydroError::OutOfRange { quantity, .. } = error {
            let about = KEYS.iter().chain(&LATER).find(|(start, _)| quantity.starts_with(start));
            let mut items = about
                .into_iter()
                .flat_map(|(_, keys)| *keys)
                .filter_map(|key| self.table.item_if_any(key));
            if let Some(item) = items.next() {
                return self.at(self.table, item, error);
            }
        }
        let path = &self.table.path;
        self.sources.error(&self.table.span, path, format!("`{path}`: {error}"))
    }

    fn coefficients(&self, base: Option<&VesselData>, ship: &Particulars) -> Read<Coefficients> {
        let table = self.table;
        let inner = |name: &str| table.item_if_any(name).map(Item::table);
        let polynomial = match (inner("sway_polynomial"), table.item_if_any("drift_polynomial")) {
            (Some(_), Some(item)) => return Err(self.together(table, item, "sway_polynomial")),
            (Some(table), None) => Some(Polynomial::Sway(sway_polynomial(table))),
            (None, Some(item)) => Some(Polynomial::Drift(drift_polynomial(item.table()))),
            (None, None) => None,
        };
        let own = Coefficients {
            added_mass: inner("added_mass")
                .map(|table| self.added_mass(table, ship))
                .transpose()?,
            polynomial,
            low_speed: inner("low_speed").map(low_speed),
            stern: stern(inner("propeller"), inner("rudder")),
        };
        let Some(base) = base.map(|base| &base.coefficients) else { return Ok(own) };
        Ok(Coefficients {
            added_mass: own.added_mass.or(base.added_mass),
            polynomial: own.polynomial.or(base.polynomial),
            low_speed: own.low_speed.or(base.low_speed),
            stern: own.stern.or(base.stern),
        })
    }

    fn added_mass(&self, table: &Table, ship: &Particulars) -> Read<AddedMassForm> {
        const VOLUMES: [&str; 3] = ["surge_volume", "sway_volume", "yaw_volume"];
        let volumes = VOLUMES.map(|name| table.item(name));
        let coefficients = ["surge", "sway", "yaw", "yaw_with_ship"].map(|name| table.item(name));
        if let (Some(_), Some(item)) =
            (coefficients.iter().flatten().next(), volumes.iter().flatten().next())
        {
            return Err(self.together(table, item, "surge").with_help("keep one form of the two"));
        }
        if volumes.iter().any(Option::is_some) {
            let mut values = [0.0; 3];
            for (value, (item, name)) in values.iter_mut().zip(volumes.into_iter().zip(VOLUMES)) {
                let missing = || self.missing(table, name, "give all three, or none");
                *value = *item.ok_or_else(missing)?.number();
            }
            return Ok(AddedMassForm::Volumes(values, [ship.length_m, ship.draught_m]));
        }
        let [surge, sway, yaw, with_ship] = coefficients;
        let need = |item: Option<&Item>, name: &str| {
            let missing = || self.missing(table, name, "give surge, sway and yaw");
            item.map(|item| *item.number()).ok_or_else(missing)
        };
        let yaw = match (yaw, with_ship) {
            (Some(_), Some(item)) => return Err(self.together(table, item, "yaw")),
            (None, Some(item)) => {
                // What is left when her own inertia is taken off.
                let mass = ship.volume_m3 / ship.mass_unit_m3();
                let own = mass * ship.yaw_gyradius_ratio * ship.yaw_gyradius_ratio;
                let left = item.number() - own;
                if left <= 0.0 {
                    let message = format!("it is less than her own inertia of {}", digits(own));
                    return Err(self.at(table, item, &message));
                }
                left
            }
            (yaw, None) => need(yaw, "yaw")?,
        };
        Ok(AddedMassForm::Coefficients([need(surge, "surge")?, need(sway, "sway")?, yaw]))
    }

    fn stern_gear(&self, ship: &Particulars, own: &SternCoefficients) -> Read<Option<SternGear>> {
        let table = self.table;
        let (propeller, rudder) = match (table.item("propeller"), table.item("rudder")) {
            (Some(propeller), Some(rudder)) => (propeller.table(), rudder.table()),
            (None, None) => return Ok(None),
            (Some(alone), None) | (None, Some(alone)) => {
                let other = if alone.name == "rudder" { "propeller" } else { "rudder" };
                let path = table.path_of(alone.name);
                let message = format!("`{path}` needs `{other}` beside it");
                return Err(self.sources.error(&alone.key_span, &path, message));
            }
        };
        let propeller_m = *propeller.given("diameter").number();
        let rudder_m2 = match (rudder.item_if_any("area"), rudder.item_if_any("area_ratio")) {
            (Some(_), Some(item)) => return Err(self.together(rudder, item, "area")),
            (Some(area), None) => *area.number(),
            (None, Some(ratio)) => ship.length_m * ship.draught_m / ratio.number(),
            (None, None) => return Err(self.missing(rudder, "area", "or give `area_ratio`")),
        };
        let (to_span, aspect) =
            (rudder.item_if_any("propeller_to_span"), rudder.item_if_any("aspect_ratio"));
        let (propeller_to_span, aspect_ratio) = match rudder.item_if_any("span") {
            Some(span) => {
                if let Some(item) = to_span.or(aspect) {
                    return Err(self.together(rudder, item, "span"));
                }
                let span_m = span.number();
                (propeller_m / span_m, span_m * span_m / rudder_m2)
            }
            None => {
                let need = |name, help| self.missing(rudder, name, help);
                let to_span = to_span.ok_or_else(|| need("span", "or give `propeller_to_span`"))?;
                let aspect = aspect.map(|item| *item.number());
                if aspect.is_none() && own.lift_gradient.is_none() {
                    return Err(need("aspect_ratio", "or give `lift_gradient`"));
                }
                (*to_span.number(), aspect.unwrap_or(1.0))
            }
        };
        Ok(Some(SternGear { propeller_m, rudder_m2, propeller_to_span, aspect_ratio, own: *own }))
    }

    fn approach_mps(
        &self,
        base: Option<(&VesselData, f64)>,
        ship: &Particulars,
        scaled: &mut Vec<Figure>,
    ) -> Read<Option<f64>> {
        let table = self.table;
        match (table.item_if_any("speed"), table.item_if_any("froude")) {
            (Some(_), Some(item)) => Err(self.together(table, item, "speed")),
            (Some(speed), None) => Ok(Some(*speed.number())),
            (None, Some(froude)) => {
                Ok(Some(froude.number() * (FROUDE_GRAVITY_MPS2 * ship.length_m).sqrt()))
            }
            (None, None) => Ok(base.and_then(|(base, time_scale)| {
                let speed_mps = base.approach_mps? / time_scale;
                scaled.push(figure("speed", &format!("{} m/s", digits(speed_mps))));
                Some(speed_mps)
            })),
        }
    }

    fn rudder(
        &self,
        base: Option<(&VesselData, f64)>,
        scaled: &mut Vec<Figure>,
        assumed: &mut Vec<Figure>,
    ) -> RateLimited {
        let Some(gear) = self.table.item("rudder").map(Item::table) else {
            return RateLimited { value: 0.0, rate_per_s: 0.0, stop: 0.0 };
        };
        let stop = gear.number_if_any("stop").unwrap_or_else(|| {
            assumed.push(figure("rudder.stop", "35°"));
            USUAL_STOP_RAD
        });
        let rate_per_s = match (gear.item("rate"), base) {
            (Some(rate), _) => *rate.number(),
            (None, Some((base, time_scale))) => {
                let rate = base.rudder.rate_per_s * time_scale;
                scaled.push(figure("rudder.rate", &format!("{}°/s", digits(rate.to_degrees()))));
                rate
            }
            (None, None) => {
                assumed.push(figure("rudder.rate", "2.32°/s"));
                USUAL_RATE_RADPS
            }
        };
        RateLimited { value: 0.0, rate_per_s, stop }
    }

    fn shaft(
        &self,
        base: Option<(&VesselData, f64)>,
        scaled: &mut Vec<Figure>,
        assumed: &mut Vec<Figure>,
    ) -> Read<Option<Shaft>> {
        let Some(propeller) = self.table.item("propeller").map(Item::table) else {
            return Ok(None);
        };
        let reversal_s = propeller.number_if_any("reversal").unwrap_or_else(|| {
            assumed.push(figure("propeller.reversal", "40 s"));
            USUAL_REVERSAL_S
        });
        let of_base = base.and_then(|(base, time_scale)| Some(base.shaft?.full_rps * time_scale));
        let full_rps = match (propeller.item("full"), of_base) {
            (Some(full), _) => full.number() / TAU,
            (None, Some(full_rps)) => {
                let text = format!("{} rpm", digits(60.0 * full_rps));
                scaled.push(figure("propeller.full", &text));
                full_rps
            }
            (None, None) => {
                return Err(self.missing(propeller, "full", "write full = \"95 rpm\""));
            }
        };
        Ok(Some(Shaft { full_rps, reversal_s }))
    }

    fn thrusters(&self, ship: &Particulars) -> Read<Vec<ThrusterSetup>> {
        let read = |(name, table): &(String, Table)| {
            let along = table.given("along");
            let along_m = *along.number();
            if along_m.abs() > 0.6 * ship.length_m {
                let message =
                    format!("{along_m} m from midship is not in a ship of {} m", ship.length_m);
                return Err(self.at(table, along, &message));
            }
            Ok(ThrusterSetup {
                name: name.clone(),
                tunnel: TunnelThruster { bollard_n: *table.given("force").number(), along_m },
                lag_s: *table.given("lag").number(),
            })
        };
        let thrusters = self.table.given("thruster").named().iter().map(read);
        let mut thrusters: Vec<ThrusterSetup> = thrusters.collect::<Read<_>>()?;
        // Their forces are added up in this order, whatever that of the file.
        thrusters.sort_by(|one, other| one.name.cmp(&other.name));
        Ok(thrusters)
    }

    fn azimuths(&self, ship: &Particulars) -> Read<Vec<AzimuthSetup>> {
        let tables = self.table.given("azimuth").named();
        for (_, table) in tables {
            for (name, most_m) in [("along", 0.6 * ship.length_m), ("across", 0.5 * ship.beam_m)] {
                let place = table.given(name);
                let place_m = *place.number();
                if place_m.abs() > most_m {
                    let message = format!("{place_m} m is not under a ship of her size");
                    return Err(self.at(table, place, &message));
                }
            }
        }
        Ok(assemble::azimuths(tables))
    }

    fn stability(&self, ship: &Particulars) -> Read<Option<Stability>> {
        let Some(item) = self.table.item("stability") else { return Ok(None) };
        let table = item.table();
        let number = |name: &str| *table.given(name).number();
        let stability = Stability {
            gm_m: number("gm"),
            gravity_above_keel_m: number("gravity_above_keel"),
            waterplane_m2: number("waterplane_area"),
        };
        hydrostatics(&stability, ship, SEA_WATER_KGPM3)
            .map_err(|error| self.at(self.table, item, &error))?;
        // A box has the highest metacentre of all: KB at most the draught, BM = I/∇.
        let most_m = ship.draught_m
            + ship.length_m * ship.beam_m * ship.beam_m * ship.beam_m / (12.0 * ship.volume_m3);
        let above_keel_m = stability.gm_m + stability.gravity_above_keel_m;
        if above_keel_m > most_m {
            let message = format!(
                "a metacentre {} m above the keel, but no hull of her size has it above {} m",
                digits(above_keel_m),
                digits((10.0 * most_m).round() / 10.0)
            );
            return Err(self.at(table, table.given("gm"), &message));
        }
        Ok(Some(stability))
    }
}

/// The ways in which a displacement may be given.
const VOLUMES: &[&str] = &["volume", "displacement", "block_coefficient", "mass_coefficient"];

/// Heave, roll and pitch in water of a density (kg/m³).
///
/// # Errors
/// A ship that does not float upright.
pub(crate) fn hydrostatics(
    stability: &Stability,
    ship: &Particulars,
    water_kgpm3: f64,
) -> Result<Hydrostatics, fenderline_sim::attitude::AttitudeError> {
    Hydrostatics::of(&HydrostaticParticulars {
        mass_kg: water_kgpm3 * ship.volume_m3,
        length_m: ship.length_m,
        beam_m: ship.beam_m,
        draught_m: ship.draught_m,
        waterplane_m2: stability.waterplane_m2,
        gm_m: stability.gm_m,
        water_kgpm3,
    })
}

/// How heave, roll and pitch are estimated, where they are, in sea water.
fn oscillators(stability: Option<&Stability>, ship: &Particulars) -> Option<Source> {
    let of_sea = |stability| hydrostatics(stability, ship, SEA_WATER_KGPM3).ok();
    stability.and_then(of_sea).map(|of| oscillator_estimates(&of))
}

fn figure(name: &str, text: &str) -> Figure {
    Figure { name: name.to_owned(), text: text.to_owned() }
}

impl AddedMassForm {
    /// Of a ship: coefficients are the same for every size, volumes grow with L²d and L⁴d.
    fn of(self, ship: &Particulars) -> AddedMass {
        match self {
            AddedMassForm::Coefficients([surge, sway, yaw]) => {
                AddedMass::from_mmg(ship, surge, sway, yaw)
            }
            AddedMassForm::Volumes([surge_m3, sway_m3, yaw_m5], [length_m, draught_m]) => {
                let length = ship.length_m / length_m;
                let mass = length * length * (ship.draught_m / draught_m);
                AddedMass { surge_m3, sway_m3, yaw_m5 }.scaled(mass, mass, mass * length * length)
            }
        }
    }
}

fn sway_polynomial(table: &Table) -> SwayPolynomial {
    let of = |name: &str| *table.given(name).number();
    SwayPolynomial {
        resistance: of("resistance"),
        x_vv: of("x_vv"),
        x_vr: of("x_vr"),
        x_rr: of("x_rr"),
        x_vvvv: of("x_vvvv"),
        y_v: of("y_v"),
        y_r: of("y_r"),
        y_vvv: of("y_vvv"),
        y_vvr: of("y_vvr"),
        y_vrr: of("y_vrr"),
        y_rrr: of("y_rrr"),
        n_v: of("n_v"),
        n_r: of("n_r"),
        n_vvv: of("n_vvv"),
        n_vvr: of("n_vvr"),
        n_vrr: of("n_vrr"),
        n_rrr: of("n_rrr"),
    }
}

fn drift_polynomial(table: &Table) -> DriftPolynomial {
    let of = |name: &str| *table.given(name).number();
    DriftPolynomial {
        x_0: of("x_0"),
        x_bb: of("x_bb"),
        x_br: of("x_br"),
        x_rr: of("x_rr"),
        x_bbbb: of("x_bbbb"),
        y_b: of("y_b"),
        y_r: of("y_r"),
        y_bbb: of("y_bbb"),
        y_bbr: of("y_bbr"),
        y_brr: of("y_brr"),
        y_rrr: of("y_rrr"),
        n_b: of("n_b"),
        n_r: of("n_r"),
        n_bbb: of("n_bbb"),
        n_bbr: of("n_bbr"),
        n_brr: of("n_brr"),
        n_rrr: of("n_rrr"),
    }
}

fn low_speed(table: &Table) -> LowSpeedHull {
    let of = |name: &str| *table.given(name).number();
    LowSpeedHull {
        ahead: of("ahead"),
        astern: of("astern"),
        surge_vr: of("x_vr"),
        sway_v: of("y_v"),
        sway_r: of("y_r"),
        yaw_v: of("n_v"),
        yaw_r: of("n_r"),
        cross_flow: CrossFlow {
            drag_coefficient: of("drag"),
            yaw_gain_force: of("yaw_gain_force"),
            yaw_gain_moment: of("yaw_gain_moment"),
        },
    }
}

fn stern(propeller: Option<&Table>, rudder: Option<&Table>) -> SternCoefficients {
    let number = |table: Option<&Table>, name: &str| table?.number_if_any(name);
    let inner = |table: Option<&Table>, name: &str| -> Option<[f64; 3]> {
        let table = table?.item_if_any(name)?.table();
        let mut values = [0.0; 3];
        for (value, item) in values.iter_mut().zip(table.spec.keys) {
            *value = *table.given(item.name).number();
        }
        Some(values)
    };
    SternCoefficients {
        thrust_polynomial: inner(propeller, "thrust"),
        series: propeller.and_then(|table| table.item_if_any("series")).map(Item::choice),
        thrust_deduction: number(propeller, "thrust_deduction"),
        thrust_deduction_astern: number(propeller, "thrust_deduction_astern"),
        wake: number(propeller, "wake"),
        wake_change: inner(propeller, "wake_change").map(|[c1, below, above]| (c1, [below, above])),
        propeller_place: number(propeller, "place"),
        lift_gradient: number(rudder, "lift_gradient"),
        wake_ratio: number(rudder, "wake_ratio"),
        race_gain: number(rudder, "race_gain"),
        straightening: inner(rudder, "straightening").map(|[below, above, _]| [below, above]),
        straightening_place: number(rudder, "straightening_place"),
        resistance_deduction: number(rudder, "resistance_deduction"),
        hull_gain: number(rudder, "hull_gain"),
        hull_place: number(rudder, "hull_place"),
        rudder_place: number(rudder, "place"),
    }
}
