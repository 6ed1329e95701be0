//! `cargo xtask bench` times the engine against its peers, and counts the engine's instructions per step. The results
//! are reported and never fail a build: times on one machine say little about another.

use std::process::ExitCode;

use crate::command::{cargo, run};
use crate::step::Done;
use crate::tools;

const BENCHES: [&str; 16] = [
    "clip",
    "step",
    "islands",
    "fenders",
    "threads",
    "outlines",
    "first",
    "border",
    "accuracy",
    "mmg",
    "berth",
    "fleet",
    "many",
    "campaign",
    "passage",
    "callgrind",
];

/// Runs the benches that have the given names; all benches if no name is given.
pub(crate) fn bench(names: &[&str]) -> ExitCode {
    if let Some(unknown) = names.iter().find(|name| !BENCHES.contains(name)) {
        eprintln!("there is no bench `{unknown}`; there are {}", BENCHES.join(", "));
        return ExitCode::from(2);
    }
    let wanted = if names.is_empty() { BENCHES.as_slice() } else { names };
    let mut code = ExitCode::SUCCESS;
    for &name in wanted {
        println!("\n== {name}");
        if name == "callgrind"
            && let Err(missing) = tools::valgrind()
        {
            println!("== not run: {} is missing; install: {}", missing.tool, missing.install);
            continue;
        }
        let bench: &[&str] = match name {
            // Examples of crates with few dependencies, which are soon built.
            "passage" => &["--package", "fenderline-embed", "--example", "passage"],
            "callgrind" => &["--package", "fenderline-bench-scenes"],
            "border" => &["--package", "fenderline-capi", "--example", "cost"],
            "step" => match tools::c_peers() {
                Ok(()) => &["--package", "fenderline-bench", "--features", "peers", "--", name],
                Err(missing) => {
                    println!(
                        "without Box2D and Chipmunk: {} is missing; install: {}",
                        missing.tool, missing.install
                    );
                    &["--package", "fenderline-bench", "--", name]
                }
            },
            _ => &["--package", "fenderline-bench", "--", name],
        };
        let mut cargo = cargo(["run", "--quiet", "--release"]);
        if let Err(message) = run(cargo.args(bench)) {
            eprintln!("{message}");
            code = ExitCode::FAILURE;
        }
    }
    code
}

/// Runs the counts of instructions as a step of `cargo xtask test all`, which prints them and decides nothing by them.
///
/// # Errors
/// Never fails: what could not be counted is printed.
pub(crate) fn reported() -> Result<Done, String> {
    if bench(&["callgrind"]) != ExitCode::SUCCESS {
        println!("the number of instructions cannot be counted on this machine");
    }
    Ok(Done::Good)
}
