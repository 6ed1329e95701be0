//! The environment of a ship: wind, current, waves, long waves, tide, bottom and banks.
//!
//! Everything in the environment is a pure function of time and position, without state, so that a run can be copied,
//! restored and replayed bit for bit. Random processes of the environment are sums of harmonics with phases from a
//! seed. Inputs of the environment are checked once, when they are created; after that no function fails.
//!
//! Positions and velocities are earth-fixed, x north and y east; forces on a ship [X, Y, N] are in the ship's axes
//! about midship, x forward, y to starboard, N positive to starboard. Doc comments say how well the source of a formula
//! is known. In doc comments, *found* means that the formula was read in a public source. In doc comments, *recalled*
//! means that the formula is given from memory, and is to be checked. *Derived*: by this project.
//!
//! ```
//! use fenderline_contact::vec2;
//! use fenderline_ship::environment::wind::*;
//! // Once: a wind with gusts from the west, and the wind areas of a loaded container ship.
//! let profile = WindProfile::Power { exponent: 1.0 / 7.0 };
//! let mean = MeanWind { speed_mps: 12.0, from_rad: 270.0_f64.to_radians(), profile };
//! let gusts = Gusts::new(&mean, &GustSpectrum::Npd, Realisation { harmonics: 60, seed: 1 })?;
//! let wind = Wind::with_gusts(mean, gusts)?;
//! let ship = ShipWindage {
//!     length_m: 298.0,
//!     beam_m: 46.0,
//!     frontal_m2: 1700.0,
//!     lateral_m2: 9000.0,
//!     centroid_forward_m: 0.0,
//!     centroid_height_m: 15.0,
//!     method: WindMethod::Blendermann(Blendermann::of_type("container ship, loaded").unwrap()),
//! };
//! ship.check()?;
//! // In each step: the wind relative to the ship, which heads north at rest, and the force.
//! let relative = RelativeWind::of(wind.velocity(10.0, 60.0), vec2(0.0, 0.0), 0.0);
//! let [_, sway_n, _] = ship.force(&relative, 1.224);
//! assert!(sway_n > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bank;
pub mod current;
mod depth_blocks;
mod depth_field;
mod error;
mod harmonics;
mod load_table;
mod long_waves;
mod table;
mod tide;
pub mod waves;
pub mod wind;

pub use bank::{Bank, BankMethod, BankWater, ShipAtBank};
pub use depth_field::{DepthField, MOST_NODES};
pub use error::EnvironmentError;
pub use load_table::{LoadTable, Sides};
pub use long_waves::{LongWaveSite, LongWaveSpectrum, LongWaves};
pub use tide::{Tide, TideConstituent};
