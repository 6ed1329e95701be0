//! All tests of the crate, as one program.

mod bad_input;
mod followed;
mod ghosts;
mod known_answers;
mod logs;
mod parabolas;
mod support;
