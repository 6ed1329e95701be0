//! The table of flexible dolphins.

use fenderline_results::{DOLPHINS, Outcome};
use fenderline_sim::DolphinSummary;
use maud::{Markup, html};

use crate::run_page::quantities;
use crate::{Head, table_head};

/// The table with one row for each flexible dolphin, in the order of the scenario; empty if there are none.
pub(super) fn table(outcome: &Outcome<'_>) -> Markup {
    if outcome.dolphins.is_empty() {
        return html! {};
    }
    let mut heads = vec![Head::Name("Dolphin")];
    heads.extend(quantities::heads(&DOLPHINS));
    html! {
        h3 { "Flexible dolphins" }
        div class="wide" {
            table {
                (table_head(&heads))
                tbody { @for dolphin in outcome.dolphins { (row(outcome, dolphin)) } }
            }
        }
        ul class="note" {
            li {
                "Deflection, load and energy are peak values of the piles at the height of the \
                 fender, sub-steps included; stiffness and period are of the dolphin without ship \
                 and fender."
            }
        }
    }
}

fn row(outcome: &Outcome<'_>, dolphin: &DolphinSummary) -> Markup {
    let body = &outcome.setup.bodies[dolphin.body];
    html! {
        tr {
            td class="name" { (body.name) }
            (quantities::cells(&DOLPHINS, body, dolphin, outcome.setup.step_s))
        }
    }
}
