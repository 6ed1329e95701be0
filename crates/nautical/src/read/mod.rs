//! Reads sentences of instruments and of AIS receivers, line by line: NMEA 0183's GGA, RMC, HDT, THS, ROT and VTG, and
//! AIS messages 1, 2, 3, 5 and 18. Every other sentence is told apart from a damaged one. Reads the sentences by which a
//! controller steers a ship, too: HTC, HSC, APB, ROR, PRC and TRC.
//!
//! Of the crates that we looked at in November 2026, `nmea` 0.8 reads neither THS nor ROT, and `nmea-parser` 0.11 and
//! `ais` 0.12 build on older releases of their parsers; all bring more crates than this module has files. The tests read
//! published sentences, and what the writers of this crate write, which `check.py` compares with other programs.

mod ais;
mod control;
mod fields;
mod nmea;

pub use ais::{AisReader, Report, Static, Told};
pub use control::{Control, ControlOrder, EngineDemand, control};
pub use fields::{SentenceFault, body_of};
pub use nmea::{ClockTime, Fix, Reading, reading};
