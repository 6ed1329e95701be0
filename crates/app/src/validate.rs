//! `fenderline validate` recomputes published cases and compares them with the published numbers; or it sweeps every
//! force over its whole domain.

use std::path::Path;

use fenderline_validate::{Resolution, Sweeps, Validation};

use crate::cli::ValidateArgs;
use crate::failure::Failure;
use crate::output::{make_folder, write_whole};
use crate::progress::Progress;
use crate::terminal::{say, say_json};

/// Runs all cases or all sweeps, prints the table and writes the report if `args` asks for one.
///
/// # Errors
/// Fails if a row is out of tolerance, if a statement unexpectedly does not hold, if a check of a sweep fails, if a run
/// failed, or if a file cannot be written. The table is printed and written even then.
pub(crate) fn validate(args: &ValidateArgs) -> Result<(), Failure> {
    if args.sweeps {
        return sweep(args);
    }
    let mut progress = Progress::of(Validation::PARTS as u64, "parts");
    let validation =
        Validation::run(|done| progress.advance(done as u64)).map_err(Failure::Case)?;
    drop(progress);
    let files = validation.files().map(|(name, text)| (name.to_owned(), text));
    print_table(args, &files, "validation.json", &validation.table())?;
    if let Some(folder) = &args.out {
        write_files(folder, &files)?;
        let names = files.map(|(name, _)| name);
        say(&format!("in {}: {}\n", folder.display(), names.join(", ")))?;
    }
    failed("validation", &validation.complaints())
}

/// `validate --sweeps`.
fn sweep(args: &ValidateArgs) -> Result<(), Failure> {
    let mut progress = Progress::of(Sweeps::count() as u64, "sweeps");
    let sweeps = Sweeps::run(Resolution::Full, |done| progress.advance(done as u64));
    drop(progress);
    let files = sweeps.files();
    print_table(args, &files, "sweeps.json", &sweeps.table())?;
    if let Some(folder) = &args.out {
        write_files(folder, &files)?;
        let pictures = files.iter().filter(|(name, _)| name.ends_with(".svg")).count();
        let tables = "sweeps.html, sweeps.csv, sweeps.json";
        say(&format!("in {}: {tables}, {pictures} pictures\n", folder.display()))?;
    }
    failed("sweeps", &sweeps.complaints())
}

/// The printed text: the table, or with `--json` the content of `validation.json` or `sweeps.json`.
fn print_table(
    args: &ValidateArgs,
    files: &[(String, String)],
    json_name: &str,
    table: &str,
) -> Result<(), Failure> {
    if !args.json {
        return say(table);
    }
    let json = files.iter().find(|(name, _)| name == json_name);
    say_json(json.map_or("", |(_, text)| text))
}

fn write_files(folder: &Path, files: &[(String, String)]) -> Result<(), Failure> {
    make_folder(folder)?;
    for (name, text) in files {
        write_whole(&folder.join(name), text.as_bytes())?;
    }
    Ok(())
}

fn failed(what: &str, complaints: &[String]) -> Result<(), Failure> {
    if complaints.is_empty() {
        return Ok(());
    }
    Err(Failure::case(format_args!("error: {what} failed:\n  {}", complaints.join("\n  "))))
}
