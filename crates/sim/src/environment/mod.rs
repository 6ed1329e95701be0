//! What surrounds a ship: wind, current, waves, water.
//!
//! Everything here is a pure function of time and place: nothing has a state, so that a run can be
//! copied, restored and replayed to the bit. What is random is a sum of harmonics with phases from a
//! seed. Set-ups are checked once; after that nothing can fail.
//!
//! Axes: positions and velocities earth-fixed, x north and y east; forces on a ship [X, Y, N] in her own
//! axes about midship, x forward, y to starboard, N positive to starboard. Doc comments say how well a
//! formula is known: *found*: read in a public source; *recalled*: to be checked; *derived*: ours.
//!
//! ```
//! use fenderline_contact::vec2;
//! use fenderline_sim::environment::wind::*;
//! // Once: a gusty wind from the west and the windage of a loaded container ship.
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
//! // Each step: what she feels, heading north at rest, and the force.
//! let felt = RelativeWind::of(wind.velocity(10.0, 60.0), vec2(0.0, 0.0), 0.0);
//! let [_, sway_n, _] = ship.force(&felt, 1.224);
//! assert!(sway_n > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bank;
pub mod current;
mod error;
mod harmonics;
mod table;
mod tide;
pub mod waves;
pub mod wind;

pub use bank::{Bank, BankWater, ShipAtBank};
pub use error::EnvironmentError;
pub use tide::{Tide, TideConstituent};
