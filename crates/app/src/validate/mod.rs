//! `fenderline validate`: every published case that the project reproduces, ours beside theirs.
//!
//! `published` reads what others published (`validation/*.toml`), `play` runs the scenarios,
//! `quantity` takes values from a run, `row` holds one against the other; `printed`, `files`, `page`
//! and `figures` show it. Everything is inside the program, so that an installed one validates
//! anywhere.

mod figures;
mod files;
mod page;
mod play;
mod printed;
mod published;
mod quantity;
mod row;

use crate::cli::ValidateArgs;
use crate::failure::Failure;
use crate::terminal::say;

use play::play_all;
use published::Source;
use row::{Row, evaluate};

const MORENO_2023: &str = include_str!("../../../../validation/moreno2023.toml");
const CLOSED_FORM: &str = include_str!("../../../../validation/closed_form.toml");

/// What there is to compare with, in the order of the table.
fn sources() -> [Source; 2] {
    [("moreno2023.toml", MORENO_2023), ("closed_form.toml", CLOSED_FORM)].map(|(file, text)| {
        Source::parse(text).unwrap_or_else(|e| panic!("the built-in validation/{file}: {e}"))
    })
}

/// Runs all cases, prints the table and writes the report where `args` asks for one.
///
/// # Errors
/// A row that is out of tolerance, a statement that unexpectedly does not hold, a run that failed,
/// or a file that cannot be written. The table is printed and written all the same.
pub(crate) fn validate(args: &ValidateArgs) -> Result<(), Failure> {
    let sources = sources();
    let runs = play_all()?;
    let rows: Vec<Row> = sources.iter().flat_map(|source| evaluate(source, &runs)).collect();
    say(&printed::tables(&rows))?;
    if let Some(folder) = &args.out {
        let written = files::write(folder, &page::render(&sources, &rows, &runs), &rows)?;
        say(&format!("in {}: {}\n", folder.display(), written.join(", ")))?;
    }
    verdict(&rows)
}

/// Success, or a failed case that names the rows that are not as they should be.
fn verdict(rows: &[Row]) -> Result<(), Failure> {
    let wrong: Vec<String> = rows.iter().filter_map(Row::complaint).collect();
    if wrong.is_empty() {
        return Ok(());
    }
    Err(Failure::case(format_args!("error: validation failed:\n  {}", wrong.join("\n  "))))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(moreno_2023: &str) -> Vec<Row> {
        let source = Source::parse(moreno_2023).expect("the published numbers parse");
        evaluate(&source, &play_all().expect("the cases run"))
    }

    #[test]
    fn published_numbers_are_met_and_tampered_ones_are_not() {
        assert_eq!(verdict(&rows(MORENO_2023)), Ok(()));

        let tampered = MORENO_2023.replacen("published = 0.96", "published = 1.50", 1);
        assert_ne!(tampered, MORENO_2023);
        let failure = verdict(&rows(&tampered)).expect_err("1.50 m is not what comes out");
        assert_eq!(failure.exit_code(), 1);
        let message = failure.message().unwrap_or_default();
        assert!(message.contains("Greatest depth at 4 kn"), "{message}");
        assert_eq!(message.lines().count(), 2, "only that row: {message}");
    }

    #[test]
    fn a_statement_that_ceases_or_comes_to_hold_is_a_failure() {
        let tampered = MORENO_2023.replacen("holds = \"rises\"", "holds = \"falls\"", 1);
        let failure = verdict(&rows(&tampered)).expect_err("the peak force does not fall");
        assert!(failure.message().is_some_and(|m| m.contains("does not hold")));

        // A mismatch that is written down and is none any more would be a false confession.
        let tampered = MORENO_2023.replacen("low = 1\n", "low = 0.5\n", 1);
        assert_ne!(tampered, MORENO_2023);
        let failure = verdict(&rows(&tampered)).expect_err("the known mismatch is gone");
        assert!(failure.message().is_some_and(|m| m.contains("known mismatch")));
    }

    #[test]
    fn the_same_runs_give_the_same_bytes() {
        let page = || {
            let (sources, runs) = (sources(), play_all().expect("the cases run"));
            let rows: Vec<Row> = sources.iter().flat_map(|s| evaluate(s, &runs)).collect();
            page::render(&sources, &rows, &runs)
        };
        assert_eq!(page(), page());
    }
}
