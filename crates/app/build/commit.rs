//! The commit that `fenderline --version` names.
//!
//! A new commit alone does not build the program again. This script runs when a source file of the program has changed
//! (the program is then built anyway), and asks git for the commit. So the program names the commit that was checked
//! out when it was built, with `modified` where the files differed from that commit.

use std::path::Path;
use std::process::Command;

/// Environment variable that names the commit, so that git is not asked: for packages of Linux distributions, and for
/// `cargo xtask dist`, which knows that no file is modified.
const VARIABLE: &str = "FENDERLINE_COMMIT";
/// Crates that are not part of the program `fenderline`.
const OTHERS: [&str; 3] = ["capi", "python", "wasm"];
/// Files and folders that the program is built from, besides the crates' sources. The few scenarios and published cases
/// that are built into the program are left out: a user who edits a scenario should not wait for a build.
const PARTS: [&str; 5] = ["fenders", "vessels", "web/src", "Cargo.toml", "Cargo.lock"];

/// The commit, such as `1a2b3c4d` or `1a2b3c4d, modified`; empty if the commit is not known.
pub(crate) fn commit() -> String {
    println!("cargo::rerun-if-env-changed={VARIABLE}");
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    watch_sources();
    if let Ok(commit) = std::env::var(VARIABLE) {
        return commit;
    }
    of_package(own).or_else(|| of_checkout(own)).unwrap_or_default()
}

/// Tells cargo to run this script again when a source file of the program has changed. The paths given to cargo are
/// relative to the crate's folder.
fn watch_sources() {
    let root = Path::new("../..");
    let Ok(crates) = std::fs::read_dir(root.join("crates")) else { return };
    let names = crates.flatten().map(|entry| entry.file_name());
    let mut names: Vec<_> =
        names.filter(|name| !OTHERS.iter().any(|other| name == other)).collect();
    names.sort();
    let sources = names.iter().map(|name| root.join("crates").join(name).join("src"));
    for path in sources.chain(PARTS.map(|part| root.join(part))).filter(|path| path.exists()) {
        println!("cargo::rerun-if-changed={}", path.display());
    }
}

/// The commit that was packaged, as `cargo package` has written it into the crate.
fn of_package(own: &Path) -> Option<String> {
    let told = std::fs::read_to_string(own.join(".cargo_vcs_info.json")).ok()?;
    let (_, after) = told.split_once("\"sha1\"")?;
    let commit = after.split('"').nth(1)?;
    let short = commit.get(..8)?;
    let is_modified = told.contains("\"dirty\": true");
    Some(if is_modified { format!("{short}, modified") } else { short.to_owned() })
}

/// The commit of the git checkout. Sources that were unpacked into another project's checkout have no commit.
fn of_checkout(own: &Path) -> Option<String> {
    git(own, &["ls-files", "--error-unmatch", "build.rs"])?;
    let commit = git(own, &["rev-parse", "--short=8", "HEAD"])?;
    let changes = git(own, &["status", "--porcelain", "--untracked-files=no"])?;
    Some(if changes.is_empty() { commit } else { format!("{commit}, modified") })
}

/// What git prints for the given arguments; `None` if git is not installed or fails.
fn git(own: &Path, arguments: &[&str]) -> Option<String> {
    // Without locks: git may write its index anew when it is asked for the status.
    let output = Command::new("git")
        .arg("--no-optional-locks")
        .args(arguments)
        .current_dir(own)
        .output()
        .ok()?;
    let text = output.status.success().then(|| String::from_utf8(output.stdout).ok())??;
    Some(text.trim().to_owned())
}
