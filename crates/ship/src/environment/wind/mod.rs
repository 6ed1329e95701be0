//! The wind: its mean, its profile over height, its gusts, and its force on a ship.
//!
//! [`Wind::velocity`] gives the velocity of the air at a height and a time, [`RelativeWind::of`] the wind relative to a
//! ship, and [`ShipWindage::force`] the force. For how to add a wind method, see `wind/method/mod.rs`; for a gust
//! spectrum, see `spectrum.rs`.
//!
//! The wind angle γ is the direction from which the wind comes, measured from the bow, positive over the *port* side:
//! for γ > 0 the force is to starboard, Y > 0 (the convention of Fossen's toolbox, found).

mod above_water;
mod admittance;
mod coefficients;
mod gust;
mod lanes;
mod mean;
mod method;
mod over_time;
mod relative;
mod series;
mod ship_gusts;
mod spectrum;
mod windage;

pub use super::harmonics::Realisation;
pub use admittance::WindFront;
pub use coefficients::WindCoefficients;
pub use gust::Gusts;
pub use mean::{MeanWind, WindProfile};
// All names are re-exported, so that a new method is named only in its own folder.
pub use method::*;
pub use over_time::Wind;
pub use relative::RelativeWind;
pub use series::WindSeries;
pub use ship_gusts::ShipGusts;
pub use spectrum::{GustSpectrum, surface_drag};
pub use windage::ShipWindage;
