//! Makes Python wheels for each platform, and the source distribution.

use std::path::PathBuf;
use std::process::Command;

use super::platforms::{GLIBC, Platform, tools};
use super::release::{PROFILE, folder, version};
use crate::command::{run, run_quietly};
use crate::virtual_environment::target_folder;

/// Makes them.
///
/// # Errors
/// A build that fails.
pub(super) fn all() -> Result<(), String> {
    let bin = tools()?.parent().map(PathBuf::from).unwrap_or_default();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path =
        std::env::join_paths(std::iter::once(bin.clone()).chain(std::env::split_paths(&path)))
            .map_err(|e| e.to_string())?;
    let maturin = |arguments: &[&str]| {
        let mut command = Command::new(bin.join("maturin"));
        command.args(arguments).arg("--out").arg(folder()).env("PATH", &path);
        // One wheel serves every CPython from 3.11 on: the interpreter of this machine has no part in it.
        run(command.env("PYO3_NO_PYTHON", "1"))
    };
    maturin(&["sdist"])?;
    for platform in Platform::ALL {
        let tag = format!("manylinux_{}", GLIBC.replace('.', "_"));
        let target = ["build", "--profile", PROFILE, "--locked", "--target", platform.triple];
        if platform.is_windows() {
            maturin(&target)?;
        } else {
            maturin(&[&target[..], &["--zig", "--compatibility", &tag]].concat())?;
        }
    }
    sdist_builds()
}

/// Checks that the source distribution can be built in an empty folder.
fn sdist_builds() -> Result<(), String> {
    let place = target_folder().join("dist-sdist");
    if place.exists() {
        std::fs::remove_dir_all(&place).map_err(|e| format!("{}: {e}", place.display()))?;
    }
    std::fs::create_dir_all(&place).map_err(|e| format!("{}: {e}", place.display()))?;
    let sdist = files(".tar.gz")?
        .into_iter()
        .find(|file| {
            file.file_name().is_some_and(|name| {
                let name = name.to_string_lossy();
                name == format!("fenderline-{}.tar.gz", version().unwrap_or_default())
            })
        })
        .ok_or("maturin has made no source distribution")?;
    // With the present time: the files in it are dated 2006, and Cargo would take what was built from others for theirs.
    run_quietly(Command::new("tar").arg("-xzmf").arg(&sdist).arg("-C").arg(&place))?;
    let list = run_quietly(Command::new("tar").arg("-tzf").arg(&sdist))?;
    for file in ["fenders/cone.toml", "vessels/kvlcc2.toml"] {
        if !list.lines().any(|line| line.ends_with(file)) {
            return Err(format!("the source distribution lacks {file}"));
        }
    }
    let python = tools()?;
    let mut pip = Command::new(python);
    pip.args(["-m", "pip", "wheel", "--quiet", "--disable-pip-version-check", "--no-deps", "-w"]);
    // Dependencies that are built already are taken from the target folder.
    let sources = place.join(format!("fenderline-{}", version()?));
    run(pip
        .arg(&place)
        .arg(&sources)
        .env("CARGO_TARGET_DIR", target_folder())
        .current_dir(&place))?;
    println!("the source distribution builds in an empty folder");
    Ok(())
}

/// Runs `twine check` on all wheels and source distributions.
///
/// # Errors
/// Fails with what the Python package index would refuse.
pub(super) fn checked() -> Result<(), String> {
    let mut packages = files(".whl")?;
    packages.extend(files(".tar.gz")?.into_iter().filter(|file| {
        file.file_name().is_some_and(|name| {
            let name = name.to_string_lossy();
            !name.contains("linux")
        })
    }));
    let mut twine = Command::new(tools()?);
    run(twine.args(["-m", "twine", "check", "--strict"]).args(packages))
}

fn files(ending: &str) -> Result<Vec<PathBuf>, String> {
    let folder = folder();
    let entries = std::fs::read_dir(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let mut files: Vec<PathBuf> = entries
        .flatten()
        .map(|entry| entry.path())
        .filter(|path| path.to_string_lossy().ends_with(ending))
        .collect();
    files.sort();
    Ok(files)
}
