//! The tangential law: a shear spring limited by Coulomb friction (§3.3 of the paper, eq. 4–8).
//!
//! The force of the shear spring is T = −k_s Δs, where Δs is the slip of body 1 less the slip of body 2. [`Coulomb`] is
//! the friction law, which both the paper's method and the coupled method use. [`friction`] is the explicit form of the
//! tangential law, for the paper's method. [`ShearSpring`] is the implicit form of the tangential law, for the coupled
//! method, whose solver varies T and N together.

use crate::maths::number::bounded;
use crate::model::material::Material;
use crate::state::report::Friction;

/// Coulomb's friction law for one contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Coulomb {
    /// The ratio |T|/N of tangential to normal force at which sticking ends.
    holding: f64,
    /// The ratio |T|/N of tangential to normal force while slipping: μ_k.
    sliding: f64,
}

impl Coulomb {
    /// Coulomb's law of a contact at rest, which sticks up to the static coefficient μ_s.
    #[inline(always)]
    fn of(material: &Material) -> Coulomb {
        Coulomb { holding: material.friction_static, sliding: material.friction_dynamic }
    }

    /// Coulomb's law of a contact that already slides, which sticks only up to the sliding coefficient μ_k.
    #[inline(always)]
    fn of_sliding(material: &Material) -> Coulomb {
        Coulomb { holding: material.friction_dynamic, sliding: material.friction_dynamic }
    }

    /// Returns true if a contact with these forces sticks. The condition is |T| ≤ μ_s N (eq. 5, with the absolute value
    /// that eq. 8 omits).
    #[inline]
    pub(crate) fn holds(&self, tangential_n: f64, normal_n: f64) -> bool {
        tangential_n.abs() <= self.holding * normal_n
    }

    /// The tangential force T that follows from the spring's force: the spring's force while the contact sticks, else
    /// μ_k N in the direction of the spring's force (eq. 6–7).
    ///
    /// A contact that has slipped in this sub-step sticks again only below the sliding force. If a contact could stick
    /// again sooner, the solver's sweeps would alternate between sticking and slipping where μ_k is less than μ_s.
    #[inline]
    fn limited(&self, spring_n: f64, normal_n: f64, now: Friction) -> (f64, Friction) {
        if spring_n.abs() <= self.coefficient(now) * normal_n {
            (spring_n, Friction::Stick)
        } else {
            ((self.sliding * normal_n).copysign(spring_n), Friction::Slip)
        }
    }

    /// The largest ratio |T|/N in this state of friction.
    #[inline]
    fn coefficient(&self, state: Friction) -> f64 {
        match state {
            Friction::Stick => self.holding,
            Friction::Slip => self.sliding,
        }
    }

    /// The tangential force T, limited to what the normal force N allows in this state of friction.
    pub(crate) fn clamped(&self, tangential_n: f64, normal_n: f64, state: Friction) -> f64 {
        let most_n = self.coefficient(state) * normal_n;
        bounded(tangential_n, -most_n, most_n)
    }

    /// The slope |dT/dN| of the tangential force while the contact slips.
    #[inline]
    pub(crate) fn sliding_slope(&self) -> f64 {
        self.sliding
    }

    /// The shear Δs after slipping: at most the shear that belongs to the sliding force.
    #[inline]
    fn limited_shear_m(&self, shear_m: f64, normal_n: f64, stiffness_npm: f64) -> f64 {
        let most_m = self.sliding * normal_n / stiffness_npm;
        bounded(shear_m, -most_m, most_m)
    }
}

/// The shear spring of the paper's method after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shear {
    /// Δs (m).
    pub(crate) shear_m: f64,
    /// Tangential force T on body 1 along the tangent t (N).
    pub(crate) force_n: f64,
    pub(crate) friction: Friction,
}

/// Computes the force of the shear spring within Coulomb's limit, for the normal force that momentum allows in this
/// step (eq. 4–8).
///
/// A contact that slips keeps the shear Δs that belongs to its force. The paper prints +k_s Δs for its Δs (C₂ − C₁), a
/// force that pushes along the slip; here Δs is the slip of body 1 less that of body 2.
#[inline]
pub(crate) fn friction(material: &Material, shear_m: f64, normal_force_n: f64) -> Shear {
    let spring_n = -material.shear_stiffness_npm * shear_m;
    let (force_n, friction) =
        Coulomb::of(material).limited(spring_n, normal_force_n, Friction::Stick);
    let shear_m = match friction {
        Friction::Stick => shear_m,
        Friction::Slip => -force_n / material.shear_stiffness_npm,
    };
    Shear { shear_m, force_n, friction }
}

/// The shear spring of the coupled method in one sub-step: T = −k_s(Δs + ϑ h V̄) with V̄ = (1 − ϑ) V_t + ϑ V_t⁺. The
/// tangential force T is linear in the tangential speed V_t⁺ after the sub-step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ShearSpring {
    pub(crate) coulomb: Coulomb,
    slide: Slide,
    /// k_s (N/m).
    pub(crate) stiffness_npm: f64,
    /// ϑ: see [`implicit_share`].
    implicit: f64,
    /// Tangential force T of the spring at V_t⁺ = 0 (N).
    pub(crate) force_at_rest_n: f64,
    /// Slope −dT/dV_t⁺ of the spring's force: c = ϑ² k_s h (N·s/m).
    pub(crate) slope: f64,
    /// Tangential speed V_t at the start of the sub-step (m/s).
    pub(crate) before_mps: f64,
    /// The most energy that the tangential force may give to the bodies in this sub-step: the energy that the spring
    /// stores (J).
    pub(crate) available_j: f64,
}

/// The friction state with which a contact enters a sub-step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Slide {
    /// The contact begins in this sub-step.
    #[default]
    Begins,
    /// The contact sticks.
    Holds,
    /// The contact slides.
    Slides,
}

/// The state of a shear spring at the start of a sub-step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShearStart {
    /// Δs (m).
    pub(crate) shear_m: f64,
    /// V_t (m/s).
    pub(crate) speed_mps: f64,
    /// t·K t (1/kg).
    pub(crate) inverse_mass: f64,
    /// Length of the sub-step (s).
    pub(crate) h: f64,
    pub(crate) slide: Slide,
    /// Energy that the spring has taken from the bodies and still stores (J).
    pub(crate) stored_j: f64,
}

impl ShearSpring {
    #[inline(always)]
    pub(crate) fn new(material: &Material, start: &ShearStart) -> ShearSpring {
        let ShearStart { shear_m, speed_mps, inverse_mass, h, slide, stored_j } = *start;
        let implicit = implicit_share(material.shear_stiffness_npm * inverse_mass, h);
        let explicit_m = implicit * (1.0 - implicit) * h * speed_mps;
        ShearSpring {
            coulomb: match slide {
                Slide::Slides => Coulomb::of_sliding(material),
                Slide::Begins | Slide::Holds => Coulomb::of(material),
            },
            slide,
            stiffness_npm: material.shear_stiffness_npm,
            implicit,
            force_at_rest_n: -material.shear_stiffness_npm * (shear_m + explicit_m),
            slope: implicit * implicit * material.shear_stiffness_npm * h,
            before_mps: speed_mps,
            available_j: stored_j,
        }
    }

    /// The spring's force for this tangential speed V_t⁺, without Coulomb's limit (N).
    #[inline]
    pub(crate) fn force_n(&self, after_mps: f64) -> f64 {
        self.force_at_rest_n - self.slope * after_mps
    }

    /// The spring's force if the tangential speed V_t⁺ would be `without_mps` without a tangential force (N).
    #[inline]
    pub(crate) fn implicit_force_n(&self, without_mps: f64, h: f64, inverse_mass: f64) -> f64 {
        self.force_n(without_mps) / (1.0 + self.slope * h * inverse_mass)
    }

    /// Computes the tangential force T and the friction state for this normal force; without T, the speed V_t⁺ would be
    /// `without_mps`. The tangential force T is the spring's force, limited by Coulomb's law and then by the spring's
    /// energy.
    #[inline]
    pub(crate) fn solve(
        &self,
        without_mps: f64,
        normal_n: f64,
        now: Friction,
        inverse_mass: f64,
        h: f64,
    ) -> (f64, Friction) {
        if self.stiffness_npm == 0.0 {
            return (0.0, Friction::Stick);
        }
        let spring_n = self.implicit_force_n(without_mps, h, inverse_mass);
        let (wanted_n, friction) = self.coulomb.limited(spring_n, normal_n, now);
        (self.passive(without_mps, wanted_n, inverse_mass, h), friction)
    }

    /// Returns `tangential_n`, or a smaller tangential force if `tangential_n` would give the bodies more energy than
    /// the spring stores.
    ///
    /// The work of T on the bodies is T h (½ T h t·K t + s), where s is the mean of two tangential speeds: V_t before
    /// the sub-step, and V_t⁺ at T = 0. With the midpoint rule the spring keeps this energy limit by itself. A spring
    /// with a larger implicit share ϑ does not keep the energy limit if other forces change V_t. A spring whose
    /// direction t turns with its body does not keep the energy limit either.
    #[inline]
    fn passive(&self, without_mps: f64, tangential_n: f64, inverse_mass: f64, h: f64) -> f64 {
        let mean_mps = 0.5 * (self.before_mps + without_mps);
        let work_j = tangential_n * h * (0.5 * tangential_n * h * inverse_mass + mean_mps);
        if work_j <= self.available_j {
            return tangential_n;
        }
        let root = libm::sqrt(mean_mps * mean_mps + 2.0 * inverse_mass * self.available_j);
        (root.copysign(tangential_n) - mean_mps) / (h * inverse_mass)
    }

    /// Returns true if the tangential force keeps within Coulomb's limit and the spring's energy, for this normal force
    /// and this V_t⁺.
    #[inline]
    pub(crate) fn is_within_bounds(
        &self,
        tangential_n: f64,
        normal_n: f64,
        after_mps: f64,
        h: f64,
    ) -> bool {
        let gives_j = 0.5 * h * tangential_n * (self.before_mps + after_mps);
        self.coulomb.holds(tangential_n, normal_n) && gives_j <= self.available_j
    }

    /// Returns true if the spring stores the energy that its force would give the bodies at this V_t⁺.
    #[inline]
    pub(crate) fn has_energy_for(&self, after_mps: f64, h: f64) -> bool {
        0.5 * h * self.force_n(after_mps) * (self.before_mps + after_mps) <= self.available_j
    }

    /// Computes the shear Δs at the end of the sub-step from Δs at the start (m). In a sub-step the shear Δs grows by h
    /// V̄. While the contact slips, the shear Δs is at most the shear that belongs to the sliding force.
    #[inline]
    pub(crate) fn shear_after_m(
        &self,
        shear_m: f64,
        after_mps: f64,
        normal_n: f64,
        friction: Friction,
        h: f64,
    ) -> f64 {
        let share = self.implicit;
        let mean_mps = (1.0 - share) * self.before_mps + share * after_mps;
        let grown_m = shear_m + h * mean_mps;
        match friction {
            Friction::Stick => grown_m,
            Friction::Slip => self.coulomb.limited_shear_m(grown_m, normal_n, self.stiffness_npm),
        }
    }

    /// Returns true if the contact still slides in the next sub-step. The shear Δs and the speed V_t⁺ are those at the
    /// end of this sub-step.
    ///
    /// A slide begins when the spring's force passes the limit of static friction. A slide ends when the tangential
    /// speed V_t turns back against the stretched spring. A spring force below μ_k N does not end a slide, because N
    /// can jump within a sub-step, and the slide would then have to pass μ_s N again. A slip in the sub-step of the
    /// first touch does not begin a slide: the normal force then belongs to the start of the sub-step, when there was
    /// hardly any overlap, and the tangential force to the end.
    #[inline]
    pub(crate) fn slides_on(&self, shear_m: f64, after_mps: f64, friction: Friction) -> bool {
        match (self.slide, friction) {
            (Slide::Begins, _) | (Slide::Holds, Friction::Stick) => false,
            (_, Friction::Slip) => true,
            (Slide::Slides, Friction::Stick) => shear_m * after_mps > 0.0,
        }
    }

    /// ½ k_s Δs² (J).
    #[inline]
    pub(crate) fn stored_j(&self, shear_m: f64) -> f64 {
        0.5 * self.stiffness_npm * shear_m * shear_m
    }
}

/// The implicit share ϑ of the shear spring; `rate_squared` is the square of its natural frequency, k_s t·K t (1/s²).
///
/// With ϑ = ½, the midpoint rule, the spring keeps its energy exactly. With ϑ = 1, backward Euler, the spring would
/// lose ωh/2 per radian: with the sub-steps that the normal law needs, a tug that rolls along a ship's side would leave
/// with a yaw rate wrong by a seventh. If the sub-step is long compared with the spring's period, ϑ rises to 1, so that
/// the spring does not ring at k_s h²/m ≫ 1. The spring is stable for any ϑ ≥ ½. Of all values, only ϑ = ½ creates no
/// energy by itself: see [`ShearSpring::passive`].
#[inline]
fn implicit_share(rate_squared: f64, h: f64) -> f64 {
    let turn_squared = rate_squared * h * h;
    if turn_squared <= 1.0 { 0.5 } else { 1.0 - 0.5 / libm::sqrt(turn_squared) }
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
    fn slips_beyond_the_static_limit_with_the_shear_of_the_dynamic_force() {
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

    /// Both methods have the same law: in a sub-step so short that nothing moves, the implicit spring gives the paper's
    /// force.
    #[test]
    fn the_implicit_spring_has_the_same_limits_as_the_explicit_one() {
        for shear_m in [-0.2, -0.0501, -0.05, 0.0, 0.03, 0.0501, 0.2] {
            let start = ShearStart {
                shear_m,
                speed_mps: 0.0,
                inverse_mass: 1e-6,
                h: 1e-9,
                slide: Slide::Holds,
                stored_j: f64::MAX,
            };
            let spring = ShearSpring::new(&RUBBER, &start);
            let (force_n, state) = spring.solve(0.0, 100.0, Friction::Stick, 1e-6, 1e-9);
            let explicit = friction(&RUBBER, shear_m, 100.0);
            assert_eq!((force_n, state), (explicit.force_n, explicit.friction), "{shear_m}");
        }
    }
}
