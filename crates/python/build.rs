//! On macOS an extension module finds Python's functions when the interpreter loads the module: the linker has to be
//! told that the functions come later. Maturin tells the linker so by itself; this script is for a plain `cargo build`
//! or `cargo test`.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "macos") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-undefined,dynamic_lookup");
    }
}
