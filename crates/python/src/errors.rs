//! Turns errors into Python exceptions of the classes in `fenderline._errors`.

use fenderline_embed::EngineError;
use fenderline_scenario::{LoadError, Place, ScenarioError};
use fenderline_sim::{SetupError, SimError};
use pyo3::prelude::*;

/// Makes an exception with a message, of a class in `fenderline._errors`.
fn exception(py: Python<'_>, class: &str, message: String) -> PyErr {
    let made = py.import("fenderline._errors").and_then(|m| m.getattr(class)?.call1((message,)));
    made.map_or_else(|error| error, PyErr::from_value)
}

/// Makes a `fenderline.ScenarioError` with file, line, column, key, message and help.
pub(crate) fn of_scenario(py: Python<'_>, error: &ScenarioError) -> PyErr {
    let exception = exception(py, "ScenarioError", error.to_string());
    let value = exception.value(py);
    let (file, line, column) = match error.place() {
        Place::File { name, line, column } => (name.as_str(), Some(*line), Some(*column)),
        Place::WholeFile { name } | Place::Option { text: name } => (name.as_str(), None, None),
    };
    let filled = (|| {
        value.setattr("file", file)?;
        value.setattr("line", line)?;
        value.setattr("column", column)?;
        value.setattr("key", error.key())?;
        value.setattr("message", error.message())?;
        value.setattr("help", error.help())
    })();
    filled.map_or_else(|error: PyErr| error, |()| exception)
}

/// Makes the exception for a file that cannot be read, or for an error in a file.
pub(crate) fn of_load(py: Python<'_>, error: &LoadError) -> PyErr {
    match error {
        LoadError::Refused(error) => of_scenario(py, error),
        LoadError::Unreadable(why) => exception(py, "ScenarioError", format!("cannot read {why}")),
    }
}

/// Makes the exception for a set-up that cannot be simulated.
pub(crate) fn of_setup(py: Python<'_>, error: &SetupError) -> PyErr {
    exception(py, "ScenarioError", error.to_string())
}

/// Makes the exception for a call that the engine refuses.
pub(crate) fn of_engine(py: Python<'_>, error: &EngineError) -> PyErr {
    exception(py, "EngineError", error.to_string())
}

/// Makes a `fenderline.ArgumentError`: an argument is out of its range.
pub(crate) fn argument(py: Python<'_>, message: String) -> PyErr {
    exception(py, "ArgumentError", message)
}

/// Makes the same exception as [`argument`], for code that does not hold Python's lock.
pub(crate) fn bad_argument(message: impl Into<String>) -> PyErr {
    Python::attach(|py| argument(py, message.into()))
}

/// `fenderline.CampaignError`.
pub(crate) fn of_campaign(py: Python<'_>, message: String) -> PyErr {
    let message = message.strip_prefix("error: ").map(str::to_owned).unwrap_or(message);
    exception(py, "CampaignError", message)
}

/// Makes the exception for a step of a simulation that failed.
pub(crate) fn of_simulation(py: Python<'_>, error: &SimError) -> PyErr {
    exception(py, "SimulationError", error.to_string())
}

/// Makes the exception for a call that a simulation refuses.
pub(crate) fn refused(py: Python<'_>, message: String) -> PyErr {
    exception(py, "SimulationError", message)
}
