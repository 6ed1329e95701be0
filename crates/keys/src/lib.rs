//! Reads files that people write: turns TOML text with units into checked values, or reports an error that names file,
//! line and key.
//!
//! [`keys`] declares every key of a scenario once: name, kind, unit, bounds, default and meaning. From the declaration
//! of the keys [`reader`] checks a file, [`overrides`] sets single keys, and [`schema`] makes the JSON Schema. The
//! crate `fenderline-scenario` turns the checked values of a scenario into the set-up of a simulation.
//!
//! | subject | module |
//! |---|---|
//! | how a key is declared | [`spec`], [`choices`], [`held`], [`typed_key`] |
//! | the keys of a scenario | [`keys`] |
//! | text to checked values | [`syntax`], [`reader`], [`checked`] |
//! | values with units | [`units`] |
//! | the place where a value was written, and errors | [`place`], [`sources`], [`origin`], [`error`] |
//! | opening a file so that no kind of file can hang the program | [`bounded_file`] |
//! | tables of numbers in CSV files | [`csv`] |
#![forbid(unsafe_code)]

pub mod bounded_file;
pub mod calendar;
pub mod checked;
pub mod choices;
pub mod csv;
pub mod error;
pub mod held;
pub mod key_path;
pub mod keys;
pub mod nesting;
pub mod option_value;
pub mod origin;
pub mod overrides;
pub mod place;
pub mod printable;
pub mod rating;
pub mod reader;
pub mod row_names;
pub mod schema;
pub mod sources;
pub mod spec;
pub mod suggest;
pub mod syntax;
pub mod typed_key;
pub mod units;
