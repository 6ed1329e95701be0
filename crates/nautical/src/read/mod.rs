//! Reads sentences of instruments and of AIS receivers, line by line: NMEA 0183's GGA, RMC, HDT, THS, ROT and VTG, and
//! AIS messages 1, 2, 3, 5 and 18. Every other sentence is told apart from a damaged one.

mod ais;
mod fields;
mod nmea;

pub use ais::{AisReader, Report, Static, Told};
pub use fields::{SentenceFault, body_of};
pub use nmea::{ClockTime, Fix, Reading, reading};
