//! Checks that the package of a crate holds every file that the compiler reads for the crate: a file from elsewhere in
//! the checkout is found in the checkout, and is missing when a user builds the crate from its package.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};

use crate::command::{cargo, run_quietly, workspace_root};
use crate::virtual_environment::target_folder;

/// Checks all crates that are published, by what the compiler wrote down when it built the program into
/// `target/release`.
///
/// # Errors
/// Names the crate and the file that its package lacks. Fails if no crate has been built.
pub(super) fn in_packages() -> Result<(), String> {
    let mut checked = 0;
    for folder in published_crates()? {
        let name = package_name(&folder)?;
        // `cargo` builds the program without crates that only other users need.
        let Some(sources) = sources_of_library(&name)? else { continue };
        let list = ["package", "--list", "--allow-dirty", "--package", &name];
        let list = run_quietly(&mut cargo(list))?;
        let packed: BTreeSet<PathBuf> = list.lines().map(|line| line.trim().into()).collect();
        // A file that is gone since the build is missing in no package.
        let read = sources.iter().filter(|source| source.exists());
        for source in read.filter(|source| !source.starts_with(target_folder())) {
            if !source.strip_prefix(&folder).is_ok_and(|inside| packed.contains(inside)) {
                return Err(format!("the package of {name} lacks {}", source.display()));
            }
        }
        checked += 1;
    }
    if checked == 0 {
        return Err("no crate is built in target/release".into());
    }
    println!("{checked} crates have all their sources in their packages");
    Ok(())
}

/// The folders of the crates that are published.
fn published_crates() -> Result<Vec<PathBuf>, String> {
    let crates = workspace_root().join("crates");
    let entries = std::fs::read_dir(&crates).map_err(|e| format!("{}: {e}", crates.display()))?;
    let mut folders: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    folders.sort();
    let mut published = Vec::new();
    for folder in folders {
        if !manifest(&folder)?.lines().any(|line| line == "publish = false") {
            published.push(folder);
        }
    }
    Ok(published)
}

fn manifest(folder: &Path) -> Result<String, String> {
    let file = folder.join("Cargo.toml");
    std::fs::read_to_string(&file).map_err(|e| format!("{}: {e}", file.display()))
}

fn package_name(folder: &Path) -> Result<String, String> {
    let manifest = manifest(folder)?;
    let name = manifest.lines().find_map(|line| line.strip_prefix("name = \"")?.strip_suffix('"'));
    name.map(str::to_owned).ok_or(format!("{}: no name of a package", folder.display()))
}

/// The files that the compiler read for the library of the package `name`, or `None` if the library is not built.
fn sources_of_library(name: &str) -> Result<Option<Vec<PathBuf>>, String> {
    let deps = target_folder().join("release/deps");
    let library = format!("{}-", name.replace('-', "_"));
    let entries = std::fs::read_dir(&deps).map_err(|e| format!("{}: {e}", deps.display()))?;
    let mut newest = None;
    for entry in entries.flatten() {
        let file = entry.file_name().to_string_lossy().into_owned();
        let Some(hash) = file.strip_prefix("lib").and_then(|f| f.strip_prefix(&library)) else {
            continue;
        };
        let Some(hash) = hash.strip_suffix(".rlib") else { continue };
        let built = entry.metadata().and_then(|m| m.modified()).map_err(|e| e.to_string())?;
        let written = deps.join(format!("{library}{hash}.d"));
        if newest.as_ref().is_none_or(|(before, _)| *before < built) {
            newest = Some((built, written));
        }
    }
    let Some((_, written)) = newest else { return Ok(None) };
    let text =
        std::fs::read_to_string(&written).map_err(|e| format!("{}: {e}", written.display()))?;
    Ok(Some(sources_in(&text)))
}

/// The files that a Makefile rule of the compiler names for a library.
fn sources_in(rules: &str) -> Vec<PathBuf> {
    let rule = rules.lines().find_map(|line| Some(line.split_once(".rlib: ")?.1));
    // A space within a name has a backslash before it.
    let names = rule.unwrap_or_default().replace("\\ ", "\0");
    let names = names.split(' ').map(|name| name.replace('\0', " "));
    names.filter(|name| !name.is_empty()).map(|name| plain(&workspace_root().join(name))).collect()
}

/// The same path without `..`; links stay.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(plain.pop()),
            Component::CurDir => {}
            other => plain.push(other),
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_a_rule_are_read_with_spaces_and_parents() {
        let rules = "x/a.d: crates/a/src/lib.rs\n\nx/liba.rlib: crates/a/src/lib.rs crates/a/../../my\\ data.toml\n";
        let root = workspace_root();
        let read = sources_in(rules);
        assert_eq!(read, [root.join("crates/a/src/lib.rs"), root.join("my data.toml")]);
    }
}
