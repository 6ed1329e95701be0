//! The contents of a simulation's pickle, which is a dictionary.

use fenderline_contact::{Wrench, vec2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors;
use crate::journal::Input;
use crate::scenario::Scenario;

/// The contents of a simulation's pickle: a scenario, all inputs since the start, and how far the run has come.
pub(crate) struct Pickled {
    pub(crate) scenario: Py<Scenario>,
    pub(crate) is_recorded: bool,
    pub(crate) inputs: Vec<(u64, Input)>,
    pub(crate) steps: u64,
    pub(crate) events_from: u64,
    /// Values in Python's arrays of controls and external wrenches, which the next step reads.
    pub(crate) controls: Vec<f64>,
    pub(crate) external: Vec<Wrench>,
}

/// An input in a pickle: number of steps before it, kind, index of the control or body, numbers, text of an order.
type Row = (u64, String, usize, Vec<f64>, String);

impl Pickled {
    /// Of a pickle's dictionary.
    pub(crate) fn of_parts(parts: &Bound<'_, PyDict>) -> PyResult<Pickled> {
        let item = |name: &str| {
            let missing = || errors::bad_argument(format!("the pickle has no item `{name}`"));
            parts.get_item(name)?.ok_or_else(missing)
        };
        let inputs: Vec<Row> = item("inputs")?.extract()?;
        let external: Vec<Vec<f64>> = item("external")?.extract()?;
        Ok(Pickled {
            scenario: item("scenario")?.extract()?,
            is_recorded: item("record")?.extract()?,
            inputs: inputs.into_iter().map(input).collect::<PyResult<_>>()?,
            steps: item("steps")?.extract()?,
            events_from: item("events_from")?.extract()?,
            controls: item("controls")?.extract()?,
            external: external.iter().map(|row| wrench(row)).collect::<PyResult<_>>()?,
        })
    }
}

impl<'py> IntoPyObject<'py> for Pickled {
    type Target = PyDict;
    type Output = Bound<'py, PyDict>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        let inputs: Vec<Row> = self.inputs.into_iter().map(row).collect();
        let external: Vec<Vec<f64>> = self.external.iter().map(numbers).collect();
        dict.set_item("scenario", self.scenario)?;
        dict.set_item("record", self.is_recorded)?;
        dict.set_item("inputs", inputs)?;
        dict.set_item("steps", self.steps)?;
        dict.set_item("events_from", self.events_from)?;
        dict.set_item("controls", self.controls)?;
        dict.set_item("external", external)?;
        Ok(dict)
    }
}

fn numbers(wrench: &Wrench) -> Vec<f64> {
    vec![wrench.force_n.x, wrench.force_n.y, wrench.moment_nm]
}

fn wrench(numbers: &[f64]) -> PyResult<Wrench> {
    match *numbers {
        [north, east, moment_nm] => Ok(Wrench { force_n: vec2(north, east), moment_nm }),
        _ => {
            Err(errors::bad_argument("the pickle has an external wrench that is not three numbers"))
        }
    }
}

fn row((step, input): (u64, Input)) -> Row {
    match input {
        Input::Control(index, value) => {
            (step, "control".to_owned(), index, vec![value], String::new())
        }
        Input::External(body, wrench) => {
            (step, "external".to_owned(), body, numbers(&wrench), String::new())
        }
        Input::Order(text) => (step, "order".to_owned(), 0, Vec::new(), text),
    }
}

fn input((step, kind, index, values, text): Row) -> PyResult<(u64, Input)> {
    let input = match (kind.as_str(), values.as_slice()) {
        ("control", [value]) => Input::Control(index, *value),
        ("external", values) => Input::External(index, wrench(values)?),
        ("order", []) => Input::Order(text),
        _ => return Err(errors::bad_argument(format!("the pickle has an input {kind:?}"))),
    };
    Ok((step, input))
}
