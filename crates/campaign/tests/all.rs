//! All tests of the crate, as one program: cargo links it once. `cargo test -p fenderline-campaign --test all NAME::` runs those of one
//! file.

mod coverage;
mod known_answers;
mod oracle;
mod report;
mod support;
mod tables;
