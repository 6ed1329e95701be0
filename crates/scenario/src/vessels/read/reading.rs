//! A table that is read, and the errors about it.

use std::fmt::Display;

use fenderline_keys::checked::{Item, Table};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::sources::Sources;

use crate::library::LookUpError;

/// A table of a vessel.
pub(super) struct Reading<'r, 's> {
    pub(super) sources: &'r Sources<'s>,
    pub(super) table: &'r Table,
}

impl Reading<'_, '_> {
    pub(super) fn at(&self, table: &Table, item: &Item, error: &dyn Display) -> ScenarioError {
        let path = table.path_of(item.name);
        self.sources.error(&item.span, &path, format!("`{path}`: {error}"))
    }

    pub(super) fn looked_up(&self, item: &Item, error: &LookUpError) -> ScenarioError {
        self.at(self.table, item, error).with_help(error.help())
    }

    pub(super) fn missing(&self, table: &Table, name: &str, help: &str) -> ScenarioError {
        let path = table.path_of(name);
        let message = format!("`{path}` is missing");
        self.sources.error(&table.span, &path, message).with_help(help)
    }

    pub(super) fn together(&self, table: &Table, item: &Item, with: &str) -> ScenarioError {
        let path = table.path_of(item.name);
        let message = format!("`{path}` does not go together with `{with}`");
        self.sources.error(&item.key_span, &path, message)
    }
}
