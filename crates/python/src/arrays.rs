//! Fills NumPy arrays, which Python and this package share.
//!
//! NumPy owns the memory of the arrays, so that no Python array can outlive its memory. A step of a simulation or
//! engine reads its inputs from these arrays and writes its results into them. Results are given to Python as read-only
//! views.

use fenderline_contact::{BodyState, Wrench, vec2};
use numpy::{PyArray2, PyArrayMethods, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::errors;

/// Number of values of a body's state: north, east, heading, velocity north and east, rate of turn.
pub(crate) const STATE: usize = 6;
/// Number of values of a wrench: force north and east, moment.
pub(crate) const WRENCH: usize = 3;

/// An array of rows that both this package and Python may write.
pub(crate) struct Shared(Py<PyArray2<f64>>);

impl Shared {
    /// Zeros.
    pub(crate) fn zeros(py: Python<'_>, rows: usize, columns: usize) -> Shared {
        Shared(PyArray2::zeros(py, [rows, columns], false).unbind())
    }

    /// The array for Python.
    pub(crate) fn array(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.0.clone_ref(py)
    }

    /// Calls `read` with the present values of the array.
    pub(crate) fn read<T>(&self, py: Python<'_>, read: impl FnOnce(&[f64]) -> T) -> PyResult<T> {
        let array: PyReadonlyArray2<'_, f64> = self.0.bind(py).try_readonly()?;
        Ok(read(array.as_slice()?))
    }

    /// Calls `write` with the memory of the array.
    pub(crate) fn write(&self, py: Python<'_>, write: impl FnOnce(&mut [f64])) -> PyResult<()> {
        let mut array = self.0.bind(py).try_readwrite()?;
        write(array.as_slice_mut()?);
        Ok(())
    }
}

/// An array that is read-only for Python.
pub(crate) struct ReadOnly {
    own: Shared,
    view: Py<PyAny>,
}

impl ReadOnly {
    /// An array of zeros. Python's view has a first axis of `rows` and then the axes `others`; the memory below the
    /// view has two axes.
    pub(crate) fn zeros(py: Python<'_>, rows: usize, others: &[usize]) -> PyResult<ReadOnly> {
        let own = Shared::zeros(py, rows, others.iter().product());
        let mut shape = vec![rows];
        shape.extend_from_slice(others);
        let view = own.0.bind(py).call_method1("reshape", (shape,))?.call_method0("view")?;
        view.getattr("flags")?.setattr("writeable", false)?;
        Ok(ReadOnly { own, view: view.unbind() })
    }

    /// The view for Python.
    pub(crate) fn view(&self, py: Python<'_>) -> Py<PyAny> {
        self.view.clone_ref(py)
    }

    pub(crate) fn write(&self, py: Python<'_>, write: impl FnOnce(&mut [f64])) -> PyResult<()> {
        self.own.write(py, write)
    }
}

/// Reads states of bodies from an array, row by row.
pub(crate) fn read_states(numbers: &[f64], into: &mut [BodyState]) -> PyResult<()> {
    check_length(numbers, into.len() * STATE)?;
    for (row, state) in numbers.chunks_exact(STATE).zip(into) {
        *state = BodyState {
            position_m: vec2(row[0], row[1]),
            heading_rad: row[2],
            velocity_mps: vec2(row[3], row[4]),
            yaw_rate_radps: row[5],
        };
    }
    Ok(())
}

/// Writes states of bodies into an array, row by row.
pub(crate) fn write_states(states: &[BodyState], into: &mut [f64]) {
    for (state, row) in states.iter().zip(into.chunks_exact_mut(STATE)) {
        let (x, v) = (state.position_m, state.velocity_mps);
        row.copy_from_slice(&[x.x, x.y, state.heading_rad, v.x, v.y, state.yaw_rate_radps]);
    }
}

/// Reads wrenches from an array, row by row.
pub(crate) fn read_wrenches(numbers: &[f64], into: &mut [Wrench]) -> PyResult<()> {
    check_length(numbers, into.len() * WRENCH)?;
    for (row, wrench) in numbers.chunks_exact(WRENCH).zip(into) {
        *wrench = Wrench { force_n: vec2(row[0], row[1]), moment_nm: row[2] };
    }
    Ok(())
}

/// Writes wrenches into an array, row by row.
pub(crate) fn write_wrenches(wrenches: &[Wrench], into: &mut [f64]) {
    for (wrench, row) in wrenches.iter().zip(into.chunks_exact_mut(WRENCH)) {
        row.copy_from_slice(&[wrench.force_n.x, wrench.force_n.y, wrench.moment_nm]);
    }
}

/// Checks the length of the array, because Python can change an array's shape.
fn check_length(numbers: &[f64], wanted: usize) -> PyResult<()> {
    if numbers.len() == wanted {
        return Ok(());
    }
    let found = numbers.len();
    Err(errors::bad_argument(format!("the array has {found} numbers, but needs {wanted}")))
}
