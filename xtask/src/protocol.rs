//! `cargo xtask protocol`: writes the pages' types of the messages, `web/src/protocol.ts`, from the messages in Rust.

use std::process::ExitCode;

use crate::command::{cargo, run};
use crate::pages::npm_in;
use crate::step::{Done, Step, run_all};
use crate::tools;

const STEP: Step = Step { name: "the pages' types of the messages", run: write };

/// `cargo xtask protocol`.
pub(crate) fn protocol_command() -> ExitCode {
    run_all(&[STEP])
}

/// A test of `crates/live` writes the file; the formatter of the pages breaks its lines.
fn write() -> Result<Done, String> {
    if let Err(missing) = tools::node() {
        return Ok(Done::NotRun(missing));
    }
    let mut test = cargo(["test", "--package", "fenderline-live", "--lib", "typescript"]);
    run(test.env("FENDERLINE_WRITE", "1"))?;
    let format = ["exec", "--", "prettier", "--write", "src/protocol.ts"];
    run(&mut npm_in("web", &format))?;
    Ok(Done::Good)
}
