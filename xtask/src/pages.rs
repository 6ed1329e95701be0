//! The pages of the live server: checks, builds, and drives them in a browser against the program.

use std::path::PathBuf;
use std::process::Command;

use crate::built;
use crate::command::{cargo, run, run_quietly};
use crate::step::{Done, Step};
use crate::tools;

const FOLDER: &str = "web";

/// Checks the pages: format, types, lints, unit tests, and the size of the pages in the program.
pub(crate) const CHECKED: Step = Step { name: "the pages", run: check };
/// The tests of `web/e2e`.
pub(crate) const DRIVEN: Step = Step { name: "the pages in a browser", run: in_a_browser };
/// The tests of `web/e2e/speed.e2e.ts`.
pub(crate) const FAST: Step = Step { name: "the speed of the pages", run: speed };
/// All of them.
pub(crate) const STEPS: [Step; 3] = [CHECKED, DRIVEN, FAST];

fn check() -> Result<Done, String> {
    if let Err(missing) = tools::node() {
        return Ok(Done::NotRun(missing));
    }
    // The build of the program has installed what the pages need and built them, where they were older than their sources.
    built::program("release")?;
    run(&mut npm(&["run", "check"]))?;
    run(&mut npm(&["run", "size"]))?;
    Ok(Done::Good)
}

/// Runs all tests of `web/e2e` but those of speed against the program; in one of them, a pilot and a tug master bring a
/// ship alongside on two pages.
fn in_a_browser() -> Result<Done, String> {
    for missing in [tools::node(), tools::chromium()] {
        if let Err(missing) = missing {
            return Ok(Done::NotRun(missing));
        }
    }
    let program = built::program("release")?;
    run(npm(&["run", "e2e"]).env("FENDERLINE_BIN", program))?;
    // The report, which the same browser prints.
    run(&mut built::tests(&["--ignored", "chromium"]))?;
    Ok(Done::Good)
}

/// Runs the tests of the pages' speed and memory, which need a processor that is otherwise free.
fn speed() -> Result<Done, String> {
    for missing in [tools::node(), tools::chromium()] {
        if let Err(missing) = missing {
            return Ok(Done::NotRun(missing));
        }
    }
    run(npm(&["run", "e2e:speed"]).env("FENDERLINE_BIN", built::program("release")?))?;
    Ok(Done::Good)
}

fn npm(arguments: &[&str]) -> Command {
    npm_in(FOLDER, arguments)
}

/// npm in a folder.
pub(crate) fn npm_in(folder: &str, arguments: &[&str]) -> Command {
    let mut command = Command::new("npm");
    command.args(arguments).current_dir(folder);
    command
}

/// The target folder that cargo reports.
pub(crate) fn target_folder() -> Result<PathBuf, String> {
    const KEY: &str = "\"target_directory\":\"";
    let metadata = run_quietly(&mut cargo(["metadata", "--format-version", "1", "--no-deps"]))?;
    metadata
        .split_once(KEY)
        .and_then(|(_, rest)| rest.split_once('"'))
        .map(|(folder, _)| PathBuf::from(folder))
        .ok_or_else(|| "cargo metadata names no target directory".into())
}
