//! The text of the session's past, for pages that ask for it at the same tick.

use std::sync::Arc;

use crate::hub::Text;

/// The version of the past, and its text.
#[derive(Debug, Default)]
pub(super) struct KeptHistory(Option<((usize, u64, u64), Text)>);

impl KeptHistory {
    /// The text of a version of the past: the one that is kept, or a new one.
    pub(super) fn text(
        &mut self,
        version: (usize, u64, u64),
        write: impl FnOnce() -> Text,
    ) -> Text {
        match &self.0 {
            Some((kept, text)) if *kept == version => Arc::clone(text),
            _ => {
                let text = write();
                self.0 = Some((version, Arc::clone(&text)));
                text
            }
        }
    }
}
