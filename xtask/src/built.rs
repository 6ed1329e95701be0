//! All builds by cargo that the tasks need are made in this module. All builds of a profile select the same packages:
//! cargo gives a dependency the features that all selected packages ask of it, so that a build with another selection
//! would compile most crates once more.

use std::path::PathBuf;
use std::process::Command;

use crate::command::{cargo, run};
use crate::virtual_environment::target_folder;

/// The packages with tests: all but the benches and `xtask-bindgen`, whose libraries take long to build.
pub(crate) const TESTED: [&str; 7] = [
    "--workspace",
    "--exclude",
    "fenderline-bench",
    "--exclude",
    "fenderline-bench-scenes",
    "--exclude",
    "xtask-bindgen",
];
/// The kinds of targets that have tests in these packages. Examples are left out: with `--examples` cargo would build
/// each example as a test, under another name.
pub(crate) const TARGETS: [&str; 3] = ["--lib", "--bins", "--tests"];
/// The packages that users build, the package of an example that steps a scenario, and the features that the program
/// shares with the wheel.
const USED: [&str; 12] = [
    "--package",
    "fenderline",
    "--package",
    "fenderline-capi",
    "--package",
    "fenderline-fmu",
    "--package",
    "fenderline-features",
    "--package",
    "fenderline-wasm",
    "--package",
    "fenderline-sim",
];

/// The command that builds `target` (`--lib`, or `--bin` or `--example` with a name) by the profile `profile`, which is
/// `dev` or `release`. With `dev` this is the build of all tests, which contains libraries and programs: a build of the
/// target alone would leave out the features that tests ask of dependencies.
pub(crate) fn build(profile: &str, target: &[&str]) -> Command {
    if profile == "dev" {
        let mut build = cargo(["test", "--quiet", "--no-run"]);
        build.args(TARGETS).args(TESTED);
        build
    } else {
        let mut build = cargo(["build", "--quiet", "--profile", profile]);
        build.args(USED).args(target);
        build
    }
}

/// The environment variable that tells a step of `cargo xtask test` the names of the steps that are done.
pub(crate) const DONE: &str = "FENDERLINE_STEPS_DONE";

/// Whether an earlier step of the same run has built the program. Cargo itself would find the program built too, but
/// only after waiting for every other build in its folder.
fn is_built(profile: &str) -> bool {
    let step = if profile == "dev" { "build" } else { profile };
    std::env::var(DONE).is_ok_and(|done| done.split(',').any(|name| name == step))
}

/// Builds the program unless an earlier step has built it, and returns the path of the program.
///
/// # Errors
/// A build that fails.
pub(crate) fn program(profile: &str) -> Result<PathBuf, String> {
    let program = folder(profile).join(format!("fenderline{}", std::env::consts::EXE_SUFFIX));
    if is_built(profile) && program.is_file() {
        return Ok(program);
    }
    run(&mut build(profile, &["--bin", "fenderline"]))?;
    Ok(program)
}

/// Builds an example and returns the path of the example's program.
///
/// # Errors
/// A build that fails.
pub(crate) fn example(profile: &str, name: &str) -> Result<PathBuf, String> {
    if profile == "dev" {
        // An example may use what tests alone depend on, so that cargo asks the features of tests of all dependencies.
        let mut build = cargo(["build", "--quiet", "--example", name]);
        run(build.args(TESTED))?;
    } else {
        run(&mut build(profile, &["--example", name]))?;
    }
    let program = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    Ok(folder(profile).join("examples").join(program))
}

/// The folder into which cargo puts the builds of a profile.
pub(crate) fn folder(profile: &str) -> PathBuf {
    target_folder().join(if profile == "dev" { "debug" } else { profile })
}

/// The command that runs the programs `tests/all.rs`; the arguments go to the tests.
pub(crate) fn tests(arguments: &[&str]) -> Command {
    let mut tests = cargo(["test", "--quiet", "--test", "all"]);
    tests.args(TESTED).arg("--").args(arguments);
    tests
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};

    use super::USED;
    use crate::command::{cargo, run_quietly};

    /// The features of each library that the given packages stand on, by name and version. A library that is built with
    /// several sets of features has each of them.
    fn features(selected: &[&str]) -> BTreeMap<String, BTreeSet<String>> {
        let mut tree = cargo(["tree", "--edges", "normal,build", "--prefix", "none"]);
        tree.args(["--format", "{p}\t{f}"]).args(selected);
        let mut features: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for line in run_quietly(&mut tree).unwrap().lines() {
            let Some((library, asked)) = line.split_once('\t') else { continue };
            let library = library.trim_end_matches(" (proc-macro)").to_owned();
            let asked = asked.trim_end_matches(" (*)").trim().to_owned();
            features.entry(library).or_default().insert(asked);
        }
        features
    }

    /// Checks that the packages `other`, which `name` names in the message, ask the features of the program.
    fn ask_the_same_as_the_program(name: &str, other: &[&str]) {
        let (program, other) = (features(&USED), features(other));
        assert!(other.len() > 50, "{} libraries", other.len());
        let shared = other.iter().filter_map(|(library, asked)| {
            program.get(library).map(|of_program| (library, of_program, asked))
        });
        for (library, of_program, asked) in shared {
            assert_eq!(
                of_program, asked,
                "the program (left) and {name} (right) ask different features of {library}, so that {library} is \
                 compiled once more: state the features in crates/features/Cargo.toml"
            );
        }
    }

    #[test]
    fn the_wheel_asks_the_same_features_of_libraries_as_the_program() {
        ask_the_same_as_the_program("the wheel", &["--package", "fenderline-python"]);
    }

    #[test]
    fn the_program_that_makes_javascript_asks_no_other_features_than_the_program() {
        let together = [&USED[..], &["--package", "xtask-bindgen"]].concat();
        ask_the_same_as_the_program("the program that makes JavaScript", &together);
    }
}
