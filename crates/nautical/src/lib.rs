//! Writes the data of a ship's instruments, as pure functions: NMEA 0183 sentences of the own ship, AIS messages of all
//! ships, and geographic positions from positions in metres. Reads the sentences that a measured track needs, and
//! those of a controller that steers a ship ([`read`]). No sockets, no clock.
//!
//! The sentence formats are those of public descriptions (gpsd's of NMEA and of AIVDM/AIVDO); the standards
//! (IEC 61162-1, ITU-R M.1371) were not read, and no conformity to them is claimed.
#![forbid(unsafe_code)]

mod ais;
mod chart;
mod nmea;
pub mod read;
mod sentence;

/// International nautical mile (m).
const NAUTICAL_MILE_M: f64 = 1852.0;

pub use ais::{PositionReport, ShipData, ais_position, ais_ship_data};
pub use chart::{ChartOrigin, GeoPoint, OutOfChart};
pub use nmea::{Instruments, Moment, Shaft, instruments};
