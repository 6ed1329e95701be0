//! `cargo xtask hosts` tests the FMUs in the masters FMPy, libcosim and ecos. The three masters come from PyPI, in the
//! versions of `crates/fmu/hosts/requirements.txt`, into a virtual environment below `target`.

use std::path::Path;
use std::process::{Command, ExitCode};

use crate::built;
use crate::command::run;
use crate::step::Done;
use crate::tools;
use crate::virtual_environment::{environment, target_folder};

const FOLDER: &str = "crates/fmu/hosts";

/// `cargo xtask hosts`.
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

/// Tests the FMUs in FMPy, libcosim and ecos, and tests the guide for FMUs.
pub(crate) fn hosts() -> Result<Done, String> {
    let python = match tools::python() {
        Ok(python) => python,
        Err(missing) => return Ok(Done::NotRun(missing)),
    };
    let target = target_folder();
    let python = environment(
        python,
        &target.join("fmu-hosts"),
        &Path::new(FOLDER).join("requirements.txt"),
    )?;
    let program = built::program("release")?;
    let mut tests = Command::new(python);
    // No __pycache__ and no caches in the source tree.
    tests.args(["-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", FOLDER]);
    run(tests.env("FENDERLINE", program))?;
    Ok(Done::Good)
}
