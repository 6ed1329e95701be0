//! Reads tugs.

use std::collections::BTreeMap;
use std::fmt::Display;

use fenderline_sim::tug::{TugEnvelope, VectorTug};
use fenderline_sim::{TugSetup, VesselSetup};

use super::assembly::{Assembly, Checked, Names, listed};
use super::orders::places;
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::{Name, Number};
use fenderline_keys::keys::world::TugKey;
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;
use fenderline_keys::typed_key::Key;

impl Assembly<'_, '_> {
    /// Makes an error that points to the value of a key.
    pub(super) fn refused<T, V>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, V>,
        error: &dyn Display,
    ) -> ScenarioError {
        let path = table.path_to(item);
        self.sources.error(&item.span, &path, format!("`{path}`: {error}"))
    }

    pub(super) fn unknown<'n, T, V>(
        &self,
        what: &str,
        table: Of<'_, T>,
        item: Entry<'_, V>,
        name: &str,
        known: impl Iterator<Item = &'n str> + Clone,
    ) -> ScenarioError {
        let path = table.path_to(item);
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

    /// The index of the vessel whose body a key names.
    pub(super) fn vessel_named<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, Name>,
        vessel_of_body: &BTreeMap<usize, usize>,
        names: &Names,
    ) -> Checked<usize> {
        let body = self.body_named(table, item, item.name(), names)?;
        vessel_of_body.get(&body).copied().ok_or_else(|| {
            let path = table.path_to(item);
            let message = format!("`{path}`: body {} is not a vessel", quoted(item.name()));
            let error = self.sources.error(&item.span, &path, message);
            error.with_help("give the body a `vessel` in its table")
        })
    }

    pub(super) fn tugs(
        &self,
        tugs: Tables<'_, TugKey>,
        vessels: &[VesselSetup],
        names: &Names,
    ) -> Checked<Vec<TugSetup>> {
        let of_body = places(vessels.iter().map(|vessel| vessel.body));
        tugs.iter()
            .map(|(name, table)| {
                let vessel =
                    self.vessel_named(table, table.given(TugKey::VESSEL), &of_body, names)?;
                let number = |name: Key<_, Number>| *table.given(name).number();
                let push_at_m = *table.given(TugKey::PUSH_AT).vector();
                let tug = VectorTug {
                    name: name.clone(),
                    envelope: TugEnvelope {
                        bollard_pull_n: number(TugKey::BOLLARD_PULL),
                        length_m: number(TugKey::LENGTH),
                        beam_m: number(TugKey::BEAM),
                        draught_m: number(TugKey::DRAUGHT),
                        drag_coefficient: 0.73,
                    },
                    push_at_m,
                    pull_at_m: table.item(TugKey::PULL_AT).map_or(push_at_m, |item| *item.vector()),
                    delay_s: number(TugKey::DELAY),
                    force_lag_s: number(TugKey::LAG),
                    direction_lag_s: number(TugKey::LAG),
                };
                tug.check().map_err(|error| self.wrong(table, &error))?;
                let height = table.given(TugKey::ABOVE_WATER);
                if !height.is_default && vessels[vessel].seakeeping.is_none() {
                    let message = "the height of the force has an effect only on a vessel with \
                                   `hydrodynamics`, and this vessel has no `hydrodynamics`";
                    return Err(self.refused(table, height, &message));
                }
                Ok(TugSetup { vessel, tug, above_water_m: *height.number() })
            })
            .collect()
    }
}
