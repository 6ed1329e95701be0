//! Values by name: pure functions and standard manoeuvres of the simulator, and scenarios of more than two bodies.
//!
//! Each file has one subject and fills a [`Values`]. It has the inputs of its cases, never the published numbers.

mod berth;
mod dolphin;
pub(crate) mod estimates;
mod finite_elements;
mod float;
mod hull;
mod manoeuvres;
mod propeller;
mod sea;
mod shallow;
mod ships;
mod wind;
mod worked;

use std::collections::BTreeMap;

/// A value with its unit; the unit is empty for a plain number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Value {
    pub(crate) value: f64,
    pub(crate) unit: &'static str,
}

/// Values by their names in the files under `validation/`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Values(BTreeMap<String, Value>);

impl Values {
    /// Computes all of them.
    pub(crate) fn all() -> Values {
        let mut values = Values::default();
        manoeuvres::compute(&mut values);
        estimates::compute(&mut values);
        hull::compute(&mut values);
        shallow::compute(&mut values);
        propeller::compute(&mut values);
        wind::compute(&mut values);
        sea::compute(&mut values);
        float::compute(&mut values);
        berth::compute(&mut values);
        dolphin::compute(&mut values);
        worked::compute(&mut values);
        finite_elements::compute(&mut values);
        values
    }

    pub(crate) fn put(&mut self, name: impl Into<String>, value: f64, unit: &'static str) {
        let name = name.into();
        let before = self.0.insert(name.clone(), Value { value, unit });
        assert!(before.is_none(), "two values have the name {name}");
    }

    /// The value called `name`.
    ///
    /// # Panics
    /// There is no such value: a bug.
    pub(crate) fn get(&self, name: &str) -> Value {
        *self.0.get(name).unwrap_or_else(|| panic!("no computed value is called {name}"))
    }

    /// All names.
    #[cfg(test)]
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }
}
