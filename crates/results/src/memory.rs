//! Tables in memory, column by column.

use std::fmt;

use crate::columns::{Column, List, Names, Value};
use crate::medium::{Medium, Table};

/// Keeps tables in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct InMemory;

/// A table of the medium [`InMemory`] that is being filled with rows of type `R`.
pub struct TableInMemory<R> {
    kept: KeptTable,
    values: Vec<Value<R>>,
}

/// A table in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptTable {
    /// Its name.
    pub name: &'static str,
    /// Its columns, of equal length.
    pub columns: Vec<KeptColumn>,
}

/// A column in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptColumn {
    /// Its name; it ends with the unit, if it has one.
    pub name: &'static str,
    /// Unit as a reader writes it; `1` for a pure number, `-` for a text or a truth value.
    pub unit: &'static str,
    /// What it means.
    pub meaning: &'static str,
    /// Its values.
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
        /// What they stand for.
        words: Vec<String>,
    },
    /// Truth values.
    Flags(Vec<bool>),
    /// Whole numbers.
    Counts(Vec<u32>),
}

/// A value that is not finite: the run failed.
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
        let kept = columns.iter().map(|column| KeptColumn {
            name: column.name,
            unit: column.unit,
            meaning: column.meaning,
            values: empty(&column.value, names),
        });
        let kept = KeptTable { name, columns: kept.collect() };
        let values = columns.into_iter().map(|column| column.value).collect();
        Ok(TableInMemory { kept, values })
    }
}

fn empty<R>(value: &Value<R>, names: &Names) -> KeptValues {
    match value {
        Value::Float(_) | Value::Known(_) => KeptValues::Floats(Vec::new()),
        Value::Name(list, _) => {
            let mut words = names.list(*list).to_vec();
            // Only fenders may be absent.
            if *list == List::Fenders {
                words.push(String::new());
            }
            KeptValues::Texts { codes: Vec::new(), words }
        }
        Value::Word(_) => KeptValues::Texts { codes: Vec::new(), words: Vec::new() },
        Value::Flag(_) => KeptValues::Flags(Vec::new()),
        Value::Count(_) => KeptValues::Counts(Vec::new()),
    }
}

impl<R> Table<R> for TableInMemory<R> {
    type Error = NotFinite;
    type Done = KeptTable;

    fn push(&mut self, row: &R) -> Result<(), NotFinite> {
        for (value, column) in self.values.iter().zip(&mut self.kept.columns) {
            match (value, &mut column.values) {
                (Value::Float(_) | Value::Known(_), KeptValues::Floats(values)) => {
                    let number = value.number(row);
                    if let Some(value) = number.filter(|number| !number.is_finite()) {
                        return Err(NotFinite { column: column.name, value });
                    }
                    values.push(number.unwrap_or(f64::NAN));
                }
                (Value::Name(_, index), KeptValues::Texts { codes, words }) => {
                    let absent = words.len().saturating_sub(1);
                    codes.push(index(row).unwrap_or(absent) as i32);
                }
                (Value::Word(word), KeptValues::Texts { codes, words }) => {
                    let word = word(row);
                    let known = words.iter().position(|known| known == word);
                    codes.push(known.unwrap_or(words.len()) as i32);
                    if known.is_none() {
                        words.push(word.to_owned());
                    }
                }
                (Value::Flag(flag), KeptValues::Flags(values)) => values.push(flag(row)),
                (Value::Count(count), KeptValues::Counts(values)) => values.push(count(row)),
                _ => unreachable!("every column was made for its values"),
            }
        }
        Ok(())
    }

    fn finish(self) -> Result<KeptTable, NotFinite> {
        Ok(self.kept)
    }
}
