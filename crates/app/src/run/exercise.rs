//! Lines about the exercise, for the summary that `run` prints.

use core::fmt::Write as _;

use super::cells::one_line;
use fenderline_report::plot::fixed;
use fenderline_results::Outcome;

/// A line with the result of the exercise, and a line for each deduction; empty if there is no exercise.
pub(super) fn lines(outcome: &Outcome<'_>) -> String {
    let Some(exercise) = outcome.exercise else { return String::new() };
    let mut text = format!("exercise: {}\n", exercise.sentence());
    for deduction in exercise.deductions() {
        let sentence = deduction.sentence(outcome.setup);
        let _ = writeln!(text, "  -{}  {}", fixed(deduction.points, 1), one_line(&sentence));
    }
    text
}
