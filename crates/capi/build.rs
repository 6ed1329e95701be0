//! Gives the shared library a SONAME (an install name on macOS) if `FENDERLINE_SONAME` names one, as `cargo xtask dist`
//! does. A build without this variable sets no SONAME, so that programs find `libfenderline.so` under the name that
//! cargo gives the file.

const VARIABLE: &str = "FENDERLINE_SONAME";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed={VARIABLE}");
    let Ok(name) = std::env::var(VARIABLE) else { return };
    if name.is_empty() {
        return;
    }
    match std::env::var("CARGO_CFG_TARGET_OS").as_deref() {
        Ok("linux") => println!("cargo::rustc-cdylib-link-arg=-Wl,-soname,{name}"),
        Ok("macos") => println!("cargo::rustc-cdylib-link-arg=-Wl,-install_name,@rpath/{name}"),
        _ => {}
    }
}
