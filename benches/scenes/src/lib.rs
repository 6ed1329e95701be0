//! Scenes of the benches, and the contact engine that plays the scenes. `fenderline-bench` times the engine and its
//! peers in these scenes; the program `fenderline-instructions` counts the engine's instructions.
#![allow(
    clippy::disallowed_methods,
    reason = "a bench only measures and prints, so the rules for equal bits do not hold here"
)]

pub mod engine;
pub mod play;
pub mod scenes;
pub mod table;
pub mod world;
