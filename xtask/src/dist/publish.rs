//! Packages for crates.io: those that a program in Rust uses. Nothing is published.

use crate::command::{cargo, run, run_quietly};

/// In the order of their dependencies.
const CRATES: [&str; 5] = [
    "fenderline-contact",
    "fenderline-sim",
    "fenderline-scenario",
    "fenderline-results",
    "fenderline-embed",
];

/// Files that a package must hold beyond its sources.
const DATA: [(&str, &str); 2] =
    [("fenderline-scenario", "fenders/cone.toml"), ("fenderline-scenario", "vessels/kvlcc2.toml")];

/// Checks what the packages hold; with `build`, builds each package as crates.io would have it.
///
/// # Errors
/// A package that lacks its data, or does not build.
pub(super) fn crates(build: bool) -> Result<(), String> {
    for (name, file) in DATA {
        let list = ["package", "--list", "--allow-dirty", "--package", name];
        let list = run_quietly(&mut cargo(list))?;
        if !list.lines().any(|line| line.trim() == file) {
            return Err(format!("the package of {name} lacks {file}"));
        }
    }
    let mut publish = if build {
        cargo(["publish", "--dry-run", "--allow-dirty"])
    } else {
        cargo(["package", "--no-verify", "--quiet", "--allow-dirty"])
    };
    for name in CRATES {
        publish.args(["--package", name]);
    }
    run(&mut publish)
}
