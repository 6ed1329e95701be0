//! Gives the shared library a SONAME if `FENDERLINE_SONAME` names one, as `cargo xtask dist` does for Linux. A plain build
//! gives none, so that programs find `libfenderline.so` under the name that cargo gives it.

const VARIABLE: &str = "FENDERLINE_SONAME";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed={VARIABLE}");
    let is_linux = std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "linux");
    match std::env::var(VARIABLE) {
        Ok(name) if is_linux && !name.is_empty() => {
            println!("cargo::rustc-cdylib-link-arg=-Wl,-soname,{name}");
        }
        _ => {}
    }
}
