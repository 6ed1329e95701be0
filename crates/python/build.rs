//! On macOS an extension module finds Python's functions when the interpreter loads it: the linker has to be told that they come
//! later. Maturin does so by itself; this is for a plain `cargo build` or `cargo test`.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "macos") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-undefined,dynamic_lookup");
    }
}
