//! Tugs.

use std::collections::BTreeMap;
use std::fmt::Display;

use fenderline_sim::tug::{TugEnvelope, VectorTug};
use fenderline_sim::{TugSetup, VesselSetup};

use super::assembly::{Assembly, Checked, Names, listed};
use super::orders::places;
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;

impl Assembly<'_, '_> {
    /// An error at a key's value.
    pub(super) fn refused(&self, table: &Table, item: &Item, error: &dyn Display) -> ScenarioError {
        let path = table.path_of(item.name);
        self.sources.error(&item.span, &path, format!("`{path}`: {error}"))
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
            None => match known.clone().next() {
                None => format!("the scenario has no {what}s"),
                Some(_) => format!("there are {}", listed(known)),
            },
        })
    }

    /// The index of the vessel that a key names by its body.
    pub(super) fn vessel_named(
        &self,
        table: &Table,
        item: &Item,
        vessel_of_body: &BTreeMap<usize, usize>,
        names: &Names,
    ) -> Checked<usize> {
        let body = self.body_named(table, item, item.name(), names)?;
        vessel_of_body.get(&body).copied().ok_or_else(|| {
            let path = table.path_of(item.name);
            let message = format!("`{path}`: body {} is not a vessel", quoted(item.name()));
            let error = self.sources.error(&item.span, &path, message);
            error.with_help("give the body a `vessel` in its table")
        })
    }

    pub(super) fn tugs(
        &self,
        tugs: &[(String, Table)],
        vessels: &[VesselSetup],
        names: &Names,
    ) -> Checked<Vec<TugSetup>> {
        let of_body = places(vessels.iter().map(|vessel| vessel.body));
        tugs.iter()
            .map(|(name, table)| {
                let vessel = self.vessel_named(table, table.given("vessel"), &of_body, names)?;
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
                let height = table.given("above_water");
                if !height.is_default && vessels[vessel].seakeeping.is_none() {
                    let message = "the height of the force heels only a vessel with \
                        `hydrodynamics`, and this vessel has none";
                    return Err(self.refused(table, height, &message));
                }
                Ok(TugSetup { vessel, tug, above_water_m: *height.number() })
            })
            .collect()
    }
}
