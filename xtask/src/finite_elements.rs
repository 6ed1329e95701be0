//! `cargo xtask finite-elements` computes fenders by finite elements. FElupe, numpy and scipy come from PyPI, in the
//! versions of `validation/finite_elements/requirements.txt`, into a virtual environment below `target`.

use std::process::{Command, ExitCode};

use crate::built;
use crate::command::run;
use crate::step::Done;
use crate::tools;

const SCRIPT: &str = "validation/finite_elements/analyse.py";

/// Runs all studies by finite elements and the comparison with the program's fender laws, and writes data files and
/// tables.
pub(crate) fn finite_elements_command() -> ExitCode {
    let whole = || {
        built::program("release")?;
        analyse(&[])
    };
    match whole() {
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

/// Computes the fenders with coarse meshes and compares with the stored results.
pub(crate) fn small() -> Result<Done, String> {
    analyse(&["--small"])
}

fn analyse(arguments: &[&str]) -> Result<Done, String> {
    match tools::python_environments() {
        Ok(python) => run(Command::new(python).args(["-B", SCRIPT]).args(arguments))?,
        Err(missing) => return Ok(Done::NotRun(missing)),
    }
    Ok(Done::Good)
}
