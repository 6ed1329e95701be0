//! Makes packages for the indexes of Rust and Node, by the indexes' own clients. Nothing is published here.

use std::path::Path;
use std::process::Command;

use crate::command::{cargo, run, run_quietly};
use crate::virtual_environment::target_folder;

/// Files that a package must hold beside its sources; in a checkout they lie in folders that are links.
const DATA: [(&str, &str); 5] = [
    ("fenderline-scenario", "fenders/cone.toml"),
    ("fenderline-scenario", "vessels/kvlcc2.toml"),
    ("fenderline-validate", "validation/moreno2023.toml"),
    ("fenderline-validate", "scenarios/paper/experiment_2_4kn.toml"),
    ("fenderline", "scenarios/berth/eight_cones_at_5_deg.toml"),
];

/// The environment variable that names the repository for the npm package, whose provenance is accepted only from
/// there.
const REPOSITORY: &str = "FENDERLINE_REPOSITORY";

/// Checks which files the packages of the crates hold. The function then does everything of `cargo publish --workspace`
/// but the upload, for every crate that can be published, in the order in which the crates need each other; with
/// `build`, each crate is built from its package.
///
/// # Errors
/// Fails for a package that lacks its data, or that does not build.
pub(super) fn crates(build: bool) -> Result<(), String> {
    for (name, file) in DATA {
        let list = ["package", "--list", "--allow-dirty", "--package", name];
        let list = run_quietly(&mut cargo(list))?;
        // On Windows with the other slash.
        if !list.lines().any(|line| line.trim().replace('\\', "/") == file) {
            return Err(format!("the package of {name} lacks the file {file}"));
        }
    }
    let mut publish = cargo(["publish", "--workspace", "--dry-run", "--allow-dirty"]);
    if !build {
        publish.args(["--no-verify", "--quiet"]);
    }
    run(&mut publish)
}

/// Runs `npm pack` for the package in the folder `built`, and puts the pack into `folder`. The pack is made of a copy,
/// in which the package names its repository if `FENDERLINE_REPOSITORY` is set.
///
/// # Errors
/// Fails if npm fails, or if files cannot be copied.
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
