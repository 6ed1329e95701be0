//! What surrounds a ship: wind, current, waves, water.
//!
//! Everything here is a pure function of time and place: nothing has a state, so that a run can be
//! copied, restored and replayed to the bit. What is random is a sum of harmonics with phases from a
//! seed. Set-ups are checked once; after that nothing can fail.
//!
//! Axes: positions and velocities earth-fixed, x north and y east; forces on a ship [X, Y, N] in her own
//! axes about midship, x forward, y to starboard, N positive to starboard. Doc comments say how well a
//! formula is known: *found*: read in a public source; *recalled*: to be checked; *derived*: ours.

pub mod current;
mod error;
mod harmonics;
mod table;
mod water;
pub mod waves;
pub mod wind;

pub use error::EnvironmentError;
pub use water::{Tide, TideConstituent, Water};
