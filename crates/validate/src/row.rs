//! The rows of the validation table: our values beside the published ones.

use std::collections::BTreeMap;

use super::computed::Values;
use super::play::Played;
use super::published::{Number, Origin, Rule, Source, Standing, Statement, Tolerance, Uncertainty};

/// The runs of the scenarios, by name.
pub(super) type Runs = BTreeMap<&'static str, Played>;

/// One row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    pub(super) case: String,
    /// The heading of the table's section in which the row stands.
    pub(super) subject: String,
    /// Short name of the source.
    pub(super) source: String,
    /// Standing of the source.
    pub(super) standing: Standing,
    /// Place in the source.
    pub(super) place: String,
    pub(super) unit: String,
    pub(super) compared: Compared,
    /// True if our value is within tolerance, or if the statement holds.
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
        /// Difference of our value from the published one, in the terms of the tolerance.
        error: f64,
        tolerance: Tolerance,
        reason: String,
        /// Uncertainty of the reference number, in the terms of the tolerance.
        uncertainty: Uncertainty,
        known_mismatch: bool,
    },
    /// A statement in words.
    Statement { says: String, rule: Rule, ours: Vec<f64>, known_mismatch: bool },
}

impl Row {
    /// `source, place`.
    pub(super) fn cited(&self) -> String {
        format!("{}, {}", self.source, self.place)
    }

    /// Whether the row is listed as a known mismatch.
    pub(super) fn is_known_mismatch(&self) -> bool {
        match self.compared {
            Compared::Number { known_mismatch, .. }
            | Compared::Statement { known_mismatch, .. } => known_mismatch,
        }
    }

    /// What is wrong with the row, in words; `None` if nothing is wrong.
    pub(super) fn complaint(&self) -> Option<String> {
        let what = match (&self.compared, self.is_ok, self.is_known_mismatch()) {
            (Compared::Number { .. }, false, false) => "out of tolerance",
            (Compared::Number { .. }, true, true) => {
                "is within tolerance, but is listed as a known mismatch"
            }
            (Compared::Statement { .. }, false, false) => "does not hold",
            (Compared::Statement { .. }, true, true) => "holds, but is listed as a known mismatch",
            _ => return None,
        };
        Some(format!("{} ({}): {what}", self.case, self.cited()))
    }
}

/// Makes the rows of one source, numbers first.
///
/// # Panics
/// Panics if a file names a run or a value that does not exist, which would be a bug.
pub(super) fn evaluate(source: &Source, runs: &Runs, values: &Values) -> Vec<Row> {
    let numbers = source.numbers.iter().map(|number| number_row(source, number, runs, values));
    let statements =
        source.statements.iter().map(|statement| statement_row(source, statement, runs));
    numbers.chain(statements).collect()
}

fn run<'r>(runs: &'r Runs, name: &str, case: &str) -> &'r Played {
    runs.get(name).unwrap_or_else(|| {
        panic!("{case}: the program has no built-in scenario with the name {name}")
    })
}

/// Our value for a row, in the unit that the row states.
fn ours(number: &Number, runs: &Runs, values: &Values) -> f64 {
    match &number.origin {
        Origin::Run { run: name, quantity, relative_to } => {
            let value = |name: &str| quantity.of(run(runs, name, &number.case));
            match relative_to {
                Some(reference) => value(name) / value(reference),
                None => value(name),
            }
        }
        Origin::Computed(name) => {
            let computed = values.get(name);
            assert_eq!(computed.unit, number.unit, "{}: the unit of {name}", number.case);
            computed.value
        }
    }
}

fn number_row(source: &Source, number: &Number, runs: &Runs, values: &Values) -> Row {
    let ours = ours(number, runs, values);
    let difference = ours - number.published;
    let (error, bound) = match number.tolerance {
        Tolerance::Relative(share) => (difference / number.published, share),
        Tolerance::Absolute(bound) => (difference, bound),
    };
    Row {
        case: number.case.clone(),
        subject: source.subject.clone(),
        source: source.short.clone(),
        standing: source.standing,
        place: number.place.clone(),
        unit: number.unit.clone(),
        compared: Compared::Number {
            published: number.published,
            ours,
            error,
            tolerance: number.tolerance,
            reason: number.reason.clone(),
            uncertainty: number.uncertainty.clone(),
            known_mismatch: number.known_mismatch,
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
        subject: source.subject.clone(),
        source: source.short.clone(),
        standing: source.standing,
        place: statement.place.clone(),
        unit: statement.quantity.unit().to_owned(),
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

/// Counts, among the rows that compare numbers or those that compare statements, how many are correct and how many
/// there are.
pub(super) fn count(rows: &[Row], of_numbers: bool) -> (usize, usize) {
    let chosen =
        rows.iter().filter(|row| matches!(row.compared, Compared::Number { .. }) == of_numbers);
    chosen.fold((0, 0), |(ok, all), row| (ok + usize::from(row.is_ok), all + 1))
}
