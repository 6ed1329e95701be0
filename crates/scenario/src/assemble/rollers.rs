//! Roller and wheel fenders: their face rolls along the hull, so that rolling resistance takes the place of friction.

use fenderline_sim::{FenderSetup, NamedMaterial};

use super::Assembly;
use crate::checked::Table;
use crate::sources::quoted;

impl Assembly<'_, '_> {
    /// Gives each roller fender a material of its own: that of its table, with the rolling resistance for its friction.
    /// Rollers that differ in nothing share one.
    pub(super) fn roll(
        &mut self,
        tables: &[(String, Table)],
        fenders: &mut [FenderSetup],
        materials: &mut Vec<NamedMaterial>,
    ) {
        for ((_, table), fender) in tables.iter().zip(fenders) {
            let Some(item) = table.item("rolling_resistance") else { continue };
            let resistance = *item.number();
            let NamedMaterial { name, mut material } = materials[fender.material].clone();
            if resistance > 0.0 && material.shear_stiffness_npm <= 0.0 {
                let message =
                    format!("no effect: the material {} has no `shear_stiffness`", quoted(&name));
                self.note_at(&item.span, table.path_of(item.name), message);
            }
            material.friction_static = resistance;
            material.friction_dynamic = resistance;
            let name = format!("{name}, rolling resistance {resistance}");
            let known = materials.iter().position(|known| known.name == name);
            fender.material = known.unwrap_or_else(|| {
                materials.push(NamedMaterial { name, material });
                materials.len() - 1
            });
        }
    }
}
