//! Prints the columns of all result tables as JSON: for each table a list of name, unit and meaning. The book's
//! reference of columns is made from it.

use std::convert::Infallible;

use fenderline_results::{Column, Medium, Names, Table, Tables};
use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

/// Together these scenarios have every table.
const SCENARIOS: [&str; 2] =
    ["berth/asd_tugs_push_alongside.toml", "berth/alongside_with_two_tugs.toml"];

/// Keeps the columns of a table and no rows.
struct ColumnsOnly;

struct Columns {
    name: &'static str,
    columns: Vec<[&'static str; 3]>,
}

impl Medium for ColumnsOnly {
    type Error = Infallible;
    type Done = Columns;
    type Table<R> = Columns;

    fn start<R>(
        &self,
        name: &'static str,
        columns: Vec<Column<R>>,
        _: &Names,
    ) -> Result<Columns, Infallible> {
        let columns = columns.iter().map(|column| [column.name, column.unit, column.meaning]);
        Ok(Columns { name, columns: columns.collect() })
    }
}

impl<R> Table<R> for Columns {
    type Error = Infallible;
    type Done = Columns;

    fn push(&mut self, _: &R) -> Result<(), Infallible> {
        Ok(())
    }

    fn finish(self) -> Result<Columns, Infallible> {
        Ok(self)
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut tables: Vec<Columns> = Vec::new();
    for scenario in SCENARIOS {
        let file = format!("{}/../../scenarios/{scenario}", env!("CARGO_MANIFEST_DIR"));
        let simulation = Simulation::new(Scenario::load(file.as_ref(), &[])?.setup)?;
        let found = Tables::start(&ColumnsOnly, simulation.setup(), simulation.energy())?;
        for table in found.finish()? {
            if tables.iter().all(|known| known.name != table.name) {
                tables.push(table);
            }
        }
    }
    // Rust's quoting of these texts, which have no control characters, is JSON's.
    let lines = tables.iter().map(|table| format!("  {:?}: {:?}", table.name, table.columns));
    println!("{{\n{}\n}}", lines.collect::<Vec<_>>().join(",\n"));
    Ok(())
}
