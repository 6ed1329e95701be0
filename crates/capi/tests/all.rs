//! All tests of the crate, as one program: cargo links it once. `cargo test -p fenderline-capi --test all NAME::` runs those of one
//! file.

mod attack_hosts;
mod calls;
mod header;
