//! `fenderline validate`: every published case that the project reproduces, ours beside theirs.
//!
//! `published` reads what others published (`validation/*.toml`), `play` runs the scenarios,
//! `quantity` takes values from a run, `computed` has all others, `row` holds one against
//! the other; `estimate_errors` tells how far off ships from main particulars are; `printed`, `files`, `page`
//! and `figures` show it. Everything is inside the program, so that an installed one validates
//! anywhere.

mod computed;
mod estimate_errors;
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

use computed::Values;
pub(crate) use estimate_errors::errors_of;
use play::play_all;
use published::Source;
use row::{Row, evaluate};

/// A file under `validation/`: name and text.
macro_rules! published {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!("../../../../validation/", $name)))),*]
    };
}

/// What there is to compare with, in the order of the table.
const PUBLISHED: [(&str, &str); 17] = published![
    "moreno2023.toml",
    "closed_form.toml",
    "coupled_independent.toml",
    "kvlcc2.toml",
    "kcs.toml",
    "estimated_ships.toml",
    "low_speed.toml",
    "esso_osaka.toml",
    "added_mass.toml",
    "shallow_water.toml",
    "propeller.toml",
    "wind.toml",
    "current_and_waves.toml",
    "wave_drift.toml",
    "lines_and_tugs.toml",
    "heave_and_roll.toml",
    "finite_elements.toml",
];

fn sources() -> Vec<Source> {
    let of_file = |(file, text): &(&str, &str)| {
        Source::parse(text).unwrap_or_else(|e| panic!("the built-in validation/{file}: {e}"))
    };
    PUBLISHED.iter().flat_map(of_file).collect()
}

/// Runs all cases, prints the table and writes the report where `args` asks for one.
///
/// # Errors
/// A row that is out of tolerance, a statement that unexpectedly does not hold, a run that failed,
/// or a file that cannot be written. The table is printed and written all the same.
pub(crate) fn validate(args: &ValidateArgs) -> Result<(), Failure> {
    let sources = sources();
    let (runs, values) = (play_all()?, Values::all());
    let rows: Vec<Row> =
        sources.iter().flat_map(|source| evaluate(source, &runs, &values)).collect();
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
    use crate::validate::published::Origin;

    const MORENO_2023: &str = PUBLISHED[0].1;

    fn rows(moreno_2023: &str) -> Vec<Row> {
        let sources = Source::parse(moreno_2023).expect("the published numbers parse");
        let runs = play_all().expect("the cases run");
        sources.iter().flat_map(|source| evaluate(source, &runs, &Values::default())).collect()
    }

    /// A run of which nobody compares anything is dead code (one run gives several measures, of which not all are
    /// published); a case that stands twice is a slip of the pen.
    #[test]
    fn every_computed_run_is_held_against_something_and_no_case_stands_twice() {
        let (sources, values) = (sources(), Values::all());
        let numbers = || sources.iter().flat_map(|source| &source.numbers);
        let run = |name: &str| name.rsplit_once('/').map_or(name, |(run, _)| run).to_owned();
        for name in values.names() {
            let is_used = numbers().any(
                |number| matches!(&number.origin, Origin::Computed(used) if run(used) == run(name)),
            );
            assert!(is_used, "{name} is compared with nothing");
        }
        for source in &sources {
            let mut cases: Vec<&str> = source.numbers.iter().map(|n| n.case.as_str()).collect();
            cases.sort_unstable();
            assert!(cases.windows(2).all(|two| two[0] != two[1]), "{}: {cases:?}", source.short);
        }
    }

    #[test]
    fn a_number_that_is_known_not_to_match_must_not_match() {
        let tampered =
            MORENO_2023.replacen("published = 0.96", "published = 0.96\nknown_mismatch = true", 1);
        let failure = verdict(&rows(&tampered)).expect_err("it does match");
        assert!(failure.message().is_some_and(|m| m.contains("known mismatch")));

        let tampered = tampered.replacen("published = 0.96", "published = 1.50", 1);
        assert_eq!(verdict(&rows(&tampered)), Ok(()), "as it is written down");
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
            let values = Values::all();
            let rows: Vec<Row> = sources.iter().flat_map(|s| evaluate(s, &runs, &values)).collect();
            page::render(&sources, &rows, &runs)
        };
        assert_eq!(page(), page());
    }
}
