//! `cargo xtask dist here` makes program, C library and wheel for the machine that runs it: for macOS and for Windows
//! on Arm, for which Linux on x86-64 cannot build. Cargo links program, library and wheel as usual on that machine. The
//! workflow of a release calls this command.

use std::path::Path;
use std::process::Command;

use super::platforms::{Platform, maturin};
use super::release::{PROFILE, copy, folder, licences, version};
use super::{archive, c_package, shell_files, tried};
use crate::command::{run, run_quietly};
use crate::program;
use crate::step::{Done, Step};

/// In order. Each package is tried right after it is made.
pub(super) const STEPS: [Step; 3] = [
    Step { name: "the program", run: program_here },
    Step { name: "the C package", run: c_here },
    Step { name: "the wheel", run: wheel_here },
];

/// The name that Rust gives to this machine's target.
fn triple() -> Result<String, String> {
    let said = run_quietly(Command::new("rustc").arg("-vV"))?;
    let host = said.lines().find_map(|line| line.strip_prefix("host: "));
    host.map(str::to_owned).ok_or("rustc does not name its host".into())
}

fn program_here() -> Result<Done, String> {
    let platform = Platform::own();
    let built = program::program(PROFILE)?;
    let folder = folder().join(format!("fenderline-{}-{}", version()?, platform.name));
    for file in [built.as_path(), Path::new("README.md"), Path::new("CHANGELOG.md")] {
        copy(file, &folder)?;
    }
    shell_files::write(&built, &folder)?;
    licences("fenderline", &folder, &[&triple()?])?;
    let archive = archive::pack(&folder, platform.is_windows())?;
    println!("{}", archive.display());
    tried::somewhere(tried::program_of_one)
}

fn c_here() -> Result<Done, String> {
    let platform = Platform::own();
    let folder = folder().join(format!("fenderline-c-{}-{}", version()?, platform.name));
    c_package::build_here()?;
    c_package::make(&platform, &folder)?;
    licences("fenderline-capi", &folder, &[&triple()?])?;
    if platform.is_windows() {
        println!("the C package was not tried, because that is done on Linux and macOS only");
    } else {
        c_package::find(&folder)?;
    }
    println!("{}", archive::pack(&folder, platform.is_windows())?.display());
    Ok(Done::Good)
}

fn wheel_here() -> Result<Done, String> {
    let mut build = Command::new(maturin()?);
    build.args(["-m", "maturin", "build", "--profile", PROFILE, "--locked", "--out"]).arg(folder());
    // One wheel serves every CPython from 3.11 on: the interpreter of this machine has no part in it.
    run(build.env("PYO3_NO_PYTHON", "1"))?;
    tried::somewhere(|place| tried::wheel(place, |_| true))
}
