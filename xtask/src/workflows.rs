//! `cargo xtask workflows` lets actionlint check the workflows of `.github` (forms, expressions, names of machines),
//! and zizmor (pinned actions, permissions, injections). Both checkers come from PyPI, in the versions of
//! `xtask/workflow-requirements.txt`.
//!
//! Whatever a workflow runs must be a command of the repository: each `cargo xtask NAME` must be a task that
//! `cargo xtask` lists.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use crate::command::run;
use crate::step::{Done, Step, run_all};
use crate::tools;
use crate::virtual_environment::{environment, target_folder};

/// The step that checks the workflows, as a part of `cargo xtask test all` or alone.
pub(crate) const STEP: Step = Step { name: "workflows", run: workflows };

const FOLDER: &str = ".github/workflows";

/// `cargo xtask workflows`.
pub(crate) fn workflows_command() -> ExitCode {
    run_all(&[STEP])
}

fn workflows() -> Result<Done, String> {
    let files = files()?;
    for file in &files {
        let text = std::fs::read_to_string(file).map_err(|e| format!("{}: {e}", file.display()))?;
        let unknown = unknown_tasks(&text, crate::USAGE);
        if !unknown.is_empty() {
            return Err(format!("{}: `cargo xtask` has no {}", file.display(), unknown.join(", ")));
        }
    }
    let python = match tools::python_environments() {
        Ok(python) => python,
        Err(missing) => return Ok(Done::NotRun(missing)),
    };
    let requirements = Path::new("xtask/workflow-requirements.txt");
    let python = environment(python, &target_folder().join("workflow-python"), requirements)?;
    let bin = python.parent().map(PathBuf::from).unwrap_or_default();
    // `ACTIONLINT` names another build of it.
    let actionlint = std::env::var_os("ACTIONLINT").map_or(bin.join("actionlint"), PathBuf::from);
    run(Command::new(actionlint).args(&files))?;
    let mut zizmor = Command::new(bin.join("zizmor"));
    run(zizmor.args(["--offline", "--no-progress", "--quiet", ".github"]))?;
    println!("{} workflows", files.len());
    Ok(Done::Good)
}

/// All workflow files, in the order of their names.
fn files() -> Result<Vec<PathBuf>, String> {
    let entries = std::fs::read_dir(FOLDER).map_err(|e| format!("{FOLDER}: {e}"))?;
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    files.sort();
    Ok(files)
}

/// Tasks that a workflow calls and that `usage` does not list.
fn unknown_tasks(workflow: &str, usage: &str) -> Vec<String> {
    let called = workflow.split("cargo xtask ").skip(1);
    let names = called.map(|after| after.split(|c: char| !(c.is_alphanumeric() || c == '-')));
    let names = names.filter_map(|mut words| words.next()).filter(|name| {
        !usage
            .split("cargo xtask ")
            .skip(1)
            .any(|line| line.split_whitespace().next() == Some(name))
    });
    names.map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::unknown_tasks;

    #[test]
    fn a_workflow_that_calls_a_task_that_is_gone_is_found() {
        let usage = "usage: cargo xtask test [FIRST]\n       cargo xtask dist [cheap]\n";
        let workflow =
            "run: cargo xtask test\nrun: cargo xtask dist tag \"$TAG\"\nrun: cargo xtask tests";
        assert_eq!(unknown_tasks(workflow, usage), ["tests"]);
    }
}
