//! The tests of this crate, one program: each file below is a module.

mod keys_without_effect;
mod quantities;
