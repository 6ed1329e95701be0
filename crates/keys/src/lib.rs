//! Files that people write: TOML text with units to checked values, and errors that name file, line and key.
//!
//! [`keys`] declares every key of a scenario once: name, kind, unit, bounds, default and meaning. From that declaration
//! [`reader`] checks a file, [`overrides`] sets single keys, and [`schema`] makes the JSON Schema. The crate
//! `fenderline-scenario` turns the checked values into a set-up.
//!
//! | subject | module |
//! |---|---|
//! | how a key is declared | [`spec`], [`choices`], [`held`], [`typed_key`] |
//! | the keys of a scenario | [`keys`] |
//! | text to checked values | [`syntax`], [`reader`], [`checked`] |
//! | values with units | [`units`] |
//! | where a value was written, and errors | [`place`], [`sources`], [`origin`], [`error`] |
//! | files of any kind, opened so that none can hang the program | [`bounded_file`] |
//! | tables of numbers in CSV files | [`csv`] |
#![forbid(unsafe_code)]

pub mod bounded_file;
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
