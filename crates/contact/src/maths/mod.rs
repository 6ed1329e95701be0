//! Numbers, vectors, headings, hashes and lists, with the same bits on every machine.

pub(crate) mod angle;
pub mod hash;
pub mod number;
pub(crate) mod room;
pub(crate) mod spread;
pub(crate) mod vec2;
