//! `cargo xtask fuzz`: runs every fuzz target for a given time, with the stable toolchain.

use std::path::Path;
use std::process::{Command, ExitCode};

use crate::command::{cargo, run};
use crate::step::Done;
use crate::tools;

/// The manifest of the fuzz targets, which are a workspace of their own.
pub(crate) const MANIFEST: &str = "fuzz/Cargo.toml";
/// Default time for each fuzz target (s).
pub(crate) const SECONDS: u64 = 20;

/// A fuzz target, and folders that have inputs to start from besides the target's seeds.
pub(crate) const TARGETS: [(&str, &[&str]); 5] = [
    ("advance", &[]),
    ("clip", &[]),
    ("dump", &[]),
    ("scenario", &["scenarios"]),
    ("snapshot", &[]),
];

/// `cargo xtask fuzz`.
pub(crate) fn fuzz_command(seconds: u64) -> ExitCode {
    match fuzz(seconds) {
        Ok(Done::Good) => ExitCode::SUCCESS,
        Ok(Done::NotRun(missing)) => {
            eprintln!("{} is missing; install: {}", missing.tool, missing.install);
            ExitCode::FAILURE
        }
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Runs each fuzz target for `seconds` seconds.
pub(crate) fn fuzz(seconds: u64) -> Result<Done, String> {
    if let Err(missing) = tools::cargo_fuzz() {
        return Ok(Done::NotRun(missing));
    }
    for (target, more) in TARGETS {
        let corpus = Path::new("fuzz/corpus").join(target);
        std::fs::create_dir_all(&corpus).map_err(|e| format!("{}: {e}", corpus.display()))?;
        println!("-- {target}, {seconds} s");
        run(&mut fuzz_one(target, &corpus, more, seconds))?;
    }
    Ok(Done::Good)
}

/// The command that runs one fuzz target. Fuzzing uses no sanitizer: sanitizers need a nightly toolchain and find
/// faults of unsafe code, which the targets do not have. Debug assertions and overflow checks are on in the fuzz
/// targets.
fn fuzz_one(target: &str, corpus: &Path, more: &[&str], seconds: u64) -> Command {
    let mut command = cargo(["fuzz", "run", "--fuzz-dir", "fuzz", "--sanitizer", "none", target]);
    command.arg(corpus).arg(Path::new("fuzz/seeds").join(target)).args(more);
    command.arg("--").arg(format!("-max_total_time={seconds}"));
    // A fixed seed: a fresh clone tries the same inputs in the same order.
    command.args(["-seed=1", "-timeout=20", "-rss_limit_mb=2048", "-max_len=8192"]);
    if Path::new("fuzz").join(target).with_extension("dict").is_file() {
        command.arg(format!("-dict=fuzz/{target}.dict"));
    }
    command
}
