//! The media in which result tables are kept: files or memory.

use crate::columns::{Column, Layout, Names};

/// A medium in which result tables are kept.
pub trait Medium {
    /// Error of the medium.
    type Error;
    /// The type of a table that is complete.
    type Done;
    /// The type of a table that is being filled with rows.
    type Table<R>: Table<R, Error = Self::Error, Done = Self::Done>;

    /// Starts a table.
    ///
    /// # Errors
    /// The medium's own.
    fn start<R>(
        &self,
        name: &'static str,
        columns: Vec<Column<R>>,
        names: &Names,
    ) -> Result<Self::Table<R>, Self::Error>;
}

/// A table that is being filled with rows of type `R`.
pub trait Table<R> {
    /// What can go wrong.
    type Error;
    /// The type of the table when it is complete.
    type Done;

    /// Adds a row.
    ///
    /// # Errors
    /// Fails with an error of the medium, or if a value is not finite.
    fn push(&mut self, row: &R) -> Result<(), Self::Error>;

    /// Ends the table.
    ///
    /// # Errors
    /// The medium's own.
    fn finish(self) -> Result<Self::Done, Self::Error>;
}

/// A table that is being filled, with its name and the number of its rows.
pub(crate) struct Counted<M: Medium, R> {
    name: &'static str,
    table: M::Table<R>,
    rows: u64,
}

impl<M: Medium, R> Counted<M, R> {
    pub(crate) fn start(
        medium: &M,
        names: &Names,
        layout: Layout<R>,
    ) -> Result<Counted<M, R>, M::Error> {
        let Layout { name, columns, .. } = layout;
        Ok(Counted { name, table: medium.start(name, columns, names)?, rows: 0 })
    }

    pub(crate) fn push(&mut self, row: &R) -> Result<(), M::Error> {
        self.rows += 1;
        self.table.push(row)
    }

    pub(crate) fn rows(&self) -> (&'static str, u64) {
        (self.name, self.rows)
    }

    pub(crate) fn finish(self) -> Result<M::Done, M::Error> {
        self.table.finish()
    }
}
