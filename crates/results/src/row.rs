//! What a row of a table can do.

/// A row of a table: its subject, and how the row takes up later steps of its interval.
pub(crate) trait Row: Sized {
    /// The subject of the row, such as the number of a fender. Rows of one interval are written in the order of this
    /// key.
    type Key: Ord;

    /// What the row is about.
    fn key(&self) -> Self::Key;

    /// Called if the row begins in a later step of the interval than the first step.
    fn begin_late(&mut self) {}

    /// Takes up a later step.
    fn join(&mut self, later: Self);

    /// Makes means of sums: the row has taken up `own` steps of the `all` of the interval.
    fn close(&mut self, own: f64, all: f64);
}
