//! `cargo xtask once-more` has the checks that compile everything once more, for another compiler or in another way. They
//! are a job of their own on the public host, so that `cargo xtask test all` stays short.

use crate::command::{cargo, run};
use crate::fuzz;
use crate::oldest_rust;
use crate::step::{Done, Step};

/// Time for each fuzz target (s).
const FUZZ_S: u64 = 12;

pub(crate) const STEPS: [Step; 4] = [
    oldest_rust::STEP,
    Step { name: "fuzz targets", run: || fuzz::fuzz(FUZZ_S) },
    Step { name: "documentation of private items", run: private_documentation },
    Step { name: "lints of the benches", run: lints_of_benches },
];

/// The step `documentation` of `cargo xtask test all` reads the documentation of public items: with private items
/// documented too, a public link to a private item would pass.
fn private_documentation() -> Result<Done, String> {
    let mut doc = cargo(["doc", "--workspace", "--no-deps", "--document-private-items"]);
    run(doc.env("RUSTDOCFLAGS", "-D warnings"))?;
    Ok(Done::Good)
}

/// The step `lints` of `cargo xtask test all` reads the packages with tests.
fn lints_of_benches() -> Result<Done, String> {
    run(&mut cargo(["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"]))?;
    Ok(Done::Good)
}
