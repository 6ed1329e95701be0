//! Anchors.

use fenderline_contact::number::lesser;
use fenderline_contact::vec2;
use fenderline_sim::anchor::{AnchorGear, Windlass};
use fenderline_sim::{
    AnchorSetup, AnchorStart, BodySetup, ChainLink, ChainSize, Environment, VesselSetup,
};

use super::assembly::{Assembly, Checked, Names};
use super::orders::places;
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::held::Number;
use fenderline_keys::keys::anchor::{AnchorKey, BowSide};
use fenderline_keys::typed_key::{AnyKey, Key};

/// Assumed place of a hawse pipe: its distances ahead of midship and to the side, as shares of the ship's length and
/// beam.
const HAWSE: (f64, f64) = (0.45, 0.1);

impl Assembly<'_, '_> {
    pub(super) fn anchors(
        &self,
        anchors: Tables<'_, AnchorKey>,
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
        table: Of<'_, AnchorKey>,
        (bodies, vessels): (&[BodySetup], &[VesselSetup]),
        environment: &Environment,
        names: &Names,
    ) -> Checked<AnchorSetup> {
        let number = |name: Key<_, Number>| *table.given(name).number();
        let optional = |name: Key<_, Number>| table.item(name).map(|item| *item.number());
        let of_body = places(vessels.iter().map(|vessel| vessel.body));
        let index = self.vessel_named(table, table.given(AnchorKey::ON), &of_body, names)?;
        let ship = &vessels[index];
        let hull = &ship.ship.particulars;
        let side = match table.given(AnchorKey::SIDE).choice() {
            BowSide::Port => -1.0,
            BowSide::Starboard => 1.0,
        };
        let hawse_m = table.item(AnchorKey::HAWSE).map_or_else(
            || {
                let ahead_m = HAWSE.0 * hull.length_m - hull.centre_of_gravity_m;
                vec2(ahead_m, side * HAWSE.1 * hull.beam_m)
            },
            |item| *item.vector(),
        );
        let factor = table.given(AnchorKey::TYPE).choice().holding_factor();
        let holding_factor = optional(AnchorKey::HOLDING_FACTOR).unwrap_or(factor);
        let dragging_factor = optional(AnchorKey::DRAGGING_FACTOR)
            .unwrap_or_else(|| lesser(AnchorGear::DRAGGING_FACTOR, holding_factor));
        if dragging_factor > holding_factor
            && let Some(item) = table.item(AnchorKey::DRAGGING_FACTOR)
        {
            let path = table.path_of(AnchorKey::DRAGGING_FACTOR);
            let message =
                format!("`{path}` is more than the holding factor, which is {holding_factor}");
            return Err(self.sources.error(&item.span, &path, message));
        }
        let chain = ChainSize {
            diameter_m: number(AnchorKey::CHAIN_DIAMETER),
            grade: table.given(AnchorKey::GRADE).choice(),
            link: ChainLink::Stud,
        };
        let windlass = Windlass::of_rules(&chain);
        let gear = AnchorGear {
            name: name.to_owned(),
            mass_kg: number(AnchorKey::MASS),
            chain_diameter_m: chain.diameter_m,
            chain_grade: chain.grade,
            chain_length_m: number(AnchorKey::CHAIN_LENGTH),
            holding_factor,
            dragging_factor,
            chain_friction: number(AnchorKey::CHAIN_FRICTION),
            windlass: Windlass {
                brake_n: optional(AnchorKey::BRAKE).unwrap_or(windlass.brake_n),
                ..windlass
            },
        };
        let start = self.anchor_start(table)?;
        let anchor = AnchorSetup {
            gear,
            vessel: index,
            hawse_m,
            hawse_above_water_m: number(AnchorKey::HAWSE_HEIGHT),
            start,
        };
        let body = &bodies[ship.body];
        anchor.check(body, environment).map_err(|error| self.wrong(table, &error))?;
        Ok(anchor)
    }

    /// Reads where an anchor is at the start; the keys `placed` and `chain_out` must be given together.
    fn anchor_start(&self, table: Of<'_, AnchorKey>) -> Checked<Option<AnchorStart>> {
        let (placed, chain_out) = (table.item(AnchorKey::PLACED), table.item(AnchorKey::CHAIN_OUT));
        let alone = |item: Entry<'_, _>, other: AnyKey<AnchorKey>| {
            let path = table.path_to(item);
            let message = format!("`{path}` needs `{other}`");
            self.sources.error(&item.key_span, &path, message)
        };
        match (placed, chain_out) {
            (None, None) => Ok(None),
            (Some(at), Some(out)) => {
                Ok(Some(AnchorStart { at_m: *at.vector(), chain_m: *out.number() }))
            }
            (Some(at), None) => Err(alone(at.any(), AnchorKey::CHAIN_OUT.any())),
            (None, Some(out)) => Err(alone(out.any(), AnchorKey::PLACED.any())),
        }
    }
}
