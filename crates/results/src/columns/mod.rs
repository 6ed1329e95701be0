//! The columns of the result tables: name, unit, meaning and value of each, defined once. The csv
//! header, the parquet schema and its metadata, Python's tables and the reference of `fenderline columns` all come from
//! here.

/// The columns of a force in the horizontal plane, in body axes: surge, sway and yaw moment about midship. `$row`: the
/// type of a row; `$prefix`: the beginning of the names; `$of`: the source of the force; `$force`: the field of the
/// row.
macro_rules! force_columns {
    ($row:ty, $prefix:literal, $of:literal, $($force:ident).+) => {
        [
            $crate::columns::float(
                concat!($prefix, "surge_n"),
                "N",
                concat!("surge force of ", $of, ", positive forward"),
                |r: &$row| r.$($force).+.surge_n,
            ),
            $crate::columns::float(
                concat!($prefix, "sway_n"),
                "N",
                concat!("sway force of ", $of, ", positive to starboard"),
                |r: &$row| r.$($force).+.sway_n,
            ),
            $crate::columns::float(
                concat!($prefix, "yaw_nm"),
                "N·m",
                concat!("yaw moment of ", $of, " about midship, positive to starboard"),
                |r: &$row| r.$($force).+.yaw_nm,
            ),
        ]
    };
}

mod anchors;
mod azimuths;
mod bodies;
mod chains;
mod contacts;
mod dolphins;
mod energy;
mod fenders;
mod lines;
mod panels;
mod passing;
mod thrusters;
mod tugs;
mod vessels;

use fenderline_sim::Setup;

pub(crate) use anchors::{AnchorRow, anchors_table};
pub(crate) use azimuths::{AzimuthRow, azimuths_table};
pub(crate) use bodies::{BodyRow, bodies_table};
pub(crate) use chains::{ChainRow, chains_table};
pub(crate) use contacts::{ContactRow, ContactWorks, contacts_table};
pub(crate) use dolphins::{DolphinRow, dolphins_table};
pub(crate) use energy::{EnergyRow, energy_table};
pub(crate) use fenders::{FenderRow, fenders_table};
pub(crate) use lines::{LineRow, lines_table};
pub(crate) use panels::{PanelRow, panels_table};
pub(crate) use passing::{PassingRow, passing_table};
pub(crate) use thrusters::{ThrusterRow, thrusters_table};
pub(crate) use tugs::{TugRow, tugs_table};
pub(crate) use vessels::{VesselRow, vessels_table};

/// The layout of a table with rows of type `R`: its name and its columns.
pub(crate) struct Layout<R> {
    pub(crate) name: &'static str,
    /// Meaning of one row.
    pub(crate) rows: &'static str,
    /// The columns, in the order of the file.
    pub(crate) columns: Vec<Column<R>>,
}

/// A table that a run can write, as the command `fenderline columns` describes the table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableReference {
    /// Name of the table; its file is `NAME.csv` or `NAME.parquet`.
    pub name: &'static str,
    /// Meaning of one row.
    pub rows: &'static str,
    /// The columns, in the order of the file.
    pub columns: Vec<ColumnReference>,
}

/// A column of a table, as the command `fenderline columns` describes the column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ColumnReference {
    /// Name of the column; it ends with the unit, if the column has one.
    pub name: &'static str,
    /// Unit of the column as a reader writes it; `1` for a pure number, `-` for a text or a truth value.
    pub unit: &'static str,
    /// Meaning of the column.
    pub meaning: &'static str,
}

/// Every table that a run can write, with its columns, from the definitions that also write the files.
#[must_use]
pub fn reference() -> Vec<TableReference> {
    vec![
        refer(bodies_table()),
        refer(contacts_table()),
        refer(fenders_table()),
        refer(panels_table()),
        refer(chains_table()),
        refer(vessels_table()),
        refer(thrusters_table()),
        refer(azimuths_table()),
        refer(tugs_table()),
        refer(lines_table()),
        refer(anchors_table()),
        refer(passing_table()),
        refer(dolphins_table()),
        refer(energy_table()),
    ]
}

fn refer<R>(layout: Layout<R>) -> TableReference {
    let Layout { name, rows, columns } = layout;
    let columns = columns.iter().map(|column| {
        let Column { name, unit, meaning, .. } = *column;
        ColumnReference { name, unit, meaning }
    });
    TableReference { name, rows, columns: columns.collect() }
}

/// One column of a table with rows of type `R`.
pub struct Column<R> {
    /// Name of the column; it ends with the unit, if the column has one.
    pub name: &'static str,
    /// Unit of the column as a reader writes it; `1` for a pure number, `-` for a text or a truth value.
    pub unit: &'static str,
    /// Meaning of the column.
    pub meaning: &'static str,
    /// Takes the column's value from a row.
    pub value: Value<R>,
}

/// How a column's value is taken from a row, which sets the column's type.
pub enum Value<R> {
    /// A number.
    Float(fn(&R) -> f64),
    /// A number of a list that each row has: the number with this index.
    Nth(usize, fn(&R, usize) -> f64),
    /// A number that some rows do not have: empty in csv, NaN elsewhere.
    Known(fn(&R) -> Option<f64>),
    /// An index into one of the lists of [`Names`], written as the name at this index; empty without an index.
    Name(List, fn(&R) -> Option<usize>),
    /// A word of a small set of words.
    Word(fn(&R) -> &'static str),
    /// A truth value.
    Flag(fn(&R) -> bool),
    /// A whole number.
    Count(fn(&R) -> u32),
}

impl<R> Value<R> {
    /// The column's number of a row; `None` if the number is not known, or if the column does not hold numbers.
    pub fn number(&self, row: &R) -> Option<f64> {
        match self {
            Value::Float(number) => Some(number(row)),
            Value::Nth(index, number) => Some(number(row, *index)),
            Value::Known(number) => number(row),
            _ => None,
        }
    }
}

/// The list of names to which an index refers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum List {
    /// Bodies.
    Bodies,
    /// Fenders.
    Fenders,
    /// Vessels, by the names of their bodies.
    Vessels,
    /// Tugs.
    Tugs,
    /// Mooring lines.
    Lines,
    /// Anchors.
    Anchors,
    /// Passing ships.
    Passing,
    /// All vessels' thrusters, one after the other.
    Thrusters,
    /// All vessels' azimuth units, one after the other.
    Azimuths,
}

/// The names that rows hold as indices.
#[derive(Clone, Debug, Default)]
pub struct Names {
    bodies: Vec<String>,
    fenders: Vec<String>,
    /// Names of the vessels; a vessel has the name of its body.
    vessels: Vec<String>,
    tugs: Vec<String>,
    lines: Vec<String>,
    anchors: Vec<String>,
    passing: Vec<String>,
    thrusters: Vec<String>,
    azimuths: Vec<String>,
}

impl Names {
    /// Collects the names in a set-up.
    #[must_use]
    pub fn of(setup: &Setup) -> Names {
        let world = &setup.world;
        let body = |index: usize| setup.bodies[index].name.clone();
        Names {
            bodies: setup.bodies.iter().map(|body| body.name.clone()).collect(),
            fenders: setup.fenders.iter().map(|fender| fender.name.clone()).collect(),
            vessels: world.vessels.iter().map(|vessel| body(vessel.body)).collect(),
            tugs: world.tugs.iter().map(|tug| tug.tug.name.clone()).collect(),
            lines: world.lines.iter().map(|line| line.line.name.clone()).collect(),
            anchors: world.anchors.iter().map(|anchor| anchor.gear.name.clone()).collect(),
            passing: world.flow.passing.iter().map(|ship| ship.name.clone()).collect(),
            thrusters: world
                .vessels
                .iter()
                .flat_map(|vessel| vessel.thrusters.iter().map(|thruster| thruster.name.clone()))
                .collect(),
            azimuths: world
                .vessels
                .iter()
                .flat_map(|vessel| vessel.azimuths.iter().map(|azimuth| azimuth.name.clone()))
                .collect(),
        }
    }

    /// The name at an index; empty if there is no index.
    #[must_use]
    pub fn get(&self, list: List, index: Option<usize>) -> &str {
        index.map_or("", |index| &self.list(list)[index])
    }

    /// A list of names.
    #[must_use]
    pub fn list(&self, list: List) -> &[String] {
        match list {
            List::Bodies => &self.bodies,
            List::Fenders => &self.fenders,
            List::Vessels => &self.vessels,
            List::Tugs => &self.tugs,
            List::Lines => &self.lines,
            List::Anchors => &self.anchors,
            List::Passing => &self.passing,
            List::Thrusters => &self.thrusters,
            List::Azimuths => &self.azimuths,
        }
    }
}

const fn float<R>(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&R) -> f64,
) -> Column<R> {
    Column { name, unit, meaning, value: Value::Float(value) }
}

const fn known<R>(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&R) -> Option<f64>,
) -> Column<R> {
    Column { name, unit, meaning, value: Value::Known(value) }
}

const fn name<R>(
    name: &'static str,
    meaning: &'static str,
    list: List,
    value: fn(&R) -> Option<usize>,
) -> Column<R> {
    Column { name, unit: "-", meaning, value: Value::Name(list, value) }
}

const fn word<R>(
    name: &'static str,
    meaning: &'static str,
    value: fn(&R) -> &'static str,
) -> Column<R> {
    Column { name, unit: "-", meaning, value: Value::Word(value) }
}

const fn flag<R>(name: &'static str, meaning: &'static str, value: fn(&R) -> bool) -> Column<R> {
    Column { name, unit: "-", meaning, value: Value::Flag(value) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_has_one_name_a_unit_and_a_meaning() {
        for table in reference() {
            for (index, column) in table.columns.iter().enumerate() {
                let ColumnReference { name, unit, meaning } = column;
                assert!(!unit.is_empty() && !meaning.is_empty(), "{}: {name}", table.name);
                let before = &table.columns[..index];
                assert!(before.iter().all(|other| other.name != *name), "{}: {name}", table.name);
            }
        }
    }
}
