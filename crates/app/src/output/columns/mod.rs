//! The columns of the result tables: name, unit, meaning and value of each, stated once. The csv
//! header, the parquet schema and its metadata all come from here.

mod bodies;
mod contacts;
mod energy;
mod fenders;

pub(super) use bodies::{BodyRow, bodies_columns};
pub(super) use contacts::{ContactRow, ContactWorks, contacts_columns};
pub(super) use energy::{EnergyRow, energy_columns};
pub(super) use fenders::{FenderRow, fenders_columns};

/// One column of a table with rows of type `R`.
pub(super) struct Column<R> {
    /// Name; it ends with the unit where there is one.
    pub(super) name: &'static str,
    /// Unit as a reader writes it; `1` for a pure number, `-` for a text or a truth value.
    pub(super) unit: &'static str,
    /// What it means.
    pub(super) meaning: &'static str,
    /// Takes the value from a row.
    pub(super) value: Value<R>,
}

/// How a column's value is taken from a row, which sets the column's type.
pub(super) enum Value<R> {
    /// A number.
    Float(fn(&R) -> f64),
    /// The index of a body, written as its name.
    Body(fn(&R) -> usize),
    /// The index of a fender, written as its name; empty where there is none.
    Fender(fn(&R) -> Option<usize>),
    /// One of a few words.
    Word(fn(&R) -> &'static str),
    /// A truth value.
    Flag(fn(&R) -> bool),
    /// A whole number.
    Count(fn(&R) -> u32),
}

/// Names that rows hold by index.
#[derive(Clone, Debug, Default)]
pub(super) struct Names {
    pub(super) bodies: Vec<String>,
    pub(super) fenders: Vec<String>,
}

const fn float<R>(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&R) -> f64,
) -> Column<R> {
    Column { name, unit, meaning, value: Value::Float(value) }
}

const fn body<R>(name: &'static str, meaning: &'static str, value: fn(&R) -> usize) -> Column<R> {
    Column { name, unit: "-", meaning, value: Value::Body(value) }
}

const fn fender<R>(
    name: &'static str,
    meaning: &'static str,
    value: fn(&R) -> Option<usize>,
) -> Column<R> {
    Column { name, unit: "-", meaning, value: Value::Fender(value) }
}
