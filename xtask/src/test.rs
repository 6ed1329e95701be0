//! `cargo xtask test` runs everything that a change must pass.

use std::path::Path;
use std::process::{Command, ExitCode};

use crate::alone;
use crate::attack;
use crate::bench;
use crate::book;
use crate::browser;
use crate::built;
use crate::c_interface;
use crate::circles;
use crate::command::{cargo, run, run_quietly};
use crate::compare::{same_bytes, same_numbers};
use crate::dist;
use crate::finite_elements;
use crate::fuzz;
use crate::gate::{Gated, Pace, Uses, run_gated, run_one};
use crate::hosts;
use crate::nautical;
use crate::pages;
use crate::passivity;
use crate::scenarios;
use crate::slurm;
use crate::step::{Done, Step};
use crate::tools;
use crate::workflows;
use crate::wrappers;

/// Folders below `target` into which only one cargo at a time writes.
const DEBUG: Uses = Uses::Builds("debug");
const RELEASE: Uses = Uses::Builds("release");

/// The steps that begin first, because the tests in a browser take longest.
const FIRST: [Gated; 3] = [
    gated("release", "the program as users build it", release_built, &[], RELEASE),
    computing("pages", pages::CHECKED, &["release"], Uses::Processor),
    in_browser("browser", pages::DRIVEN, &["release", "pages"]),
];

/// The steps that need only Rust, which a contributor runs.
const OWN: [Gated; 7] = [
    gated("format", "format", format, &[], Uses::Processor),
    gated("no-std", "the contact engine is no_std with one dependency", no_std, &[], DEBUG),
    computing("circles", circles::STEP, &[], Uses::Processor),
    gated("build", "all tests are built", tests_built, &[], DEBUG),
    gated("tests", "tests", tests, &["build"], Uses::Processor),
    gated("doc-tests", "examples in the documentation", doc_tests, &["build"], DEBUG),
    gated("cases", "published cases", validate, &["build"], Uses::Processor),
];

/// The steps that also need other tools, or that compile everything once more.
const MORE: [Gated; 25] = [
    gated("lints", "lints", lints, &["build"], DEBUG),
    in_browser("speed", pages::FAST, &["browser"]),
    gated("python", "the Python package", python_package, &["release"], RELEASE),
    computing("npm", browser::PACKAGE_TESTED, &["release"], RELEASE),
    in_browser("page", browser::PAGE_DRIVEN, &["npm", "browser"]),
    gated("documentation", "documentation", documentation, &["lints"], DEBUG),
    computing("book", book::STEP, &["release"], Uses::Processor),
    gated("hosts", "FMI: FMPy, libcosim, ecos and the guide", hosts::hosts, &["release"], RELEASE),
    gated(
        "scenarios",
        "every scenario is accepted",
        scenarios_accepted,
        &["release"],
        Uses::Processor,
    ),
    gated(
        "same-bits",
        "the same bits from debug, release and a second run",
        same_bits,
        &["build", "release"],
        Uses::Processor,
    ),
    gated("independent", "independent implementation", independent, &[], Uses::Processor),
    gated(
        "finite-elements",
        "fenders by finite elements, coarse",
        finite_elements::small,
        &[],
        Uses::Processor,
    ),
    computing("nautical", nautical::STEP, &["build"], Uses::Processor),
    computing("workflows", workflows::STEP, &[], Uses::Processor),
    gated("licences", "licences and sources of dependencies", licences, &[], Uses::Processor),
    gated("passivity", "contacts make no energy", passive, &["release"], RELEASE),
    computing("dist", dist::CHEAP, &["release"], RELEASE),
    gated("c", "C: examples and guide", c_interface::examples, &["dist"], RELEASE),
    gated("cpp", "C++: example, guide of game loops", wrappers::cpp, &["dist"], RELEASE),
    gated("csharp", "C#: example", wrappers::csharp, &["dist"], RELEASE),
    gated("c-calls", "C: random calls", random_calls, &["dist"], RELEASE),
    computing("attacks", attack::STEP, &["tests", "python"], DEBUG),
    gated(
        "instructions",
        "instruction counts, which decide nothing",
        bench::reported,
        &["release", "tests"],
        RELEASE,
    ),
    // They build the program anew, with the libraries of FMUs in it, and so come last in their folder.
    computing(
        "alone",
        alone::STEP,
        &["attacks", "instructions", "page", "speed", "c-calls", "hosts", "passivity", "python"],
        RELEASE,
    ),
    computing("slurm", slurm::STEP, &["alone"], RELEASE),
];

const fn gated(
    key: &'static str,
    name: &'static str,
    run: fn() -> Result<Done, String>,
    after: &'static [&'static str],
    uses: Uses,
) -> Gated {
    computing(key, Step { name, run }, after, uses)
}

const fn computing(
    key: &'static str,
    step: Step,
    after: &'static [&'static str],
    uses: Uses,
) -> Gated {
    Gated { key, step, after, uses, pace: Pace::Any }
}

/// Tests in a browser.
const fn in_browser(key: &'static str, step: Step, after: &'static [&'static str]) -> Gated {
    Gated { key, step, after, uses: Uses::Processor, pace: Pace::RealTime }
}

/// `cargo xtask test [all | STEP...]`: without names it runs the steps that need only Rust.
pub(crate) fn test_command(names: &[&str]) -> ExitCode {
    let all = || FIRST.into_iter().chain(OWN).chain(MORE);
    if let Some(unknown) =
        names.iter().find(|name| **name != "all" && all().all(|s| s.key != **name))
    {
        let keys: Vec<&str> = all().map(|step| step.key).collect();
        eprintln!("there is no step `{unknown}`; there are all, {}", keys.join(", "));
        return ExitCode::from(2);
    }
    let steps: Vec<Gated> = if names.is_empty() {
        OWN.into_iter().collect()
    } else {
        all().filter(|step| names.contains(&"all") || names.contains(&step.key)).collect()
    };
    run_gated(&steps)
}

/// `cargo xtask step NAME` runs one step in this process, as `test` starts a step.
pub(crate) fn step_command(name: &str) -> ExitCode {
    match FIRST.into_iter().chain(OWN).chain(MORE).find(|step| step.key == name) {
        Some(step) => run_one(&step),
        None => {
            eprintln!("there is no step `{name}`");
            ExitCode::from(2)
        }
    }
}

fn format() -> Result<Done, String> {
    run(&mut cargo(["fmt", "--all", "--check"]))?;
    run(&mut cargo(["fmt", "--manifest-path", fuzz::MANIFEST, "--check"]))?;
    Ok(Done::Good)
}

/// `cargo xtask once-more` reads the benches too, which stand on large peers.
fn lints() -> Result<Done, String> {
    let mut clippy = cargo(["clippy", "--all-targets"]);
    run(clippy.args(built::TESTED).args(["--", "-D", "warnings"]))?;
    Ok(Done::Good)
}

/// Compiles the contact engine for a target without `std` if the toolchain has one. Otherwise checks the engine's
/// source: in a crate that declares `no_std` and does not name `std` outside tests, no path to `std` resolves.
fn no_std() -> Result<Done, String> {
    const ENGINE: &str = "fenderline-contact";
    const ROOT: &str = "crates/contact/src/lib.rs";
    let source = std::fs::read_to_string(ROOT).map_err(|e| format!("{ROOT}: {e}"))?;
    let lines: Vec<&str> = source.lines().map(str::trim).collect();
    if !lines.contains(&"#![no_std]") {
        return Err(format!("{ROOT} does not declare `#![no_std]`"));
    }
    for (index, _) in lines.iter().enumerate().filter(|(_, l)| **l == "extern crate std;") {
        if index == 0 || lines[index - 1] != "#[cfg(test)]" {
            return Err(format!("{ROOT}:{}: `std` outside tests", index + 1));
        }
    }
    let tree = ["tree", "--package", ENGINE, "--edges", "normal,build", "--prefix", "none"];
    let tree = run_quietly(&mut cargo(tree))?;
    let names: Vec<&str> = tree.lines().filter_map(|line| line.split(' ').next()).collect();
    if names != [ENGINE, "libm"] {
        return Err(format!("{ENGINE} must depend on libm alone, but depends on:\n{tree}"));
    }
    if let Some(target) = tools::bare_target() {
        run(&mut cargo(["check", "--package", ENGINE, "--target", target]))?;
        println!("compiled for {target}");
    } else {
        println!(
            "the engine was checked by its declaration and dependencies, because no target without std is \
                  installed"
        );
    }
    Ok(Done::Good)
}

fn tests_built() -> Result<Done, String> {
    built::program("dev").map(|_| Done::Good)
}

/// Runs all tests. With the seed the property tests draw the same cases every time, so that the outcome depends only on
/// the change under test; without the seed, `cargo test` draws new cases, as the fuzz targets do. Many tests of the
/// program wait for a clock, so two tests for each processor run at once.
fn tests() -> Result<Done, String> {
    const SEED: &str = "PROPTEST_RNG_SEED";
    const AT_ONCE: &str = "RUST_TEST_THREADS";
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let mut tests = cargo(["test"]);
    tests.args(built::TARGETS).args(built::TESTED);
    for (name, value) in [(SEED, "20261121".to_owned()), (AT_ONCE, (2 * processors).to_string())] {
        if std::env::var_os(name).is_none() {
            tests.env(name, value);
        }
    }
    run(&mut tests)?;
    Ok(Done::Good)
}

fn doc_tests() -> Result<Done, String> {
    run(cargo(["test", "--doc"]).args(built::TESTED))?;
    Ok(Done::Good)
}

/// Size limit of the program as `cargo build --release` makes it (bytes).
const PROGRAM_BYTES: u64 = 35_000_000;

fn release_built() -> Result<Done, String> {
    let program = built::program("release")?;
    let size = std::fs::metadata(&program).map_err(|e| format!("{}: {e}", program.display()))?;
    println!("the program has {:.1} MB", size.len() as f64 / 1e6);
    // Programs for other systems have another size.
    if cfg!(target_os = "linux") && size.len() > PROGRAM_BYTES {
        return Err(format!("the program is larger than {} MB", PROGRAM_BYTES / 1_000_000));
    }
    Ok(Done::Good)
}

/// `cargo xtask once-more` reads the documentation of private items too. With examples cargo asks the features of tests
/// of all libraries, which the lints have compiled.
fn documentation() -> Result<Done, String> {
    let mut doc = cargo(["doc", "--no-deps", "--lib", "--bins", "--examples"]);
    run(doc.args(built::TESTED).env("RUSTDOCFLAGS", "-D warnings"))?;
    Ok(Done::Good)
}

fn scenarios_accepted() -> Result<Done, String> {
    let all = scenarios::all()?;
    let program = built::program("release")?;
    for scenario in &all {
        run_quietly(Command::new(&program).arg("check").arg(scenario))?;
    }
    println!("{} scenarios", all.len());
    Ok(Done::Good)
}

/// Checks that all result files of some runs are the same, byte for byte.
fn same_bits() -> Result<Done, String> {
    let folder = std::env::temp_dir().join(format!("fenderline-xtask-{}", std::process::id()));
    let compared = same_bits_in(&folder);
    let removed =
        std::fs::remove_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()));
    compared.and(removed).map(|()| Done::Good)
}

fn same_bits_in(folder: &Path) -> Result<(), String> {
    for (scenario, options) in [
        ("scenarios/oblique_hit.toml", vec![]),
        ("scenarios/paper/experiment_2_4kn.toml", vec!["--format", "parquet"]),
        ("scenarios/paper/experiment_1_step_0.1s.toml", vec!["--set", "time.integrator=rk4"]),
        ("scenarios/berth/leaning_on_eight_fenders.toml", vec![]),
        ("scenarios/berth/eight_cones_at_5_deg.toml", vec![]),
    ] {
        let results = |name: &str, profile: &str| {
            let out = folder.join(name);
            // Remove the results of the last scenario.
            if out.exists() {
                std::fs::remove_dir_all(&out).map_err(|e| format!("{}: {e}", out.display()))?;
            }
            let mut command = Command::new(built::program(profile)?);
            command.args(["run", scenario]).args(&options).arg("--out").arg(&out);
            run_quietly(&mut command).map(|_| out)
        };
        let first = results("release", "release")?;
        for other in [results("again", "release")?, results("debug", "dev")?] {
            same_bytes(&first, &other).map_err(|e| format!("{scenario}: {e}"))?;
        }
        println!("{scenario} {}", options.join(" "));
    }
    Ok(())
}

fn validate() -> Result<Done, String> {
    let program = built::program("dev")?;
    run(Command::new(&program).arg("validate"))?;
    run(Command::new(&program).args(["validate", "--sweeps"]))?;
    Ok(Done::Good)
}

/// Checks the identities of the independent implementations, and that they still compute the committed results, with
/// which the engine's tests compare.
fn independent() -> Result<Done, String> {
    const FOLDER: &str = "validation/independent";
    const RESULTS: &str = "validation/independent/oblique_hit";
    let python = match tools::python() {
        Ok(python) => python,
        Err(missing) => return Ok(Done::NotRun(missing)),
    };
    let python = |script: &str| {
        let mut command = Command::new(python);
        // No __pycache__ in the source tree.
        command.arg("-B").arg(Path::new(FOLDER).join(script));
        command
    };
    run(&mut python("check_paper_method.py"))?;
    run(&mut python("check_coupled_method.py"))?;
    // The coarse runs of all scenarios; the fine ones are `coupled_berth.py make`.
    run(&mut python("coupled_berth.py"))?;
    for script in ["ship_formulas.py", "mmg_standard.py", "reference_ships.py"] {
        run(python(script).arg("--check"))?;
    }
    let out = std::env::temp_dir().join(format!("fenderline-oracle-{}", std::process::id()));
    let mut method = python("paper_method.py");
    run(method.arg("scenarios/oblique_hit.toml").arg("--out").arg(&out))?;
    let compared = ["contacts.csv", "bodies.csv"]
        .iter()
        .try_for_each(|name| same_numbers(&Path::new(RESULTS).join(name), &out.join(name)));
    std::fs::remove_dir_all(&out).map_err(|e| format!("{}: {e}", out.display()))?;
    compared.map(|()| Done::Good)
}

/// Tests the Python package in a clean virtual environment, with test tools from PyPI.
fn python_package() -> Result<Done, String> {
    match tools::python_environments() {
        Ok(python) => {
            let mut test = Command::new(python);
            test.args(["-B", "crates/python/test.py"]);
            run(test.env("FENDERLINE_PROGRAM", built::program("release")?))
        }
        Err(missing) => return Ok(Done::NotRun(missing)),
    }
    .map(|()| Done::Good)
}

/// Runs few random impacts on fenders; `cargo xtask passivity` has fifty times as many.
fn passive() -> Result<Done, String> {
    passivity::passivity(passivity::EPISODES / 50).map(|()| Done::Good)
}

/// Runs few random sequences of calls; `cargo xtask c` has five times as many.
fn random_calls() -> Result<Done, String> {
    c_interface::random_calls(c_interface::SEQUENCES / 5)
}

fn licences() -> Result<Done, String> {
    if let Err(missing) = tools::cargo_deny() {
        return Ok(Done::NotRun(missing));
    }
    for manifest in ["Cargo.toml", fuzz::MANIFEST] {
        let mut deny = cargo(["deny", "--log-level", "error", "--config", "deny.toml"]);
        deny.args(["--manifest-path", manifest]);
        run(deny.args(["check", "--hide-inclusion-graph", "licenses", "bans", "sources"]))?;
    }
    Ok(Done::Good)
}
