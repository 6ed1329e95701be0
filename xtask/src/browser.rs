//! Builds and tests the npm package, and the page that runs scenarios in a browser without a server.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use crate::built;
use crate::command::{cargo, run};
use crate::pages::{npm_in, target_folder};
use crate::step::{Done, Step, run_all};
use crate::tools;

const TARGET: &str = "wasm32-unknown-unknown";
/// The settings of the module's build. They change the release profile, so that macros are built once for the program
/// and the module.
const PROFILE: &str = "crates/wasm/profile.toml";
/// The npm package's folder.
pub(crate) const PACKAGE: &str = "crates/wasm/npm";
const WEB: &str = "web";
/// The folder with the page that runs scenarios; any web server can serve this folder.
const PAGE: &str = "target/page";

/// Builds the npm package as it is published, made small by `wasm-opt`; tests it under Node and times its steps.
const PACKAGE_WHOLE: Step = Step { name: "the npm package", run: package_whole };
/// Builds the page without a server as it is published, and tests it in a browser.
const PAGE_WHOLE: Step = Step { name: "the page without a server", run: page_whole };
/// Builds the npm package without `wasm-opt`, because that program takes a minute, and tests it under Node.
pub(crate) const PACKAGE_TESTED: Step =
    Step { name: "the npm package, not made small", run: package_tested };
/// Builds the page from the package without `wasm-opt`, and tests it in a browser.
pub(crate) const PAGE_DRIVEN: Step =
    Step { name: "the page without a server, in a browser", run: page_driven };

/// `cargo xtask npm`.
pub(crate) fn npm_command() -> ExitCode {
    run_all(&[PACKAGE_WHOLE])
}

/// `cargo xtask page`.
pub(crate) fn page_command() -> ExitCode {
    run_all(&[PACKAGE_WHOLE, PAGE_WHOLE])
}

/// Builds the npm package as it is published, and tests it.
///
/// # Errors
/// Fails if a build or a test fails.
pub(crate) fn package_whole() -> Result<Done, String> {
    let done = package(&["optimize", "test", "ratio"])?;
    println!("{PACKAGE} is ready: `npm pack` in this folder makes the file to publish");
    Ok(done)
}

fn package_tested() -> Result<Done, String> {
    package(&["test"])
}

/// Builds the npm package and runs the given `scripts` of it.
fn package(scripts: &[&str]) -> Result<Done, String> {
    for missing in [tools::node(), tools::wasm_target()] {
        if let Err(missing) = missing {
            return Ok(Done::NotRun(missing));
        }
    }
    let mut module = cargo(["build", "--release", "--config", PROFILE, "--target", TARGET]);
    run(module.args(["--package", "fenderline-wasm"]))?;
    run(&mut built::build("release", &["--package", "xtask-bindgen", "--bin", "xtask-bindgen"]))?;
    let target = target_folder()?;
    let raw = Path::new(PACKAGE).join("dist").join("raw");
    if raw.exists() {
        std::fs::remove_dir_all(&raw).map_err(|e| format!("{}: {e}", raw.display()))?;
    }
    let bindgen = built::folder("release").join("xtask-bindgen");
    let module = target.join(TARGET).join("release").join("fenderline_wasm.wasm");
    run(Command::new(bindgen).arg(module).arg(&raw))?;
    for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
        let copy = Path::new(PACKAGE).join(licence);
        std::fs::copy(licence, &copy).map_err(|e| format!("{}: {e}", copy.display()))?;
    }
    run(&mut npm_in(PACKAGE, &["ci", "--no-audit", "--no-fund"]))?;
    run(&mut npm_in(PACKAGE, &["run", "types"]))?;
    let [program, native] = native_programs()?;
    for script in scripts {
        let mut script = npm_in(PACKAGE, &["run", script]);
        run(script.env("FENDERLINE_BIN", &program).env("FENDERLINE_NATIVE", &native))?;
    }
    Ok(Done::Good)
}

/// Paths of the program, and of the example `native`, which makes the same runs as the package.
fn native_programs() -> Result<[PathBuf; 2], String> {
    Ok([built::program("release")?, built::example("release", "native")?])
}

fn page_whole() -> Result<Done, String> {
    let done = page_driven()?;
    println!("{PAGE} is ready: any web server can serve this folder");
    Ok(done)
}

/// Builds the page from the npm package that was built before, measures its size, and runs all tests of `web/e2e-page`.
fn page_driven() -> Result<Done, String> {
    for missing in [tools::node(), tools::chromium(), tools::wasm_target()] {
        if let Err(missing) = missing {
            return Ok(Done::NotRun(missing));
        }
    }
    // The build of the program has installed what the pages need.
    let program = built::program("release")?;
    run(&mut npm_in(WEB, &["run", "build:page"]))?;
    run(npm_in(WEB, &["run", "e2e:page"]).env("FENDERLINE_BIN", program))?;
    Ok(Done::Good)
}
