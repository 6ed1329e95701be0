//! `cargo xtask program [PROFILE]` builds the program `fenderline` for this machine as one file that needs nothing
//! else: the pages, the library of FMUs and all data are in it.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use crate::built;
use crate::command::{run, run_quietly};
use crate::virtual_environment::target_folder;

/// The environment variable by which the build of the program finds the libraries of FMUs; see `crates/app/build.rs`.
pub(crate) const LIBRARIES: &str = "FENDERLINE_FMU_LIBRARIES";

/// `cargo xtask program`.
pub(crate) fn program_command(profile: &str) -> ExitCode {
    match program(profile) {
        Ok(program) => {
            println!("{}", program.display());
            ExitCode::SUCCESS
        }
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// Builds the program and returns its path.
///
/// # Errors
/// Fails if the build fails, or if it gives a program without pages.
pub(crate) fn program(profile: &str) -> Result<PathBuf, String> {
    let target = target_folder();
    run(&mut built::build(profile, &["--lib"]))?;
    let name =
        format!("{}fenderline_fmu{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let folder = target.join("program").join("fmu-libraries");
    let os = match std::env::consts::OS {
        "macos" => "darwin",
        os => os,
    };
    let place = folder.join(format!("{}-{os}", std::env::consts::ARCH)).join(&name);
    copy_stripped("strip", &built::folder(profile).join(&name), &place)?;
    run(built::build(profile, &["--bin", "fenderline"]).env(LIBRARIES, &folder))?;
    let name = format!("fenderline{}", std::env::consts::EXE_SUFFIX);
    let program = target.join("program").join(&name);
    copy_stripped("strip", &built::folder(profile).join(&name), &program)?;
    Ok(program)
}

/// Copies a program or library without its debug information and local symbols, if the copy's content would change: an
/// unchanged copy keeps its time, so that nothing is built again. If `strip` is not installed, copies the file as it
/// is.
pub(crate) fn copy_stripped(strip: &str, from: &Path, to: &Path) -> Result<(), String> {
    let failed = |path: &Path, e: std::io::Error| format!("{}: {e}", path.display());
    let folder = to.parent().unwrap_or(Path::new(""));
    std::fs::create_dir_all(folder).map_err(|e| failed(folder, e))?;
    let new = to.with_extension("new");
    std::fs::copy(from, &new).map_err(|e| failed(from, e))?;
    if run_quietly(Command::new(strip).arg("--version")).is_ok() {
        run_quietly(Command::new(strip).arg("--strip-unneeded").arg(&new))?;
    }
    let content = std::fs::read(&new).map_err(|e| failed(&new, e))?;
    if std::fs::read(to).is_ok_and(|old| old == content) {
        std::fs::remove_file(&new).map_err(|e| failed(&new, e))
    } else {
        std::fs::rename(&new, to).map_err(|e| failed(to, e))
    }
}
