//! From a checked table to a vessel. Checks the rules between keys, and refuses impossible particulars.

mod coefficients;
mod machinery;
mod particulars;
mod reading;
mod stability;

use std::f64::consts::TAU;

use fenderline_sim::hydro::vessels::{Figure, Origin, Source};
use fenderline_sim::hydro::{Known, estimated};

use super::VesselLibrary;
use super::data::VesselData;
use super::provenance;
use super::shape::{self, Hull};
use crate::assemble;
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::sources::Sources;

use self::reading::Reading;
pub(crate) use self::stability::hydrostatics;
use self::stability::oscillators;

type Read<T> = Result<T, ScenarioError>;

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

/// A vessel of a scenario, with particulars of its own, or derived from a vessel of the library.
///
/// # Errors
/// An unknown vessel in `from`, particulars beside `from`, missing or impossible particulars.
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

impl Reading<'_, '_> {
    /// Reads the whole vessel. `sources` is called last, so that mistakes in numbers are reported first.
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
        // Froude's law: times scale with the square root of the length.
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
            let own = oscillators(vessel.stability.as_ref(), particulars);
            let all = &mut vessel.origin.sources;
            all.retain(|source| !own.iter().any(|own| own.group == source.group));
            all.extend(own);
        }
        Ok(vessel)
    }

    /// Refuses a vessel without `from` that lacks a particular.
    fn refuse_what_is_missing(&self) -> Read<()> {
        for name in ["length_bp", "beam", "draught", "block_coefficient"] {
            if self.table.item(name).is_none() {
                let help = "give it, or name a vessel of the library with `from`";
                return Err(self.missing(self.table, name, help));
            }
        }
        let needs = [("propeller", ["diameter", "full"].as_slice()), ("rudder", &["area", "span"])];
        for (part, names) in needs {
            let Some(inner) = self.table.item(part).map(Item::table) else { continue };
            for name in names {
                if inner.item(name).is_none() {
                    let help = "a vessel without `from` needs it";
                    return Err(self.missing(inner, name, help));
                }
            }
        }
        Ok(())
    }

    /// Refuses particulars beside `from`, because they come from the library's vessel.
    fn refuse_other_particulars(&self) -> Read<()> {
        let table = self.table;
        const HERS: [&str; 6] =
            ["length_bp", "beam", "draught", "block_coefficient", "centre_of_gravity", "gyradius"];
        for name in HERS {
            if let Some(item) = table.item(name) {
                let error = self.together(table, item, "from");
                return Err(error.with_help(
                    "remove this key: the particulars come from the vessel of \
                        `from`",
                ));
            }
        }
        for (part, name) in [("propeller", "diameter"), ("rudder", "area"), ("rudder", "span")] {
            let Some(inner) = table.item(part).map(Item::table) else { continue };
            if let Some(item) = inner.item(name) {
                let error = self.together(inner, item, "from");
                return Err(error.with_help(
                    "remove this key: propeller and rudder come from the vessel of `from`",
                ));
            }
        }
        Ok(())
    }
}

fn figure(name: &str, text: &str) -> Figure {
    Figure { name: name.to_owned(), text: text.to_owned() }
}
