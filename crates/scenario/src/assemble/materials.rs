//! Materials.

use fenderline_contact::Material;
use fenderline_sim::NamedMaterial;

use super::assembly::{Assembly, Checked};
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::error::Notice;
use fenderline_keys::held::Number;
use fenderline_keys::keys::material::MaterialKey;

/// Coefficient of friction above which there is a warning. Rubber on dry steel or concrete has a coefficient of about
/// 1, polyethylene facings of about 0.2 (from memory, not from a source); the margin is for rough surfaces.
const HIGHEST_USUAL_FRICTION: f64 = 1.5;

impl Assembly<'_, '_> {
    pub(super) fn materials(
        &mut self,
        materials: Tables<'_, MaterialKey>,
    ) -> Checked<Vec<NamedMaterial>> {
        let mut read = |(name, table): (&String, Of<'_, _>)| {
            Ok(NamedMaterial { name: name.clone(), material: self.material(table)? })
        };
        materials.iter().map(&mut read).collect()
    }

    pub(super) fn material(&mut self, table: Of<'_, MaterialKey>) -> Checked<Material> {
        let friction_static = *table.given(MaterialKey::FRICTION_STATIC).number();
        let dynamic = table.item(MaterialKey::FRICTION_DYNAMIC);
        let friction_dynamic = dynamic.map_or(friction_static, |item| *item.number());
        if let Some(item) = dynamic.filter(|_| friction_dynamic > friction_static) {
            let path = table.path_of(MaterialKey::FRICTION_DYNAMIC);
            let message = format!(
                "`{path}` must be at most `friction_static`, which is {friction_static}, but is \
                 {friction_dynamic}"
            );
            return Err(self.sources.error(&item.span, &path, message));
        }
        let item = table.given(MaterialKey::FRICTION_STATIC);
        self.need_shear_stiffness(table, item, table)?;
        if friction_static > HIGHEST_USUAL_FRICTION {
            self.notices.push(Notice {
                place: self.sources.place(&item.span),
                key: table.path_of(MaterialKey::FRICTION_STATIC),
                message: format!(
                    "a coefficient of friction of {friction_static} is more than \
                     {HIGHEST_USUAL_FRICTION}; facings, rubber, steel and concrete mostly have 0.1 \
                     to 1 on each other, so hulls will stick rather than slide"
                ),
            });
        }
        Ok(Material {
            stiffness_npm2: *table.given(MaterialKey::STIFFNESS).number(),
            damping_nspm2: *table.given(MaterialKey::DAMPING).number(),
            shear_stiffness_npm: *table.given(MaterialKey::SHEAR_STIFFNESS).number(),
            friction_static,
            friction_dynamic,
            restitution: *table.given(MaterialKey::RESTITUTION).number(),
        })
    }

    /// Refuses friction or rolling resistance on a material without shear stiffness. In the paper on the contact method
    /// (Moreno and others, 2023), friction acts as the force of a shear spring (eq. 4). The stiffness of the shear
    /// spring is a parameter of the fender (Table 1) and does not follow from other parameters; with a stiffness of
    /// zero there is no friction at any slip. A default of the shear stiffness would give wrong results without a
    /// message, because the stiffness decides how far a hull moves before it slides, and how the hull surges alongside.
    pub(super) fn need_shear_stiffness<T>(
        &self,
        of: Of<'_, T>,
        friction: Entry<'_, Number>,
        material: Of<'_, MaterialKey>,
    ) -> Checked<()> {
        if *friction.number() == 0.0 || *material.given(MaterialKey::SHEAR_STIFFNESS).number() > 0.0
        {
            return Ok(());
        }
        let path = of.path_to(friction);
        let key = material.path_of(MaterialKey::SHEAR_STIFFNESS);
        let message = format!(
            "`{path}` needs `{key}`: friction acts through a shear spring, and is zero if the \
             spring has no stiffness"
        );
        let error = self.sources.error(&friction.span, &path, message);
        Err(error.with_help(
            "write shear_stiffness = \"3000 kN/m\", which is the value of the paper, or the value \
             of the fender's maker; for a contact without friction, remove `friction_static`",
        ))
    }
}
