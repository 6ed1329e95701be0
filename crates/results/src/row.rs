//! The functions that a row of a table must have.

/// A row of a table: its subject, and how it combines the steps of its interval.
pub(crate) trait Row: Sized {
    /// The subject of the row, such as the number of a fender. Rows of one interval are written in the order of this
    /// key.
    type Key: Ord;

    /// The subject of the row.
    fn key(&self) -> Self::Key;

    /// Called if the row begins in a later step of the interval than the first step.
    fn begin_late(&mut self) {}

    /// Combines the row with that of a later step of its interval.
    fn join(&mut self, later: Self);

    /// Turns sums into means: the row has combined `own` steps, and the interval has `all` steps.
    fn close(&mut self, own: f64, all: f64);
}
