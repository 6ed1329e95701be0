//! The contact engine for programs in C, or in whatever calls C: `include/fenderline.h`, made of this crate by
//! cbindgen, documents every function.
//!
//! Each function here does three things and no more: it reads what C gave (`border`), finds the object that a
//! handle stands for (`table`) and calls [`fenderline_embed`]. `unsafe` is here, as in
//! `fenderline-fmu`, only to read and write through the caller's pointers; handles are looked up in a table
//! and never followed as pointers, so that a destroyed, foreign or made-up handle is refused.
#![allow(unsafe_code, reason = "C gives raw pointers; each block says why it is sound")]
#![allow(
    clippy::missing_safety_doc,
    reason = "the header's preamble says for all functions what a pointer must be"
)]

#[cfg(not(panic = "unwind"))]
compile_error!("a panic must become a status: build this with panic = \"unwind\"");

mod border;
mod builder;
mod engine;
mod failure;
mod library;
mod table;
#[cfg(test)]
mod tests;
mod types;

pub use builder::*;
pub use engine::*;
pub use failure::FlStatus;
pub use library::*;
pub use table::{FlBuilder, FlEngine};
pub use types::*;
