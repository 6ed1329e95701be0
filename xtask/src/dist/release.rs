//! What all packages of a release have in common: profile, commit, version, folder, licences.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{run, run_quietly};
use crate::tools;
use crate::virtual_environment::target_folder;

/// The cargo profile of the builds that a release hands out.
pub(super) const PROFILE: &str = "release";

/// The commit that the programs are to name, and whether the files differ from it: the build itself would name the
/// commit of an earlier build if only the commit is new. Nothing outside a checkout.
pub(super) fn commit() -> Option<(&'static str, String)> {
    let git = |arguments: &[&str]| run_quietly(Command::new("git").args(arguments)).ok();
    let commit = git(&["rev-parse", "--short=8", "HEAD"])?.trim().to_owned();
    let is_clean = git(&["status", "--porcelain", "--untracked-files=no"])?.trim().is_empty();
    let commit = if is_clean { commit } else { format!("{commit}, modified") };
    Some(("FENDERLINE_COMMIT", commit))
}

/// Where the packages go.
pub(super) fn folder() -> PathBuf {
    target_folder().join("dist")
}

/// The version of the workspace, which is the version of all packages.
pub(super) fn version() -> Result<String, String> {
    let manifest = std::fs::read_to_string("Cargo.toml").map_err(|e| format!("Cargo.toml: {e}"))?;
    let versions: Vec<&str> = manifest
        .lines()
        .filter_map(|line| line.split_once("version = \"")?.1.split_once('"'))
        .map(|(version, _)| version)
        .collect();
    let version = *versions.first().ok_or("Cargo.toml has no version")?;
    // The crates' requirements of each other.
    let own = manifest.lines().filter(|line| line.contains("path = \"crates/"));
    match own.into_iter().find(|line| !line.contains(&format!("version = \"{version}\""))) {
        None => Ok(version.to_owned()),
        Some(line) => {
            Err(format!("Cargo.toml has a line with another version than {version}: {line}"))
        }
    }
}

/// Collects the project's licences, those of all dependencies, and the bill of materials.
pub(super) fn licences(package: &str, folder: &Path, triples: &[&str]) -> Result<(), String> {
    copy(Path::new("LICENSE-MIT"), folder)?;
    copy(Path::new("LICENSE-APACHE"), folder)?;
    let python = tools::python().map_err(|missing| format!("{} is missing", missing.tool))?;
    let mut collect = Command::new(python);
    collect.args(["-B", "xtask/third_party.py", "--package", package, "--out"]).arg(folder);
    if package == "fenderline" {
        collect.arg("--pages");
    }
    run(collect.args(triples))
}

pub(super) fn copy(file: &Path, folder: &Path) -> Result<(), String> {
    std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let name = file.file_name().unwrap_or_default();
    std::fs::copy(file, folder.join(name))
        .map(|_| ())
        .map_err(|e| format!("{}: {e}", file.display()))
}

pub(super) fn size(file: &Path) -> Result<u64, String> {
    std::fs::metadata(file).map(|of| of.len()).map_err(|e| format!("{}: {e}", file.display()))
}
