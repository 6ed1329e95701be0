//! The tangential law: a shear spring with memory (§3.3 of the paper, eq. 4–8).

use crate::model::Material;
use crate::report::Friction;

/// The shear spring after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shear {
    /// Δs (m).
    pub(crate) shear_m: f64,
    /// T on body 1 along t (N).
    pub(crate) force_n: f64,
    pub(crate) friction: Friction,
}

/// Coulomb's limit on the spring, with the limited normal force of this step.
///
/// Stick while |k_s Δs| ≤ μ_s N (eq. 5, with the modulus that eq. 8 omits): T = −k_s Δs. Else slip
/// (eq. 6–7): T = −sgn(Δs) μ_k N, and Δs becomes what that force shears. The paper prints +k_s Δs
/// for its Δs (C₂ − C₁), which pushes with the slip; here Δs is body 1's slip less body 2's.
#[inline]
pub(crate) fn friction(material: &Material, shear_m: f64, normal_force_n: f64) -> Shear {
    let spring_n = material.shear_stiffness_npm * shear_m;
    if spring_n.abs() <= material.friction_static * normal_force_n {
        return Shear { shear_m, force_n: -spring_n, friction: Friction::Stick };
    }
    let sliding_n = (material.friction_dynamic * normal_force_n).copysign(shear_m);
    Shear {
        shear_m: sliding_n / material.shear_stiffness_npm,
        force_n: -sliding_n,
        friction: Friction::Slip,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RUBBER: Material = Material {
        stiffness_npm2: 0.0,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 1000.0,
        friction_static: 0.5,
        friction_dynamic: 0.4,
        restitution: 0.0,
    };

    #[test]
    fn sticks_up_to_the_static_limit_on_both_sides() {
        for sign in [1.0, -1.0] {
            let held = friction(&RUBBER, sign * 0.05, 100.0);
            assert_eq!(held.force_n, -sign * 50.0);
            assert_eq!(held.friction, Friction::Stick);
            assert_eq!(held.shear_m, sign * 0.05);
        }
    }

    #[test]
    fn slips_beyond_it_and_keeps_the_shear_of_the_dynamic_force() {
        for sign in [1.0, -1.0] {
            let slid = friction(&RUBBER, sign * 0.0501, 100.0);
            assert_eq!(slid.force_n, -sign * 40.0);
            assert_eq!(slid.friction, Friction::Slip);
            assert_eq!(slid.shear_m, sign * 0.04);
        }
    }

    #[test]
    fn without_a_shear_spring_there_is_no_tangential_force() {
        let free = friction(&Material { shear_stiffness_npm: 0.0, ..RUBBER }, 3.0, 0.0);
        assert_eq!((free.force_n, free.shear_m), (0.0, 3.0));
    }
}
