//! Lists the FMU libraries that are built into the program: those in the folder that the environment variable
//! `FENDERLINE_FMU_LIBRARIES` names, such as `x86_64-linux/libfenderline_fmu.so`. Without that variable no library is
//! built in, and `fenderline fmu` takes the library that cargo puts beside the program. `cargo xtask program` builds
//! the program with the FMU library in it.
//!
//! This build script also finds the example scenarios, the commit that `fenderline --version` names, and the features
//! that the program is built with.

#[path = "build/commit.rs"]
mod commit;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

const VARIABLE: &str = "FENDERLINE_FMU_LIBRARIES";
/// For each platform: its folder, named by the platform tuple of FMI 3.0, and the file name of the FMU library.
const PLACES: [(&str, &str); 5] = [
    ("x86_64-linux", "libfenderline_fmu.so"),
    ("aarch64-linux", "libfenderline_fmu.so"),
    ("x86_64-windows", "fenderline_fmu.dll"),
    ("x86_64-darwin", "libfenderline_fmu.dylib"),
    ("aarch64-darwin", "libfenderline_fmu.dylib"),
];

fn main() {
    for own in ["build.rs", "build"] {
        println!("cargo::rerun-if-changed={own}");
    }
    println!("cargo::rerun-if-env-changed={VARIABLE}");
    println!("cargo::rustc-env=FENDERLINE_COMMIT_OF_BUILD={}", commit::commit());
    println!("cargo::rustc-env=FENDERLINE_FEATURES_OF_BUILD={}", features().join(", "));
    println!("cargo::rustc-env=FENDERLINE_SCENARIOS={}", scenarios().display());
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    let mut list = String::from("pub(crate) static EMBEDDED: &[(&str, &[u8])] = &[\n");
    if let Some(folder) = std::env::var_os(VARIABLE).filter(|folder| !folder.is_empty()) {
        let folder = Path::new(&folder);
        assert!(folder.is_absolute(), "{VARIABLE}: {}: not an absolute path", folder.display());
        let mut found = 0;
        for (platform, name) in PLACES {
            let file = folder.join(platform).join(name);
            println!("cargo::rerun-if-changed={}", file.display());
            if file.is_file() {
                let path = file.to_str().expect("the folder's path is Unicode");
                writeln!(list, "    ({platform:?}, include_bytes!({path:?})),").expect("a string");
                found += 1;
            }
        }
        assert!(found > 0, "{VARIABLE}: {}: no library in it", folder.display());
    }
    list += "];\n";
    std::fs::write(out.join("fmu_libraries.rs"), list).expect("OUT_DIR can be written");
}

/// The cargo features that the program is built with, in the order of their names.
fn features() -> Vec<String> {
    let on = std::env::vars().filter_map(|(name, _)| {
        let feature = name.strip_prefix("CARGO_FEATURE_")?.to_lowercase().replace('_', "-");
        (feature != "default").then_some(feature)
    });
    let mut on: Vec<String> = on.collect();
    on.sort();
    on
}

/// The folder of the example scenarios. In a package it is the crate's own folder `scenarios`; in a git checkout
/// `scenarios` is a link, for which a checkout on Windows may have a text file.
fn scenarios() -> PathBuf {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let linked = own.join("scenarios");
    if linked.is_dir() { linked } else { own.join("../../scenarios") }
}
