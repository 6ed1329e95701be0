//! The platforms for which a release is built, and the tools that build for them.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::release::{PROFILE, commit};
use crate::command::{cargo, run_quietly};
use crate::same_bits::add_target;
use crate::tools;
use crate::virtual_environment::{environment, target_folder};

/// The oldest glibc with which programs and libraries run. The wheels' tag `manylinux2014` names the same glibc.
pub(super) const GLIBC: &str = "2.17";

/// The tools' versions.
const REQUIREMENTS: &str = "xtask/dist-requirements.txt";

/// The Python of the virtual environment that has maturin, Zig, cargo-zigbuild and twine.
pub(super) fn tools() -> Result<PathBuf, String> {
    let python = tools::python().map_err(|missing| format!("{} is missing", missing.tool))?;
    environment(python, &target_folder().join("dist-python"), Path::new(REQUIREMENTS))
}

/// The Python of a virtual environment with maturin alone, in the same version, for a machine that builds for itself.
pub(super) fn maturin() -> Result<PathBuf, String> {
    let python = tools::python().map_err(|missing| format!("{} is missing", missing.tool))?;
    let all = std::fs::read_to_string(REQUIREMENTS).map_err(|e| format!("{REQUIREMENTS}: {e}"))?;
    let one = all.lines().find(|line| line.starts_with("maturin=="));
    let one = one.ok_or(format!("{REQUIREMENTS} has no maturin"))?;
    let folder = target_folder();
    std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let list = folder.join("maturin-requirements.txt");
    std::fs::write(&list, format!("{one}\n")).map_err(|e| format!("{}: {e}", list.display()))?;
    environment(python, &folder.join("maturin-python"), &list)
}

/// One platform.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Platform {
    /// Name of the platform in the names of archives.
    pub(super) name: &'static str,
    /// Rust's target.
    pub(super) triple: &'static str,
    /// FMI 3.0's name.
    pub(super) tuple: &'static str,
    /// Name of the program that strips debug information from the platform's files.
    pub(super) strip: &'static str,
}

impl Platform {
    pub(super) const ALL: [Platform; 3] = [
        Platform {
            name: "linux-x86_64",
            triple: "x86_64-unknown-linux-gnu",
            tuple: "x86_64-linux",
            strip: "strip",
        },
        Platform {
            name: "linux-aarch64",
            triple: "aarch64-unknown-linux-gnu",
            tuple: "aarch64-linux",
            strip: "aarch64-linux-gnu-strip",
        },
        Platform {
            name: "windows-x86_64",
            triple: "x86_64-pc-windows-gnu",
            tuple: "x86_64-windows",
            strip: "x86_64-w64-mingw32-strip",
        },
    ];

    /// The platform of this machine, for which cargo alone builds.
    pub(super) fn own() -> Platform {
        let name = match (std::env::consts::OS, std::env::consts::ARCH) {
            ("linux", "x86_64") => "linux-x86_64",
            ("linux", "aarch64") => "linux-aarch64",
            ("macos", "x86_64") => "macos-x86_64",
            ("macos", "aarch64") => "macos-aarch64",
            ("windows", "x86_64") => "windows-x86_64",
            ("windows", "aarch64") => "windows-aarch64",
            _ => "here",
        };
        Platform { name, triple: "", tuple: "", strip: "strip" }
    }

    pub(super) fn is_windows(&self) -> bool {
        self.triple.contains("windows") || (self.triple.is_empty() && cfg!(windows))
    }

    fn is_macos(&self) -> bool {
        self.triple.contains("apple") || (self.triple.is_empty() && cfg!(target_os = "macos"))
    }

    /// Whether programs for the platform run on this machine without an emulator.
    pub(super) fn is_own(&self) -> bool {
        cfg!(all(target_os = "linux", target_arch = "x86_64")) && self.name == "linux-x86_64"
    }

    /// Checks that the programs which build and strip files of the platform are installed.
    ///
    /// # Errors
    /// Fails with the name of the missing program and its package of Debian.
    pub(super) fn has_programs(&self) -> Result<(), String> {
        let programs: &[&str] = match self.triple {
            "x86_64-pc-windows-gnu" => &["x86_64-w64-mingw32-gcc", "x86_64-w64-mingw32-dlltool"],
            _ => &[],
        };
        let package = match self.triple {
            "x86_64-pc-windows-gnu" => "gcc-mingw-w64-x86-64",
            "aarch64-unknown-linux-gnu" => "gcc-aarch64-linux-gnu",
            _ => "binutils",
        };
        for program in programs.iter().chain([&self.strip]) {
            run_quietly(Command::new(program).arg("--version"))
                .map_err(|_| format!("{program} is missing; install: {package} of Debian"))?;
        }
        Ok(())
    }

    /// A cargo command that links for the platform: by Zig for Linux, by mingw for Windows.
    pub(super) fn cargo(&self, what: &str) -> Result<Command, String> {
        add_target(self.triple)?;
        if self.is_windows() {
            let mut command = cargo([what]);
            command.envs(commit());
            return Ok(command);
        }
        let bin = tools()?.parent().map(PathBuf::from).unwrap_or_default();
        let mut command = Command::new(bin.join("cargo-zigbuild"));
        command.arg(if what == "build" { "zigbuild" } else { what });
        // It asks this Python for Zig.
        command.env("CARGO_ZIGBUILD_PYTHON_PATH", bin.join("python3"));
        command.envs(commit());
        Ok(command)
    }

    /// The target that the command of cargo gets for the platform.
    pub(super) fn target(&self) -> String {
        if self.is_windows() { self.triple.into() } else { format!("{}.{GLIBC}", self.triple) }
    }

    pub(super) fn library(&self, name: &str) -> String {
        if self.is_windows() {
            return format!("{name}.dll");
        }
        format!("lib{name}.{}", if self.is_macos() { "dylib" } else { "so" })
    }

    /// Name of the C library's shared file, with a version in the name; not for Windows.
    pub(super) fn shared_library(&self, version: &str) -> String {
        match self.is_macos() {
            true => format!("libfenderline.{version}.dylib"),
            false => format!("libfenderline.so.{version}"),
        }
    }

    /// Name of the C library's import library for Windows, as the platform's compiler writes it: mingw's or
    /// Microsoft's.
    pub(super) fn import_library(&self) -> &'static str {
        if self.triple.is_empty() { "fenderline.dll.lib" } else { "libfenderline.dll.a" }
    }

    pub(super) fn program(&self, name: &str) -> String {
        if self.is_windows() { format!("{name}.exe") } else { name.into() }
    }

    /// Path of a file that the release build for the platform has made.
    pub(super) fn built(&self, file: &str) -> PathBuf {
        target_folder().join(self.triple).join(PROFILE).join(file)
    }
}
