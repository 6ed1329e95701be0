//! Gives result tables to Python as NumPy columns, which `fenderline._results` wraps.

use std::collections::BTreeMap;

use fenderline_results::{KeptTable, KeptValues};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyList;

/// Makes a `fenderline.Table`; NumPy takes over the memory of the columns.
pub(crate) fn table(py: Python<'_>, table: KeptTable) -> PyResult<Bound<'_, PyAny>> {
    let columns = PyList::empty(py);
    for column in table.columns {
        let (values, words) = match column.values {
            KeptValues::Floats(values) => (PyArray1::from_vec(py, values).into_any(), None),
            KeptValues::Texts { codes, words } => {
                (PyArray1::from_vec(py, codes).into_any(), Some(words))
            }
            KeptValues::Flags(values) => (PyArray1::from_vec(py, values).into_any(), None),
            KeptValues::Counts(values) => (PyArray1::from_vec(py, values).into_any(), None),
        };
        columns.append((column.name, column.unit, column.meaning, values, words))?;
    }
    py.import("fenderline._results")?.getattr("Table")?.call1((table.name, columns))
}

/// Makes a `fenderline.Results` of the tables of a run.
pub(crate) fn results<'py>(
    py: Python<'py>,
    title: &str,
    tables: Vec<KeptTable>,
) -> PyResult<Bound<'py, PyAny>> {
    let list = PyList::empty(py);
    for kept in tables {
        list.append(table(py, kept)?)?;
    }
    py.import("fenderline._results")?.getattr("Results")?.call1((title, list))
}

/// Different texts, each once with its number, in the order of their first use.
#[derive(Default)]
pub(crate) struct Words {
    pub(crate) list: Vec<String>,
    numbers: BTreeMap<String, i32>,
}

impl Words {
    /// The number of a text; a new text gets the next number.
    pub(crate) fn code(&mut self, text: String) -> i32 {
        *self.numbers.entry(text).or_insert_with_key(|text| {
            self.list.push(text.clone());
            self.list.len() as i32 - 1
        })
    }
}

/// Joins pieces of tables: the rows of all pieces, one piece after the other. Each piece must have the same tables and
/// columns.
pub(crate) fn joined(pieces: Vec<Vec<KeptTable>>) -> Vec<KeptTable> {
    let mut pieces = pieces.into_iter();
    let mut all = pieces.next().unwrap_or_default();
    let mut others: Vec<_> = pieces.map(Vec::into_iter).collect();
    for table in &mut all {
        let same = others.iter_mut().filter_map(Iterator::next);
        let mut others: Vec<_> = same.map(|other| other.columns.into_iter()).collect();
        for column in &mut table.columns {
            let same = others.iter_mut().filter_map(Iterator::next);
            add_rows(&mut column.values, same.map(|other| other.values));
        }
    }
    all
}

/// Adds the rows of the columns `others` to the column `own`; all of them hold values of the same kind.
fn add_rows(own: &mut KeptValues, others: impl Iterator<Item = KeptValues>) {
    let mut all_words = Words::default();
    if let KeptValues::Texts { words, .. } = own {
        for word in std::mem::take(words) {
            all_words.code(word);
        }
    }
    for other in others {
        match (&mut *own, other) {
            (KeptValues::Floats(own), KeptValues::Floats(other)) => own.extend(other),
            (KeptValues::Flags(own), KeptValues::Flags(other)) => own.extend(other),
            (KeptValues::Counts(own), KeptValues::Counts(other)) => own.extend(other),
            (KeptValues::Texts { codes, .. }, KeptValues::Texts { codes: other, words }) => {
                let of: Vec<i32> = words.into_iter().map(|word| all_words.code(word)).collect();
                codes.extend(other.into_iter().map(|code| of[code as usize]));
            }
            _ => unreachable!("a column has values of one kind in all pieces"),
        }
    }
    if let KeptValues::Texts { words, .. } = own {
        *words = all_words.list;
    }
}
