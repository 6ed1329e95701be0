//! The normal law (§3.2 of the paper, eq. 2–3).

use crate::model::Material;

/// N = max(0, kS + cṠ) [N], with Ṡ = (S − S_before)/(time since then); for a new contact S_before
/// is 0.
///
/// Eq. 2–3 print −(kS − c dS/dt): with c > 0 that damper pulls the bodies together and makes a
/// bounce leave faster than it came. A contact does not pull either, hence the maximum.
#[inline]
pub(crate) fn normal_force_n(
    material: &Material,
    area_m2: f64,
    area_before_m2: f64,
    elapsed_s: f64,
) -> f64 {
    let growth_m2ps = (area_m2 - area_before_m2) / elapsed_s;
    (material.stiffness_npm2 * area_m2 + material.damping_nspm2 * growth_m2ps).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn damped() -> Material {
        Material {
            stiffness_npm2: 100.0,
            damping_nspm2: 10.0,
            shear_stiffness_npm: 0.0,
            friction_static: 0.0,
            friction_dynamic: 0.0,
            restitution: 0.0,
        }
    }

    #[test]
    fn the_damper_pushes_apart_while_the_overlap_grows_and_never_pulls() {
        assert_eq!(normal_force_n(&damped(), 2.0, 1.0, 0.5), 220.0);
        assert_eq!(normal_force_n(&damped(), 1.0, 2.0, 0.5), 80.0);
        assert_eq!(normal_force_n(&damped(), 0.1, 2.0, 0.5), 0.0);
    }
}
