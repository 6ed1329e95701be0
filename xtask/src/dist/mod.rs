//! `cargo xtask dist` makes everything that a release hands out, into `target/dist`: programs, C libraries and Python
//! wheels for Linux on x86-64 and 64-bit Arm and for Windows, FMU libraries within the programs, the source
//! distribution, licences, bills of materials and check sums. `cargo xtask dist cheap` is the part of these packages
//! that continuous integration makes; `cargo xtask dist here` makes program, C library and wheel on a machine of
//! another kind, such as a Mac, for that machine.
//!
//! Zig links for an old glibc (2.17, of 2012), so that programs and libraries also run on older Linux systems than the
//! one that builds them. Zig, cargo-zigbuild, maturin and twine come from PyPI, in the versions of
//! `xtask/dist-requirements.txt`.

mod archive;
mod c_package;
mod here;
mod platforms;
mod publish;
mod python;
mod release;
mod shell_files;
mod sources;
mod tag;
mod tried;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use self::platforms::Platform;
use self::release::{PROFILE, copy, folder, licences, size, version};
use crate::browser;
use crate::command::{run, run_quietly};
use crate::program::copy_stripped;
use crate::step::{Done, Step, run_all};
use crate::tools;
use crate::virtual_environment::target_folder;

/// The part of the release's packages that continuous integration makes.
pub(crate) const CHEAP: Step = Step { name: "packages for release, the cheap half", run: cheap };

/// The whole, in order.
const STEPS: [Step; 9] = [
    Step { name: "tools", run: tools_of_all },
    Step { name: "libraries of FMUs, C libraries", run: libraries },
    Step { name: "programs", run: programs },
    Step { name: "C packages", run: c_packages },
    Step {
        name: "Python wheels and source distribution",
        run: || python::all().map(|()| Done::Good),
    },
    Step { name: "npm package", run: npm },
    Step { name: "crates and Python packages could be published", run: published },
    SUMS,
    TRIED,
];

/// Installs the tools from PyPI, and checks the programs that other platforms need.
fn tools_of_all() -> Result<Done, String> {
    Platform::ALL.iter().try_for_each(Platform::has_programs)?;
    platforms::tools().map(|_| Done::Good)
}

const SUMS: Step = Step { name: "check sums", run: sums };

/// Unpacks the archives that were made, and uses what is in them.
const TRIED: Step = Step { name: "the archives as a user finds them", run: tried::tried };

/// `cargo xtask dist`.
pub(crate) fn dist_command() -> ExitCode {
    anew(&STEPS)
}

/// `cargo xtask dist here`.
pub(crate) fn here_command() -> ExitCode {
    anew(&here::STEPS)
}

/// Empties the folder of the release, then runs `steps`.
fn anew(steps: &[Step]) -> ExitCode {
    let folder = folder();
    if folder.exists()
        && let Err(e) = std::fs::remove_dir_all(&folder)
    {
        eprintln!("{}: {e}", folder.display());
        return ExitCode::FAILURE;
    }
    run_all(steps)
}

/// `cargo xtask dist sums` writes check sums of the files in `target/dist`, also of files that other machines have
/// made.
pub(crate) fn sums_command() -> ExitCode {
    run_all(&[SUMS])
}

/// `cargo xtask dist tag TAG` says whether a tag may be released, and writes the notes of the release.
pub(crate) fn tag_command(name: &str) -> ExitCode {
    match tag::checked(name) {
        Ok(notes) => {
            println!("{name}: all files have this version; notes in {}", notes.display());
            ExitCode::SUCCESS
        }
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// `cargo xtask dist cheap`.
pub(crate) fn cheap_command() -> ExitCode {
    run_all(&[CHEAP])
}

/// `cargo xtask dist try` runs only the last step, over the archives in `target/dist`.
pub(crate) fn try_command() -> ExitCode {
    run_all(&[TRIED])
}

/// `cargo xtask dist c PREFIX` builds the C library for this machine and installs it, with its headers, pkg-config and
/// CMake files, into a folder such as `/usr/local`.
pub(crate) fn install_c_command(prefix: &str) -> ExitCode {
    let prefix = Path::new(prefix);
    match c_package::build_here().and_then(|()| c_package::make(&Platform::own(), prefix)) {
        Ok(()) => {
            println!("installed into {}", prefix.display());
            println!("for programs: PKG_CONFIG_PATH={}", prefix.join("lib/pkgconfig").display());
            println!("              cmake -DCMAKE_PREFIX_PATH={}", prefix.display());
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn libraries() -> Result<Done, String> {
    for platform in Platform::ALL {
        let soname = c_package::soname(&platform)?;
        let mut build = platform.cargo("build")?;
        build.args([
            "--profile",
            PROFILE,
            "--package",
            "fenderline-fmu",
            "--package",
            "fenderline-capi",
        ]);
        run(build.args(["--target", &platform.target()]).env("FENDERLINE_SONAME", soname))?;
        let library = platform.library("fenderline_fmu");
        let place = fmu_libraries().join(platform.tuple).join(&library);
        copy_stripped(platform.strip, &platform.built(&library), &place)?;
        println!("{}: {} kB", platform.name, size(&place)? / 1000);
    }
    Ok(Done::Good)
}

/// The folder from which the build of programs takes the libraries for FMUs.
fn fmu_libraries() -> PathBuf {
    target_folder().join("dist-fmu-libraries")
}

fn programs() -> Result<Done, String> {
    for platform in Platform::ALL {
        let mut build = platform.cargo("build")?;
        build.args([
            "--profile",
            PROFILE,
            "--package",
            "fenderline",
            "--target",
            &platform.target(),
        ]);
        run(build.env(crate::program::LIBRARIES, fmu_libraries()))?;
        let name = format!("fenderline-{}-{}", version()?, platform.name);
        let folder = folder().join(&name);
        let program = platform.program("fenderline");
        copy_stripped(platform.strip, &platform.built(&program), &folder.join(&program))?;
        copy(Path::new("README.md"), &folder)?;
        copy(Path::new("CHANGELOG.md"), &folder)?;
        // That of this machine comes first, and its texts are those of all.
        let own = Platform::ALL.into_iter().find(Platform::is_own).ok_or("not Linux on x86-64")?;
        shell_files::write(&own.built("fenderline"), &folder)?;
        licences("fenderline", &folder, &[platform.triple])?;
        let size = size(&folder.join(&program))?;
        let archive = archive::pack(&folder, platform.is_windows())?;
        println!("{}: {:.1} MB", archive.display(), size as f64 / 1e6);
    }
    Ok(Done::Good)
}

fn c_packages() -> Result<Done, String> {
    for platform in Platform::ALL {
        let name = format!("fenderline-c-{}-{}", version()?, platform.name);
        let folder = folder().join(&name);
        c_package::make(&platform, &folder)?;
        licences("fenderline-capi", &folder, &[platform.triple])?;
        if platform.is_own() {
            c_package::find(&folder)?;
        }
        println!("{}", archive::pack(&folder, platform.is_windows())?.display());
    }
    Ok(Done::Good)
}

/// Makes the npm package as `npm pack` does, and tests it under Node.
fn npm() -> Result<Done, String> {
    match browser::package_whole()? {
        Done::Good => {}
        missing => return Ok(missing),
    }
    publish::npm(Path::new(browser::PACKAGE), &folder())?;
    Ok(Done::Good)
}

fn published() -> Result<Done, String> {
    publish::crates(true)?;
    python::checked()?;
    Ok(Done::Good)
}

/// Writes `SHA256SUMS` for all files for download, in the form that `sha256sum --check` reads.
fn sums() -> Result<Done, String> {
    let folder = folder();
    let mut names = Vec::new();
    let entries = std::fs::read_dir(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    for entry in entries.flatten().filter(|entry| entry.path().is_file()) {
        names.push(entry.file_name().to_string_lossy().into_owned());
    }
    // Those of an earlier call.
    names.retain(|name| name != "SHA256SUMS");
    names.sort();
    let sums = run_quietly(Command::new("sha256sum").args(&names).current_dir(&folder))?;
    let file = folder.join("SHA256SUMS");
    std::fs::write(&file, &sums).map_err(|e| format!("{}: {e}", file.display()))?;
    print!("{sums}");
    Ok(Done::Good)
}

/// Makes, installs, finds and uses a C package for this machine; makes licences and bills of materials; checks what the
/// packages of crates and the source distribution hold.
fn cheap() -> Result<Done, String> {
    for missing in [tools::c_compiler(), tools::cmake(), tools::python().map(|_| ())] {
        if let Err(missing) = missing {
            return Ok(Done::NotRun(missing));
        }
    }
    let folder = target_folder().join("dist-cheap");
    if folder.exists() {
        std::fs::remove_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    }
    let platform = Platform::own();
    c_package::build_here()?;
    c_package::make(&platform, &folder.join("c"))?;
    // Once more over the first, as an installation into a prefix that has an older one.
    c_package::make(&platform, &folder.join("c"))?;
    c_package::find(&folder.join("c"))?;
    let triples: Vec<&str> = Platform::ALL.iter().map(|platform| platform.triple).collect();
    licences("fenderline", &folder.join("program"), &triples)?;
    licences("fenderline-capi", &folder.join("c"), &triples)?;
    publish::crates(false)?;
    sources::in_packages()?;
    version()?;
    Ok(Done::Good)
}
