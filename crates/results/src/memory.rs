//! Keeps tables in memory, column by column.

use std::fmt;

use crate::columns::{Column, List, Names, Value};
use crate::medium::{Medium, Table};

/// Keeps tables in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct InMemory;

/// A table of the medium [`InMemory`] that is being filled with rows of type `R`.
pub struct TableInMemory<R> {
    name: &'static str,
    columns: Vec<Filled<R>>,
}

/// A column that is being filled.
struct Filled<R> {
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    values: Filling<R>,
}

/// The function that takes a column's values from rows, and the values so far.
enum Filling<R> {
    Float(fn(&R) -> f64, Vec<f64>),
    Nth(usize, fn(&R, usize) -> f64, Vec<f64>),
    Known(fn(&R) -> Option<f64>, Vec<f64>),
    /// Names, as codes of the different names; `absent` is the code of a row without a name.
    Name {
        index: fn(&R) -> Option<usize>,
        absent: usize,
        codes: Vec<i32>,
        words: Vec<String>,
    },
    Word {
        word: fn(&R) -> &'static str,
        codes: Vec<i32>,
        words: Vec<String>,
    },
    Flag(fn(&R) -> bool, Vec<bool>),
    Count(fn(&R) -> u32, Vec<u32>),
}

/// A table in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptTable {
    /// Name of the table.
    pub name: &'static str,
    /// Columns of the table, of equal length.
    pub columns: Vec<KeptColumn>,
}

/// A column in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptColumn {
    /// Name of the column; it ends with the unit, if it has one.
    pub name: &'static str,
    /// Unit of the column as a reader writes it; `1` for a pure number, `-` for a text or a truth value.
    pub unit: &'static str,
    /// Meaning of the column.
    pub meaning: &'static str,
    /// Values of the column.
    pub values: KeptValues,
}

/// The values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum KeptValues {
    /// Numbers.
    Floats(Vec<f64>),
    /// Texts, as indices into a list of the different texts.
    Texts {
        /// One index per row.
        codes: Vec<i32>,
        /// The texts.
        words: Vec<String>,
    },
    /// Truth values.
    Flags(Vec<bool>),
    /// Whole numbers.
    Counts(Vec<u32>),
}

/// An error: a value is not finite, so that the run failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotFinite {
    /// The column.
    pub column: &'static str,
    /// The value.
    pub value: f64,
}

impl fmt::Display for NotFinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the simulation gave {} for `{}`", self.value, self.column)
    }
}

impl std::error::Error for NotFinite {}

impl KeptTable {
    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| match &column.values {
            KeptValues::Floats(values) => values.len(),
            KeptValues::Texts { codes, .. } => codes.len(),
            KeptValues::Flags(values) => values.len(),
            KeptValues::Counts(values) => values.len(),
        })
    }
}

impl Medium for InMemory {
    type Error = NotFinite;
    type Done = KeptTable;
    type Table<R> = TableInMemory<R>;

    fn start<R>(
        &self,
        name: &'static str,
        columns: Vec<Column<R>>,
        names: &Names,
    ) -> Result<TableInMemory<R>, NotFinite> {
        let columns = columns.into_iter().map(|column| Filled {
            name: column.name,
            unit: column.unit,
            meaning: column.meaning,
            values: Filling::of(column.value, names),
        });
        Ok(TableInMemory { name, columns: columns.collect() })
    }
}

impl<R> Filling<R> {
    fn of(value: Value<R>, names: &Names) -> Filling<R> {
        match value {
            Value::Float(number) => Filling::Float(number, Vec::new()),
            Value::Nth(index, number) => Filling::Nth(index, number, Vec::new()),
            Value::Known(number) => Filling::Known(number, Vec::new()),
            Value::Name(list, index) => {
                let mut words = names.list(list).to_vec();
                // Only fenders may be absent.
                if list == List::Fenders {
                    words.push(String::new());
                }
                let absent = words.len().saturating_sub(1);
                Filling::Name { index, absent, codes: Vec::new(), words }
            }
            Value::Word(word) => Filling::Word { word, codes: Vec::new(), words: Vec::new() },
            Value::Flag(flag) => Filling::Flag(flag, Vec::new()),
            Value::Count(count) => Filling::Count(count, Vec::new()),
        }
    }

    /// Adds the column's value of a row.
    ///
    /// # Errors
    /// Gives the number back if it is not finite.
    fn push(&mut self, row: &R) -> Result<(), f64> {
        match self {
            Filling::Float(number, values) => values.push(finite(number(row))?),
            Filling::Nth(index, number, values) => values.push(finite(number(row, *index))?),
            Filling::Known(number, values) => {
                values.push(number(row).map_or(Ok(f64::NAN), finite)?);
            }
            Filling::Name { index, absent, codes, .. } => {
                codes.push(index(row).unwrap_or(*absent) as i32);
            }
            Filling::Word { word, codes, words } => {
                let word = word(row);
                let known = words.iter().position(|known| known == word);
                codes.push(known.unwrap_or(words.len()) as i32);
                if known.is_none() {
                    words.push(word.to_owned());
                }
            }
            Filling::Flag(flag, values) => values.push(flag(row)),
            Filling::Count(count, values) => values.push(count(row)),
        }
        Ok(())
    }

    fn kept(self) -> KeptValues {
        match self {
            Filling::Float(_, values) | Filling::Nth(_, _, values) | Filling::Known(_, values) => {
                KeptValues::Floats(values)
            }
            Filling::Name { codes, words, .. } | Filling::Word { codes, words, .. } => {
                KeptValues::Texts { codes, words }
            }
            Filling::Flag(_, values) => KeptValues::Flags(values),
            Filling::Count(_, values) => KeptValues::Counts(values),
        }
    }
}

fn finite(value: f64) -> Result<f64, f64> {
    if value.is_finite() { Ok(value) } else { Err(value) }
}

impl<R> Table<R> for TableInMemory<R> {
    type Error = NotFinite;
    type Done = KeptTable;

    fn push(&mut self, row: &R) -> Result<(), NotFinite> {
        for column in &mut self.columns {
            let pushed = column.values.push(row);
            pushed.map_err(|value| NotFinite { column: column.name, value })?;
        }
        Ok(())
    }

    fn finish(self) -> Result<KeptTable, NotFinite> {
        let columns = self.columns.into_iter().map(|column| KeptColumn {
            name: column.name,
            unit: column.unit,
            meaning: column.meaning,
            values: column.values.kept(),
        });
        Ok(KeptTable { name: self.name, columns: columns.collect() })
    }
}
