//! Tries the files of `target/dist` as a user would: checks the check sums, then unpacks each archive into an empty
//! folder and uses it there.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::platforms::Platform;
use super::release::{commit, folder, version};
use super::{c_package, shell_files};
use crate::command::run_quietly;
use crate::step::Done;
use crate::tools;
use crate::wine;

/// Files that each archive has besides program, library or package.
const BESIDE: [&str; 3] = ["LICENSE-MIT", "LICENSE-APACHE", "THIRD-PARTY-LICENSES.txt"];

/// A Python program that prints the number of components of each bill of materials in a folder.
const BILL: &str = "\
import json, sys
from pathlib import Path
bills = sorted(Path(sys.argv[1]).glob('*.cdx.json'))
assert bills, 'no bill of materials'
for bill in bills:
    content = json.loads(bill.read_text())
    assert content['bomFormat'] == 'CycloneDX' and content['components'], bill
    print(f\"{bill.name}: {len(content['components'])} components\")
";

/// A Python program that runs the package's own example, in a folder that has nothing of the project.
const IMPORT: &str = "\
import fenderline
run = fenderline.run(fenderline.example('tug_4kn'))
print(fenderline.__version__, run['contacts']['normal_force_n'].max())
";

/// A program for Node that runs the scenario which the program has written.
const NODE: &str = "\
import { readFile } from 'node:fs/promises';
import { Run, load, version } from 'fenderline';
await load();
const run = new Run({ text: await readFile(process.argv[1], 'utf8'), file: 'berth.toml' });
await run.play({});
console.log(version(), run.verdict().text);
";

/// Runs the last step of `cargo xtask dist`, which is also `cargo xtask dist try`.
pub(super) fn tried() -> Result<Done, String> {
    somewhere(tried_in)
}

/// Tries something in an empty folder, which is removed afterwards.
pub(super) fn somewhere(try_in: impl FnOnce(&Path) -> Result<(), String>) -> Result<Done, String> {
    let place = std::env::temp_dir().join(format!("fenderline-dist-{}", std::process::id()));
    std::fs::create_dir(&place).map_err(|e| format!("{}: {e}", place.display()))?;
    let tried = try_in(&place);
    let removed = std::fs::remove_dir_all(&place);
    tried?;
    removed.map_err(|e| format!("{}: {e}", place.display()))?;
    Ok(Done::Good)
}

fn tried_in(place: &Path) -> Result<(), String> {
    let mut sums = Command::new("sha256sum");
    let sums = run_quietly(sums.args(["--check", "SHA256SUMS"]).current_dir(folder()))?;
    println!("{} files as SHA256SUMS says", sums.lines().count());
    for platform in Platform::ALL {
        program(&platform, place, &Platform::ALL)?;
        let folder = unpacked("fenderline-c", &platform, place)?;
        if platform.is_own() {
            c_package::find(&folder)?;
        }
    }
    wheel(place, |name| name.contains("linux") && name.contains("x86_64"))?;
    npm_package(place)
}

/// Unpacks an archive, checks that it has licences and a bill of materials, and returns its folder.
fn unpacked(name: &str, platform: &Platform, place: &Path) -> Result<PathBuf, String> {
    let name = format!("{name}-{}-{}", version()?, platform.name);
    let python = tools::python().map_err(|missing| format!("{} is missing", missing.tool))?;
    if platform.is_windows() {
        let archive = folder().join(format!("{name}.zip"));
        run_quietly(Command::new(python).args(["-m", "zipfile", "-e"]).arg(archive).arg(place))?;
    } else {
        let archive = folder().join(format!("{name}.tar.gz"));
        run_quietly(Command::new("tar").arg("-xzf").arg(archive).arg("-C").arg(place))?;
    }
    let folder = place.join(&name);
    for file in BESIDE {
        is_there(&folder.join(file))?;
    }
    let bill = run_quietly(Command::new(python).args(["-c", BILL]).arg(&folder))?;
    println!("{name}: licences, {}", bill.trim());
    Ok(folder)
}

/// Tries the program of `cargo xtask dist here`, which has the FMU library for this machine alone.
pub(super) fn program_of_one(place: &Path) -> Result<(), String> {
    program(&Platform::own(), place, &[])
}

/// Lets the program, where it can run here, say its version and commit, run an example and pack an FMU for all
/// platforms of `libraries`.
fn program(platform: &Platform, place: &Path, libraries: &[Platform]) -> Result<(), String> {
    let folder = unpacked("fenderline", platform, place)?;
    let completions = shell_files::COMPLETIONS.map(|(_, name)| name);
    for file in completions.iter().chain([&shell_files::PAGE]) {
        is_there(&folder.join(file))?;
    }
    let program = folder.join(platform.program("fenderline"));
    let call = |arguments: &[&str]| {
        let Some(mut command) = emulated(platform, &program)? else { return Ok(None) };
        run_quietly(command.args(arguments).current_dir(&folder)).map(Some)
    };
    let Some(said) = call(&["--version"])? else {
        println!("{}: no emulator is here, not run", platform.name);
        return Ok(());
    };
    let mut lines = said.lines();
    let commit = commit().map_or("commit: not known".into(), |(_, name)| format!("commit: {name}"));
    if [lines.next(), lines.next()]
        != [Some(&*format!("fenderline {}", version()?)), Some(&*commit)]
    {
        return Err(format!("{} says it is {said}, and should say {commit}", program.display()));
    }
    call(&["init", "-o", "berth.toml"])?;
    call(&["run", "berth.toml", "--allow-failures"])?;
    is_there(&folder.join("out/berth/report.html"))?;
    // FMI 3.0 names the folders of libraries by platform tuples.
    call(&["fmu", "berth.toml", "--kind", "engine", "--fmi", "3", "-o", "engine.fmu"])?;
    let fmu = std::fs::read(folder.join("engine.fmu")).map_err(|e| format!("engine.fmu: {e}"))?;
    for Platform { tuple, .. } in libraries {
        let name = format!("binaries/{tuple}/");
        if !fmu.windows(name.len()).any(|bytes| bytes == name.as_bytes()) {
            return Err(format!("engine.fmu has no {name}"));
        }
    }
    let said = said.trim().replace('\n', ", ");
    println!("{}: {said}; runs an example, packs FMUs", platform.name);
    Ok(())
}

/// The command that runs a program of a platform, with an emulator if needed; `None` if that emulator is not installed.
fn emulated(platform: &Platform, program: &Path) -> Result<Option<Command>, String> {
    if platform.is_own() || platform.triple.is_empty() {
        return Ok(Some(Command::new(program)));
    }
    if platform.is_windows() {
        return match wine::find() {
            Ok(_) => wine::command(program).map(Some),
            Err(_) => Ok(None),
        };
    }
    let there = run_quietly(Command::new("qemu-aarch64").arg("--version")).is_ok();
    Ok(there.then(|| {
        let mut command = Command::new("qemu-aarch64");
        command.args(["-L", "/usr/aarch64-linux-gnu"]).arg(program);
        command
    }))
}

/// Tries the wheel for this machine, which is known by its name, in a new virtual environment with nothing of the
/// checkout.
pub(super) fn wheel(place: &Path, is_for_this: impl Fn(&str) -> bool) -> Result<(), String> {
    let python = tools::python().map_err(|missing| format!("{} is missing", missing.tool))?;
    let environment = place.join("python");
    run_quietly(Command::new(python).args(["-m", "venv"]).arg(&environment))?;
    let bin = if cfg!(windows) { "Scripts" } else { "bin" };
    let own = environment.join(bin).join(format!("python{}", std::env::consts::EXE_SUFFIX));
    let entries =
        std::fs::read_dir(folder()).map_err(|e| format!("{}: {e}", folder().display()))?;
    let wheel = entries
        .flatten()
        .map(|entry| entry.path())
        .find(|path| {
            let name = path.to_string_lossy();
            name.ends_with(".whl") && is_for_this(&name)
        })
        .ok_or("there is no wheel for this machine")?;
    let mut pip = Command::new(&own);
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]).arg(&wheel);
    run_quietly(&mut pip)?;
    let said = run_quietly(Command::new(&own).args(["-I", "-c", IMPORT]).current_dir(place))?;
    println!("{}: {}", wheel.file_name().unwrap_or_default().to_string_lossy(), said.trim());
    Ok(())
}

/// Installs the npm package into an empty folder and imports it.
fn npm_package(place: &Path) -> Result<(), String> {
    let folder_here = place.join("node");
    std::fs::create_dir(&folder_here).map_err(|e| format!("{}: {e}", folder_here.display()))?;
    let package = folder().join(format!("fenderline-{}.tgz", version()?));
    let mut install = Command::new("npm");
    install.args(["install", "--no-audit", "--no-fund"]).arg(&package);
    run_quietly(install.current_dir(&folder_here))?;
    let mut node = Command::new("node");
    let name = format!("fenderline-{}-{}", version()?, Platform::ALL[0].name);
    node.args(["--input-type=module", "-e", NODE]).arg(place.join(name).join("berth.toml"));
    let said = run_quietly(node.current_dir(&folder_here))?;
    println!("npm package: {}", said.trim());
    Ok(())
}

fn is_there(file: &Path) -> Result<(), String> {
    if file.is_file() { Ok(()) } else { Err(format!("{} is missing", file.display())) }
}
