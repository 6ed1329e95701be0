//! Makes the C library as a folder that can be installed anywhere: header, libraries, pkg-config and CMake files.

use std::path::Path;
use std::process::Command;

use super::platforms::Platform;
use super::release::{PROFILE, copy, version};
use crate::built;
use crate::command::{run, run_quietly};
use crate::program::copy_stripped;
use crate::virtual_environment::target_folder;

/// The scenario that the C example runs, and the number of its steps.
const SCENARIO: [&str; 2] = ["scenarios/paper/experiment_2_4kn.toml", "200"];

/// The SONAME of the shared library (on macOS its install name), which changes with the version of the interface in the
/// header.
pub(super) fn soname(platform: &Platform) -> Result<String, String> {
    let header = std::fs::read_to_string("include/fenderline.h")
        .map_err(|e| format!("include/fenderline.h: {e}"))?;
    let version = header
        .lines()
        .find_map(|line| line.strip_prefix("#define FL_ABI_VERSION "))
        .ok_or("the header include/fenderline.h does not define FL_ABI_VERSION")?;
    Ok(platform.shared_library(version.trim()))
}

/// Builds the C library for this machine, with its SONAME. The next plain build replaces this library by one without a
/// SONAME.
pub(super) fn build_here() -> Result<(), String> {
    run(built::build(PROFILE, &["--lib"]).env("FENDERLINE_SONAME", soname(&Platform::own())?))
}

/// Makes the folder of the C package from the libraries that were built.
pub(super) fn make(platform: &Platform, folder: &Path) -> Result<(), String> {
    let built = |file: &str| {
        if platform.triple.is_empty() {
            target_folder().join(PROFILE).join(file)
        } else {
            platform.built(file)
        }
    };
    let (version, soname) = (version()?, soname(platform)?);
    let real = platform.shared_library(&version);
    let lib = folder.join("lib");
    for header in ["include/fenderline.h", "include/fenderline.hpp"] {
        copy(Path::new(header), &folder.join("include"))?;
    }
    copy(Path::new("bindings/csharp/Fenderline.cs"), &folder.join("share/fenderline/csharp"))?;
    if platform.is_windows() {
        copy_stripped(
            platform.strip,
            &built("fenderline.dll"),
            &folder.join("bin/fenderline.dll"),
        )?;
        copy(&built(platform.import_library()), &lib)?;
    } else {
        let plain = platform.library("fenderline");
        copy_stripped(platform.strip, &built(&plain), &lib.join(&real))?;
        link(&real, &lib.join(&soname))?;
        link(&soname, &lib.join(&plain))?;
        // Debug information of the static library alone is five times the rest.
        let archive = lib.join("libfenderline.a");
        copy(&built("libfenderline.a"), &lib)?;
        if run_quietly(Command::new(platform.strip).arg("--version")).is_ok() {
            run_quietly(Command::new(platform.strip).arg("--strip-debug").arg(&archive))?;
        }
    }
    let mut numbers = version.split('.');
    let (major, minor) = (numbers.next().unwrap_or(""), numbers.next().unwrap_or(""));
    for (template, place) in [
        ("fenderline.pc.in", "lib/pkgconfig/fenderline.pc"),
        ("fenderline-config.cmake.in", "lib/cmake/fenderline/fenderline-config.cmake"),
        (
            "fenderline-config-version.cmake.in",
            "lib/cmake/fenderline/fenderline-config-version.cmake",
        ),
    ] {
        let template = Path::new("crates/capi/package").join(template);
        let text = std::fs::read_to_string(&template)
            .map_err(|e| format!("{}: {e}", template.display()))?;
        let text = text
            .replace("@VERSION@", &version)
            .replace("@SONAME@", &soname)
            .replace("@LIBRARY@", &real)
            .replace("@IMPORT_LIBRARY@", platform.import_library())
            .replace("@MAJOR@", major)
            .replace("@MINOR@", minor);
        let place = folder.join(place);
        let within = place.parent().unwrap_or(folder);
        std::fs::create_dir_all(within).map_err(|e| format!("{}: {e}", within.display()))?;
        std::fs::write(&place, text).map_err(|e| format!("{}: {e}", place.display()))?;
    }
    Ok(())
}

#[cfg(unix)]
fn link(to: &str, place: &Path) -> Result<(), String> {
    // That of an earlier installation.
    if place.is_symlink() {
        std::fs::remove_file(place).map_err(|e| format!("{}: {e}", place.display()))?;
    }
    std::os::unix::fs::symlink(to, place).map_err(|e| format!("{}: {e}", place.display()))
}

#[cfg(not(unix))]
fn link(_: &str, place: &Path) -> Result<(), String> {
    Err(format!("{}: packages are made on Linux", place.display()))
}

/// Moves the C package's folder, finds the package by pkg-config (on Linux) and by CMake, and runs the example with the
/// shared and the static library: all runs must print the same.
pub(super) fn find(folder: &Path) -> Result<(), String> {
    let place = std::env::temp_dir().join(format!("fenderline-c-{}", std::process::id()));
    let found = find_in(folder, &place);
    let _ = std::fs::remove_dir_all(&place);
    found
}

fn find_in(folder: &Path, place: &Path) -> Result<(), String> {
    std::fs::create_dir_all(place).map_err(|e| format!("{}: {e}", place.display()))?;
    let prefix = place.join("prefix");
    run_quietly(Command::new("cp").arg("-a").arg(folder).arg(&prefix))?;
    let mut outputs = Vec::new();
    if cfg!(target_os = "linux") {
        outputs.push(by_pkg_config(&prefix, place)?);
    }
    let build = place.join("build");
    let examples = std::path::absolute("examples").map_err(|e| format!("examples: {e}"))?;
    let mut configure = Command::new("cmake");
    configure.args(["-S", "crates/capi/package/find", "-B"]).arg(&build);
    configure.arg(format!("-DCMAKE_PREFIX_PATH={}", prefix.display()));
    run_quietly(configure.arg(format!("-DEXAMPLES={}", examples.display())))?;
    run_quietly(Command::new("cmake").arg("--build").arg(&build))?;
    for name in ["ship", "ship_static"] {
        outputs.push(run_quietly(Command::new(build.join(name)).args(SCENARIO))?);
    }
    run_quietly(&mut Command::new(build.join("game_loop")))?;
    if outputs.iter().any(|output| output.lines().count() < 100 || output != &outputs[0]) {
        return Err("the outputs of the C example differ, or are too short".into());
    }
    println!(
        "pkg-config and CMake find the C package; the example prints the same with each library; the C++ example runs"
    );
    Ok(())
}

/// Checks the SONAME of the library, and builds the examples with the options that pkg-config gives. Returns what the C
/// example has printed.
fn by_pkg_config(prefix: &Path, place: &Path) -> Result<String, String> {
    let lib = prefix.join("lib");
    let dynamic =
        run_quietly(Command::new("readelf").arg("-d").arg(lib.join(soname(&Platform::own())?)))?;
    if !dynamic.contains(&format!("soname: [{}]", soname(&Platform::own())?)) {
        return Err(format!("the library has no SONAME {}:\n{dynamic}", soname(&Platform::own())?));
    }
    let example = Path::new("examples/c/ship.c");
    let mut flags = Command::new("pkg-config");
    flags.args(["--cflags", "--libs", "fenderline"]);
    let flags = run_quietly(flags.env("PKG_CONFIG_PATH", lib.join("pkgconfig")))?;
    let by_pkg_config = place.join("ship");
    let mut cc = Command::new("cc");
    cc.arg("-std=c99").arg(example).args(flags.split_whitespace()).arg("-o").arg(&by_pkg_config);
    run_quietly(&mut cc)?;
    let mut ship = Command::new(&by_pkg_config);
    let said = run_quietly(ship.args(SCENARIO).env("LD_LIBRARY_PATH", &lib))?;
    let by_pkg_config = place.join("game_loop");
    let mut cpp = Command::new("c++");
    cpp.arg("-std=c++17").arg("examples/cpp/game_loop.cpp").args(flags.split_whitespace());
    run_quietly(cpp.arg("-o").arg(&by_pkg_config))?;
    run_quietly(Command::new(&by_pkg_config).env("LD_LIBRARY_PATH", &lib))?;
    Ok(said)
}
