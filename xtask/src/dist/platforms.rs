//! The platforms of a release, and the tools that build for them.

use std::path::PathBuf;
use std::process::Command;

use crate::command::cargo;
use crate::same_bits::add_target;
use crate::tools;
use crate::virtual_environment::{environment, target_folder};

/// The oldest glibc that programs and libraries run with. It is that of the wheels' tag `manylinux2014`.
pub(super) const GLIBC: &str = "2.17";

/// The Python of the environment with maturin, Zig, cargo-zigbuild and twine.
pub(super) fn tools() -> Result<PathBuf, String> {
    let python = tools::python().map_err(|missing| format!("{} is missing", missing.tool))?;
    let requirements = std::path::Path::new("xtask/dist-requirements.txt");
    environment(python, &target_folder().join("dist-python"), requirements)
}

/// One platform.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Platform {
    /// In the names of archives.
    pub(super) name: &'static str,
    /// Rust's target.
    pub(super) triple: &'static str,
    /// FMI 3.0's name.
    pub(super) tuple: &'static str,
    /// The program that strips its files.
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

    /// The platform of this machine, built by cargo alone for the cheap half.
    pub(super) fn own() -> Platform {
        Platform { name: "here", triple: "", tuple: "", strip: "strip" }
    }

    pub(super) fn is_windows(&self) -> bool {
        self.triple.contains("windows")
    }

    /// Whether programs for it run here without an emulator.
    pub(super) fn is_own(&self) -> bool {
        cfg!(all(target_os = "linux", target_arch = "x86_64")) && self.name == "linux-x86_64"
    }

    /// A cargo command that links for the platform: by Zig for Linux, by mingw for Windows.
    pub(super) fn cargo(&self, what: &str) -> Result<Command, String> {
        add_target(self.triple)?;
        if self.is_windows() {
            return Ok(cargo([what]));
        }
        let bin = tools()?.parent().map(PathBuf::from).unwrap_or_default();
        let mut command = Command::new(bin.join("cargo-zigbuild"));
        command.arg(if what == "build" { "zigbuild" } else { what });
        // It asks this Python for Zig.
        command.env("CARGO_ZIGBUILD_PYTHON_PATH", bin.join("python3"));
        Ok(command)
    }

    /// The target for that command.
    pub(super) fn target(&self) -> String {
        if self.is_windows() { self.triple.into() } else { format!("{}.{GLIBC}", self.triple) }
    }

    pub(super) fn library(&self, name: &str) -> String {
        if self.is_windows() { format!("{name}.dll") } else { format!("lib{name}.so") }
    }

    pub(super) fn program(&self, name: &str) -> String {
        if self.is_windows() { format!("{name}.exe") } else { name.into() }
    }

    /// A file that the release build has made.
    pub(super) fn built(&self, file: &str) -> PathBuf {
        target_folder().join(self.triple).join("release").join(file)
    }
}
