//! Keeps the texts of the session's past, for several pages that ask for them at the same tick.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::hub::Text;

/// The vessel to which a past belongs, and true if the values are those that her instruments showed.
type Of = (Option<usize>, bool);

/// The number of a version of the past, and the texts that were made of it.
#[derive(Debug, Default)]
pub(super) struct KeptHistory {
    version: (usize, u64, u64),
    texts: BTreeMap<Of, Text>,
}

impl KeptHistory {
    /// The text of a vessel's past in a version: the text that is kept, or a new text that `write` makes.
    ///
    /// # Errors
    /// The error of `write`.
    pub(super) fn text<E>(
        &mut self,
        version: (usize, u64, u64),
        of: Of,
        write: impl FnOnce() -> Result<Text, E>,
    ) -> Result<Text, E> {
        if self.version != version {
            self.version = version;
            self.texts.clear();
        }
        if let Some(text) = self.texts.get(&of) {
            return Ok(Arc::clone(text));
        }
        let text = write()?;
        self.texts.insert(of, Arc::clone(&text));
        Ok(text)
    }
}
