//! Pressing out: bodies that their host placed into one another are moved apart slowly.
//!
//! A host that places a ship 3 m into a quay has compressed its springs more than any impact could: a thousand
//! meganewtons and more, which would throw her out at metres a second. Such a contact does not act by its law but by its
//! speed. N is the force that brings V_n⁺ to
//!
//! V_n − h (a + V_n/T) while the bodies close, and from there with a to −V_out,
//!
//! as long as the law has that much. So N holds the load, and accelerates the bodies by at most a (and V_n/T while they
//! still close), however deep they lie. If the law has less, N is the law's force and V_out still bounds the speed, until
//! the contact closes again: then the load is held, and the contact acts by its law. A fender with an unloading law
//! continues like this until it is hit anew: it may be compressed softer than a for metres, and its stored energy returns
//! by its law whenever a load is taken off.
//!
//! The test is on the energy that the host has created by placing bodies deeper than they had moved by themselves. A
//! contact gives back by its law what it took from bodies that moved by themselves, even if the host displaces them a
//! little meanwhile. A contact that began by motion is never pressed out.

use crate::memory::PatchMemory;
use crate::number::{greater, lesser};

/// V_out: the largest speed at which a contact presses apart bodies that were placed into one another (m/s).
pub const MAX_PUSH_OUT_MPS: f64 = 0.08;

/// a: the acceleration to V_out [m/s²]: a five-hundredth of gravity.
const ACCELERATION_MPS2: f64 = 0.02;

/// T: the time in which closing bodies are stopped (s).
const STOPPING_S: f64 = 2.0;

/// Bodies are pressed out if the stored energy could bring them to this speed (m/s).
const THROWN_OUT_MPS: f64 = 0.5;

/// The fraction of the law's force above which a contact counts as acting by its law. The law's force changes from one
/// sub-step to the next, so equality is no test.
const AT_LAW: f64 = 0.9;

/// What decides whether a contact presses its bodies out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placement<'m> {
    /// Number of the bodies' contacts if the host displaced them before this sub-step, else 0. Each contact counts as if
    /// all stored as much as it does.
    pub(crate) contacts: u32,
    pub(crate) old: Option<&'m PatchMemory>,
    /// The most energy that the contact may give them (J).
    pub(crate) available_j: f64,
    /// f (N).
    pub(crate) law_n: f64,
    /// n·K n without rotation (1/kg).
    pub(crate) inverse_mass: f64,
    /// V_n (m/s).
    pub(crate) v_normal_mps: f64,
    /// γ; `None` for a fender with an unloading law, whose available energy is already reduced by its loss.
    pub(crate) restitution: Option<f64>,
}

impl Placement<'_> {
    /// Does this contact press its bodies out?
    #[inline(always)]
    pub(crate) fn is_pressed_out(&self) -> bool {
        self.contacts > 0 && self.would_throw_out()
            || self.old.is_some_and(|old| self.continues(old))
    }

    /// Does a contact that pressed out in the last sub-step still do so?
    #[inline(always)]
    fn continues(&self, old: &PatchMemory) -> bool {
        old.flags & PatchMemory::PRESSED_OUT != 0
            && (old.normal_force_n < AT_LAW * self.law_n || self.has_not_closed())
    }

    /// If the law's force is the smaller: pressing out lasts until the bodies close again.
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
        // Small earned energy is ignored: it may come from many small displacements.
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

/// The lower bound on V_n⁺ with its sign changed, in place of γ v_ref (m/s).
pub(crate) fn opening_mps(v_normal_mps: f64, h: f64) -> f64 {
    let slower_mps = h * (ACCELERATION_MPS2 + greater(v_normal_mps, 0.0) / STOPPING_S);
    // A sub-step that is long compared with T stops them.
    let opening_mps =
        lesser(slower_mps, greater(v_normal_mps, 0.0) + h * ACCELERATION_MPS2) - v_normal_mps;
    lesser(opening_mps, MAX_PUSH_OUT_MPS)
}
