//! From readings to the state of the ship at the first touch, with uncertainties.

pub(crate) mod channels;
pub(crate) mod checks;
pub(crate) mod find;
pub(crate) mod parabola;
pub(crate) mod state;
pub(crate) mod touch;

/// A number with its standard deviation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Uncertain {
    /// The number.
    pub value: f64,
    /// Its standard deviation.
    pub sd: f64,
}
