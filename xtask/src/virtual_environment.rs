//! Makes Python virtual environments below the target folder, with packages of fixed versions from PyPI.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::run_quietly;

/// The folder into which cargo puts build outputs.
pub(crate) fn target_folder() -> PathBuf {
    let folder =
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| "target".into(), PathBuf::from);
    std::path::absolute(&folder).unwrap_or(folder)
}

/// The Python of the virtual environment `folder`, which has the packages of the list `requirements`. The virtual
/// environment is made again if the requirements have changed.
///
/// # Errors
/// Fails if the list does not exist, or if a package could not be installed.
pub(crate) fn environment(
    python: &str,
    folder: &Path,
    requirements: &Path,
) -> Result<PathBuf, String> {
    let wanted = std::fs::read_to_string(requirements)
        .map_err(|e| format!("{}: {e}", requirements.display()))?;
    let stamp = folder.join("installed.txt");
    let bin = if cfg!(windows) { "Scripts" } else { "bin" };
    let own = folder.join(bin).join(format!("python{}", std::env::consts::EXE_SUFFIX));
    if std::fs::read_to_string(&stamp).is_ok_and(|installed| installed == wanted) {
        return Ok(own);
    }
    println!("{}, from PyPI, into {}", requirements.display(), folder.display());
    run_quietly(Command::new(python).args(["-m", "venv", "--clear"]).arg(folder))?;
    install(&own, &["-r", &requirements.to_string_lossy()])?;
    std::fs::write(&stamp, wanted).map_err(|e| format!("{}: {e}", stamp.display()))?;
    Ok(own)
}

/// Installs packages for `python`, which is the one of a virtual environment: by uv where uv is installed, which takes a
/// tenth of pip's time, else by pip. `wanted` are names of packages, or `-r` and a list of requirements.
///
/// # Errors
/// Fails if a package could not be installed.
pub(crate) fn install(python: &Path, wanted: &[&str]) -> Result<(), String> {
    if run_quietly(Command::new("uv").arg("--version")).is_ok() {
        let mut uv = Command::new("uv");
        uv.args(["pip", "install", "--quiet", "--python"]).arg(python);
        match run_quietly(uv.args(wanted)) {
            Ok(_) => return Ok(()),
            Err(why) => println!("uv failed, and pip installs the packages: {why}"),
        }
    }
    let mut pip = Command::new(python);
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
    run_quietly(pip.args(wanted)).map(|_| ())
}
