//! Turns a checked table into a vessel, checks the rules between its keys, and refuses impossible particulars.

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
use crate::vessels::keys::FileVesselKey;
use crate::vessels::keys::deck::FileDeckPointKey;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::{NamedOf, Number, TableOf};
use fenderline_keys::keys::vessel::{PropellerKey, RudderKey, VesselKey};
use fenderline_keys::sources::Sources;
use fenderline_keys::typed_key::{AnyKey, Key};

use self::reading::Reading;
pub(crate) use self::stability::hydrostatics;
use self::stability::oscillators;

type Read<T> = Result<T, ScenarioError>;

/// Reads a vessel of a vessel file.
pub(super) fn file_vessel(
    sources: &Sources<'_>,
    name: &str,
    table: Of<'_, FileVesselKey>,
    known: &VesselLibrary,
) -> Read<VesselData> {
    let reading = Reading { sources, table };
    let base = match table.item(FileVesselKey::COEFFICIENTS_OF) {
        None => None,
        Some(item) => {
            Some(known.vessel(item.text()).map_err(|error| reading.looked_up(item, &error))?)
        }
    };
    let title = table.given(FileVesselKey::TITLE).text().to_owned();
    reading.vessel(name, title, base, || {
        let mut all = provenance::of_file(sources, table)?;
        if let Some(base) = base {
            all.extend(provenance::inherited(table, base));
        }
        Ok(all)
    })
}

/// Reads a vessel of a scenario, which has its own particulars or is derived from a vessel of the library.
///
/// # Errors
/// Fails if `from` names an unknown vessel, if particulars are given beside `from`, or if particulars are missing or
/// impossible.
pub(crate) fn own_vessel(
    sources: &Sources<'_>,
    name: &str,
    table: Of<'_, VesselKey>,
    known: &VesselLibrary,
) -> Read<VesselData> {
    let reading = Reading { sources, table: table.read_as() };
    match table.item(VesselKey::FROM) {
        Some(item) => {
            let base =
                known.vessel(item.text()).map_err(|error| reading.looked_up(item, &error))?;
            reading.changed(name, table, base)
        }
        None => {
            reading.refuse_what_is_missing(table)?;
            reading.vessel(name, name.to_owned(), None, || Ok(provenance::of_scenario(table)))
        }
    }
}

impl Reading<'_, '_> {
    /// Reads the whole vessel. The function `sources` is called last, so that mistakes in numbers are reported before
    /// mistakes in sources.
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
        let overall = table.item_if_any(FileVesselKey::LENGTH_OVERALL);
        let has_shape = table.spec.key(FileVesselKey::OUTLINE.name()).is_some();
        let outline_m = match has_shape {
            true => shape::outline(self.sources, table, &particulars, overall)?,
            false => None,
        };
        let hull = Hull { outline_m: outline_m.as_deref(), ship: &particulars };
        let points = |name: Key<_, NamedOf<FileDeckPointKey>>| match table.item_if_any(name) {
            Some(item) => shape::deck_points(self.sources, item.named(), &hull),
            None => Ok(Vec::new()),
        };
        let mut vessel = VesselData {
            name: name.to_owned(),
            is_model: table.item_if_any(FileVesselKey::TANK_MODEL).is_some_and(|item| *item.flag()),
            resistance_of_model_m: table
                .item_if_any(FileVesselKey::RESISTANCE_OF_MODEL)
                .map(|item| *item.number()),
            length_overall_m: overall.map(|item| *item.number()),
            ship: estimate.model,
            approach_mps,
            rudder,
            shaft,
            thrusters: self.thrusters(&particulars)?,
            azimuths: self.azimuths(&particulars)?,
            windage: assemble::windage(self.sources, table, FileVesselKey::WINDAGE, &particulars)?,
            stability: self.stability(&particulars)?,
            chocks: points(FileVesselKey::CHOCK)?,
            bitts: points(FileVesselKey::BITTS)?,
            beltings: match table.item_if_any(FileVesselKey::BELTING) {
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

    /// Makes a vessel of the library with other machinery, wind areas or stability.
    fn changed(&self, name: &str, table: Of<'_, VesselKey>, base: &VesselData) -> Read<VesselData> {
        self.refuse_other_particulars(table)?;
        let mut vessel = base.clone();
        vessel.name = name.to_owned();
        let propeller = |key: Key<PropellerKey, Number>| {
            Some(*table.item(VesselKey::PROPELLER)?.table().item(key)?.number())
        };
        let rudder = |key: Key<RudderKey, Number>| {
            Some(*table.item(VesselKey::RUDDER)?.table().item(key)?.number())
        };
        for part in any_keys![VesselKey: PROPELLER, RUDDER] {
            if let Some(item) = table.item(*part).filter(|_| base.shaft.is_none()) {
                let message = format!("{} has no {part}", base.origin.title);
                return Err(self.at(table, item, &message));
            }
        }
        if let Some(shaft) = &mut vessel.shaft {
            shaft.full_rps =
                propeller(PropellerKey::FULL).map_or(shaft.full_rps, |full| full / TAU);
            shaft.reversal_s = propeller(PropellerKey::REVERSAL).unwrap_or(shaft.reversal_s);
        }
        vessel.rudder.rate_per_s = rudder(RudderKey::RATE).unwrap_or(vessel.rudder.rate_per_s);
        vessel.rudder.stop = rudder(RudderKey::STOP).unwrap_or(vessel.rudder.stop);
        let particulars = &base.ship.particulars;
        if !table.given(VesselKey::THRUSTER).is_default {
            vessel.thrusters = self.thrusters(particulars)?;
        }
        if !table.given(VesselKey::AZIMUTH).is_default {
            vessel.azimuths = self.azimuths(particulars)?;
        }
        if table.item(VesselKey::WINDAGE).is_some() {
            vessel.windage =
                assemble::windage(self.sources, table, VesselKey::WINDAGE, particulars)?;
        }
        if table.item(VesselKey::STABILITY).is_some() {
            vessel.stability = self.stability(particulars)?;
        }
        vessel.origin = provenance::replaced(&base.origin, table);
        if table.item(VesselKey::STABILITY).is_some() {
            let own = oscillators(vessel.stability.as_ref(), particulars);
            let all = &mut vessel.origin.sources;
            all.retain(|source| !own.iter().any(|own| own.group == source.group));
            all.extend(own);
        }
        Ok(vessel)
    }

    /// Refuses a vessel without `from` that lacks a particular.
    fn refuse_what_is_missing(&self, table: Of<'_, VesselKey>) -> Read<()> {
        for name in [
            VesselKey::LENGTH_BP,
            VesselKey::BEAM,
            VesselKey::DRAUGHT,
            VesselKey::BLOCK_COEFFICIENT,
        ] {
            if table.item(name).is_none() {
                let help = "give this key, or name a vessel of the library with `from`";
                return Err(self.missing(table, name, help));
            }
        }
        let propeller = any_keys![PropellerKey: DIAMETER, FULL];
        self.refuse_missing_part(table, VesselKey::PROPELLER, propeller)?;
        self.refuse_missing_part(table, VesselKey::RUDDER, any_keys![RudderKey: AREA, SPAN])
    }

    /// Refuses a part of a vessel without `from` that lacks a key.
    fn refuse_missing_part<T>(
        &self,
        table: Of<'_, VesselKey>,
        part: Key<VesselKey, TableOf<T>>,
        keys: &[AnyKey<T>],
    ) -> Read<()> {
        let Some(inner) = table.item(part).map(Entry::table) else { return Ok(()) };
        match keys.iter().find(|key| inner.item(**key).is_none()) {
            None => Ok(()),
            Some(key) => Err(self.missing(inner, *key, "a vessel without `from` needs this key")),
        }
    }

    /// Refuses particulars beside `from`, because they come from the library's vessel.
    fn refuse_other_particulars(&self, table: Of<'_, VesselKey>) -> Read<()> {
        const HERS: &[AnyKey<VesselKey>] = any_keys![
            VesselKey: LENGTH_BP, BEAM, DRAUGHT, BLOCK_COEFFICIENT, CENTRE_OF_GRAVITY, GYRADIUS
        ];
        for name in HERS {
            if let Some(item) = table.item(*name) {
                let error = self.together(table, item, VesselKey::FROM);
                return Err(error.with_help(
                    "remove this key: the particulars come from the vessel of \
                        `from`",
                ));
            }
        }
        self.refuse_other_part(table, VesselKey::PROPELLER, any_keys![PropellerKey: DIAMETER])?;
        self.refuse_other_part(table, VesselKey::RUDDER, any_keys![RudderKey: AREA, SPAN])
    }

    /// Refuses keys of a part that come from the library's vessel.
    fn refuse_other_part<T>(
        &self,
        table: Of<'_, VesselKey>,
        part: Key<VesselKey, TableOf<T>>,
        keys: &[AnyKey<T>],
    ) -> Read<()> {
        let Some(inner) = table.item(part).map(Entry::table) else { return Ok(()) };
        let Some(item) = keys.iter().find_map(|key| inner.item(*key)) else { return Ok(()) };
        let error = self.together(inner, item, VesselKey::FROM);
        Err(error.with_help("remove this key: propeller and rudder come from the vessel of `from`"))
    }
}

fn figure(name: &str, text: &str) -> Figure {
    Figure { name: name.to_owned(), text: text.to_owned() }
}
