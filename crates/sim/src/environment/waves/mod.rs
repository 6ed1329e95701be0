//! Waves: what the surface does, and what first-order motion and mean drift they give a ship.
//!
//! A [`Sea`] is a sum of harmonics, all in one direction or in several about it; its elevation is ζ = Σ a·cos(ωt − k·x + ε), upwards. A
//! [`MotionResponse`] turns it into the motion of a ship that is superposed on her manoeuvring:
//! [`first_order_motion`]. Not Cummins' equations: no memory, no coupling back.
//!
//! The direction of a wave is that it runs *towards*, clockwise from north. μ is that direction from the
//! bow: 0 from astern, π from ahead, 0 < μ < π from port. Motions are surge, sway, heave *down*, roll to
//! starboard, pitch bow up, yaw to starboard.

mod box_ship;
mod complex;
mod dispersion;
mod drift;
mod jonswap;
mod motion;
mod rao;
mod sea;

pub use super::harmonics::Realisation;
pub use box_ship::BoxShip;
pub use complex::Complex;
pub use dispersion::wave_number;
pub use drift::{DriftHull, mean_drift};
pub use jonswap::Jonswap;
pub use motion::{FirstOrderMotion, MotionResponse, ShipInWaves, first_order_motion};
pub use rao::RaoTable;
pub use sea::{DIRECTIONS, RegularWave, Sea};
