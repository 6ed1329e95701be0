//! Errors of table files.

use core::fmt;
use std::path::{Path, PathBuf};

use fenderline_scenario::{FileError, nearest, printable_line};

/// A table that cannot be read, or does not hold the requested data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong.
    pub fault: TableFault,
}

/// What is wrong with a table file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TableFault {
    /// The file cannot be opened.
    File(FileError),
    /// The file is damaged, or is not a file of this form.
    Damaged {
        /// The reader's text.
        why: String,
    },
    /// The first line of the file is not a line of column names.
    NoHead {
        /// The first cell of the first line that is a number; `None` if the file is empty.
        number: Option<String>,
    },
    /// Two columns have this name.
    TwoOfOneName {
        /// The name.
        name: String,
    },
    /// The table has no column of the requested name.
    NoColumn {
        /// The requested name.
        name: String,
        /// The nearest existing name.
        nearest: Option<String>,
        /// All columns.
        columns: Vec<String>,
    },
    /// The number of cells in a line differs from the number of heads.
    UnequalLines {
        /// Line, from 1.
        line: u64,
        /// Number of cells of the line.
        cells: u64,
        /// Number of heads.
        heads: u64,
    },
    /// A cell of a column of numbers does not hold a number.
    NotANumber {
        /// Column.
        column: String,
        /// Line of a text file or row of a Parquet file, counted from 1.
        line: u64,
        /// The cell.
        text: String,
    },
    /// A column of a Parquet file holds lists or binary data.
    NotPlain {
        /// Column.
        column: String,
    },
}

impl TableError {
    pub(super) fn new(path: &Path, fault: TableFault) -> TableError {
        TableError { path: path.to_owned(), fault }
    }

    pub(super) fn damaged(path: &Path, why: impl fmt::Display) -> TableError {
        TableError::new(path, TableFault::Damaged { why: why.to_string() })
    }
}

impl TableFault {
    pub(super) fn no_column(name: &str, columns: &[&str]) -> TableFault {
        TableFault::NoColumn {
            name: name.to_owned(),
            nearest: nearest(name, columns.iter().copied()).map(str::to_owned),
            columns: columns.iter().map(|&column| column.to_owned()).collect(),
        }
    }
}

/// Longest cell that an error shows (characters).
const SHOWN: usize = 40;

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = printable_line(&self.path.display().to_string()).into_owned();
        let cut = |text: &str| printable_line(text).chars().take(SHOWN).collect::<String>();
        match &self.fault {
            TableFault::File(error) => write!(f, "cannot read {error}"),
            TableFault::Damaged { why } => write!(f, "{path}: {}", printable_line(why)),
            TableFault::NoHead { number: None } => write!(f, "{path}: the file is empty"),
            TableFault::NoHead { number: Some(number) } => write!(
                f,
                "{path}:1: `{}` is a number: the first line must name the columns, as in `speed [cm/s]`",
                cut(number)
            ),
            TableFault::TwoOfOneName { name } => {
                write!(f, "{path}: two columns are called `{}`", cut(name))
            }
            TableFault::NoColumn { name, nearest, columns } => {
                write!(f, "{path}: there is no column `{}`", cut(name))?;
                match nearest {
                    Some(nearest) => write!(f, "; did you mean `{}`?", cut(nearest)),
                    None => {
                        let names: Vec<String> = columns.iter().map(|name| cut(name)).collect();
                        write!(f, "; the columns are {}", names.join(", "))
                    }
                }
            }
            TableFault::UnequalLines { line, cells, heads } => write!(
                f,
                "{path}:{line}: the row has {cells} cells, but the file has {heads} columns; with \
                 decimal commas, put semicolons between the columns"
            ),
            TableFault::NotANumber { column, line, text } => write!(
                f,
                "{path}:{line}: column `{}`: `{}` is not a number; leave the cell empty if there \
                 is no number",
                cut(column),
                cut(text)
            ),
            TableFault::NotPlain { column } => {
                write!(f, "{path}: column `{}` holds neither numbers nor texts", cut(column))
            }
        }
    }
}

impl std::error::Error for TableError {}
