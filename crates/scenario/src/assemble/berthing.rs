//! Reads the particulars for the comparison of the run's berthing energy with the formula.

use fenderline_sim::berthing::{AddedMass, BerthingSetup};
use fenderline_sim::{Approach, BodySetup, BodyVelocity, Environment, FenderSetup, VesselSetup};

use super::particulars::Taken;
use crate::assemble::assembly::{Assembly, Checked, Names};
use fenderline_keys::checked::Of;
use fenderline_keys::error::NO_EFFECT;
use fenderline_keys::keys::berthing::BerthingKey;

impl Assembly<'_, '_> {
    pub(super) fn berthing(
        &mut self,
        table: Option<Of<'_, BerthingKey>>,
        (bodies, vessels, fenders): (&[BodySetup], &[VesselSetup], &[FenderSetup]),
        approaches: &[Approach],
        environment: &Environment,
        names: &Names,
    ) -> Checked<Option<BerthingSetup>> {
        let Some(table) = table else { return Ok(None) };
        let ship =
            self.floating_body(table, BerthingKey::SHIP, bodies, names, "it does not berth")?;
        let added_mass = match table.item(BerthingKey::ADDED_MASS_FACTOR) {
            None => AddedMass::By(table.given(BerthingKey::ADDED_MASS).choice()),
            Some(factor) if !table.given(BerthingKey::ADDED_MASS).is_default => {
                let path = table.path_to(factor);
                let message = format!("`{path}` does not go together with `added_mass`");
                let error = self.sources.error(&factor.key_span, &path, message);
                return Err(error.with_help("keep only one of the two keys"));
            }
            Some(factor) => AddedMass::Given(*factor.number()),
        };
        let Taken { length_bp_m, beam_m, draught_m, under_keel_clearance_m, block_coefficient } =
            self.particulars(table, ship, (bodies, vessels), environment)?;
        let mut abnormal = table.item(BerthingKey::ABNORMAL_FACTOR);
        // If the berth moves, the approach does not give the closing speed.
        let is_at_rest = |approach: &Approach| {
            let berth = &bodies[fenders[approach.fender].body];
            berth.velocity == BodyVelocity::default()
        };
        let is_abnormal = |approach: &Approach| approach.body == ship && approach.is_abnormal();
        if let (Some(item), true) = (abnormal, approaches.iter().any(is_abnormal)) {
            // The formula takes the speed of the run, which includes the factor.
            let message = format!("{NO_EFFECT}the run itself is already an abnormal berthing");
            self.note_at(&item.span, table.path_to(item), message);
            abnormal = None;
        }
        Ok(Some(BerthingSetup {
            ship,
            length_bp_m,
            beam_m,
            draught_m,
            under_keel_clearance_m,
            block_coefficient,
            design_speed_mps: approaches
                .iter()
                .find(|approach| approach.body == ship && is_at_rest(approach))
                .map(Approach::speed_mps),
            added_mass,
            softness: table.given(BerthingKey::SOFTNESS).choice(),
            configuration: table.given(BerthingKey::CONFIGURATION).choice(),
            abnormal_factor: abnormal.map(|item| *item.number()),
        }))
    }
}
