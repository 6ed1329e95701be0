//! The verdict on the run in `summary.json`.

use fenderline_sim::{Departure, Verdict};

use crate::json::{Json, object};
use crate::outcome::Outcome;

/// The verdict on the run and its findings as JSON, the worst finding first.
pub(super) fn verdict_json(outcome: &Outcome<'_>) -> Json {
    let verdict = Verdict::of(outcome.findings);
    let findings = outcome.findings.iter().map(|finding| {
        let mut object = object!({
            "key": finding.verdict().key(),
            "gravity": finding.verdict().gravity().key(),
            "names": finding.names(outcome.setup),
            "text": finding.sentence(outcome.setup),
        });
        if let Some(Departure { law, first_s, lasting_s, share_of_run, .. }) = finding.departure() {
            object.put("law", law.row().key);
            object.put("from_s", *first_s);
            object.put("lasting_s", *lasting_s);
            object.put("share_of_run", *share_of_run);
        }
        object
    });
    object!({
        "key": verdict.key(),
        "gravity": verdict.gravity().key(),
        "text": verdict.text(),
        "findings": findings.collect::<Json>(),
    })
}
