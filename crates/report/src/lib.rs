//! Makes pages for people from the records of a run, by pure functions that return text.
//!
//! [`run_page::render`] makes `report.html` from a run's [`Outcome`](fenderline_results::Outcome) and the
//! [`run_page::Recorder`] that followed its steps. [`plot`] draws charts and plan views as SVG and puts them on a page;
//! the program uses [`plot`] for other pages too. [`words`] names events. The crate reads and writes no files, knows no
//! command line and builds for `wasm32-unknown-unknown`.
#![forbid(unsafe_code)]

pub mod plot;
pub mod run_page;
mod table;
pub mod words;

pub use table::{Head, table_head};
