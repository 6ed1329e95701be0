//! The engine and the simulator for Python: the module `fenderline._native`. What Python sees is documented in
//! `python/fenderline/_native.pyi`, the package around it is in `python/fenderline`.
//!
//! Users' mistakes are exceptions of `fenderline._errors`; our own mistakes panic, which PyO3 makes an exception
//! too. Memory that Python sees is NumPy's own (`arrays`), so that nothing can outlive it and no `unsafe` is
//! needed.
#![forbid(unsafe_code)]
#![allow(missing_docs, reason = "private items; Python's documentation stands on the classes")]

mod arrays;
mod contacts;
mod controls;
mod engine;
mod errors;
mod fleet;
mod many;
mod parallel;
mod run;
mod scenario;
mod simulation;
mod summaries;
mod tables;
mod variants;

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
    module.add_function(wrap_pyfunction!(engine::seconds_of_steps, module)?)?;
    module.add_function(wrap_pyfunction!(many::run_variants, module)?)
}
