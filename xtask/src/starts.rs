//! `cargo xtask starts` tries the README's three ways to start, with each command as the README has it, in a place
//! without this checkout's builds: a new clone of the last commit, an empty home folder, a new Python environment, few
//! variables.
//!
//! Packages come from crates.io, PyPI and npm; cargo takes packages that it has downloaded before. This task builds
//! everything from nothing, which would take too long in `cargo xtask test all`, and is therefore no part of it.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;

use crate::command::{run, run_quietly};
use crate::step::{Done, Step, run_all};
use crate::tools;

/// `cargo xtask starts`.
pub(crate) fn starts_command() -> ExitCode {
    run_all(&[Step { name: "the README's three ways to start, in a clean place", run: starts }])
}

/// Beginnings of the names of environment variables that the commands keep: variables that say where programs, packages
/// and certificates are found.
const KEPT: [&str; 14] = [
    "PATH",
    "LANG",
    "CI",
    "CHROMIUM",
    "CARGO_HTTP",
    "CARGO_NET",
    "CARGO_REGISTR",
    "RUSTUP_TOOLCHAIN",
    "PIP_",
    "NPM_CONFIG_",
    "npm_config_",
    "SSL_CERT",
    "NODE_EXTRA_CA",
    "REQUESTS_CA",
];

fn starts() -> Result<Done, String> {
    for missing in [
        tools::python_environments().map(|_| ()),
        tools::node(),
        tools::chromium(),
        tools::wasm_target(),
    ] {
        if let Err(missing) = missing {
            return Ok(Done::NotRun(missing));
        }
    }
    let place = std::env::temp_dir().join(format!("fenderline-starts-{}", std::process::id()));
    std::fs::create_dir(&place).map_err(|e| format!("{}: {e}", place.display()))?;
    let started = starts_in(&place);
    let removed = std::fs::remove_dir_all(&place);
    started?;
    removed.map_err(|e| format!("{}: {e}", place.display()))?;
    Ok(Done::Good)
}

fn starts_in(place: &Path) -> Result<(), String> {
    let (clone, home, python) = (place.join("clone"), place.join("home"), place.join("python"));
    run_quietly(Command::new("git").args(["clone", "--quiet", "--no-hardlinks", "."]).arg(&clone))?;
    std::fs::create_dir(&home).map_err(|e| format!("{}: {e}", home.display()))?;
    run_quietly(Command::new("python3").args(["-m", "venv"]).arg(&python))?;
    let readme = clone.join("README.md");
    let readme =
        std::fs::read_to_string(&readme).map_err(|e| format!("{}: {e}", readme.display()))?;
    let clean = |line: &str| clean(line, &clone, &home, &python);
    let [program, package, page] = commands(&readme)?;

    timed(&program, |line| run(&mut clean(line)))?;
    is_there(&clone.join("out/eight_cones_at_5_deg/report.html"))?;
    let mut printed = String::new();
    timed(&package, |line| {
        printed = run_quietly(&mut clean(line))?;
        Ok(())
    })?;
    let force_n = printed.trim().parse::<f64>();
    if !force_n.is_ok_and(|force_n| force_n.is_finite() && force_n > 1e5) {
        return Err(format!("the run has printed no force of a tug at 4 knots: {printed}"));
    }
    println!("the largest force: {} N", printed.trim());
    timed(&page, |line| run(&mut clean(line)))?;
    is_there(&clone.join("target/page/index.html"))
}

/// The commands of each of the three ways to start: the indented lines below the name of the way in the section *Start*
/// of the README.
fn commands(readme: &str) -> Result<[Vec<&str>; 3], String> {
    let section = readme.split("\n## Start\n").nth(1).and_then(|rest| rest.split("\n## ").next());
    let section = section.ok_or("the README has no section \"Start\"")?;
    let of = |name: &str| {
        let rest = section
            .split(name)
            .nth(1)
            .ok_or(format!("the README's section \"Start\" has no {name}"))?;
        let rest = rest.split("\n**").next().unwrap_or(rest);
        let lines: Vec<&str> = rest.lines().filter_map(|line| line.strip_prefix("    ")).collect();
        if lines.is_empty() {
            Err(format!("the README has no command for {name}"))
        } else {
            Ok(lines)
        }
    };
    Ok([of("**The program**")?, of("**Python**")?, of("**A page in the browser**")?])
}

/// Runs the lines of a way to start, and prints how long each line took.
fn timed(
    lines: &[&str],
    mut run_line: impl FnMut(&str) -> Result<(), String>,
) -> Result<(), String> {
    for line in lines {
        println!("$ {line}");
        let began = Instant::now();
        run_line(line)?;
        println!("{:.0} s", began.elapsed().as_secs_f64());
    }
    Ok(())
}

/// The command that runs a line of the README in the clone. The command keeps the settings of registries in the real
/// home, and the downloads of cargo.
fn clean(line: &str, clone: &Path, home: &Path, python: &Path) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", line]).current_dir(clone).env_clear();
    let is_kept = |name: &str| {
        KEPT.iter().any(|kept| name.starts_with(kept)) || name.to_lowercase().ends_with("_proxy")
    };
    command.envs(std::env::vars().filter(|(name, _)| is_kept(name)));
    command.env("HOME", home);
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::iter::once(python.join("bin")).chain(std::env::split_paths(&path));
    command.env("PATH", std::env::join_paths(path).unwrap_or_default());
    let own_home = std::env::var_os("HOME").map(PathBuf::from).unwrap_or_default();
    for (variable, within) in [
        ("CARGO_HOME", ".cargo"),
        ("RUSTUP_HOME", ".rustup"),
        ("NPM_CONFIG_USERCONFIG", ".npmrc"),
        ("PIP_CONFIG_FILE", ".config/pip/pip.conf"),
    ] {
        let default = Some(own_home.join(within)).filter(|path| path.exists());
        if let Some(path) = std::env::var_os(variable).map(PathBuf::from).or(default) {
            command.env(variable, path);
        }
    }
    command
}

fn is_there(file: &Path) -> Result<(), String> {
    if file.is_file() { Ok(()) } else { Err(format!("{} is missing", file.display())) }
}

#[cfg(test)]
mod tests {
    use super::commands;

    #[test]
    fn the_readme_has_commands_for_each_way() {
        let readme = include_str!("../../README.md");
        let [program, python, page] = commands(readme).expect("three ways");
        assert!(program.len() == 1 && program[0].starts_with("cargo run --release -- run "));
        assert_eq!(python.first(), Some(&"pip install ."));
        assert_eq!(page, ["cargo xtask page"]);
    }
}
