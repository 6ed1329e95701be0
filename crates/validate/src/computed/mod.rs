//! Computes values by name: from pure functions and standard manoeuvres of the simulator, and from scenarios of more
//! than two bodies.
//!
//! Each file of this folder has one subject and fills a [`Values`]. A file of this folder has the inputs of its cases,
//! never the published numbers.

mod banks;
mod berth;
mod current;
mod dolphin;
pub(crate) mod estimates;
mod finite_elements;
mod float;
mod hull;
mod manoeuvres;
mod passing;
mod propeller;
mod sea;
mod seakeeping;
mod shallow;
pub(crate) mod ships;
mod wind;
mod worked;

use std::collections::BTreeMap;

/// A computed value with its unit; the unit is empty for a plain number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Value {
    pub(crate) value: f64,
    pub(crate) unit: &'static str,
}

/// Computed values, by their names in the files under `validation/`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Values(BTreeMap<String, Value>);

/// The functions that compute the values, one for each subject.
pub(crate) const SUBJECTS: [fn(&mut Values); 16] = [
    manoeuvres::compute,
    estimates::compute,
    hull::compute,
    current::compute,
    shallow::compute,
    propeller::compute,
    wind::compute,
    sea::compute,
    float::compute,
    berth::compute,
    dolphin::compute,
    passing::compute,
    banks::compute,
    seakeeping::compute,
    worked::compute,
    finite_elements::compute,
];

impl Values {
    pub(crate) fn put(&mut self, name: impl Into<String>, value: f64, unit: &'static str) {
        let name = name.into();
        let before = self.0.insert(name.clone(), Value { value, unit });
        assert!(before.is_none(), "two computed values have the name {name}");
    }

    /// The value called `name`.
    ///
    /// # Panics
    /// Panics if there is no value of this name, which would be a bug.
    pub(crate) fn get(&self, name: &str) -> Value {
        *self.0.get(name).unwrap_or_else(|| panic!("no computed value is called {name}"))
    }

    /// All names.
    #[cfg(test)]
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }
}
