//! When a time step begins, and how long it is.

/// A time step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepTime {
    /// Start of the step (s).
    pub t_s: f64,
    /// Length of the step (s).
    pub step_s: f64,
}

impl StepTime {
    /// End of the step (s).
    #[must_use]
    #[inline]
    pub fn end_s(self) -> f64 {
        self.t_s + self.step_s
    }
}
