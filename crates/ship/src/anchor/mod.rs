//! Anchors on chains. An anchor can be let go, held on the brake, veered, hove in, dredged or slipped.
//!
//! A ship is held as far as anchor and chain hold the bottom. [`AnchorGear::step`] moves the windlass, and finds the
//! form of the chain between hawse pipe and anchor. If the pull is more than the anchor holds, the anchor drags. The
//! step returns the force on the ship. Chain and anchor are quasi-static: they have no inertia and no drag in the
//! water.
//!
//! | what | formula or value | source |
//! |---|---|---|
//! | mass of chain with studs | 21.9 d² t/m, d in m | Orcina, OrcaFlex help, "Chain" (read) |
//! | weight in water | times 1 − ρ/7850 kg/m³: 0.87 in sea water | ISO 4568 by GB/T 4447: "buoyancy coefficient of 87 %" (read) |
//! | break load, stiffness | [`crate::chain::ChainSize`] | IACS UR W18; Orcina |
//! | form of the chain | [`crate::mooring::catenary`]: without stretch s = √(h² + 2ha), a = H/w | as mooring cables |
//! | holding power | λa Wa + λc w l: anchor, and chain of length l on the bottom | P = Wa λa + Wc λc l, λc = 0.75, in a training paper of a shipping company (read) |
//! | λa of a stockless anchor | 3 | shipcalculators.com: 3 m g (read); Hall and Spek 3 in mud, 7 in sand (realtrawlers.com, read) |
//! | λa of a high-holding-power anchor | 6 | at least twice the holding power of a stockless anchor (ABS rules; Wärtsilä encyclopaedia; read) |
//! | dragging | 1.5 Wa | Japan P&I, Loss Prevention Bulletin 25 (recalled); that the pull falls to a constant value: trials of Shioji Maru (abstract read) |
//! | share with the shank lifted | by scope, 10: 1; 7: 0.91; 6: 0.85; 5: 0.77; 4: 0.67; 3: 0.53; 2: 0.35 | D. Casey, BoatUS (table read), for small craft |
//! | windlass: pull, overload, speed | 37.5, 42.5, 47.5 d² N (d in mm, grades 1 to 3), 1.5 times that, 0.15 m/s | IACS UR A3 and GB/T 4447 (read) |
//! | windlass: brake | 45 % of the break load, where a chain stopper is fitted | IACS UR A3 (read) |
//! | bitter end | 30 % of the break load | recalled |
//! | speed of chain that runs out | 5 m/s | our assumption |
//!
//! Simplifications. The chain lies in a straight line from the anchor, so the part on the bottom has no friction
//! sideways. Friction along the chain adds to the holding power, but does not change the form. An anchor bites at once
//! where it comes to rest, and breaks out without suction. Chain above the water weighs the same as chain in the water.

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
pub use windlass::Windlass;
