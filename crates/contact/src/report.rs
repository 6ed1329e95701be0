//! What a step reports: contacts, wrenches and events.

use crate::model::BodyId;
use crate::vec2::Vec2;

/// Whether the shear spring holds or slides (eq. 5–8).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Friction {
    /// |k_s Δs| ≤ μ_s N: no sliding.
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
    /// Number of the patch within the pair: 0 unless non-convex outlines touch in several places.
    pub patch: u32,
    /// S, the overlap area [m²].
    pub area_m2: f64,
    /// δ, the extent of the overlap along the normal [m].
    pub depth_m: f64,
    /// C, the centroid of the overlap, earth-fixed [m].
    pub point_m: Vec2,
    /// From body 1's centre of gravity to C, earth-fixed [m]; exact far from the chart's origin.
    pub arm_1_m: Vec2,
    /// From body 2's centre of gravity to C, earth-fixed [m].
    pub arm_2_m: Vec2,
    /// n, body 1's outward normal, earth-fixed.
    pub normal: Vec2,
    /// V_n [m/s], positive while approaching.
    pub v_normal_mps: f64,
    /// V_t [m/s], of body 1 relative to body 2 along the tangent (n turned by +90°).
    pub v_tangential_mps: f64,
    /// Δs, the shear of the contact [m].
    pub shear_m: f64,
    /// N ≥ 0 [N].
    pub normal_force_n: f64,
    /// T [N], on body 1 along the tangent.
    pub tangential_force_n: f64,
    /// Stick or slip.
    pub friction: Friction,
    /// True where the limit from momentum cut the normal or the tangential force.
    pub limited: bool,
    /// Largest N within the step, sub-steps included [N]; `normal_force_n` by the paper's method.
    pub peak_normal_force_n: f64,
    /// Largest δ within the step, sub-steps included [m]; `depth_m` by the paper's method.
    pub peak_depth_m: f64,
    /// Work of N on the two bodies within the step [J], where the engine moved them; else 0.
    pub normal_work_j: f64,
    /// Work of T on the two bodies within the step [J], where the engine moved them; else 0.
    pub tangential_work_j: f64,
}

impl Contact {
    /// t: the normal turned by +90°.
    #[must_use]
    #[inline]
    pub fn tangent(&self) -> Vec2 {
        self.normal.quarter_turn()
    }

    /// Force on body 1, earth-fixed [N]: −N n + T t. Body 2 gets exactly the opposite.
    #[must_use]
    #[inline]
    pub fn force_on_body_1_n(&self) -> Vec2 {
        self.normal * -self.normal_force_n + self.tangent() * self.tangential_force_n
    }
}

/// A force at a body's centre of gravity and a moment about it, earth-fixed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// Force [N].
    pub force_n: Vec2,
    /// Moment about the vertical axis, positive to starboard [N·m].
    pub moment_nm: f64,
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
    /// A body moved by more than its velocities explain: its contacts start afresh.
    Teleported,
    /// The coupled solve of these bodies' contact did not settle within its bounded work.
    NotConverged,
}
