//! Waves: elevation of the surface, first-order motion of a ship, and mean wave drift force.
//!
//! A [`Sea`] is a sum of harmonics in one direction, or in several directions about a mean direction. The sea's
//! elevation is ζ = Σ a·cos(ωt − k·x + ε), upwards. [`first_order_motion`] gives the motion of a ship in waves by her
//! [`MotionResponse`]; this motion is added to her manoeuvring motion. The motion in waves has no memory effects as in
//! Cummins' equations, and does not act back on the manoeuvring motion. [`mean_drift`] gives the mean second-order
//! force of the waves.
//!
//! The direction of a wave is the direction *towards* which it travels, clockwise from north. The angle μ is the wave's
//! direction relative to the bow: 0 for waves from astern, π from ahead, 0 < μ < π from port. Motions of the ship are
//! surge, sway, heave *down*, roll to starboard, pitch bow up, yaw to starboard.

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
pub use sea::{Component, DIRECTIONS, RegularWave, Sea, breaking_height_m};
