//! `cargo xtask hosts`: the FMUs in the programs that take them. Hosts come from PyPI, in the versions of
//! `crates/fmu/hosts/requirements.txt`, into a virtual environment of their own beside what cargo builds.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use crate::command::{cargo, run, run_quietly};
use crate::step::Done;
use crate::tools;

const FOLDER: &str = "crates/fmu/hosts";

/// As a command of its own.
pub(crate) fn hosts_command() -> ExitCode {
    match hosts() {
        Ok(Done::Good) => ExitCode::SUCCESS,
        Ok(Done::NotRun(missing)) => {
            eprintln!("{} is missing; install: {}", missing.tool, missing.install);
            ExitCode::FAILURE
        }
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// FMPy, libcosim and ecos, and the guide.
pub(crate) fn hosts() -> Result<Done, String> {
    let python = match tools::python() {
        Ok(python) => python,
        Err(missing) => return Ok(Done::NotRun(missing)),
    };
    let target = target_folder();
    let python = environment(python, &target.join("fmu-hosts"))?;
    run(&mut cargo(["build", "--quiet", "--release", "--package", "fenderline"]))?;
    let program =
        target.join("release").join(format!("fenderline{}", std::env::consts::EXE_SUFFIX));
    let mut tests = Command::new(python);
    // No __pycache__ and no caches in the source tree.
    tests.args(["-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", FOLDER]);
    run(tests.env("FENDERLINE", program))?;
    Ok(Done::Good)
}

/// Where cargo puts what it builds.
fn target_folder() -> PathBuf {
    let told = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| "target".into(), PathBuf::from);
    std::path::absolute(&told).unwrap_or(told)
}

/// The Python of a virtual environment with the hosts in it, made anew where the list has changed.
fn environment(python: &str, folder: &Path) -> Result<PathBuf, String> {
    let list = Path::new(FOLDER).join("requirements.txt");
    let wanted = std::fs::read_to_string(&list).map_err(|e| format!("{}: {e}", list.display()))?;
    let stamp = folder.join("installed.txt");
    let bin = if cfg!(windows) { "Scripts" } else { "bin" };
    let own = folder.join(bin).join(format!("python{}", std::env::consts::EXE_SUFFIX));
    if std::fs::read_to_string(&stamp).is_ok_and(|installed| installed == wanted) {
        return Ok(own);
    }
    println!("the hosts, from PyPI, into {}", folder.display());
    run_quietly(Command::new(python).args(["-m", "venv", "--clear"]).arg(folder))?;
    let mut install = Command::new(&own);
    install.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"]);
    run_quietly(install.arg(&list))?;
    std::fs::write(&stamp, wanted).map_err(|e| format!("{}: {e}", stamp.display()))?;
    Ok(own)
}
