//! A row of a table of coefficients.

/// The flow of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flow {
    Wind,
    Current,
}

/// A row in this program's axes: angle γ (deg) and [X, Y, N] over dynamic pressure (m², m², m³).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    pub(crate) row: usize,
    pub(crate) angle_deg: f64,
    pub(crate) value: [f64; 3],
}
