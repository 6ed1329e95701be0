//! A contact constraint: one contact between two bodies in the form that the solver uses.
//!
//! The normal force N lies between 0 and the law's force f, and the tangential force T follows the shear spring within
//! Coulomb's limit ([`crate::law::friction`]). Velocities in a constraint are those of body A relative to body B along
//! the normal n and the tangent t.

use crate::law::friction::{ShearSpring, ShearStart, Slide};
use crate::maths::number::{greater, lesser};
use crate::maths::vec2::Vec2;
use crate::model::mass::{InverseMatrix, Response};
use crate::model::material::Material;
use crate::state::body_state::Velocity;
use crate::state::report::Friction;
use crate::touch::levers::Levers;
use crate::touch::{Movers, Touch};

/// The solver damps the sweeps over a sliding contact if they would overshoot by more than this factor. With less
/// overshoot the sweeps converge without damping, in less than 50 sweeps.
const OVERSHOOT: f64 = 0.5;

/// The forces of a contact and all data of the contact that a solver sweep needs. A solver sweep reads only constraints
/// and the velocities of the bodies.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Constraint {
    /// Ranks of the two bodies A and B of the contact.
    pub(crate) a: u32,
    pub(crate) b: u32,
    /// Whether body A floats, and whether body B floats. Contact forces change the motion of floating bodies only.
    a_floats: bool,
    b_floats: bool,
    pub(crate) movers: Movers,
    /// Normal n of the contact, and the levers of n and of the tangent t about each body's centre of gravity (m).
    pub(crate) normal: Vec2,
    levers_a: Levers,
    levers_b: Levers,
    /// The inverse of the effective mass at the contact: n·K n, t·K n and t·K t (1/kg).
    pub(crate) inverse_mass: Response,
    /// The time κ for which the contact's forces act on the velocities in this sub-step (s).
    pub(crate) kick_s: f64,
    /// Normal speed V_n of the two bodies at the start of the sub-step (m/s).
    pub(crate) normal_before_mps: f64,
    /// Force f of the normal law, the upper bound of the normal force N (N).
    pub(crate) law_n: f64,
    /// Rebound speed γ v_ref: after the solve, the normal speed V_n⁺ may not be below −γ v_ref (m/s).
    pub(crate) rebound_mps: f64,
    /// The most energy that the normal force N may give to the bodies in this sub-step (J).
    pub(crate) available_j: f64,
    /// Energy stored in the contact that no load balances (J): see [`super::release`].
    pub(crate) unbalanced_j: f64,
    pub(crate) shear: ShearSpring,
    /// Whether the normal force was less than the force of its law in the last step or sub-step.
    pub(crate) was_limited: bool,
    /// The bound that decides the normal force N in the direct solve, while this solve includes bounds other than the
    /// law's force.
    pub(crate) bound: NormalBound,
    /// The forces of the contact with which the sweeps begin. After the solve, these are the resulting forces of the
    /// contact.
    pub(crate) forces: Forces,
    /// Normal speed V_n⁺ and tangential speed V_t⁺ after the solve (m/s).
    pub(crate) after: Speeds,
}

/// Which bound decides N.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum NormalBound {
    /// N = f.
    #[default]
    Full,
    /// V_n⁺ = −γ v_ref.
    Tight,
    /// N = 0.
    Open,
}

/// Normal force N and tangential force T of a contact (N), and whether the contact slips.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Forces {
    pub(crate) normal_n: f64,
    pub(crate) tangential_n: f64,
    pub(crate) friction: Friction,
}

impl Forces {
    /// The change of the normal and the tangential force from the forces `other` to these forces.
    #[inline]
    pub(crate) fn minus(&self, other: &Forces) -> Change {
        Change {
            normal_n: self.normal_n - other.normal_n,
            tangential_n: self.tangential_n - other.tangential_n,
        }
    }

    #[inline]
    pub(crate) fn change(&self) -> Change {
        Change { normal_n: self.normal_n, tangential_n: self.tangential_n }
    }
}

/// A change of the normal force N and the tangential force T of a contact (N).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Change {
    pub(crate) normal_n: f64,
    pub(crate) tangential_n: f64,
}

impl Change {
    pub(crate) const NONE: Change = Change { normal_n: 0.0, tangential_n: 0.0 };
}

/// Normal speed V_n and tangential speed V_t of a contact (m/s).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Speeds {
    pub(crate) normal_mps: f64,
    pub(crate) tangential_mps: f64,
}

/// The results of the contact laws for one contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Laws<'m> {
    pub(crate) material: &'m Material,
    /// f (N).
    pub(crate) law_n: f64,
    /// γ v_ref (m/s).
    pub(crate) rebound_mps: f64,
    /// The most energy that the normal force may give to the bodies in this sub-step (J), and the same for the
    /// tangential force.
    pub(crate) available_j: f64,
    pub(crate) shear_available_j: f64,
    /// Energy stored in the contact that no load balances (J).
    pub(crate) unbalanced_j: f64,
    pub(crate) slide: Slide,
    /// Whether the normal force was less than the force of its law in the last step or sub-step.
    pub(crate) was_limited: bool,
    /// Length h of the sub-step, and the time κ for which the contact's forces act (s).
    pub(crate) h: f64,
    pub(crate) kick_s: f64,
}

/// One of the two bodies of a contact, A or B.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    A,
    B,
}

impl Side {
    #[inline(always)]
    pub(crate) fn other(self) -> Side {
        match self {
            Side::A => Side::B,
            Side::B => Side::A,
        }
    }

    /// The sign of the side: 1 for A and −1 for B, because velocities and forces are those of A relative to B.
    #[inline(always)]
    pub(crate) fn sign(self) -> f64 {
        match self {
            Side::A => 1.0,
            Side::B => -1.0,
        }
    }
}

/// One body's part of the Jacobian of a constraint: the normal n, and the levers of n and of the tangent t.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jacobian {
    pub(crate) normal: Vec2,
    pub(crate) levers: Levers,
}

impl Jacobian {
    /// Normal and tangential speed of the contact if only this body moves, in the role of body A.
    #[inline(always)]
    pub(crate) fn speeds(&self, (velocity_mps, turn_radps): Velocity) -> Speeds {
        Speeds {
            normal_mps: velocity_mps.dot(self.normal) + turn_radps * self.levers.n_m,
            tangential_mps: velocity_mps.dot(self.normal.quarter_turn())
                + turn_radps * self.levers.t_m,
        }
    }

    /// The force −N n + T t of the contact on body A, and the moment of this force.
    #[inline(always)]
    pub(crate) fn wrench(&self, normal_n: f64, tangential_n: f64) -> (Vec2, f64) {
        (
            self.normal.quarter_turn() * tangential_n - self.normal * normal_n,
            self.levers.t_m * tangential_n - self.levers.n_m * normal_n,
        )
    }
}

impl Constraint {
    /// Makes the constraint of a contact between two bodies, given by rank and inverse mass; `forces` are the forces
    /// with which the solve begins.
    #[cfg(test)]
    pub(crate) fn new(
        a: (u32, &InverseMatrix),
        b: (u32, &InverseMatrix),
        touch: &Touch,
        laws: &Laws,
        forces: Forces,
    ) -> Constraint {
        let mut constraint = Constraint::default();
        let floats = [a.1, b.1].map(InverseMatrix::floats);
        constraint.set_kinematics([a.0, b.0], Movers::of(floats), touch);
        let response_a = Response::of(a.1, touch.normal, touch.levers_a);
        let response_b = Response::of(b.1, touch.normal, touch.levers_b);
        constraint.set_masses(Response::both(response_a, response_b), floats);
        constraint.set_laws(touch, laws, forces);
        constraint
    }

    /// Sets the bodies, the Jacobian and the normal speed V_n of the constraint.
    // The constraint is set in three steps, each in place, as soon as the inputs are known.
    #[inline(always)]
    pub(crate) fn set_kinematics(&mut self, [a, b]: [u32; 2], movers: Movers, touch: &Touch) {
        let Touch { normal, levers_a, levers_b, .. } = *touch;
        (self.a, self.b, self.movers) = (a, b, movers);
        (self.normal, self.levers_a, self.levers_b) = (normal, levers_a, levers_b);
        self.normal_before_mps = touch.v_normal_mps;
    }

    /// Sets the effective mass of the contact, and whether A and B float.
    #[inline(always)]
    pub(crate) fn set_masses(&mut self, inverse_mass: Response, [a_floats, b_floats]: [bool; 2]) {
        (self.a_floats, self.b_floats) = (a_floats, b_floats);
        self.inverse_mass = inverse_mass;
    }

    /// Sets the bounds that the contact laws give, and the forces with which the sweeps begin.
    #[inline(always)]
    pub(crate) fn set_laws(&mut self, touch: &Touch, laws: &Laws<'_>, forces: Forces) {
        let start = ShearStart {
            shear_m: touch.shear_m,
            speed_mps: touch.v_tangential_mps,
            inverse_mass: self.inverse_mass.tangential,
            h: laws.h,
            slide: laws.slide,
            stored_j: laws.shear_available_j,
        };
        self.shear = ShearSpring::new(laws.material, &start);
        self.kick_s = laws.kick_s;
        self.law_n = laws.law_n;
        self.rebound_mps = laws.rebound_mps;
        self.available_j = laws.available_j;
        self.unbalanced_j = laws.unbalanced_j;
        self.was_limited = laws.was_limited;
        self.forces = forces;
    }

    /// The normal and the tangential speed of the contact for these velocities of the bodies.
    #[inline]
    pub(crate) fn speeds(&self, velocities: &[Velocity]) -> Speeds {
        let (normal_mps, tangential_mps) = self.movers.speeds(
            || velocities[self.a as usize],
            || velocities[self.b as usize],
            (self.normal, self.levers_a, self.levers_b),
        );
        Speeds { normal_mps, tangential_mps }
    }

    /// Changes the velocities of the two bodies by the impulse of the contact's forces over the sub-step h.
    #[inline(always)]
    pub(crate) fn apply_impulse(
        &self,
        velocities: &mut [Velocity],
        inverses: &[InverseMatrix],
        forces: Change,
        h: f64,
    ) {
        let (normal_ns, tangential_ns) = (forces.normal_n * h, forces.tangential_n * h);
        if self.a_floats {
            let (impulse, moment) = self.jacobian(Side::A).wrench(normal_ns, tangential_ns);
            let (dv, dr) = self.response(inverses, self.a, impulse, moment);
            let (velocity_mps, turn_radps) = &mut velocities[self.a as usize];
            *velocity_mps += dv;
            *turn_radps += dr;
        }
        if self.b_floats {
            let (impulse, moment) = self.jacobian(Side::B).wrench(normal_ns, tangential_ns);
            let (dv, dr) = self.response(inverses, self.b, impulse, moment);
            let (velocity_mps, turn_radps) = &mut velocities[self.b as usize];
            *velocity_mps -= dv;
            *turn_radps -= dr;
        }
    }

    /// The change of velocity and yaw rate that an impulse and its moment give to a floating body of the contact.
    #[inline(always)]
    fn response(
        &self,
        inverses: &[InverseMatrix],
        rank: u32,
        impulse: Vec2,
        moment: f64,
    ) -> Velocity {
        if self.inverse_mass.is_isotropic {
            (impulse * self.inverse_mass.linear, moment * self.inverse_mass.inverse_inertia)
        } else {
            inverses[rank as usize].response(impulse, moment)
        }
    }

    /// The speeds of the contact after a change of its forces.
    #[inline]
    pub(crate) fn speeds_after(&self, speeds: Speeds, more: Change, h: f64) -> Speeds {
        let k = &self.inverse_mass;
        Speeds {
            normal_mps: speeds.normal_mps
                + h * (more.tangential_n * k.cross - more.normal_n * k.normal),
            tangential_mps: speeds.tangential_mps
                + h * (more.tangential_n * k.tangential - more.normal_n * k.cross),
        }
    }

    /// Computes the forces of the contact for the case that the forces of all other contacts stay as they are. `speeds`
    /// are the speeds of the contact under the present forces of all contacts.
    ///
    /// The normal force N is the middle one of three: 0, the N at which V_n⁺ = −γ v_ref, and the law's force f; N is
    /// less if it would give more energy than is available. The tangential force T of the contact then follows from the
    /// implicit shear spring within Coulomb's limit.
    #[inline]
    pub(crate) fn relaxed(&self, speeds: Speeds, h: f64) -> Forces {
        let (now, k) = (&self.forces, &self.inverse_mass);
        let tight_n =
            now.normal_n + (speeds.normal_mps + self.rebound_mps) * self.force_per_speed(h);
        let bounded_n = greater(lesser(tight_n, self.law_n), 0.0);
        let normal_n = self.passive_normal_n(speeds.normal_mps, bounded_n, h);
        let normal_n = match now.friction {
            Friction::Slip => self.damped_by_friction(normal_n),
            Friction::Stick => normal_n,
        };
        // V_t⁺ with the new N at T = 0.
        let without_mps = speeds.tangential_mps
            - h * ((normal_n - now.normal_n) * k.cross + now.tangential_n * k.tangential);
        let (tangential_n, friction) =
            self.shear.solve(without_mps, normal_n, now.friction, k.tangential, h);
        Forces { normal_n, tangential_n, friction }
    }

    /// Computes the normal force N of a sliding contact. `normal_n` is the normal force that would result if the
    /// tangential force T stayed constant.
    ///
    /// T = ±μ_k N follows each change of N, and a change of T changes the normal speed V_n through t·K n. With ρ = μ_k
    /// |t·K n| / n·K n, a change of N changes V_n through friction by ρ times as much as directly. The change of V_n
    /// through friction is opposed to the direct change if T drives the bodies apart. Sweeps without damping would
    /// overshoot by ρ, and would never converge if ρ > 1. A change of N that is divided by 1 + ρ is exact where the
    /// bound V_n⁺ = −γ v_ref decides N.
    #[inline]
    fn damped_by_friction(&self, normal_n: f64) -> f64 {
        let k = &self.inverse_mass;
        let follows = self.shear.coulomb.sliding_slope() * k.cross.abs();
        if follows <= OVERSHOOT * k.normal || self.forces.tangential_n * k.cross > 0.0 {
            return normal_n;
        }
        let now_n = self.forces.normal_n;
        now_n + (normal_n - now_n) * (k.normal / (k.normal + follows))
    }

    /// 1/(h n·K n) (kg/s).
    #[inline]
    pub(crate) fn force_per_speed(&self, h: f64) -> f64 {
        1.0 / (h * self.inverse_mass.normal)
    }

    /// Returns `normal_n`, or a smaller normal force if `normal_n` would give the bodies more energy than is available.
    ///
    /// The work of the normal force N on the bodies is N h (½ N h n·K n − s), where s is the mean of two normal speeds:
    /// V_n before the sub-step, and V_n⁺ at N = 0.
    #[inline]
    fn passive_normal_n(&self, normal_mps: f64, normal_n: f64, h: f64) -> f64 {
        let k_n = self.inverse_mass.normal;
        let without_mps = normal_mps + self.forces.normal_n * h * k_n;
        let mean_mps = 0.5 * (self.normal_before_mps + without_mps);
        let work_j = normal_n * h * (0.5 * normal_n * h * k_n - mean_mps);
        if work_j <= self.available_j {
            return normal_n;
        }
        let root = libm::sqrt(mean_mps * mean_mps + 2.0 * k_n * self.available_j);
        greater((mean_mps + root) * self.force_per_speed(h), 0.0)
    }

    /// Tangential force T and speeds of a contact that sticks, if its normal force N equals the law's force f and no
    /// other contact acts. `free` are the speeds of the contact without contact forces.
    #[inline]
    pub(crate) fn sticking(&self, free: Speeds, h: f64) -> (f64, Speeds) {
        let k = &self.inverse_mass;
        let normal_ns = h * self.law_n;
        let without_mps = free.tangential_mps - normal_ns * k.cross;
        let tangential_n = self.shear.implicit_force_n(without_mps, h, k.tangential);
        let tangential_ns = h * tangential_n;
        let speeds = Speeds {
            normal_mps: free.normal_mps + (tangential_ns * k.cross - normal_ns * k.normal),
            tangential_mps: without_mps + tangential_ns * k.tangential,
        };
        (tangential_n, speeds)
    }

    /// Returns true if the law's force f as normal force, and the tangential force `tangential_n`, keep within all
    /// bounds of the contact. `speeds` are the speeds of the contact under the forces of all contacts.
    #[inline]
    pub(crate) fn is_within_bounds(&self, speeds: Speeds, tangential_n: f64, h: f64) -> bool {
        speeds.normal_mps >= -self.rebound_mps
            && self.has_energy_and_holds(speeds, self.law_n, tangential_n, h)
    }

    /// Returns true if the normal force `normal_n`, and the tangential force `tangential_n` of a sticking contact, keep
    /// within the available energies and Coulomb's limit. `speeds` are the speeds of the contact under the forces of
    /// all contacts.
    #[inline(always)]
    pub(crate) fn has_energy_and_holds(
        &self,
        speeds: Speeds,
        normal_n: f64,
        tangential_n: f64,
        h: f64,
    ) -> bool {
        let gives_j = -0.5 * h * normal_n * (self.normal_before_mps + speeds.normal_mps);
        gives_j <= self.available_j
            && self.shear.is_within_bounds(tangential_n, normal_n, speeds.tangential_mps, h)
    }

    /// Sets the normal force of the contact to the law's force f, and the tangential force to `tangential_n`, the force
    /// of the shear spring of a sticking contact.
    #[inline(always)]
    pub(crate) fn set_sticking(&mut self, speeds: Speeds, tangential_n: f64) {
        self.forces = Forces { normal_n: self.law_n, tangential_n, friction: Friction::Stick };
        self.after = speeds;
    }

    /// The ranks of the contact's floating bodies: first A's rank, then B's rank.
    #[inline(always)]
    pub(crate) fn floating(&self) -> [Option<u32>; 2] {
        [self.a_floats.then_some(self.a), self.b_floats.then_some(self.b)]
    }

    /// The rank of the contact's floating body, if exactly one of its two bodies floats.
    #[inline(always)]
    pub(crate) fn only_floating(&self) -> Option<u32> {
        match (self.a_floats, self.b_floats) {
            (true, false) => Some(self.a),
            (false, true) => Some(self.b),
            _ => None,
        }
    }

    /// The rank of a floating body of the contact.
    #[inline(always)]
    pub(crate) fn one_floating(&self) -> u32 {
        if self.a_floats { self.a } else { self.b }
    }

    /// The side of the contact's floating body, if exactly one of its two bodies floats.
    #[inline(always)]
    pub(crate) fn floating_side(&self) -> Side {
        if self.a_floats { Side::A } else { Side::B }
    }

    /// The part of the Jacobian that belongs to the contact's only floating body, and the sign of its side.
    #[inline]
    pub(crate) fn floating_jacobian(&self) -> (Jacobian, f64) {
        let side = self.floating_side();
        (self.jacobian(side), side.sign())
    }

    /// The part of the Jacobian that belongs to the body on this side, with the signs for a body that is body A.
    #[inline(always)]
    pub(crate) fn jacobian(&self, side: Side) -> Jacobian {
        Jacobian {
            normal: self.normal,
            levers: match side {
                Side::A => self.levers_a,
                Side::B => self.levers_b,
            },
        }
    }

    /// The larger of the changes that a change of the contact's forces makes to the normal and the tangential speed
    /// (m/s).
    #[inline]
    pub(crate) fn change_mps(&self, more: Change, h: f64) -> f64 {
        let k = &self.inverse_mass;
        greater((more.normal_n * k.normal).abs(), (more.tangential_n * k.tangential).abs()) * h
    }
}
