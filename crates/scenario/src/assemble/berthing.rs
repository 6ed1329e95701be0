//! The study of berthing energy.

use fenderline_sim::berthing::{AddedMass, BerthingSetup};
use fenderline_sim::{Approach, BodySetup, BodyVelocity, Environment, FenderSetup, VesselSetup};

use super::particulars::Taken;
use crate::assemble::assembly::{Assembly, Checked, Names};
use fenderline_keys::checked::Table;
use fenderline_keys::error::NO_EFFECT;

impl Assembly<'_, '_> {
    pub(super) fn berthing(
        &mut self,
        table: Option<&Table>,
        (bodies, vessels, fenders): (&[BodySetup], &[VesselSetup], &[FenderSetup]),
        approaches: &[Approach],
        environment: &Environment,
        names: &Names,
    ) -> Checked<Option<BerthingSetup>> {
        let Some(table) = table else { return Ok(None) };
        let ship = self.floating_body(table, "ship", bodies, names, "it does not berth")?;
        let added_mass = match table.item("added_mass_factor") {
            None => AddedMass::By(table.given("added_mass").choice()),
            Some(factor) if !table.given("added_mass").is_default => {
                let path = table.path_of(factor.name);
                let message = format!("`{path}` does not go together with `added_mass`");
                let error = self.sources.error(&factor.key_span, &path, message);
                return Err(error.with_help("keep one of the two"));
            }
            Some(factor) => AddedMass::Given(*factor.number()),
        };
        let Taken { length_bp_m, beam_m, draught_m, under_keel_clearance_m, block_coefficient } =
            self.particulars(table, ship, (bodies, vessels), environment)?;
        let mut abnormal = table.item("abnormal_factor");
        // If the berth moves, the approach does not give the closing speed.
        let is_at_rest = |approach: &Approach| {
            let berth = &bodies[fenders[approach.fender].body];
            berth.velocity == BodyVelocity::default()
        };
        let is_abnormal = |approach: &Approach| approach.body == ship && approach.is_abnormal();
        if let (Some(item), true) = (abnormal, approaches.iter().any(is_abnormal)) {
            // The formula takes the speed of the run, which includes the factor.
            let message = format!("{NO_EFFECT}the run itself is already an abnormal berthing");
            self.note_at(&item.span, table.path_of(item.name), message);
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
            softness: table.given("softness").choice(),
            configuration: table.given("configuration").choice(),
            abnormal_factor: abnormal.map(|item| *item.number()),
        }))
    }
}
