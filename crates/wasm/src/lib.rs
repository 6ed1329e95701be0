//! fenderline in WebAssembly: what the npm package `fenderline` is made of.
//!
//! [`run`] is a scenario from its text to summary and report, [`exercise`] makes one from choices, [`model`] and [`engine`] are the contact engine alone,
//! [`problem`] is what goes wrong. [`exports`] hands them to JavaScript: structured data as JSON, arrays of numbers by address
//! and length. The package's TypeScript in `npm/src` turns addresses into views, and JSON into typed objects.
//!
//! Nothing here reads a clock, a file or the network.

pub mod engine;
pub mod exercise;
pub mod exports;
pub mod model;
pub mod numbers;
pub mod problem;
pub mod run;
