//! The study of berthing energy.

use fenderline_sim::BodySetup;
use fenderline_sim::berthing::BerthingSetup;

use crate::assemble::{Assembly, Checked, Names};
use crate::checked::Table;

impl Assembly<'_, '_> {
    pub(super) fn berthing(
        &self,
        table: Option<&Table>,
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<Option<BerthingSetup>> {
        let Some(table) = table else { return Ok(None) };
        let ship = self.floating_body(table, "ship", bodies, names, "it does not berth")?;
        let number = |name: &str| *table.given(name).number();
        Ok(Some(BerthingSetup {
            ship,
            length_bp_m: number("length_bp"),
            beam_m: number("beam"),
            draught_m: number("draught"),
            under_keel_clearance_m: number("under_keel_clearance"),
            block_coefficient: number("block_coefficient"),
            softness: table.given("softness").choice(),
            configuration: table.given("configuration").choice(),
            abnormal_factor: table.item("abnormal_factor").map(|item| *item.number()),
        }))
    }
}
