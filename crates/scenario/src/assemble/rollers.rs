//! Roller and wheel fenders: the face rolls along the hull, so rolling resistance takes the place of friction.

use fenderline_sim::{FenderSetup, NamedMaterial};

use super::assembly::{Assembly, Checked};
use fenderline_keys::checked::Tables;
use fenderline_keys::keys::fender::FenderKey;
use fenderline_keys::keys::material::MaterialKey;

impl Assembly<'_, '_> {
    /// Gives each roller fender its own material, which is the material in the fender's table with the rolling
    /// resistance as friction. Equal roller fenders share a material.
    ///
    /// # Errors
    /// Fails if a fender has a rolling resistance and its material has no shear stiffness.
    pub(super) fn roll(
        &self,
        of_materials: Tables<'_, MaterialKey>,
        tables: Tables<'_, FenderKey>,
        fenders: &mut [FenderSetup],
        materials: &mut Vec<NamedMaterial>,
    ) -> Checked<()> {
        for ((_, table), fender) in tables.iter().zip(fenders) {
            let Some(item) = table.item(FenderKey::ROLLING_RESISTANCE) else { continue };
            let resistance = *item.number();
            let NamedMaterial { name, mut material } = materials[fender.material].clone();
            self.need_shear_stiffness(table, item, of_materials.at(fender.material))?;
            material.friction_static = resistance;
            material.friction_dynamic = resistance;
            let name = format!("{name}, rolling resistance {resistance}");
            let known = materials.iter().position(|known| known.name == name);
            fender.material = known.unwrap_or_else(|| {
                materials.push(NamedMaterial { name, material });
                materials.len() - 1
            });
        }
        Ok(())
    }
}
