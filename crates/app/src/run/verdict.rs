//! The verdict in the summary that `run` prints, and in its exit code.

use core::fmt::Write as _;

use super::cells::one_line;
use crate::failure::Failure;
use fenderline_results::Outcome;
use fenderline_sim::{Finding, Gravity, Verdict};

/// Findings printed at most.
const FINDINGS: usize = 12;

/// The verdict in one line (in capitals if a limit was exceeded or worse), and one line for each finding, the worst
/// first.
pub(super) fn lines(outcome: &Outcome<'_>) -> String {
    let verdict = Verdict::of(outcome.findings);
    let is_grave = verdict.gravity() >= Gravity::Attention;
    let words = if is_grave { verdict.text().to_uppercase() } else { verdict.text().to_owned() };
    let mut text = format!("verdict: {words}\n");
    for finding in outcome.findings.iter().take(FINDINGS) {
        let _ = writeln!(text, "  {}", one_line(&finding.sentence(outcome.setup)));
    }
    if outcome.findings.len() > FINDINGS {
        let more = outcome.findings.len() - FINDINGS;
        let _ = writeln!(text, "  and {more} more findings, in summary.json");
    }
    text
}

/// The outcome of the command, by the verdict of the run.
///
/// # Errors
/// Unless failures are allowed, fails if something broke or was struck or if the results are not valid. With
/// `is_strict` the command also fails if the run left the range of its data.
pub(super) fn exit(
    findings: &[Finding],
    allow_failures: bool,
    is_strict: bool,
) -> Result<(), Failure> {
    let in_doubt = |verdict: &Verdict| {
        is_strict && verdict.is_of_law() && verdict.gravity() >= Gravity::Attention
    };
    let is_failure = |verdict: &Verdict| verdict.gravity() == Gravity::Failed || in_doubt(verdict);
    let failures = findings.iter().map(Finding::verdict).filter(is_failure);
    let Some(verdict) = failures.max().filter(|_| !allow_failures) else { return Ok(()) };
    Err(Failure::case(format_args!(
        "error: {}; the results are complete (--allow-failures: exit code 0)",
        verdict.text().to_lowercase()
    )))
}
