//! C interface of the contact engine. `include/fenderline.h`, generated from this crate by cbindgen, documents every
//! function.
//!
//! Each function of the interface does three things: it reads the caller's arguments (`border`), looks up the object of
//! a handle (`table`) and calls [`fenderline_embed`]. `unsafe` is used only to read and write through the caller's
//! pointers. Handles are looked up in a table and never dereferenced, so a destroyed or invalid handle is refused.
#![allow(unsafe_code, reason = "C passes raw pointers; each unsafe block says why it is sound")]
#![allow(
    clippy::missing_safety_doc,
    reason = "the preamble of the header states the rules for all pointers"
)]

#[cfg(not(panic = "unwind"))]
compile_error!("a panic must become a status: build this crate with panic = \"unwind\"");

mod border;
mod builder;
mod drawing;
mod dump;
mod engine;
mod failure;
mod last_error;
mod library;
mod outline;
mod table;
#[cfg(test)]
mod tests;
mod types;

pub use builder::*;
pub use drawing::*;
pub use dump::*;
pub use engine::*;
pub use failure::FlStatus;
pub use library::*;
pub use outline::*;
pub use table::{FlBuilder, FlEngine};
pub use types::*;
