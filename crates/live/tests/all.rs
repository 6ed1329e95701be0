//! All tests of the crate, as one program: cargo links it once. `cargo test -p fenderline-live --test all NAME::` runs those of one
//! file.

mod anchors;
#[path = "support/damage.rs"]
mod damage;
mod debrief;
mod docking_board;
mod exercise;
mod instruments;
mod outlook;
mod passage;
mod place;
mod present;
mod protocol;
mod recordings;
mod rows;
mod script;
mod session;
mod support;
mod traffic;
mod trial;
mod visibility;
