//! Features of libraries, and no code.
//!
//! Cargo gives a library the features that all packages of a build ask of it. The program, the Python wheel and the program
//! that makes JavaScript of the WebAssembly module are built by three commands. Where these ask different features of
//! one library, cargo compiles this library again, and every crate above it. The wheel depends on this package, and `cargo
//! xtask` builds the two programs together with it, so that all three have the same features. A test of `xtask` compares
//! them.
