//! Charts and bottoms: reads GeoJSON charts and surveys, and makes the grid of depths that ships feel.
//!
//! | subject | module |
//! |---|---|
//! | features of a chart from GeoJSON, also of electronic charts (S-57) | [`chart`] |
//! | depth of the water by place, from surveys and depth areas | [`bottom`] |
//!
//! The crate `fenderline-scenario` hands the texts of the files over; this crate opens no file.
#![forbid(unsafe_code)]

pub mod bottom;
pub mod chart;
