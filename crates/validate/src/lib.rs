//! Validation of the simulator: every published case that the project reproduces, our numbers beside the published
//! ones.
//!
//! The module `published` reads the published numbers (`validation/*.toml`), `play` runs the scenarios, `quantity`
//! takes values from a run, `computed` has all other values, and `row` compares them. The module `estimate_errors` has
//! the errors of ships that are estimated from main particulars. The module `sweeps` has every force over its whole
//! domain. The modules `printed`, `files`, `page` and `figures` write the results of the validation. All cases of the
//! validation are compiled in, so that an installed program validates anywhere; no file is read or written.
#![forbid(unsafe_code)]

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
mod sweeps;
mod table;

use computed::{SUBJECTS, Values};
pub use estimate_errors::errors_of;
use play::play_all;
use published::Source;
use row::{Row, Runs, evaluate};
pub use sweeps::{Resolution, Sweeps};

/// Name and text of a file under `validation/`.
macro_rules! published {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!(env!("FENDERLINE_DATA"), "/validation/", $name)))),*]
    };
}

/// The files of published numbers, in the order of the table.
const PUBLISHED: [(&str, &str); 22] = published![
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
    "current.toml",
    "current_and_waves.toml",
    "wave_drift.toml",
    "lines_and_tugs.toml",
    "heave_and_roll.toml",
    "finite_elements.toml",
    "worked_examples.toml",
    "passing_ships.toml",
    "banks.toml",
    "seakeeping.toml",
];

fn sources() -> Vec<Source> {
    let of_file = |(file, text): &(&str, &str)| {
        Source::parse(text).unwrap_or_else(|e| panic!("the built-in validation/{file}: {e}"))
    };
    PUBLISHED.iter().flat_map(of_file).collect()
}

/// All published cases, recomputed.
#[derive(Debug)]
pub struct Validation {
    sources: Vec<Source>,
    runs: Runs,
    rows: Vec<Row>,
}

impl Validation {
    /// The number of parts that [`Validation::run`] counts: the runs, the subjects of computed values, and the ships
    /// that are estimated.
    pub const PARTS: usize = play::SCENARIOS.len() + SUBJECTS.len() + 1;

    /// Runs all cases. `progress` gets the number of parts that are done, after each of the [`Validation::PARTS`].
    ///
    /// # Errors
    /// A run that failed.
    pub fn run(mut progress: impl FnMut(usize)) -> Result<Validation, String> {
        let mut done = 0;
        let mut part_done = || {
            done += 1;
            progress(done);
        };
        let sources = sources();
        let (runs, values) = (play_all(&mut part_done)?, values(&mut part_done));
        let rows = sources.iter().flat_map(|source| evaluate(source, &runs, &values)).collect();
        Ok(Validation { sources, runs, rows })
    }

    /// The table of all rows, for the terminal.
    pub fn table(&self) -> String {
        printed::tables(&self.rows)
    }

    /// Names and contents of `validation.csv`, `validation.json` and `validation.html`.
    pub fn files(&self) -> [(&'static str, String); 3] {
        files::files(page::render(&self.sources, &self.rows, &self.runs), &self.rows)
    }

    /// A complaint for each row that is out of tolerance, or that is within tolerance although it is listed as a known
    /// mismatch.
    pub fn complaints(&self) -> Vec<String> {
        complaints(&self.rows)
    }
}

fn complaints(rows: &[Row]) -> Vec<String> {
    rows.iter().filter_map(Row::complaint).collect()
}

/// All computed values that rows name by `computed`.
fn values(mut part_done: impl FnMut()) -> Values {
    let mut values = Values::default();
    for subject in SUBJECTS.into_iter().chain([estimate_errors::put as fn(&mut Values)]) {
        subject(&mut values);
        part_done();
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::published::Origin;

    const MORENO_2023: &str = PUBLISHED[0].1;

    fn rows(moreno_2023: &str) -> Vec<Row> {
        let sources = Source::parse(moreno_2023).expect("the published numbers parse");
        let runs = play_all(|| ()).expect("the cases run");
        sources.iter().flat_map(|source| evaluate(source, &runs, &Values::default())).collect()
    }

    /// A computed run without a comparison is dead code. (A run gives several measures, not all of which are published.)
    #[test]
    fn every_computed_run_is_compared_and_no_case_occurs_twice() {
        let (sources, values) = (sources(), values(|| ()));
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

    /// The rows of these files need no run: each matches, or is a mismatch that is known.
    #[test]
    fn rows_on_banks_and_shallow_water_match_or_are_known_mismatches() {
        let (runs, values) = (Runs::new(), values(|| ()));
        for file in ["banks.toml", "shallow_water.toml"] {
            let (_, text) = PUBLISHED.iter().find(|(name, _)| *name == file).expect("the file");
            let sources = Source::parse(text).expect("the published numbers parse");
            let of_source = |source: &Source| evaluate(source, &runs, &values);
            let rows: Vec<Row> = sources.iter().flat_map(of_source).collect();
            assert!(complaints(&rows).is_empty(), "{file}: {:#?}", complaints(&rows));
        }
    }

    #[test]
    fn a_known_mismatch_that_matches_is_a_complaint() {
        let tampered =
            MORENO_2023.replacen("published = 0.96", "published = 0.96\nknown_mismatch = true", 1);
        let complaints = complaints(&rows(&tampered));
        assert!(complaints[0].contains("known mismatch"), "it matches");

        let tampered = tampered.replacen("published = 0.96", "published = 1.50", 1);
        assert!(super::complaints(&rows(&tampered)).is_empty(), "a mismatch that is listed");
    }

    #[test]
    fn published_numbers_match_and_tampered_ones_do_not() {
        assert!(complaints(&rows(MORENO_2023)).is_empty());

        let tampered = MORENO_2023.replacen("published = 0.96", "published = 1.50", 1);
        assert_ne!(tampered, MORENO_2023);
        let complaints = complaints(&rows(&tampered));
        assert_eq!(complaints.len(), 1, "only that row: {complaints:?}");
        assert!(complaints[0].contains("Greatest depth at 4 kn"), "{complaints:?}");
    }

    #[test]
    fn a_statement_that_changes_its_truth_is_a_complaint() {
        let tampered = MORENO_2023.replacen("holds = \"rises\"", "holds = \"falls\"", 1);
        assert!(complaints(&rows(&tampered))[0].contains("does not hold"));

        // A statement that is listed as a mismatch, and holds.
        let tampered = MORENO_2023.replacen("low = 1\n", "low = 0.5\n", 1);
        assert_ne!(tampered, MORENO_2023);
        assert!(complaints(&rows(&tampered))[0].contains("known mismatch"));
    }

    #[test]
    fn the_same_runs_give_the_same_bytes() {
        let page = || {
            let (sources, runs) = (sources(), play_all(|| ()).expect("the cases run"));
            let values = values(|| ());
            let rows: Vec<Row> = sources.iter().flat_map(|s| evaluate(s, &runs, &values)).collect();
            page::render(&sources, &rows, &runs)
        };
        assert_eq!(page(), page());
    }
}
