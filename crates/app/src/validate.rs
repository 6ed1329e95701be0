//! `fenderline validate`: published cases, recomputed and compared.

use fenderline_validate::Validation;

use crate::cli::ValidateArgs;
use crate::failure::Failure;
use crate::output::{make_folder, write_whole};
use crate::progress::Progress;
use crate::terminal::{say, say_json};

/// Runs all cases, prints the table and writes the report if `args` asks for one.
///
/// # Errors
/// A row that is out of tolerance, a statement that unexpectedly does not hold, a run that failed,
/// or a file that cannot be written. The table is printed and written all the same.
pub(crate) fn validate(args: &ValidateArgs) -> Result<(), Failure> {
    let mut progress = Progress::of(Validation::PARTS as u64, "parts");
    let validation =
        Validation::run(|done| progress.advance(done as u64)).map_err(Failure::Case)?;
    drop(progress);
    let files = validation.files();
    if args.json {
        let json = files.iter().find(|(name, _)| *name == "validation.json");
        say_json(json.map_or("", |(_, text)| text))?;
    } else {
        say(&validation.table())?;
    }
    if let Some(folder) = &args.out {
        make_folder(folder)?;
        for (name, content) in &files {
            write_whole(&folder.join(name), content.as_bytes())?;
        }
        let names = files.map(|(name, _)| name);
        say(&format!("in {}: {}\n", folder.display(), names.join(", ")))?;
    }
    let complaints = validation.complaints();
    if complaints.is_empty() {
        return Ok(());
    }
    Err(Failure::case(format_args!("error: validation failed:\n  {}", complaints.join("\n  "))))
}
