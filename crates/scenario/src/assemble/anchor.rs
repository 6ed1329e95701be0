//! Anchors.

use fenderline_contact::number::lesser;
use fenderline_contact::vec2;
use fenderline_sim::anchor::{AnchorGear, AnchorType, Windlass};
use fenderline_sim::{
    AnchorSetup, AnchorStart, BodySetup, ChainLink, ChainSize, Environment, VesselSetup,
};

use super::assembly::{Assembly, Checked, Names};
use super::orders::places;
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::keys::anchor::BowSide;

/// Place of a hawse pipe over length and beam, from midship: our assumption.
const HAWSE: (f64, f64) = (0.45, 0.1);

impl Assembly<'_, '_> {
    pub(super) fn anchors(
        &self,
        anchors: &[(String, Table)],
        ships: (&[BodySetup], &[VesselSetup]),
        environment: &Environment,
        names: &Names,
    ) -> Checked<Vec<AnchorSetup>> {
        anchors
            .iter()
            .map(|(name, table)| self.anchor(name, table, ships, environment, names))
            .collect()
    }

    fn anchor(
        &self,
        name: &str,
        table: &Table,
        (bodies, vessels): (&[BodySetup], &[VesselSetup]),
        environment: &Environment,
        names: &Names,
    ) -> Checked<AnchorSetup> {
        let number = |name: &str| *table.given(name).number();
        let optional = |name: &str| table.item(name).map(|item| *item.number());
        let of_body = places(vessels.iter().map(|vessel| vessel.body));
        let index = self.vessel_named(table, table.given("on"), &of_body, names)?;
        let ship = &vessels[index];
        let hull = &ship.ship.particulars;
        let side = match table.given("side").choice::<BowSide>() {
            BowSide::Port => -1.0,
            BowSide::Starboard => 1.0,
        };
        let hawse_m = table.item("hawse").map_or_else(
            || {
                let ahead_m = HAWSE.0 * hull.length_m - hull.centre_of_gravity_m;
                vec2(ahead_m, side * HAWSE.1 * hull.beam_m)
            },
            |item| *item.vector(),
        );
        let factor = table.given("type").choice::<AnchorType>().holding_factor();
        let holding_factor = optional("holding_factor").unwrap_or(factor);
        let dragging_factor = optional("dragging_factor")
            .unwrap_or_else(|| lesser(AnchorGear::DRAGGING_FACTOR, holding_factor));
        if dragging_factor > holding_factor
            && let Some(item) = table.item("dragging_factor")
        {
            let path = table.path_of("dragging_factor");
            let message =
                format!("`{path}` is more than the holding factor, which is {holding_factor}");
            return Err(self.sources.error(&item.span, &path, message));
        }
        let chain = ChainSize {
            diameter_m: number("chain_diameter"),
            grade: table.given("grade").choice(),
            link: ChainLink::Stud,
        };
        let windlass = Windlass::of_rules(&chain);
        let gear = AnchorGear {
            name: name.to_owned(),
            mass_kg: number("mass"),
            chain_diameter_m: chain.diameter_m,
            chain_grade: chain.grade,
            chain_length_m: number("chain_length"),
            holding_factor,
            dragging_factor,
            chain_friction: number("chain_friction"),
            windlass: Windlass {
                brake_n: optional("brake").unwrap_or(windlass.brake_n),
                ..windlass
            },
        };
        let start = self.anchor_start(table)?;
        let anchor = AnchorSetup {
            gear,
            vessel: index,
            hawse_m,
            hawse_above_water_m: number("hawse_height"),
            start,
        };
        let body = &bodies[ship.body];
        anchor.check(body, environment).map_err(|error| self.wrong(table, &error))?;
        Ok(anchor)
    }

    /// Where an anchor is at the start: `placed` and `chain_out` go together.
    fn anchor_start(&self, table: &Table) -> Checked<Option<AnchorStart>> {
        let (placed, chain_out) = (table.item("placed"), table.item("chain_out"));
        let alone = |item: &Item, other: &str| {
            let path = table.path_of(item.name);
            let message = format!("`{path}` needs `{other}`");
            self.sources.error(&item.key_span, &path, message)
        };
        match (placed, chain_out) {
            (None, None) => Ok(None),
            (Some(at), Some(out)) => {
                Ok(Some(AnchorStart { at_m: *at.vector(), chain_m: *out.number() }))
            }
            (Some(at), None) => Err(alone(at, "chain_out")),
            (None, Some(out)) => Err(alone(out, "placed")),
        }
    }
}
