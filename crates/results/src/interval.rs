//! Makes rows of tables that stand for several time steps.

use std::collections::BTreeMap;

use crate::columns::{Layout, Names};
use crate::medium::{Counted, Medium};
use crate::row::Row;

/// A table, and the rows of the present interval.
pub(crate) struct Rows<M: Medium, R: Row> {
    table: Counted<M, R>,
    open: BTreeMap<R::Key, (R, u32)>,
}

/// The output interval that a step is in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Interval {
    steps_per_row: u64,
    /// Steps of the interval so far, this step included.
    steps: u64,
    /// Start of the interval (s).
    pub(crate) start_s: f64,
}

impl Interval {
    /// Makes an interval before the first time step.
    pub(crate) fn new(steps_per_row: u64) -> Interval {
        Interval { steps_per_row, steps: 0, start_s: 0.0 }
    }

    /// Continues the interval with a time step that begins at `t_s`.
    pub(crate) fn advance(&mut self, t_s: f64) {
        if self.steps == 0 {
            self.start_s = t_s;
        }
        self.steps += 1;
    }

    /// Whether the last step of the interval was taken.
    pub(crate) fn is_over(&self) -> bool {
        self.steps == self.steps_per_row
    }

    /// Whether the interval has begun.
    pub(crate) fn is_begun(&self) -> bool {
        self.steps > 0
    }

    /// Ends the interval, so that the next time step begins a new interval.
    pub(crate) fn end(&mut self) {
        self.steps = 0;
    }

    fn is_first_step(&self) -> bool {
        self.steps == 1
    }
}

impl<M: Medium, R: Row> Rows<M, R> {
    pub(crate) fn start(
        medium: &M,
        names: &Names,
        layout: Layout<R>,
    ) -> Result<Rows<M, R>, M::Error> {
        Ok(Rows { table: Counted::start(medium, names, layout)?, open: BTreeMap::new() })
    }

    /// Adds the row of one time step of the interval.
    pub(crate) fn push(&mut self, interval: &Interval, mut row: R) -> Result<(), M::Error> {
        if interval.steps_per_row == 1 {
            // In the order in which they come.
            return self.table.push(&row);
        }
        match self.open.get_mut(&row.key()) {
            Some((open, own)) => {
                open.join(row);
                *own += 1;
            }
            None => {
                if !interval.is_first_step() {
                    row.begin_late();
                }
                self.open.insert(row.key(), (row, 1));
            }
        }
        Ok(())
    }

    /// Writes the rows of an output interval that is over.
    pub(crate) fn close(&mut self, interval: &Interval) -> Result<(), M::Error> {
        for (_, (mut row, own)) in core::mem::take(&mut self.open) {
            row.close(f64::from(own), interval.steps as f64);
            self.table.push(&row)?;
        }
        Ok(())
    }

    /// Name of the table, with the number of rows written.
    pub(crate) fn rows(&self) -> (&'static str, u64) {
        self.table.rows()
    }

    /// Ends the table.
    pub(crate) fn finish(self) -> Result<M::Done, M::Error> {
        self.table.finish()
    }
}
