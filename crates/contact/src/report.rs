//! Results of a step: contacts, wrenches, displacements and events.

use crate::material::{BodyId, FenderId};
use crate::vec2::Vec2;

/// State of the shear spring (eq. 5–8).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Friction {
    /// |k_s Δs| ≤ μ_s N: no sliding.
    #[default]
    Stick,
    /// The friction force is μ_k N, against the sliding velocity.
    Slip,
}

/// One contact patch between two bodies in one step.
///
/// The force on body 1 is `−normal_force_n · normal + tangential_force_n · tangent`; the force on body 2
/// is exactly the opposite. By the coupled method `normal_force_n`, `tangential_force_n` and `parts` are
/// means over the step, and the other values are those at its start where not said otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The body that was added first.
    pub body_1: BodyId,
    /// The body that was added later.
    pub body_2: BodyId,
    /// The fender that is compressed; `None` where outline meets outline.
    pub fender: Option<FenderId>,
    /// Number of the patch within the pair: 0 unless non-convex outlines touch in several places.
    pub patch: u32,
    /// S, area of the overlap (m²).
    pub area_m2: f64,
    /// δ, extent of the overlap along the normal, or deflection of the fender (m).
    pub depth_m: f64,
    /// Point where the force acts, earth-fixed (m): C, the centroid of the overlap; at a fender a point
    /// near it on the force's line of action.
    pub point_m: Vec2,
    /// Vector from body 1's centre of gravity to that point, earth-fixed (m). Exact far from the
    /// chart's origin.
    pub arm_1_m: Vec2,
    /// Vector from body 2's centre of gravity to that point, earth-fixed (m).
    pub arm_2_m: Vec2,
    /// n, body 1's outward normal, earth-fixed: perpendicular to the chord of the overlap, or opposite
    /// to a fender's force on body 1.
    pub normal: Vec2,
    /// V_n (m/s), positive while approaching.
    pub v_normal_mps: f64,
    /// V_t (m/s), of body 1 relative to body 2 along the tangent.
    pub v_tangential_mps: f64,
    /// Δs, deflection of the shear spring (m).
    pub shear_m: f64,
    /// N ≥ 0 (N).
    pub normal_force_n: f64,
    /// T (N), on body 1 along the tangent.
    pub tangential_force_n: f64,
    /// Impulse of N and T on the two bodies within the step.
    pub impulse: ContactImpulse,
    /// Stick or slip.
    pub friction: Friction,
    /// True where the momentum limit reduced the normal or the tangential force.
    pub limited: bool,
    /// Largest N within the step, sub-steps included (N); `normal_force_n` by the paper's method.
    pub peak_normal_force_n: f64,
    /// Largest δ within the step, sub-steps included (m); `depth_m` by the paper's method.
    pub peak_depth_m: f64,
    /// The terms of N.
    pub parts: ForceParts,
    /// Work on the two bodies within the step, where the engine moves them; else 0.
    pub work: ContactWork,
    /// Factor on a fender's reaction, set when the contact began; 1 where outline meets outline.
    pub factor: f64,
    /// Angle between a fender's face and the hull (rad); 0 where outline meets outline.
    pub tilt_rad: f64,
    /// Energy in the fender and in the shear spring.
    pub energy: EnergyParts,
}

/// Impulse of a contact's forces within one step (N·s): Σ N κ and Σ T κ over the sub-steps, where κ is the
/// time over which a sub-step's force changes momentum (see [`Displacement::translation_m`]).
///
/// Where the engine moves the bodies by the coupled method, this is exactly the change of momentum. It
/// differs from [`Contact::normal_force_n`] times Δt where the length of the sub-steps changes from one
/// step to the next, because that mean weighs each force by its own sub-step. By the paper's method it is
/// the force times Δt.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactImpulse {
    /// Impulse of N (N·s).
    pub normal_ns: f64,
    /// Impulse of T (N·s).
    pub tangential_ns: f64,
}

/// The terms of a normal force (N): N = spring + stop + damper − limiter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ForceParts {
    /// Area spring or reaction curve, with all factors.
    pub spring_n: f64,
    /// The stop at the end of a fender's travel.
    pub stop_n: f64,
    /// c Ṡ; negative while the overlap shrinks, and then never larger than the springs.
    pub damper_n: f64,
    /// What the momentum limit (eq. 26, or the coupled solve) subtracted.
    pub limiter_n: f64,
}

impl ForceParts {
    /// N (N).
    #[must_use]
    #[inline]
    pub fn total_n(&self) -> f64 {
        ((self.spring_n + self.stop_n) + self.damper_n) - self.limiter_n
    }

    /// Adds the terms of a sub-step that is `share` of the step.
    #[inline]
    pub(crate) fn add(&mut self, parts: &ForceParts, share: f64) {
        self.spring_n += parts.spring_n * share;
        self.stop_n += parts.stop_n * share;
        self.damper_n += parts.damper_n * share;
        self.limiter_n += parts.limiter_n * share;
    }
}

/// Work of a contact on its two bodies in one step (J); negative where it takes energy from them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactWork {
    /// Work of N.
    pub normal_j: f64,
    /// Work of T.
    pub tangential_j: f64,
    /// Work of the damper's part of N.
    pub damper_j: f64,
    /// Work of the part that the momentum limit subtracted, as that of a force along N: energy that the
    /// springs released and the bodies did not receive, which is the loss by restitution.
    pub limiter_j: f64,
}

/// Energy stored and dissipated in a contact (J).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyParts {
    /// Energy in a fender's spring and stop at the start of the step; with an unloading law, the part that
    /// it can return. 0 where outline meets outline: that law has no potential (docs/contact_model.md,
    /// section 2).
    pub stored_j: f64,
    /// Largest energy that loading the fender to its deflection takes, within the step and its sub-steps:
    /// ∫ R dδ of the loading curve, the absorbed energy that catalogues rate. Without an unloading law it
    /// is the largest `stored_j`.
    pub peak_absorbed_j: f64,
    /// Energy that a fender's unloading law dissipated, evaluated at the start of each sub-step: from the
    /// start of the previous step's last sub-step to the start of this step's last sub-step. 0 without an
    /// unloading law, and by the paper's method.
    pub hysteresis_j: f64,
    /// The part of `hysteresis_j` that was found at the start of the step.
    pub hysteresis_at_start_j: f64,
    /// ½ T²/k_s, energy in the shear spring at the end of the step.
    pub shear_stored_j: f64,
}

impl Contact {
    /// t: the normal turned by +90°.
    #[must_use]
    #[inline]
    pub fn tangent(&self) -> Vec2 {
        self.normal.quarter_turn()
    }

    /// Force on body 1, earth-fixed (N): −N n + T t. The force on body 2 is exactly the opposite.
    #[must_use]
    #[inline]
    pub fn force_on_body_1_n(&self) -> Vec2 {
        self.normal * -self.normal_force_n + self.tangent() * self.tangential_force_n
    }
}

/// A force at a body's centre of gravity and a moment about it, earth-fixed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// Force (N).
    pub force_n: Vec2,
    /// Moment about the vertical axis, positive to starboard (N·m).
    pub moment_nm: f64,
}

impl Wrench {
    pub(crate) fn plus(&self, other: &Wrench) -> Wrench {
        let Wrench { force_n, moment_nm } = *other;
        Wrench { force_n: self.force_n + force_n, moment_nm: self.moment_nm + moment_nm }
    }

    pub(crate) fn minus(&self, other: &Wrench) -> Wrench {
        let Wrench { force_n, moment_nm } = *other;
        Wrench { force_n: self.force_n - force_n, moment_nm: self.moment_nm - moment_nm }
    }

    pub(crate) fn times(&self, factor: f64) -> Wrench {
        Wrench { force_n: self.force_n * factor, moment_nm: self.moment_nm * factor }
    }
}

/// Displacement of a body in one step, as forces do work along it: the work of a steady load is the load
/// times this displacement.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Displacement {
    /// Σ ½(v + v⁺)κ over the sub-steps, earth-fixed (m). κ is the time over which a sub-step's forces
    /// change momentum: the sub-step's length h, or the mean of h and the previous sub-step's length where
    /// they differ.
    pub translation_m: Vec2,
    /// Σ ½(r + r⁺)κ (rad).
    pub rotation_rad: f64,
}

/// An occurrence that users should know about, reported in the step in which it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// The bodies concerned; twice the same where there is only one.
    pub bodies: [BodyId; 2],
    /// What happened.
    pub kind: EventKind,
}

/// The kinds of [`Event`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// A contact patch began.
    ContactBegan,
    /// A contact patch ended.
    ContactEnded,
    /// One patch split into two or more. Each keeps the whole shear, and its share by area of areas and energies.
    PatchSplit,
    /// Two or more patches merged into one: the mean of their shear by area, the sum of their areas and energies.
    PatchesMerged,
    /// One body lies wholly within the other: the overlap no longer grows with depth.
    Contained,
    /// The overlap is more than half the smaller body's area; the force law is not meant for that.
    DeepOverlap,
    /// A body was displaced by a tenth of its outline's radius more than its velocities explain, or its
    /// host called [`crate::Memory::mark_teleported`]. Its contacts begin anew.
    Teleported,
    /// A fender is deflected beyond its rated deflection.
    FenderRatingExceeded(FenderId),
    /// A fender is deflected into its stop, or by its whole projection: it has failed, and the stop or
    /// the structure behind holds the hull.
    FenderFailed(FenderId),
    /// The coupled solve of these bodies' contact did not converge within its iteration limit.
    NotConverged,
    /// A body was placed so deep in another that the contact would eject it. It is pushed out slowly
    /// instead, at [`crate::MAX_PUSH_OUT_MPS`] at most.
    PlacedInOverlap,
    /// A body does not accelerate under the wrenches as its mass in the model says: the host uses another
    /// mass. Reported once per body, by a [`crate::CoSimHost`].
    MassMismatch,
}
