//! Result tables for Python: NumPy columns, which `fenderline._results` wraps.

use fenderline_results::{KeptTable, KeptValues};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyList;

/// A `fenderline.Table`; NumPy takes over the columns' memory.
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

/// `fenderline.Results` of the tables of a run.
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
