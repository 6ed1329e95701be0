//! Finds the programs other than Rust that some steps need.

use std::process::Command;

use crate::command::{cargo, run_quietly};

/// A tool that a step needs and that is not installed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Missing {
    /// Name of the tool.
    pub(crate) tool: &'static str,
    /// How to install it.
    pub(crate) install: &'static str,
}

/// Finds a Python that is new enough to read TOML.
pub(crate) fn python() -> Result<&'static str, Missing> {
    let asks = "import sys, tomllib; sys.exit(sys.version_info < (3, 11))";
    answers(Command::new("python3").args(["-c", asks]))
        .then_some("python3")
        .ok_or(Missing { tool: "Python 3.11 or later", install: "from your distribution" })
}

/// Finds a Python with venv and pip, and access to a package index.
pub(crate) fn python_environments() -> Result<&'static str, Missing> {
    let python = python()?;
    let finds = ["install", "--dry-run", "--quiet", "--no-deps", "--ignore-installed", "maturin"];
    let is_there = answers(Command::new(python).args(["-c", "import ensurepip, venv"]))
        && answers(Command::new(python).args(["-m", "pip"]).args(finds));
    is_there.then_some(python).ok_or(Missing {
        tool: "Python's venv and pip, with access to PyPI",
        install: "python3-venv and python3-pip of your distribution",
    })
}

/// cargo-deny.
pub(crate) fn cargo_deny() -> Result<(), Missing> {
    let install = "cargo install --locked cargo-deny";
    answers(&mut cargo(["deny", "--version"]))
        .then_some(())
        .ok_or(Missing { tool: "cargo-deny", install })
}

/// Finds cargo-fuzz, and the C++ compiler that its library needs.
pub(crate) fn cargo_fuzz() -> Result<(), Missing> {
    let install = "cargo install --locked cargo-fuzz";
    answers(&mut cargo(["fuzz", "--version"]))
        .then_some(())
        .ok_or(Missing { tool: "cargo-fuzz", install })?;
    let compiler = std::env::var("CXX").unwrap_or_else(|_| "c++".into());
    answers(Command::new(compiler).arg("--version"))
        .then_some(())
        .ok_or(Missing { tool: "a C++ compiler", install: "g++ or clang of your distribution" })
}

/// Finds a C compiler with the address and undefined-behaviour sanitizers, a C++ compiler for the header, and `nm`.
pub(crate) fn c_compiler() -> Result<(), Missing> {
    let mut cc = Command::new("cc");
    cc.args(["-x", "c", "-fsanitize=address,undefined", "/dev/null", "-shared", "-fPIC"]);
    let all = answers(cc.args(["-o", "/dev/null"]))
        && answers(Command::new("c++").arg("--version"))
        && answers(Command::new("nm").arg("--version"));
    all.then_some(()).ok_or(Missing {
        tool: "a C and C++ compiler with sanitizers",
        install: "gcc, g++ and binutils of your distribution",
    })
}

/// Finds CMake and pkg-config, by which programs find the C package.
pub(crate) fn cmake() -> Result<(), Missing> {
    let both = answers(Command::new("cmake").arg("--version"))
        && answers(Command::new("pkg-config").arg("--version"));
    both.then_some(()).ok_or(Missing {
        tool: "CMake or pkg-config",
        install: "cmake and pkg-config of your distribution",
    })
}

/// Finds Mono with its C# compiler.
pub(crate) fn mono() -> Result<(), Missing> {
    let both = answers(Command::new("mcs").arg("--version"))
        && answers(Command::new("mono").arg("--version"));
    both.then_some(())
        .ok_or(Missing { tool: "Mono", install: "mono-mcs and mono-runtime of your distribution" })
}

/// valgrind, which counts instructions.
pub(crate) fn valgrind() -> Result<(), Missing> {
    answers(Command::new("valgrind").arg("--version"))
        .then_some(())
        .ok_or(Missing { tool: "valgrind", install: "from your distribution" })
}

/// Finds a C compiler, which builds Box2D for the benches, and the library Chipmunk.
pub(crate) fn c_peers() -> Result<(), Missing> {
    answers(Command::new("cc").args(["-shared", "-o", "/dev/null", "-lchipmunk"]))
        .then_some(())
        .ok_or(Missing { tool: "Chipmunk or a C compiler", install: "libchipmunk-dev and gcc" })
}

/// Finds Node and npm that are new enough for the pages' tools.
pub(crate) fn node() -> Result<(), Missing> {
    let asks = "const [a, b] = process.versions.node.split('.').map(Number); \
                process.exit(a > 20 || (a === 20 && b >= 19) ? 0 : 1)";
    (answers(Command::new("node").args(["-e", asks]))
        && answers(Command::new("npm").arg("--version")))
    .then_some(())
    .ok_or(Missing { tool: "Node 20.19 or later with npm", install: "from your distribution" })
}

/// Finds Chromium, or the browser that the variable `CHROMIUM` names.
pub(crate) fn chromium() -> Result<(), Missing> {
    let browser = std::env::var("CHROMIUM").unwrap_or_else(|_| "/usr/bin/chromium".into());
    answers(Command::new(browser).arg("--version"))
        .then_some(())
        .ok_or(Missing { tool: "Chromium", install: "from your distribution" })
}

/// Finds Rust's standard library for WebAssembly in browsers.
pub(crate) fn wasm_target() -> Result<(), Missing> {
    const TARGET: &str = "wasm32-unknown-unknown";
    is_installed(TARGET).then_some(()).ok_or(Missing {
        tool: "the target wasm32-unknown-unknown",
        install: "rustup target add wasm32-unknown-unknown",
    })
}

/// Finds an installed target of Rust without an operating system, if there is one.
pub(crate) fn bare_target() -> Option<&'static str> {
    ["wasm32v1-none", "thumbv7em-none-eabi", "thumbv7em-none-eabihf"]
        .into_iter()
        .find(|target| is_installed(target))
}

fn is_installed(target: &str) -> bool {
    let asked =
        Command::new("rustc").args(["--print", "target-libdir", "--target", target]).output();
    asked.is_ok_and(|output| {
        output.status.success()
            && std::path::Path::new(String::from_utf8_lossy(&output.stdout).trim()).is_dir()
    })
}

fn answers(command: &mut Command) -> bool {
    run_quietly(command).is_ok()
}
