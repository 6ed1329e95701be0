//! Tells the compiler where the published numbers, scenarios and hydrodynamic data are that are built into the crate.
//! In a package of the crate, the folders with these data are the crate's own. In a checkout, the crate's folders with
//! these data are links to the folders at the top; a checkout on Windows may have text files in place of links.

use std::path::Path;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let top = own.join("../..");
    let root = if own.join("validation").is_dir() { own } else { top.as_path() };
    println!("cargo::rustc-env=FENDERLINE_DATA={}", root.display());
}
