//! Vector tugs: a force on a ship that a tug can really give, after the time it takes.
//!
//! A [`VectorTug`] is the constant part, checked once; a [`TugState`] is plain data. Orders go in by
//! [`VectorTug::order`], and [`VectorTug::step`] gives the force. For a tug that pushes through a real bow
//! fender, or swings round on her line, use a body of her own.

mod envelope;
mod state;

pub use envelope::TugEnvelope;
pub use state::{TugForce, TugOrder, TugState, VectorTug};
