//! Reads nautical charts (GeoJSON) and depth surveys, and makes the grid of water depths for the ships of a simulation.
//!
//! | subject | module |
//! |---|---|
//! | features of a chart, such as coasts and buoys, from GeoJSON files, also of electronic charts (S-57) | [`chart`] |
//! | depth of the water at each place, from surveys and from the depth areas of a chart | [`bottom`] |
//! | solid land and quays as one outline | [`shore`] |
//! | lines of a chart along which fenders and bollards stand | [`quay`] |
//!
//! The crate `fenderline-scenario` hands the texts of the files over; this crate opens no file.
#![forbid(unsafe_code)]

pub mod bottom;
pub mod chart;
pub mod quay;
pub mod shore;
