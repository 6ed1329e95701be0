//! Ours beside theirs: the rows of the table.

use std::collections::BTreeMap;

use super::play::Played;
use super::published::{Number, Rule, Source, Statement, Tolerance};

/// What the scenarios gave, by name.
pub(super) type Runs = BTreeMap<&'static str, Played>;

/// One row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    pub(super) case: String,
    /// Short name of the source.
    pub(super) source: String,
    /// Where in the source.
    pub(super) place: String,
    pub(super) unit: &'static str,
    pub(super) compared: Compared,
    /// Within tolerance, or the statement holds.
    pub(super) is_ok: bool,
    pub(super) note: String,
}

/// What a row compares.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Compared {
    /// A published value.
    Number {
        published: f64,
        ours: f64,
        /// Ours less theirs, in the terms of the tolerance.
        error: f64,
        tolerance: Tolerance,
        reason: String,
    },
    /// Something said in words.
    Statement { says: String, rule: Rule, ours: Vec<f64>, known_mismatch: bool },
}

impl Row {
    /// `source, place`.
    pub(super) fn cited(&self) -> String {
        format!("{}, {}", self.source, self.place)
    }

    /// What is wrong with the row, unless it is as it should be.
    pub(super) fn complaint(&self) -> Option<String> {
        let what = match (&self.compared, self.is_ok) {
            (Compared::Number { .. }, false) => "out of tolerance",
            (Compared::Statement { known_mismatch: false, .. }, false) => "does not hold",
            (Compared::Statement { known_mismatch: true, .. }, true) => {
                "holds, but is written down as a known mismatch"
            }
            _ => return None,
        };
        Some(format!("{} ({}): {what}", self.case, self.cited()))
    }
}

/// The rows of one source, numbers first. A run that a file names and that there is not is our own
/// mistake, and panics.
pub(super) fn evaluate(source: &Source, runs: &Runs) -> Vec<Row> {
    let numbers = source.numbers.iter().map(|number| number_row(source, number, runs));
    let statements =
        source.statements.iter().map(|statement| statement_row(source, statement, runs));
    numbers.chain(statements).collect()
}

fn run<'r>(runs: &'r Runs, name: &str, case: &str) -> &'r Played {
    runs.get(name).unwrap_or_else(|| panic!("{case}: no scenario {name} is built in"))
}

fn number_row(source: &Source, number: &Number, runs: &Runs) -> Row {
    let value = |name: &str| number.quantity.of(run(runs, name, &number.case));
    let (ours, unit) = match &number.relative_to {
        Some(reference) => (value(&number.run) / value(reference), ""),
        None => (value(&number.run), number.quantity.unit()),
    };
    let difference = ours - number.published;
    let (error, bound) = match number.tolerance {
        Tolerance::Relative(share) => (difference / number.published, share),
        Tolerance::Absolute(bound) => (difference, bound),
    };
    Row {
        case: number.case.clone(),
        source: source.short.clone(),
        place: number.place.clone(),
        unit,
        compared: Compared::Number {
            published: number.published,
            ours,
            error,
            tolerance: number.tolerance,
            reason: number.reason.clone(),
        },
        // NaN is out of every tolerance.
        is_ok: error.abs() <= bound,
        note: number.note.clone(),
    }
}

fn statement_row(source: &Source, statement: &Statement, runs: &Runs) -> Row {
    let ours: Vec<f64> = statement
        .runs
        .iter()
        .map(|name| statement.quantity.of(run(runs, name, &statement.case)))
        .collect();
    Row {
        case: statement.case.clone(),
        source: source.short.clone(),
        place: statement.place.clone(),
        unit: statement.quantity.unit(),
        is_ok: statement.rule.holds(&ours),
        compared: Compared::Statement {
            says: statement.says.clone(),
            rule: statement.rule,
            ours,
            known_mismatch: statement.known_mismatch,
        },
        note: statement.note.clone(),
    }
}

/// How many rows of `rows` compare a number or, where not `of_numbers`, a statement; and how many of
/// them are well.
pub(super) fn count(rows: &[Row], of_numbers: bool) -> (usize, usize) {
    let chosen =
        rows.iter().filter(|row| matches!(row.compared, Compared::Number { .. }) == of_numbers);
    chosen.fold((0, 0), |(ok, all), row| (ok + usize::from(row.is_ok), all + 1))
}
