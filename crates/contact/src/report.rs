//! What a step reports: contacts, wrenches and events.

use crate::fender::FenderId;
use crate::model::BodyId;
use crate::vec2::Vec2;

/// Whether the shear spring holds or slides (eq. 5–8).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Friction {
    /// |k_s Δs| ≤ μ_s N: no sliding.
    #[default]
    Stick,
    /// The friction force is μ_k N against the slip.
    Slip,
}

/// One patch of contact between two bodies in one step. Force on body 1:
/// `−normal_force_n · normal + tangential_force_n · tangent`; on body 2 exactly the opposite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The body added first.
    pub body_1: BodyId,
    /// The body added later.
    pub body_2: BodyId,
    /// The fender of one of the two that the other's outline presses on; `None`: outline on outline.
    pub fender: Option<FenderId>,
    /// Number of the patch within the pair: 0 unless non-convex outlines touch in several places.
    pub patch: u32,
    /// S, the overlap area (m²).
    pub area_m2: f64,
    /// δ, the extent of the overlap along the normal, or the deflection of the fender (m).
    pub depth_m: f64,
    /// Where the force acts, earth-fixed (m): C, the centroid of the overlap, or near it a point of the
    /// line of a fender's force.
    pub point_m: Vec2,
    /// From body 1's centre of gravity to that point, earth-fixed (m); exact far from the chart's
    /// origin.
    pub arm_1_m: Vec2,
    /// From body 2's centre of gravity to it, earth-fixed (m).
    pub arm_2_m: Vec2,
    /// n, body 1's outward normal, earth-fixed: that of the chord, or against a fender's force.
    pub normal: Vec2,
    /// V_n (m/s), positive while approaching.
    pub v_normal_mps: f64,
    /// V_t (m/s), of body 1 relative to body 2 along the tangent (n turned by +90°).
    pub v_tangential_mps: f64,
    /// Δs, the shear of the contact (m).
    pub shear_m: f64,
    /// N ≥ 0 (N).
    pub normal_force_n: f64,
    /// T (N), on body 1 along the tangent.
    pub tangential_force_n: f64,
    /// What N gives the two bodies within the step (N·s): Σ N κ over the sub-steps, with κ for how long forces act (see
    /// [`Displacement::translation_m`]). By the coupled method, of what the engine moved, it is the change of momentum exactly. The
    /// mean `normal_force_n` times the step is not, where the length of the sub-steps changes: that mean is over the
    /// sub-steps' own time, so that it is the force at rest. By the paper's method N times the step.
    pub normal_impulse_ns: f64,
    /// The same of T (N·s).
    pub tangential_impulse_ns: f64,
    /// Stick or slip.
    pub friction: Friction,
    /// True where the limit from momentum cut the normal or the tangential force.
    pub limited: bool,
    /// Largest N within the step, sub-steps included (N); `normal_force_n` by the paper's method.
    pub peak_normal_force_n: f64,
    /// Largest δ within the step, sub-steps included (m); `depth_m` by the paper's method.
    pub peak_depth_m: f64,
    /// What N is made of.
    pub parts: ForceParts,
    /// Work on the two bodies within the step, where the engine moved them; else 0.
    pub work: ContactWork,
    /// The factor on a fender's reaction, taken when the contact began; 1 for outline on outline.
    pub factor: f64,
    /// Angle between a fender's face and the hull (rad); 0 for outline on outline.
    pub tilt_rad: f64,
    /// Energy that a fender's spring and stop store at the start of the step (J), of one with an unloading law what they
    /// can give back; 0 for outline on outline, whose law has no potential (docs/contact_model.md, section 2).
    pub stored_j: f64,
    /// The largest energy that loads such a fender from nothing to where it is, within the step, sub-steps included
    /// (J): ∫ R dδ of the loading curve, which catalogues rate. Without an unloading law the largest of the one above.
    pub peak_absorbed_j: f64,
    /// Energy that a fender's unloading law has turned to heat (J), found at the starts of this step's sub-steps: since
    /// the start of the last one of the step before. 0 without such a law, and by the paper's method.
    pub hysteresis_j: f64,
    /// The part of it that was found at the start of the step.
    pub hysteresis_at_start_j: f64,
    /// ½ T²/k_s at the end of the step: what the shear spring stores (J).
    pub shear_stored_j: f64,
}

/// What a normal force is made of (N): N = spring + stop + damper − limiter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ForceParts {
    /// Area spring or reaction curve, with all factors.
    pub spring_n: f64,
    /// The stop past a fender's travel.
    pub stop_n: f64,
    /// c Ṡ; negative while the overlap shrinks, and never more than the springs.
    pub damper_n: f64,
    /// What the limit from momentum (eq. 26, or the coupled solve) took off.
    pub limiter_n: f64,
}

impl ForceParts {
    /// N (N).
    #[must_use]
    #[inline]
    pub fn total_n(&self) -> f64 {
        ((self.spring_n + self.stop_n) + self.damper_n) - self.limiter_n
    }

    /// Adds parts with a sub-step's share of the step.
    #[inline]
    pub(crate) fn add(&mut self, parts: &ForceParts, share: f64) {
        self.spring_n += parts.spring_n * share;
        self.stop_n += parts.stop_n * share;
        self.damper_n += parts.damper_n * share;
        self.limiter_n += parts.limiter_n * share;
    }
}

/// Work of a contact on its two bodies in one step (J): negative where it takes energy from them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactWork {
    /// Of N.
    pub normal_j: f64,
    /// Of T.
    pub tangential_j: f64,
    /// Of N's damper alone.
    pub damper_j: f64,
    /// Of what the limiter took off N, with the sign of a force along N: what the springs gave back and
    /// the bodies did not get is restitution's loss.
    pub limiter_j: f64,
}

impl Contact {
    /// t: the normal turned by +90°.
    #[must_use]
    #[inline]
    pub fn tangent(&self) -> Vec2 {
        self.normal.quarter_turn()
    }

    /// Force on body 1, earth-fixed (N): −N n + T t. Body 2 gets exactly the opposite.
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

/// How far a body went in a step, by the velocities that forces work along: a steady load times it is that
/// load's work.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Displacement {
    /// Σ ½(v + v⁺)κ over the sub-steps, earth-fixed, with κ for how long forces act: h, and half of the two where a
    /// sub-step is not as long as the last one (m).
    pub translation_m: Vec2,
    /// Σ ½(r + r⁺)κ (rad).
    pub rotation_rad: f64,
}

/// Something that a user should know of, beyond the forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// The bodies it is about; the second is the first where only one is meant.
    pub bodies: [BodyId; 2],
    /// What happened.
    pub kind: EventKind,
}

/// The kinds of [`Event`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// A patch of contact came into being.
    ContactBegan,
    /// A patch of contact ceased.
    ContactEnded,
    /// One patch became two or more; each goes on with the memory of the one.
    PatchSplit,
    /// Two or more patches became one; it goes on with their mean memory.
    PatchesMerged,
    /// One body lies wholly within the other: the overlap no longer grows with depth.
    Contained,
    /// The overlap is deeper than half the smaller body is wide: the force law means little there.
    DeepOverlap,
    /// A body moved by a tenth of the radius of its outline more than its velocities explain, or its host said that it
    /// has put it there: its contacts start afresh.
    Teleported,
    /// A fender is deflected beyond what it is rated for.
    FenderRatingExceeded(FenderId),
    /// A fender is in its stop, or as deep as it projects: it has failed, and the stop or the structure
    /// behind holds the hull.
    FenderFailed(FenderId),
    /// The coupled solve of these bodies' contact did not settle within its bounded work.
    NotConverged,
    /// A body was put into another, so deep that the contact would throw it out faster: it is pressed out instead, at
    /// [`crate::MAX_PUSH_OUT_MPS`] at most.
    PlacedInOverlap,
    /// A body answers the wrenches that its host is given otherwise than its mass in the model says: the host moves
    /// it with another. Told once a body, by a following host.
    MassMismatch,
}
