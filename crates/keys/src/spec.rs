//! How scenario files are described: the types of the key table in [`crate::keys`], from which the
//! reader, the overrides and the JSON Schema all work.

use serde_json::Value as Json;

use crate::choices::AnyChoices;
use crate::units::Measure;

/// A table of keys.
#[derive(Debug)]
pub struct TableSpec {
    /// The thing that such a table describes, with its article, as `a material`.
    pub what: &'static str,
    /// What the table is for.
    pub doc: &'static str,
    /// Keys of the table, in the order in which documentation shows them.
    pub keys: &'static [KeySpec],
    /// Rules between the keys, as JSON Schema keywords. `assemble` checks them in code, and a test compares the two.
    pub rules: Option<fn() -> Json>,
}

impl TableSpec {
    /// The key of this name.
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
    /// Meaning of the key's absence.
    pub absent: Absent,
    /// What the key is for.
    pub doc: &'static str,
    /// Example values, as TOML.
    pub examples: &'static [&'static str],
}

/// A key, by position: name, kind, what its absence means, documentation, examples.
pub const fn key(
    name: &'static str,
    kind: Kind,
    absent: Absent,
    doc: &'static str,
    examples: &'static [&'static str],
) -> KeySpec {
    KeySpec { name, kind, absent, doc, examples }
}

/// The keys of a table, as a type.
pub trait TableKeys {
    /// Every key that such a table may have.
    const KEYS: &'static [KeySpec];
}

/// What the absence of a key means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Absent {
    /// An error.
    Refused,
    /// The same as this value, written as TOML.
    Is(&'static str),
    /// What these words say.
    Means(&'static str),
    /// An error unless these words hold. `assemble` checks the condition.
    Unless(&'static str),
}

/// What a key holds.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Free text in one line.
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
    /// The name of a file, relative to this one, that is read with the scenario.
    FileName,
    /// The names of several files, as [`Kind::FileName`].
    FileNames,
    /// A list of texts.
    Texts,
    /// A list of values of any kind: numbers, or texts with their units.
    Values,
    /// A number, or a text with a number and a unit, of any dimension.
    AnyNumber,
    /// A list of points, forward and to starboard.
    Outline(Quantity),
    /// A list of points, with the least and the greatest number of them.
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
    /// Tables under names that the user gives.
    Named(&'static TableSpec),
    /// A list of tables.
    List(&'static TableSpec),
}

/// A kind of quantity and its bounds in SI, both included.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// Dimension and unit.
    pub measure: &'static Measure,
    /// The least value.
    pub low: f64,
    /// The greatest value.
    pub high: f64,
}

/// A curve: what its two columns are, and how many rows it needs. The first number rises from row to
/// row.
#[derive(Debug)]
pub struct CurveSpec {
    /// Name and quantity of the first column.
    pub from: (&'static str, Quantity),
    /// Name and quantity of the second column.
    pub to: (&'static str, Quantity),
    /// The least number of rows.
    pub fewest: usize,
}
