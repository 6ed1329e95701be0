//! Reads numbers that a Python caller gives. A whole number in Python may be as large as you like, but a number in Rust
//! has bounds; an error names the bounds.

use std::ops::Range;

use pyo3::conversion::FromPyObjectOwned;
use pyo3::exceptions::{PyIndexError, PyOverflowError, PyTypeError};
use pyo3::prelude::*;

use crate::errors;

/// Most steps of one call: as many as the longest run of a scenario has.
pub(crate) const MOST_STEPS: i64 = 1_000_000_000;
/// Most simulations that take their steps together: memory for all of them is taken at once.
const MOST_AT_ONCE: i64 = 1_000_000;

/// Reads the number of steps that one call of a method shall take.
pub(crate) fn steps(given: &Bound<'_, PyAny>) -> PyResult<u64> {
    within(given, "steps", [0, MOST_STEPS]).map(|number| number as u64)
}

/// Reads the number of steps by which the states that a host gives may be old.
pub(crate) fn delay_steps(given: &Bound<'_, PyAny>) -> PyResult<u32> {
    within(given, "delay_steps", [0, i64::from(u32::MAX)]).map(|number| number as u32)
}

/// Reads the number of steps that the benchmark `bench.py` takes.
pub(crate) fn count(given: &Bound<'_, PyAny>) -> PyResult<u64> {
    within(given, "count", [0, MOST_STEPS]).map(|number| number as u64)
}

/// Reads the number of episodes that take their steps together.
pub(crate) fn episodes(given: &Bound<'_, PyAny>) -> PyResult<usize> {
    within(given, "count", [1, MOST_AT_ONCE]).map(|number| number as usize)
}

/// The number of threads.
pub(crate) fn threads(given: &Bound<'_, PyAny>) -> PyResult<usize> {
    let most = fenderline_campaign::MOST_THREADS as i64;
    within(given, "threads", [1, most]).map(|number| number as usize)
}

/// Reads the number of threads, or `None`.
pub(crate) fn some_threads(given: &Bound<'_, PyAny>) -> PyResult<Option<usize>> {
    if given.is_none() { Ok(None) } else { threads(given).map(Some) }
}

/// Reads the length of a step (s).
pub(crate) fn step_s(given: &Bound<'_, PyAny>) -> PyResult<f64> {
    real(given, "step_s")
}

/// Reads a time (s), or `None`.
pub(crate) fn until_s(given: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
    if given.is_none() { Ok(None) } else { real(given, "until_s").map(Some) }
}

/// A distance (m).
pub(crate) fn berthed_within_m(given: &Bound<'_, PyAny>) -> PyResult<f64> {
    real(given, "berthed_within_m")
}

/// Reads names of controls, each with the value that the number 1 in an action sets.
pub(crate) fn levers(given: &Bound<'_, PyAny>) -> PyResult<Vec<(String, f64)>> {
    named(given, "levers", "names with numbers")
}

/// Probabilities.
pub(crate) fn probabilities(given: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    named(given, "probabilities", "numbers in a sequence")
}

/// Reads a number, whose range the call has to check.
///
/// # Errors
/// Raises TypeError for a value that is no number, and `fenderline.ArgumentError` for a whole number that is too large
/// for us.
fn real(given: &Bound<'_, PyAny>, name: &str) -> PyResult<f64> {
    named(given, name, "a number")
}

/// Reads an argument of the type `T`; an error gives the argument's name `name` and the expected kind `kind`.
fn named<'py, T: FromPyObjectOwned<'py>>(
    given: &Bound<'py, PyAny>,
    name: &str,
    kind: &str,
) -> PyResult<T> {
    given.extract::<T>().map_err(|error| {
        let error: PyErr = error.into();
        let words = format!("{name} must be {kind}, but is {}", shown(given));
        match error.is_instance_of::<PyOverflowError>(given.py()) {
            true => errors::argument(given.py(), words),
            false => PyTypeError::new_err(words),
        }
    })
}

/// Reads the number of one of `count` things; the first has the number 0.
///
/// # Errors
/// Raises TypeError for a value that is no whole number, and IndexError for a number that is out of range.
pub(crate) fn index(given: &Bound<'_, PyAny>, what: &str, count: u64) -> PyResult<u64> {
    let number = number(given, what)?;
    let found = number.extract::<u64>().ok().filter(|number| *number < count);
    found.ok_or_else(|| {
        PyIndexError::new_err(format!(
            "{what} is {}, but there are {count}, from 0",
            shown(&number)
        ))
    })
}

/// Reads the numbers of the runs from `first` to `last - 1`, among `count` runs.
///
/// # Errors
/// Raises TypeError for a value that is no whole number, and IndexError for runs that do not exist.
pub(crate) fn range(
    first: &Bound<'_, PyAny>,
    last: &Bound<'_, PyAny>,
    count: u64,
) -> PyResult<Range<u64>> {
    let [first, last] = [number(first, "first")?, number(last, "last")?];
    if let (Ok(first), Ok(last)) = (first.extract::<u64>(), last.extract::<u64>())
        && first <= last
        && last <= count
    {
        return Ok(first..last);
    }
    let [first, last] = [shown(&first), shown(&last)];
    Err(PyIndexError::new_err(format!(
        "runs {first} to {last} were asked for, but there are {count} runs"
    )))
}

/// Reads the numbers of some of `count` things; the first has the number 0.
pub(crate) fn indices(given: &Bound<'_, PyAny>, what: &str, count: u64) -> PyResult<Vec<usize>> {
    let refused = |_| {
        let words = shown(given);
        PyTypeError::new_err(format!("{what} must be whole numbers in a sequence, but is {words}"))
    };
    let all = given.try_iter().map_err(refused)?;
    all.map(|one| index(&one?, what, count).map(|number| number as usize)).collect()
}

/// Reads a whole number that lies within bounds, both included.
///
/// # Errors
/// Raises TypeError for a value that is no whole number, and `fenderline.ArgumentError` for a number that is out of
/// range.
pub(crate) fn within(given: &Bound<'_, PyAny>, name: &str, bounds: [i64; 2]) -> PyResult<i64> {
    let number = number(given, name)?;
    let [low, high] = bounds;
    let found = number.extract::<i64>().ok().filter(|number| (low..=high).contains(number));
    found.ok_or_else(|| {
        let words = format!("{name} must be from {low} to {high}, but is {}", shown(&number));
        errors::argument(given.py(), words)
    })
}

/// Reads a value as an integer of Python.
fn number<'py>(given: &Bound<'py, PyAny>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    let index = given.py().import("operator")?.getattr("index")?;
    index.call1((given,)).map_err(|_| {
        PyTypeError::new_err(format!("{name} must be a whole number, but is {}", shown(given)))
    })
}

/// A value in a few words, for an error message.
fn shown(object: &Bound<'_, PyAny>) -> String {
    const MOST: usize = 60;
    // Python refuses to write integers of thousands of digits.
    let Ok(text) = object.repr() else { return "too large to be written".to_owned() };
    let text = text.to_string_lossy().into_owned();
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}
