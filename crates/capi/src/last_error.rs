//! The message of the last failed call.

use std::cell::RefCell;

thread_local! {
    /// Message of the last failed call on this thread.
    static LAST: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Keeps a message for [`crate::fl_last_error`].
#[cold]
pub(crate) fn remember(text: String) {
    // It fails only while the thread ends.
    let _ = LAST.try_with(|last| *last.borrow_mut() = text);
}

/// The message of the last failed call on this thread; empty if no call has failed.
pub(crate) fn last() -> String {
    LAST.try_with(|last| last.borrow().clone()).unwrap_or_default()
}
