//! Lists the data files that are built into the program: every `.toml` file of `fenders/` and `vessels/`. A new file in
//! one of these folders therefore needs no line of code.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// The folders with data files, each with the name of the list of its files.
const LISTS: [(&str, &str); 2] = [("fenders", "FENDER_FILES"), ("vessels", "VESSEL_FILES")];

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut lists = String::new();
    for (folder, name) in LISTS {
        // In a package the folders are the crate's own. In a checkout they are links to those at the top; a checkout
        // on Windows may have text files in place of links.
        let linked = own.join(folder);
        let folder = if linked.is_dir() { linked } else { own.join("../..").join(folder) };
        println!("cargo::rerun-if-changed={}", folder.display());
        let files = data_files(&folder);
        writeln!(lists, "pub(crate) static {name}: [(&str, &str); {}] = [", files.len())
            .expect("a string");
        for file in files {
            let name = file.file_name().and_then(|name| name.to_str()).expect("a plain name");
            let path = file.to_str().expect("the path of the repository is valid text");
            writeln!(lists, "    ({name:?}, include_str!({path:?})),").expect("a string");
        }
        lists += "];\n";
    }
    let out = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    std::fs::write(Path::new(&out).join("data_files.rs"), lists).expect("OUT_DIR can be written");
}

/// The TOML files of a folder, in the order of their names.
fn data_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let paths = entries.map(|entry| entry.expect("an entry of the folder").path());
    let mut files: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    files.sort();
    files
}
