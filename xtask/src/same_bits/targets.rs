//! The targets of the comparison: how a program for each target is built and run on this machine.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{cargo, run, run_quietly};
use crate::virtual_environment::target_folder;
use crate::wine;

/// The names of the targets, in the order of the columns.
pub(super) const NAMES: [&str; 5] =
    ["linux gnu", "linux musl", "windows, wine", "wasm, node", "aarch64, qemu"];

const TRIPLES: [&str; 5] = [
    "x86_64-unknown-linux-gnu",
    "x86_64-unknown-linux-musl",
    "x86_64-pc-windows-gnu",
    "wasm32-wasip1",
    "aarch64-unknown-linux-gnu",
];

/// JavaScript that runs a WASI program under Node, gives the program the present folder, and passes its arguments on.
const NODE_RUNNER: &str = "\
import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';
const [program, ...rest] = process.argv.slice(2);
const wasi = new WASI({ version: 'preview1', args: [program, ...rest], env: {}, preopens: { '.': '.' } });
const module = await WebAssembly.compile(await readFile(program));
process.exit(wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject())));
";

/// One target.
pub(super) struct Target {
    pub(super) name: &'static str,
    pub(super) triple: &'static str,
}

/// All targets.
///
/// # Errors
/// Fails if this machine is not Linux on x86-64.
pub(super) fn all() -> Result<Vec<Target>, String> {
    if !cfg!(all(target_os = "linux", target_arch = "x86_64")) {
        return Err("this command needs a machine with Linux on x86-64".into());
    }
    Ok(NAMES.into_iter().zip(TRIPLES).map(|(name, triple)| Target { name, triple }).collect())
}

impl Target {
    /// Adds the target's standard library, and checks that the programs which the target needs are installed.
    pub(super) fn prepare(&self) -> Result<(), String> {
        let has = |program: &str, package: &str| {
            run_quietly(Command::new(program).arg("--version"))
                .map(|_| ())
                .map_err(|_| format!("{program} is missing; install: {package} of Debian"))
        };
        match self.triple {
            "x86_64-pc-windows-gnu" => {
                has("x86_64-w64-mingw32-gcc", "gcc-mingw-w64-x86-64")?;
                wine::find()?;
            }
            "wasm32-wasip1" => has("node", "nodejs")?,
            "aarch64-unknown-linux-gnu" => {
                has("aarch64-linux-gnu-gcc", "gcc-aarch64-linux-gnu and libc6-dev-arm64-cross")?;
                has("qemu-aarch64", "qemu-user")?;
            }
            _ => {}
        }
        add_target(self.triple)
    }

    /// Builds the runner.
    pub(super) fn build(&self, profile: &str) -> Result<PathBuf, String> {
        let mut build = cargo(["build", "--quiet", "--package", "fenderline-results"]);
        build.args(["--example", "hash_results", "--profile", profile, "--target", self.triple]);
        run(build.env("CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER", "aarch64-linux-gnu-gcc"))?;
        let suffix = match self.triple {
            "x86_64-pc-windows-gnu" => ".exe",
            "wasm32-wasip1" => ".wasm",
            _ => "",
        };
        let folder = if profile == "dev" { "debug" } else { profile };
        Ok(target_folder()
            .join(self.triple)
            .join(folder)
            .join("examples")
            .join(format!("hash_results{suffix}")))
    }

    /// The command that runs a program of the target.
    pub(super) fn runs(&self, program: &Path) -> Result<Command, String> {
        let mut command;
        match self.triple {
            "x86_64-pc-windows-gnu" => return wine::command(program),
            "wasm32-wasip1" => {
                let runner = target_folder().join("same-bits.mjs");
                std::fs::write(&runner, NODE_RUNNER)
                    .map_err(|e| format!("{}: {e}", runner.display()))?;
                command = Command::new("node");
                command.arg("--no-warnings").arg(runner).arg(program);
            }
            "aarch64-unknown-linux-gnu" => {
                command = Command::new("qemu-aarch64");
                command.args(["-L", "/usr/aarch64-linux-gnu"]).arg(program);
            }
            _ => command = Command::new(program),
        }
        Ok(command)
    }
}

/// Adds the standard library of a target with rustup, if it is not installed.
pub(crate) fn add_target(triple: &str) -> Result<(), String> {
    let folder =
        run_quietly(Command::new("rustc").args(["--print", "target-libdir", "--target", triple]))?;
    if Path::new(folder.trim()).is_dir() {
        return Ok(());
    }
    run(Command::new("rustup").args(["target", "add", triple]))
        .map_err(|why| format!("the standard library for {triple} is missing: {why}"))
}
