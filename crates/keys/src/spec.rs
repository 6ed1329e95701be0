//! How scenario files are described: the types with which [`crate::keys`] declares the keys. The reader, the overrides
//! and the JSON Schema all use these declarations.

use serde_json::Value as Json;

use crate::choices::AnyChoices;
use crate::units::Measure;

/// A table of keys.
#[derive(Debug)]
pub struct TableSpec {
    /// What a table of this kind describes, with the article, as in `a material`.
    pub what: &'static str,
    /// What the table is for.
    pub doc: &'static str,
    /// Keys of the table, in the order in which documentation shows them.
    pub keys: &'static [KeySpec],
    /// Rules between the keys of the table, as JSON Schema keywords. `assemble` checks the same rules in code, and a
    /// test compares both.
    pub rules: Option<fn() -> Json>,
}

impl TableSpec {
    /// The key of the table with the name `name`.
    pub fn key(&self, name: &str) -> Option<&'static KeySpec> {
        self.keys.iter().find(|key| key.name == name)
    }
}

/// One key.
#[derive(Clone, Copy, Debug)]
pub struct KeySpec {
    /// Name of the key.
    pub name: &'static str,
    /// What the key holds.
    pub kind: Kind,
    /// What it means if the file does not give the key.
    pub absent: Absent,
    /// What the key is for.
    pub doc: &'static str,
    /// Example values, as TOML.
    pub examples: &'static [&'static str],
}

/// Declares a key by its name, its kind, the meaning of its absence, its documentation and example values.
pub const fn key(
    name: &'static str,
    kind: Kind,
    absent: Absent,
    doc: &'static str,
    examples: &'static [&'static str],
) -> KeySpec {
    KeySpec { name, kind, absent, doc, examples }
}

/// A type that stands for the keys of a kind of table.
pub trait TableKeys {
    /// Every key that a table of this kind may have.
    const KEYS: &'static [KeySpec];
}

/// What it means if the file does not give a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Absent {
    /// A file without the key is an error.
    Refused,
    /// A file without the key means the same as a file with this value of the key, which is written as TOML.
    Is(&'static str),
    /// These words say what a file without the key means.
    Means(&'static str),
    /// A file without the key is an error unless the condition in these words holds. `assemble` checks the condition.
    Unless(&'static str),
}

/// What a key holds.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A free text in one line.
    Text,
    /// `true` or `false`.
    Flag,
    /// One of several words.
    Choice(&'static dyn AnyChoices),
    /// A number with a unit.
    Quantity(Quantity),
    /// A name, or a number with a unit.
    NameOr(Quantity),
    /// Two quantities: north and east.
    Vector(Quantity),
    /// A point in a body's axes: forward and to starboard.
    Point(Quantity),
    /// The name of a file that is read with the scenario, relative to the file in which the name stands.
    FileName,
    /// The names of several files, each as in [`Kind::FileName`].
    FileNames,
    /// A list of texts.
    Texts,
    /// A list of values of any kind: numbers, or texts with their units.
    Values,
    /// A number, or a text with a number and a unit of any dimension.
    AnyNumber,
    /// A list of points in a body's axes: forward and to starboard.
    Outline(Quantity),
    /// A list of points, with the least and the greatest number of points.
    Points(Quantity, usize, usize),
    /// A curve in rows of two numbers.
    Curve(&'static CurveSpec),
    /// The name of a material.
    MaterialName,
    /// The name of a body.
    BodyName,
    /// The names of two bodies, or `*` twice.
    TwoBodyNames,
    /// A table.
    Table(&'static TableSpec),
    /// Tables, each under a name that the user gives.
    Named(&'static TableSpec),
    /// A list of tables.
    List(&'static TableSpec),
}

/// A kind of quantity and its bounds in SI; both bounds are allowed values.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// Dimension and unit.
    pub measure: &'static Measure,
    /// The least value.
    pub low: f64,
    /// The greatest value.
    pub high: f64,
}

/// A curve: what its two columns are, and how many rows it needs. The first number of a curve's rows increases from row
/// to row.
#[derive(Debug)]
pub struct CurveSpec {
    /// Name and quantity of the first column.
    pub from: (&'static str, Quantity),
    /// Name and quantity of the second column.
    pub to: (&'static str, Quantity),
    /// The least number of rows of the curve.
    pub fewest: usize,
}
