//! A row of a table of wind or current coefficients.

/// Whether a table of coefficients is for wind or for current.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flow {
    Wind,
    Current,
}

/// A row of a table in the program's own axes: angle γ (deg) and [X, Y, N] divided by dynamic pressure (m², m², m³).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    pub(crate) row: usize,
    pub(crate) angle_deg: f64,
    pub(crate) value: [f64; 3],
}
