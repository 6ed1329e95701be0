//! The verdict on the run in `summary.json`.

use fenderline_sim::Verdict;
use serde_json::{Value, json};

use crate::outcome::Outcome;

/// The verdict, and its findings from the worst on.
pub(super) fn verdict_json(outcome: &Outcome<'_>) -> Value {
    let verdict = Verdict::of(outcome.findings);
    let findings = outcome.findings.iter().map(|finding| {
        json!({
            "key": finding.verdict().key(),
            "gravity": finding.verdict().gravity().key(),
            "names": finding.names(outcome.setup),
            "text": finding.sentence(outcome.setup),
        })
    });
    json!({
        "key": verdict.key(),
        "gravity": verdict.gravity().key(),
        "text": verdict.text(),
        "findings": findings.collect::<Vec<Value>>(),
    })
}
