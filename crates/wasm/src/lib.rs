//! fenderline in WebAssembly, of which the npm package `fenderline` is made.
//!
//! [`run`] takes a scenario from its text to summary and report, [`exercise`] makes a scenario from choices, [`model`]
//! and [`engine`] are the contact engine alone, and [`problem`] is the error that JavaScript gets. [`exports`] hands
//! these modules to JavaScript: structured data as JSON, arrays of numbers by address and length. The package's
//! TypeScript in `npm/src` turns addresses into views, and JSON into typed objects.
//!
//! Nothing in this crate reads a clock, a file or the network.

pub mod engine;
pub mod exercise;
pub mod exports;
pub mod model;
pub mod numbers;
pub mod problem;
pub mod run;
