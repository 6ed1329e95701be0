//! The report's sentences on how ships come to their berths.

use fenderline_results::Outcome;
use maud::{Markup, html};

/// A sentence for each approach of the scenario.
pub(super) fn sentences(outcome: &Outcome<'_>) -> Markup {
    let setup = outcome.setup;
    html! {
        @for approach in &setup.approaches {
            p {
                @if approach.is_abnormal() { strong { "Abnormal berthing. " } }
                (approach.sentence(setup)) "."
            }
        }
    }
}
