//! Lists the scenario files of the project.

use std::path::{Path, PathBuf};

/// Every `.toml` file below the folder `scenarios/`, in a fixed order.
///
/// # Errors
/// Fails for a folder that cannot be read, and if there is no scenario at all.
pub(crate) fn all() -> Result<Vec<PathBuf>, String> {
    let mut found = Vec::new();
    collect(Path::new("scenarios"), &mut found)?;
    found.sort();
    if found.is_empty() { Err("scenarios/ holds no scenario".into()) } else { Ok(found) }
}

fn collect(folder: &Path, found: &mut Vec<PathBuf>) -> Result<(), String> {
    let unreadable = |e: std::io::Error| format!("{}: {e}", folder.display());
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.is_dir() {
            collect(&path, found)?;
        } else if path.extension().is_some_and(|e| e == "toml") {
            found.push(path);
        }
    }
    Ok(())
}
