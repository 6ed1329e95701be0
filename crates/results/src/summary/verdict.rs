//! The verdict on the run in `summary.json`.

use fenderline_sim::Verdict;

use crate::json::{Json, object};
use crate::outcome::Outcome;

/// The verdict, and its findings from the worst on.
pub(super) fn verdict_json(outcome: &Outcome<'_>) -> Json {
    let verdict = Verdict::of(outcome.findings);
    let findings = outcome.findings.iter().map(|finding| {
        object!({
            "key": finding.verdict().key(),
            "gravity": finding.verdict().gravity().key(),
            "names": finding.names(outcome.setup),
            "text": finding.sentence(outcome.setup),
        })
    });
    object!({
        "key": verdict.key(),
        "gravity": verdict.gravity().key(),
        "text": verdict.text(),
        "findings": findings.collect::<Json>(),
    })
}
