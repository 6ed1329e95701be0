//! `cargo xtask book` builds the book of `docs/` into `target/book`. The build of the book fails for a warning, for a
//! dead link, and for a text that names a file or a function that does not exist.
//!
//! Sphinx and its theme come from PyPI, in the versions of `docs/requirements.txt`. `docs/generate` makes reference
//! pages and figures from the program's output. Nothing generated is committed.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::built;
use crate::citations;
use crate::command::{run, run_quietly};
use crate::step::{Done, Step};
use crate::tools;
use crate::virtual_environment::{environment, target_folder};

/// The step that builds the book, as a part of `cargo xtask test all` or alone.
pub(crate) const STEP: Step = Step { name: "the book", run: book };

/// Folder for the data from which the book is made.
const DATA: &str = "book-data";

fn book() -> Result<Done, String> {
    citations::check()?;
    let python = match tools::python_environments() {
        Ok(python) => python,
        Err(missing) => return Ok(Done::NotRun(missing)),
    };
    let target = target_folder();
    let requirements = Path::new("docs/requirements.txt");
    let python = environment(python, &target.join("book-python"), requirements)?;
    let program = program()?;
    let data = target.join(DATA);
    run_quietly(Command::new(&program).args(["validate", "--out"]).arg(&data))?;
    run_quietly(Command::new(&program).args(["validate", "--sweeps", "--out"]).arg(&data))?;
    let columns = data.join("columns.json");
    std::fs::write(&columns, run_quietly(Command::new(&program).args(["columns", "--json"]))?)
        .map_err(|e| format!("{}: {e}", columns.display()))?;

    let mut generate = Command::new(&python);
    generate.args(["-B", "docs/generate"]).arg(&program);
    generate.args([data.join("validation.json"), data.join("sweeps.json")]);
    run(generate.arg(&columns))?;
    let book = target.join("book");
    let mut sphinx = Command::new(&python);
    sphinx.args(["-B", "-m", "sphinx", "--builder", "html", "--fail-on-warning", "--quiet"]);
    // Read all pages, so that the check of links does not depend on an earlier build.
    sphinx
        .args(["--fresh-env", "--jobs", "auto", "--doctree-dir"])
        .arg(target.join("book-doctrees"));
    run(sphinx.arg("docs").arg(&book))?;
    println!("{}", book.join("index.html").display());
    Ok(Done::Good)
}

/// Path of the program whose tables and runs the book shows: the one in `FENDERLINE_BIN`, or the release build.
fn program() -> Result<PathBuf, String> {
    if let Some(program) = std::env::var_os("FENDERLINE_BIN") {
        return std::path::absolute(&program).map_err(|e| format!("FENDERLINE_BIN: {e}"));
    }
    built::program("release")
}
