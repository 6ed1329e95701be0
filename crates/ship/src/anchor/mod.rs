//! Anchors on chains. An anchor can be let go, held on the brake, veered, hove in, dredged, or slipped with its chain.
//!
//! An anchored ship is held as far as her anchor and chain hold on the bottom. [`AnchorGear::step`] moves the windlass,
//! and computes the shape of the chain between hawse pipe and anchor. If the chain pulls with more than the anchor
//! holds, the anchor drags. [`AnchorGear::step`] returns the force of the chain on the ship. Chain and anchor are
//! quasi-static: they have no inertia and no drag in the water.
//!
//! | what | formula or value | source |
//! |---|---|---|
//! | mass per length of chain with studs | 21.9 d² t/m, where d is the diameter of the chain's bar in m | Orcina, OrcaFlex help, "Chain" (read) |
//! | weight in water | weight in air times 1 − ρ/7850 kg/m³, which is 0.87 in sea water of density ρ | ISO 4568 by GB/T 4447: "buoyancy coefficient of 87 %" (read) |
//! | break load, stiffness | [`crate::chain::ChainSize`] | IACS UR W18; Orcina |
//! | form of the chain | [`crate::mooring::catenary`]: without stretch the length is s = √(h² + 2ha), where h is the height, a = H/w, H the horizontal tension and w the weight per length | as mooring cables |
//! | holding power | λa Wa + λc w l: the anchor's weight Wa and the weight w per length of the chain on the bottom (length l), each times its holding factor | a training paper of a shipping company has P = Wa λa + Wc λc l with λc = 0.75 (read) |
//! | holding factor λa of a stockless anchor | 3 | shipcalculators.com gives 3 m g (read); realtrawlers.com gives 3 in mud and 7 in sand for Hall and Spek anchors (read) |
//! | holding factor λa of a high-holding-power anchor | 6 | at least twice the holding power of a stockless anchor, by the ABS rules and the Wärtsilä encyclopaedia (both read) |
//! | dragging | 1.5 Wa | Japan P&I, Loss Prevention Bulletin 25 (from memory); trials of Shioji Maru show that the pull falls to a constant value (abstract read) |
//! | share of the holding power that is left when the chain lifts the shank | by scope (chain length over depth): 1 at 10, 0.91 at 7, 0.85 at 6, 0.77 at 5, 0.67 at 4, 0.53 at 3, 0.35 at 2 | D. Casey, BoatUS (table read), for small craft |
//! | windlass: pull, overload, speed | pull 37.5, 42.5 or 47.5 d² N for grades 1, 2 and 3 (d: bar diameter in mm); overload 1.5 times the pull; speed 0.15 m/s | IACS UR A3 and GB/T 4447 (read) |
//! | windlass: brake | 45 % of the chain's break load, as on ships with a chain stopper | IACS UR A3 (read) |
//! | bitter end | 30 % of the chain's break load | recalled |
//! | speed at which chain runs out | 5 m/s | our assumption |
//!
//! Simplifications. The chain lies in a straight line from the anchor, so that the part on the bottom gives no friction
//! sideways. Friction along the chain adds to the holding power, but does not change the shape of the chain. An anchor
//! bites at once where it comes to rest, and breaks out without suction. Chain above the water weighs the same as chain
//! in the water.

mod error;
mod gear;
mod ground;
mod state;
mod step;
mod windlass;

pub use error::AnchorError;
pub use gear::{AnchorGear, AnchorType, SHACKLE_M};
pub use ground::uplift_share;
pub use state::{
    AnchorEvent, AnchorFaults, AnchorLoad, AnchorPosition, AnchorState, Hawse, LostBy, Stay,
    WindlassOrder,
};
pub use step::AnchorStep;
pub use windlass::Windlass;
