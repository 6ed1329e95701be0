//! All tests of the crate, as one program: cargo links it once. `cargo test -p fenderline-fmu --test all NAME::` runs those of one
//! file.

mod attack_fmi3;
mod calls;
mod placed;
mod states;
mod support;
