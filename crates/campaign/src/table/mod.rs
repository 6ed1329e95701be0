//! Reads tables of many runs from files, column by column.
//!
//! [`Table::open`] reads the heads only; [`Table::numbers`] and [`Table::texts`] read one column each, so that a table
//! of any length takes the memory of one column. Table files are comma-separated text with a head line, or Apache
//! Parquet.

mod cell;
mod comma;
mod error;
mod head;
mod parquet_file;
mod texts;

use std::path::{Path, PathBuf};

use fenderline_scenario::Origin;

pub use error::{TableError, TableFault};
pub use head::Head;
pub use texts::Texts;

/// Largest table file that is read (bytes): 64 GiB, more than 10⁸ rows of a campaign.
const LARGEST_BYTES: u64 = 64 << 30;

/// A table in a file whose heads are known.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    path: PathBuf,
    heads: Vec<Head>,
    form: Form,
}

/// The format in which the table file is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// Text with this separator.
    Text { separator: u8 },
    /// Apache Parquet.
    Parquet,
}

/// A column of numbers, with one value for each row.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers {
    /// One value for each row; NaN for an empty cell.
    pub values: Vec<f64>,
    /// Number of empty cells.
    pub missing: usize,
}

impl Numbers {
    /// The values without the empty cells, in the order of the rows.
    #[must_use]
    pub fn present(&self) -> Vec<f64> {
        self.values.iter().copied().filter(|value| value.is_finite()).collect()
    }
}

impl Table {
    /// Opens a table and reads its heads. A file whose name ends in `.parquet` is Parquet, every other file is text.
    /// The separator of a text file is that of its head line: a tab, a semicolon, or a comma. If semicolons separate
    /// the cells, a comma in a number is the decimal point.
    ///
    /// # Errors
    /// Fails if the file cannot be read, has no head line, or has two columns of the same name.
    pub fn open(path: &Path) -> Result<Table, TableError> {
        let is_parquet = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("parquet"));
        let (heads, form) = match is_parquet {
            true => (parquet_file::heads(path)?, Form::Parquet),
            false => {
                let (heads, separator) = comma::heads(path)?;
                (heads, Form::Text { separator })
            }
        };
        for (index, head) in heads.iter().enumerate() {
            if heads[..index].iter().any(|earlier| earlier.name == head.name) {
                let fault = TableFault::TwoOfOneName { name: head.name.clone() };
                return Err(TableError::new(path, fault));
            }
        }
        Ok(Table { path: path.to_owned(), heads, form })
    }

    /// The file.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The columns, in the order of the file.
    #[must_use]
    pub fn heads(&self) -> &[Head] {
        &self.heads
    }

    /// Whether the table has a column of this name.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.heads.iter().any(|head| head.name == name)
    }

    /// A column's head. The unit may stand in the name, as in `energy [kJ]`.
    ///
    /// # Errors
    /// Fails if the table has no such column; the error names the column with the nearest name.
    pub fn head(&self, name: &str) -> Result<&Head, TableError> {
        self.place(name).map(|place| &self.heads[place])
    }

    /// A column of numbers. Empty cells, and cells with `NaN`, `NA` or `n/a`, are missing; `true` and `false` are 1 and
    /// 0.
    ///
    /// # Errors
    /// Fails if the table has no column `name`, if the file cannot be read, or if a cell holds a text that is no
    /// number, or a number that is not finite.
    pub fn numbers(&self, name: &str) -> Result<Numbers, TableError> {
        let place = self.place(name)?;
        match self.form {
            Form::Text { separator } => {
                comma::numbers(&self.path, separator, place, &self.heads[place].name)
            }
            Form::Parquet => parquet_file::numbers(&self.path, place, &self.heads[place].name),
        }
    }

    /// Reads a column of texts; an empty cell gives an empty text.
    ///
    /// # Errors
    /// Fails if the table has no such column, or if the file cannot be read.
    pub fn texts(&self, name: &str) -> Result<Texts, TableError> {
        let place = self.place(name)?;
        match self.form {
            Form::Text { separator } => comma::texts(&self.path, separator, place),
            Form::Parquet => parquet_file::texts(&self.path, place, &self.heads[place].name),
        }
    }

    /// The place of a row (counted from 0) for errors about its value in a column: the line of a text file, or a
    /// Parquet file as a whole, without a line.
    #[must_use]
    pub fn origin(&self, column: &str, row: usize) -> Origin {
        let name = self.path.display().to_string();
        let found = match (self.form, self.place(column)) {
            (Form::Text { separator }, Ok(place)) => {
                comma::line_of_row(&self.path, separator, place, row)
            }
            _ => None,
        };
        match found {
            Some(comma::Line { number, text, column, length }) => {
                Origin::line(&name, number, column, &text, length)
            }
            None => Origin::file(&format!("{name}, row {}", row + 1)),
        }
    }

    fn place(&self, name: &str) -> Result<usize, TableError> {
        let wanted = Head::of_text(name).name;
        self.heads.iter().position(|head| head.name == name || head.name == wanted).ok_or_else(
            || {
                let names: Vec<&str> = self.heads.iter().map(|head| head.name.as_str()).collect();
                TableError::new(&self.path, TableFault::no_column(name, &names))
            },
        )
    }
}
