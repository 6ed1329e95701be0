//! Results of a step: contacts, wrenches, displacements and events.

use crate::maths::vec2::Vec2;
use crate::model::material::{BodyId, FenderId};

/// Friction state of the contact's shear spring (eq. 5–8).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Friction {
    /// The contact does not slide: |k_s Δs| ≤ μ_s N.
    #[default]
    Stick,
    /// The contact slides: the friction force is μ_k N, against the sliding velocity.
    Slip,
}

/// One contact patch between two bodies in one step.
///
/// The force on body 1 is `−normal_force_n · normal + tangential_force_n · tangent`. The force on body 2 is exactly the
/// opposite of the force on body 1. In the coupled method `normal_force_n`, `tangential_force_n` and `parts` are means
/// over the step. All other values are those at the start of the step, unless the documentation of the field says
/// otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The body of the pair that was added first to the model.
    pub body_1: BodyId,
    /// The body of the pair that was added later to the model.
    pub body_2: BodyId,
    /// The fender that is compressed; `None` if two outlines meet each other.
    pub fender: Option<FenderId>,
    /// Number of the patch within the pair of bodies: 0 unless non-convex outlines touch in several places.
    pub patch: u32,
    /// Area S of the overlap (m²).
    pub area_m2: f64,
    /// Depth δ of the contact (m): extent of the overlap along the normal, or deflection of the fender.
    pub depth_m: f64,
    /// Point where the contact force acts, earth-fixed (m): the centroid C of the overlap; at a fender, a point near
    /// the centroid on the force's line of action.
    pub point_m: Vec2,
    /// Vector from body 1's centre of gravity to `point_m`, earth-fixed (m). The vector stays exact far from the
    /// chart's origin.
    pub arm_1_m: Vec2,
    /// Vector from body 2's centre of gravity to `point_m`, earth-fixed (m).
    pub arm_2_m: Vec2,
    /// Unit normal n of the contact: the outward normal of body 1, earth-fixed. The normal is perpendicular to the
    /// chord of the overlap or, at a fender, opposite to the fender's force on body 1.
    pub normal: Vec2,
    /// Normal speed V_n (m/s), positive while the bodies approach.
    pub v_normal_mps: f64,
    /// Tangential speed V_t of body 1 relative to body 2 along the tangent (m/s).
    pub v_tangential_mps: f64,
    /// Deflection Δs of the shear spring (m).
    pub shear_m: f64,
    /// N ≥ 0 (N).
    pub normal_force_n: f64,
    /// Tangential force T on body 1 along the tangent (N).
    pub tangential_force_n: f64,
    /// Impulse of the normal and the tangential force on the two bodies within the step.
    pub impulse: ContactImpulse,
    /// Stick or slip.
    pub friction: Friction,
    /// True if the momentum limit reduced the normal or the tangential force.
    pub limited: bool,
    /// Largest normal force N within the step, sub-steps included (N); in the paper's method this is `normal_force_n`.
    pub peak_normal_force_n: f64,
    /// Largest depth δ within the step, sub-steps included (m); in the paper's method this is `depth_m`.
    pub peak_depth_m: f64,
    /// The terms of the normal force N.
    pub parts: ForceParts,
    /// Work of the contact on the two bodies within the step if the engine moves the bodies; else 0.
    pub work: ContactWork,
    /// Factor on a fender's reaction, set when the contact began; 1 if two outlines meet each other.
    pub factor: f64,
    /// Angle between a fender's face and the hull (rad); 0 if two outlines meet each other.
    pub tilt_rad: f64,
    /// Energy in the fender and in the shear spring.
    pub energy: EnergyParts,
}

/// Impulse of a contact's forces within one step (N·s): Σ N κ and Σ T κ over the sub-steps, where κ is the
/// time over which a sub-step's force changes momentum (see [`Displacement::translation_m`]).
///
/// If the engine moves the bodies by the coupled method, the impulse is exactly the change of momentum. The impulse
/// differs from [`Contact::normal_force_n`] times Δt if the length of the sub-steps changes from one step to the next,
/// because this mean force weighs the force of each sub-step by the length of the sub-step. In the paper's method the
/// impulse is the force times Δt.
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
    /// Force of the area spring or of the reaction curve, with all factors of the fender.
    pub spring_n: f64,
    /// Force of the stop at the end of a fender's travel.
    pub stop_n: f64,
    /// Damper, c Ṡ. The damper's force is negative while the overlap shrinks, and then never larger in size than spring
    /// and stop.
    pub damper_n: f64,
    /// The force that the momentum limit (eq. 26, or the coupled solve) subtracted.
    pub limiter_n: f64,
}

impl ForceParts {
    /// The normal force N, the sum of the terms (N).
    #[must_use]
    #[inline]
    pub fn total_n(&self) -> f64 {
        ((self.spring_n + self.stop_n) + self.damper_n) - self.limiter_n
    }

    /// Adds the terms of a sub-step whose length is `share` of the step.
    #[inline]
    pub(crate) fn add(&mut self, parts: &ForceParts, share: f64) {
        self.spring_n += parts.spring_n * share;
        self.stop_n += parts.stop_n * share;
        self.damper_n += parts.damper_n * share;
        self.limiter_n += parts.limiter_n * share;
    }
}

/// Work of a contact on its two bodies in one step (J); negative if the contact takes energy from the bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactWork {
    /// Work of N.
    pub normal_j: f64,
    /// Work of T.
    pub tangential_j: f64,
    /// Work of the damper's part of the normal force N.
    pub damper_j: f64,
    /// Work of the force that the momentum limit subtracted, as the work of a force along the contact normal. The springs released this
    /// energy, and the bodies did not receive it: it is the loss by restitution.
    pub limiter_j: f64,
}

/// Energy stored and dissipated in a contact (J).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyParts {
    /// Energy in a fender's spring and stop at the start of the step; with an unloading law, only the part that the
    /// fender can return. The energy is 0 if two outlines meet, because their law has no potential
    /// (docs/contact_model.md, section 2).
    pub stored_j: f64,
    /// Largest energy within the step, sub-steps included, that loads the fender to its deflection: ∫ R dδ of the
    /// loading curve. The energy to load the fender to its deflection is the absorbed energy that catalogues rate.
    /// Without an unloading law this is the largest value of `stored_j`.
    pub peak_absorbed_j: f64,
    /// Energy that a fender's unloading law dissipated. The dissipated energy is evaluated at the start of each
    /// sub-step, so it covers the time from the start of the previous step's last sub-step to the start of this step's
    /// last sub-step. The dissipated energy is 0 without an unloading law, and in the paper's method.
    pub hysteresis_j: f64,
    /// The part of `hysteresis_j` that belongs to the start of the step: the energy dissipated since the last sub-step
    /// before the step.
    pub hysteresis_at_start_j: f64,
    /// Energy ½ T²/k_s in the shear spring at the end of the step.
    pub shear_stored_j: f64,
}

impl Contact {
    /// Unit tangent t of the contact: the normal turned by +90°.
    #[must_use]
    #[inline]
    pub fn tangent(&self) -> Vec2 {
        self.normal.quarter_turn()
    }

    /// Force on body 1, earth-fixed (N): −N n + T t. The force on body 2 is exactly the opposite of this force on
    /// body 1.
    #[must_use]
    #[inline]
    pub fn force_on_body_1_n(&self) -> Vec2 {
        self.normal * -self.normal_force_n + self.tangent() * self.tangential_force_n
    }
}

/// A force at the centre of gravity of a body, and a moment about the centre of gravity, earth-fixed.
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

/// Displacement of a body in one step, for computing the work of forces: the work of a steady load is the load times
/// this displacement.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Displacement {
    /// Displacement of the centre of gravity, Σ ½(v + v⁺)κ over the sub-steps, earth-fixed (m). Here κ is the time over
    /// which a sub-step's forces change momentum: the length h of the sub-step, or the mean of h and the length of the
    /// previous sub-step if they differ.
    pub translation_m: Vec2,
    /// Angle of turn of the body, Σ ½(r + r⁺)κ over the sub-steps (rad).
    pub rotation_rad: f64,
}

/// An occurrence that users should know about; the engine reports it in the step in which it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// The bodies concerned. Both entries are the same body if only one body is concerned.
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
    /// One patch of contact split into two or more patches. Each of the new patches keeps the whole shear, and gets a
    /// share of areas and energies in proportion to its area.
    PatchSplit,
    /// Two or more patches of contact merged into one patch. The merged patch has the mean of the old patches' shear
    /// weighted by area, and the sum of their areas and energies.
    PatchesMerged,
    /// One body lies wholly within the other body, so that the overlap no longer grows with depth.
    Contained,
    /// The overlap is more than half of the smaller body's area, and the force law is not meant for such an overlap.
    DeepOverlap,
    /// A body moved farther than its velocities explain, by more than a tenth of its outline's radius; or the host
    /// called [`crate::Memory::mark_teleported`] for the body. The contacts of a teleported body begin anew.
    Teleported,
    /// A fender is deflected beyond its rated deflection.
    FenderRatingExceeded(FenderId),
    /// A fender is deflected into its stop, or by its whole projection. A fender that is deflected so far has failed:
    /// the stop, or the structure behind the fender, holds the hull.
    FenderFailed(FenderId),
    /// The coupled solve of the contact of these bodies did not converge within its iteration limit.
    NotConverged,
    /// A body was placed so deep in another body that the contact would eject it. The contact pushes the placed body
    /// out slowly instead, at [`crate::MAX_PUSH_OUT_MPS`] at most.
    PlacedInOverlap,
    /// A body does not accelerate under the wrenches as its mass in the model says: the host uses another mass. A
    /// [`crate::CoSimHost`] reports this once for each body.
    MassMismatch,
}
