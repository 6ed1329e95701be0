//! Lists the libraries for FMUs that the program carries in itself: those of the folder that `FENDERLINE_FMU_LIBRARIES`
//! names, in `x86_64-linux/libfenderline_fmu.so` and so on. Without the variable it carries none, and `fenderline fmu` takes
//! the library that cargo puts beside it. `cargo xtask program` builds a program with its library.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

const VARIABLE: &str = "FENDERLINE_FMU_LIBRARIES";
/// Folder of a platform, by the platform tuple of FMI 3.0, and the library's file name.
const PLACES: [(&str, &str); 5] = [
    ("x86_64-linux", "libfenderline_fmu.so"),
    ("aarch64-linux", "libfenderline_fmu.so"),
    ("x86_64-windows", "fenderline_fmu.dll"),
    ("x86_64-darwin", "libfenderline_fmu.dylib"),
    ("aarch64-darwin", "libfenderline_fmu.dylib"),
];

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed={VARIABLE}");
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
