//! The verdict on the run, at the top of the page.

use maud::{Markup, html};

use fenderline_results::Outcome;
use fenderline_sim::{Gravity, Verdict};

use crate::words::with_code;

/// Largest number of shown findings.
const FINDINGS: usize = 8;

/// The verdict on the run, and its findings, the worst first.
pub(super) fn headline(outcome: &Outcome<'_>) -> Markup {
    let verdict = Verdict::of(outcome.findings);
    let (shown, rest) = outcome.findings.split_at(outcome.findings.len().min(FINDINGS));
    html! {
        div class={ "banner " (class(verdict.gravity())) } {
            p class="headline" { span class="label" { "Verdict" } " " strong { (verdict.text()) } }
            @if !shown.is_empty() {
                ul class="plain" {
                    @for finding in shown { li { (with_code(&finding.sentence(outcome.setup))) "." } }
                    @if !rest.is_empty() { li { "And " (rest.len()) " more, in summary.json." } }
                }
            }
        }
    }
}

/// The CSS class that colours a verdict.
fn class(gravity: Gravity) -> &'static str {
    match gravity {
        Gravity::Ok => "ok",
        Gravity::Note => "not_rated",
        Gravity::Attention => "over_rated",
        Gravity::Failed => "failed",
    }
}
