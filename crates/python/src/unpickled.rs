//! Makes a simulation from its pickle.

use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::pickled::Pickled;
use crate::simulation::Simulation;

/// The simulation that a pickle's dictionary describes; `fenderline._pickling` calls this function.
#[pyfunction]
pub(crate) fn simulation_of_parts(
    py: Python<'_>,
    parts: &Bound<'_, PyDict>,
) -> PyResult<Simulation> {
    Simulation::of_pickled(py, &Pickled::of_parts(parts)?)
}
