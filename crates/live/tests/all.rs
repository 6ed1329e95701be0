//! All tests of the crate in one program, so that cargo links only once. `cargo test -p fenderline-live --test all
//! NAME::` runs the tests of one file.

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
mod plan;
mod present;
mod protocol;
mod recordings;
mod rows;
mod script;
mod session;
mod support;
mod traffic;
mod trial;
mod view;
mod visibility;
