//! The table of a vessel that is being read, and errors about this table.

use std::fmt::Display;

use crate::library::LookUpError;
use crate::vessels::keys::FileVesselKey;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::sources::Sources;
use fenderline_keys::typed_key::Key;

/// The table of a vessel that is being read.
pub(super) struct Reading<'r, 's> {
    pub(super) sources: &'r Sources<'s>,
    pub(super) table: Of<'r, FileVesselKey>,
}

impl Reading<'_, '_> {
    pub(super) fn at<T, V>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, V>,
        error: &dyn Display,
    ) -> ScenarioError {
        let path = table.path_to(item);
        self.sources.error(&item.span, &path, format!("`{path}`: {error}"))
    }

    pub(super) fn looked_up<V>(&self, item: Entry<'_, V>, error: &LookUpError) -> ScenarioError {
        self.at(self.table, item, error).with_help(error.help())
    }

    pub(super) fn missing<T, V>(
        &self,
        table: Of<'_, T>,
        key: Key<T, V>,
        help: &str,
    ) -> ScenarioError {
        let path = table.path_of(key);
        let message = format!("`{path}` is missing");
        self.sources.error(&table.span, &path, message).with_help(help)
    }

    pub(super) fn together<T, V, S, W>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, V>,
        with: Key<S, W>,
    ) -> ScenarioError {
        let path = table.path_to(item);
        let message = format!("`{path}` does not go together with `{with}`");
        self.sources.error(&item.key_span, &path, message)
    }
}
