//! Packages for the indexes of Rust and Node, as their own clients make them. Nothing is published here.

use std::path::Path;
use std::process::Command;

use crate::command::{cargo, run, run_quietly};
use crate::virtual_environment::target_folder;

/// Files that a package must hold beyond its sources: those of the folders that are links in a checkout.
const DATA: [(&str, &str); 5] = [
    ("fenderline-scenario", "fenders/cone.toml"),
    ("fenderline-scenario", "vessels/kvlcc2.toml"),
    ("fenderline-validate", "validation/moreno2023.toml"),
    ("fenderline-validate", "scenarios/paper/experiment_2_4kn.toml"),
    ("fenderline", "scenarios/berth/eight_cones_at_5_deg.toml"),
];

/// Names the repository in the npm package, whose provenance is accepted only from there.
const REPOSITORY: &str = "FENDERLINE_REPOSITORY";

/// Checks what the packages hold. Then all but the upload of `cargo publish --workspace`: every crate that can be published, in
/// the order of their requirements of each other; with `build`, each is built from its package.
///
/// # Errors
/// A package that lacks its data, or does not build.
pub(super) fn crates(build: bool) -> Result<(), String> {
    for (name, file) in DATA {
        let list = ["package", "--list", "--allow-dirty", "--package", name];
        let list = run_quietly(&mut cargo(list))?;
        // On Windows with the other slash.
        if !list.lines().any(|line| line.trim().replace('\\', "/") == file) {
            return Err(format!("the package of {name} lacks {file}"));
        }
    }
    let mut publish = cargo(["publish", "--workspace", "--dry-run", "--allow-dirty"]);
    if !build {
        publish.args(["--no-verify", "--quiet"]);
    }
    run(&mut publish)
}

/// `npm pack` of the package in `built`, into `folder`. From a copy, in which the package names its repository if
/// `FENDERLINE_REPOSITORY` does.
///
/// # Errors
/// A failure of npm; files that cannot be copied.
pub(super) fn npm(built: &Path, folder: &Path) -> Result<(), String> {
    let copy = target_folder().join("dist-npm");
    if copy.exists() {
        std::fs::remove_dir_all(&copy).map_err(|e| format!("{}: {e}", copy.display()))?;
    }
    std::fs::create_dir_all(&copy).map_err(|e| format!("{}: {e}", copy.display()))?;
    let mut files = Command::new("cp");
    for name in ["package.json", "README.md", "LICENSE-MIT", "LICENSE-APACHE", "dist"] {
        files.arg(built.join(name));
    }
    run_quietly(files.arg("-R").arg(&copy))?;
    if let Ok(repository) = std::env::var(REPOSITORY) {
        let mut set = Command::new("npm");
        set.args(["pkg", "set", "repository.type=git"]);
        set.arg(format!("repository.url=git+{repository}.git")).current_dir(&copy);
        run(&mut set)?;
    }
    let mut pack = Command::new("npm");
    run(pack.args(["pack", "--pack-destination"]).arg(folder).current_dir(&copy))
}
