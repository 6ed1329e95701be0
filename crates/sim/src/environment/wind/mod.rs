//! Wind: mean, profile and gusts, and what it does to a ship.
//!
//! [`Wind::velocity`] gives the air's velocity at a height and a time; [`RelativeWind::of`] what a ship
//! feels of it; [`ShipWindage::force`] the force.
//!
//! The angle γ is that of the wind's origin from the bow, positive where it comes over the *port* side,
//! so that γ > 0 pushes to starboard, Y > 0 (the convention of Fossen's toolbox, found).

mod gust;
mod mean;
mod method;
mod relative;
mod series;
mod spectrum;
mod windage;

pub use super::harmonics::Realisation;
pub use gust::Gusts;
pub use mean::{MeanWind, Wind, WindProfile};
// All of them, so that a new method is named in its own folder alone.
pub use method::*;
pub use relative::RelativeWind;
pub use series::WindSeries;
pub use spectrum::{GustSpectrum, surface_drag};
pub use windage::{ShipWindage, WindCoefficients};
