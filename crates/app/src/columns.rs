//! `fenderline columns`: the columns of the result files.

use core::fmt::Write as _;

use fenderline_results::{TableReference, reference};
use serde_json::{Map, Value, json};

use crate::cli::ColumnsArgs;
use crate::failure::Failure;
use crate::terminal::{answer, say_json};

/// Prints every column of the result tables with unit and meaning, as Markdown or JSON.
///
/// # Errors
/// Fails if standard output cannot be written.
pub(crate) fn columns(args: &ColumnsArgs) -> Result<(), Failure> {
    let tables = reference();
    if args.json {
        say_json(&format!("{:#}\n", as_json(&tables)))
    } else {
        answer(&markdown(&tables))
    }
}

fn markdown(tables: &[TableReference]) -> String {
    let mut text = String::from(
        "A row stands for one output interval: one time step, or as many as `[output] interval` of \
         the scenario says. States are those at the start of the interval, forces are means over \
         the interval, columns that begin with `peak_` hold the largest value of any step, works \
         are sums.\n\n",
    );
    for table in tables {
        let _ = writeln!(
            text,
            "## `{}`: {}\n\n| column | unit | meaning |\n|---|---|---|",
            table.name, table.rows
        );
        for column in &table.columns {
            let _ = writeln!(text, "| `{}` | {} | {} |", column.name, column.unit, column.meaning);
        }
        text.push('\n');
    }
    text
}

/// The tables as JSON: for each table a list of the name, unit and meaning of its columns.
fn as_json(tables: &[TableReference]) -> Value {
    let table = |table: &TableReference| {
        let columns = table.columns.iter().map(|c| json!([c.name, c.unit, c.meaning]));
        (table.name.to_owned(), columns.collect())
    };
    Value::Object(tables.iter().map(table).collect::<Map<_, _>>())
}
