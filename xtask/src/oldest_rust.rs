//! `cargo xtask oldest-rust` checks that everything users build compiles with the oldest Rust that `Cargo.toml` names.
//! The check compiles all libraries once more, and so is part of `cargo xtask once-more`. Every run of the lints finds
//! uses of the standard library that the oldest Rust does not have (Clippy's `incompatible_msrv`).

use std::process::Command;

use crate::command::{run, run_quietly};
use crate::step::{Done, Step};
use crate::tools::Missing;
use crate::virtual_environment::target_folder;

/// The packages that users build: the program, the libraries for other programs, the Python package, these tasks.
const PACKAGES: [&str; 5] =
    ["fenderline", "fenderline-capi", "fenderline-fmu", "fenderline-python", "xtask"];

/// `cargo xtask oldest-rust`.
pub(crate) const STEP: Step =
    Step { name: "the oldest Rust that the manifest names", run: oldest_rust };

fn oldest_rust() -> Result<Done, String> {
    let manifest = std::fs::read_to_string("Cargo.toml").map_err(|e| format!("Cargo.toml: {e}"))?;
    let version = manifest
        .lines()
        .find_map(|line| line.strip_prefix("rust-version = \"")?.strip_suffix('"'))
        .ok_or("Cargo.toml names no rust-version")?;
    let there = run_quietly(Command::new("rustup").args(["run", version, "cargo", "--version"]));
    let Ok(there) = there else {
        return Ok(Done::NotRun(Missing {
            tool: "the oldest Rust that Cargo.toml names",
            install: "rustup toolchain install VERSION --profile minimal, with the rust-version of Cargo.toml",
        }));
    };
    println!("{}", there.trim());
    let mut check = Command::new("rustup");
    check.args(["run", version, "cargo", "check", "--locked", "--target-dir"]);
    check.arg(target_folder().join("oldest-rust"));
    for package in PACKAGES {
        check.args(["--package", package]);
    }
    // Those of the cargo that runs this task.
    check.env_remove("CARGO").env_remove("RUSTC").env_remove("RUSTUP_TOOLCHAIN");
    run(&mut check)?;
    Ok(Done::Good)
}
