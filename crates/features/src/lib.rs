//! Features of libraries, and no code.
//!
//! Cargo gives a library the features that all packages of a build ask of it. The program and the Python wheel are built
//! by two commands. Where the two ask different features of one library, cargo compiles this library twice, and every
//! crate above it. The wheel depends on this package, and `cargo xtask` builds the program together with it, so that
//! both have the same features. A test of `xtask` compares them.
