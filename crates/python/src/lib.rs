//! The engine and the simulator for Python: the module `fenderline._native`. The Python package around this module is
//! in `python/fenderline`, with types in `_native.pyi`.
//!
//! Mistakes of users raise exceptions of `fenderline._errors`; bugs panic, which PyO3 turns into exceptions too. NumPy
//! owns all memory that Python sees (`arrays`), so that no array outlives its memory and no `unsafe` is needed.
#![forbid(unsafe_code)]
#![allow(
    missing_docs,
    reason = "the items are private; the classes have the documentation for Python"
)]

mod arrays;
mod campaign;
mod contacts;
mod controls;
mod docking;
mod engine;
mod errors;
mod fleet;
mod journal;
mod many;
mod parallel;
mod pickled;
mod run;
mod scenario;
mod simulation;
mod summaries;
mod tables;
mod totals;
mod unpickled;
mod variants;
mod vessels;
mod whole;

use pyo3::prelude::*;

/// The native part of the package `fenderline`.
#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("CONTACT_TYPE", contacts::contact_type(module.py())?)?;
    module.add_class::<scenario::Scenario>()?;
    module.add_class::<engine::Engine>()?;
    module.add_class::<simulation::Simulation>()?;
    module.add_class::<simulation::SimulationState>()?;
    module.add_class::<contacts::StepEvent>()?;
    module.add_class::<fleet::Fleet>()?;
    module.add_class::<docking::Docking>()?;
    module.add_class::<campaign::Campaign>()?;
    module.add_function(wrap_pyfunction!(engine::seconds_of_steps, module)?)?;
    module.add_function(wrap_pyfunction!(scenario::scenario_of_parts, module)?)?;
    module.add_function(wrap_pyfunction!(unpickled::simulation_of_parts, module)?)?;
    module.add_function(wrap_pyfunction!(contacts::step_event, module)?)?;
    module.add_function(wrap_pyfunction!(vessels::vessel_files, module)?)?;
    module.add_function(wrap_pyfunction!(vessels::vessel_numbers, module)?)?;
    module.add_function(wrap_pyfunction!(many::run_variants, module)?)
}
