//! Bodies that were put into one another are pressed out slowly.
//!
//! Whoever puts a ship 3 m into a quay has pressed its springs with more than any impact: a thousand
//! meganewtons and more, that would throw her out at metres a second. Such a contact does not act by its law but
//! by its speed: N is what it takes to bring V_n⁺ to
//!
//! V_n − h (a + V_n/T) while the bodies close, and from there with a to −V_out,
//!
//! where the law has as much. So N holds the load, and accelerates the bodies by at most a (and V_n/T where they
//! still close), however deep they lie. Where the law has less than that N is the law's, and V_out bounds the speed
//! still, until the contact closes again: then the load is held, and the contact acts by its law. Rubber goes on
//! like this until it is hit anew: it may be pressed softer than a for metres, and what it holds comes back by its law
//! whenever a load lets go.
//!
//! What counts is the energy that the host has made, by putting bodies deeper than they had come by
//! themselves: what a contact took from bodies that came by themselves it gives back by its law, though a host moves
//! them a little otherwise meanwhile. A contact that came about by itself never begins like this.

use crate::memory::PatchMemory;
use crate::number::{greater, lesser};

/// V_out: the fastest that a contact presses bodies apart that were put into one another (m/s).
pub const MAX_PUSH_OUT_MPS: f64 = 0.08;

/// a: how fast it gets there (m/s²): a five-hundredth of the weight.
const GENTLY_MPS2: f64 = 0.02;

/// T: in which time it stops bodies that close (s).
const STOPPING_S: f64 = 2.0;

/// Bodies that what the springs hold could bring to this speed are not left to them (m/s).
const THROWN_OUT_MPS: f64 = 0.5;

/// Share of the law's force from which on a contact is taken to act by its law: that force changes from one sub-step
/// to the next.
const NEARLY: f64 = 0.9;

/// What decides whether a contact presses bodies apart slowly.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Put<'m> {
    /// Were they put where they are before this sub-step, and how many contacts have they there? Each counts as if all
    /// held as much: what all of them could do together is not left to them.
    pub(crate) placed: u32,
    pub(crate) old: Option<&'m PatchMemory>,
    /// What the contact may give them (J), and f (N).
    pub(crate) may_give_j: f64,
    pub(crate) law_n: f64,
    /// n·K n without rotation (1/kg), and V_n (m/s).
    pub(crate) inverse_mass: f64,
    pub(crate) v_normal_mps: f64,
    /// γ; `None` of a fender with an unloading law: what it may give is what is left after its loss.
    pub(crate) restitution: Option<f64>,
}

impl Put<'_> {
    /// Is this a contact that presses out slowly?
    #[inline(always)]
    pub(crate) fn is_pressed_out(&self) -> bool {
        self.placed > 0 && self.would_throw_out() || self.old.is_some_and(|old| self.goes_on(old))
    }

    #[inline(always)]
    fn goes_on(&self, old: &PatchMemory) -> bool {
        old.flags & PatchMemory::PRESSED_OUT != 0
            && (old.normal_force_n < NEARLY * self.law_n || self.is_still_let_out())
    }

    /// Where the law has no more than it takes: until the bodies close again.
    #[cold]
    fn is_still_let_out(&self) -> bool {
        let hit_mps = if self.restitution.is_none() { MAX_PUSH_OUT_MPS } else { 0.0 };
        self.v_normal_mps <= hit_mps
    }

    #[cold]
    #[inline(never)]
    fn would_throw_out(&self) -> bool {
        let fastest_mps = |one_j: f64| {
            let all_j = one_j * f64::from(self.placed);
            libm::sqrt(2.0 * all_j * self.inverse_mass)
        };
        // So little may be from one putting or from many, each by a little.
        let earned_j = self.old.map_or(0.0, |old| old.taken_j);
        let made_j = if fastest_mps(earned_j) > MAX_PUSH_OUT_MPS {
            self.may_give_j - earned_j
        } else {
            self.may_give_j
        };
        match (fastest_mps(made_j), self.restitution) {
            (thrown_mps, None) => thrown_mps > MAX_PUSH_OUT_MPS,
            (thrown_mps, Some(restitution)) => {
                thrown_mps > THROWN_OUT_MPS || restitution * thrown_mps > MAX_PUSH_OUT_MPS
            }
        }
    }
}

/// What V_n⁺ may not fall below, with the other sign, as that of γ v_ref else (m/s).
pub(crate) fn opening_mps(v_normal_mps: f64, h: f64) -> f64 {
    let slower_mps = h * (GENTLY_MPS2 + greater(v_normal_mps, 0.0) / STOPPING_S);
    // A sub-step that is long beside T stops them.
    let opening_mps =
        lesser(slower_mps, greater(v_normal_mps, 0.0) + h * GENTLY_MPS2) - v_normal_mps;
    lesser(opening_mps, MAX_PUSH_OUT_MPS)
}
