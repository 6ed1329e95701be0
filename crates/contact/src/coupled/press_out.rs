//! Pressing out: slowly moves apart the bodies that a host placed into one another.
//!
//! A host that places a ship 3 m into a quay compresses the springs more than any impact could. A spring force of a
//! thousand meganewtons and more would throw the ship out at metres a second. The contact of bodies that were placed
//! into one another does not follow its force law. This contact follows a speed law instead. While the bodies close,
//! the normal force N brings the normal speed V_n⁺ to V_n − h (a + V_n/T). When the bodies no longer close, N brings
//! V_n⁺ to −V_out with the acceleration a. The speed law holds as long as the force law allows a force of that size. So
//! the normal force N holds the load, and accelerates the bodies by at most a (plus V_n/T while they still close),
//! however deep they lie. If the force law gives less, N is the law's force, and V_out still bounds the speed until the
//! bodies close again. When the bodies close again, the load is held, and the contact follows its force law. A fender
//! with an unloading law keeps to the speed law until it is hit anew, because the fender may be compressed for metres
//! with a force too small for the acceleration a, and would return its stored energy whenever a load is taken off.
//!
//! The test for pressing out is on energy: on the energy that the host created by placing bodies deeper than they had
//! moved by themselves. The force law gives back the energy that a contact took from bodies that moved by themselves,
//! even if the host displaces the bodies a little meanwhile. A contact that began by the bodies' own motion is never
//! pressed out.

use crate::maths::number::{greater, lesser};
use crate::state::memory::PatchMemory;

/// V_out: the largest speed at which a contact presses apart bodies that were placed into one another (m/s).
pub const MAX_PUSH_OUT_MPS: f64 = 0.08;

/// Acceleration a with which bodies are pressed out up to the speed V_out (m/s²), a five-hundredth of gravity.
const ACCELERATION_MPS2: f64 = 0.02;

/// Time T in which bodies that close are stopped (s).
const STOPPING_S: f64 = 2.0;

/// Least speed (m/s) to which the stored energy must be able to bring the bodies for them to be pressed out.
const THROWN_OUT_MPS: f64 = 0.5;

/// A contact whose force is more than this fraction of the law's force counts as following its force law. A test for
/// equality with the law's force would not do, because the law's force changes from one sub-step to the next.
const AT_LAW: f64 = 0.9;

/// The data that decide whether a contact presses its two bodies out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placement<'m> {
    /// Number of contacts of the two bodies if the host displaced the bodies before this sub-step, else 0. The test for
    /// pressing out assumes that each contact of the two bodies stores as much energy as this contact.
    pub(crate) contacts: u32,
    pub(crate) old: Option<&'m PatchMemory>,
    /// The most energy that the contact may give to the bodies (J).
    pub(crate) available_j: f64,
    /// f (N).
    pub(crate) law_n: f64,
    /// Inverse effective mass n·K n along the normal, without rotation (1/kg).
    pub(crate) inverse_mass: f64,
    /// V_n (m/s).
    pub(crate) v_normal_mps: f64,
    /// γ. The restitution is also `None` for a fender with an unloading law, because the available energy of such a
    /// fender already excludes the loss.
    pub(crate) restitution: Option<f64>,
}

impl Placement<'_> {
    /// Returns true if this contact must press its bodies out.
    #[inline(always)]
    pub(crate) fn is_pressed_out(&self) -> bool {
        self.contacts > 0 && self.would_throw_out()
            || self.old.is_some_and(|old| self.continues(old))
    }

    /// Returns true if a contact that pressed its bodies out in the last sub-step must still press them out.
    #[inline(always)]
    fn continues(&self, old: &PatchMemory) -> bool {
        old.flags & PatchMemory::PRESSED_OUT != 0
            && (old.normal_force_n < AT_LAW * self.law_n || self.has_not_closed())
    }

    /// Returns true if the bodies have not closed again yet. The function is for a contact whose law gives less force
    /// than the speed law: such a contact presses its bodies out until they close again.
    #[cold]
    fn has_not_closed(&self) -> bool {
        let hit_mps = if self.restitution.is_none() { MAX_PUSH_OUT_MPS } else { 0.0 };
        self.v_normal_mps <= hit_mps
    }

    #[cold]
    #[inline(never)]
    fn would_throw_out(&self) -> bool {
        let fastest_mps = |one_j: f64| {
            let all_j = one_j * f64::from(self.contacts);
            libm::sqrt(2.0 * all_j * self.inverse_mass)
        };
        // Small earned energy is ignored, because many small displacements may have caused it.
        let earned_j = self.old.map_or(0.0, |old| old.taken_j);
        let created_j = if fastest_mps(earned_j) > MAX_PUSH_OUT_MPS {
            self.available_j - earned_j
        } else {
            self.available_j
        };
        match (fastest_mps(created_j), self.restitution) {
            (thrown_mps, None) => thrown_mps > MAX_PUSH_OUT_MPS,
            (thrown_mps, Some(restitution)) => {
                thrown_mps > THROWN_OUT_MPS || restitution * thrown_mps > MAX_PUSH_OUT_MPS
            }
        }
    }
}

/// The speed that replaces the rebound speed γ v_ref: V_n⁺ may not fall below the negative of this speed (m/s).
pub(crate) fn opening_mps(v_normal_mps: f64, h: f64) -> f64 {
    let slower_mps = h * (ACCELERATION_MPS2 + greater(v_normal_mps, 0.0) / STOPPING_S);
    // A sub-step that is long compared with T stops the bodies.
    let opening_mps =
        lesser(slower_mps, greater(v_normal_mps, 0.0) + h * ACCELERATION_MPS2) - v_normal_mps;
    lesser(opening_mps, MAX_PUSH_OUT_MPS)
}
