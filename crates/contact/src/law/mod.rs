//! Stage 4, law: what a contact would push and drag with, were nothing to limit it.

pub(crate) mod damper;
pub(crate) mod friction;
pub(crate) mod normal;
