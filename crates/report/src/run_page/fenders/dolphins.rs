//! The table of flexible dolphins.

use fenderline_results::Outcome;
use fenderline_sim::DolphinSummary;
use maud::{Markup, html};

use crate::plot::{fixed, significant};
use crate::{Head, table_head};

/// One row a flexible dolphin, in the order of the scenario; nothing without one.
pub(super) fn table(outcome: &Outcome<'_>) -> Markup {
    if outcome.dolphins.is_empty() {
        return html! {};
    }
    html! {
        h3 { "Flexible dolphins" }
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Dolphin"),
                    Head::Number("Deflection", "mm"),
                    Head::Number("Load", "kN"),
                    Head::Number("Energy", "kJ (kN·m)"),
                    Head::Number("Stiffness", "MN/m"),
                    Head::Number("Period", "s"),
                    Head::Number("Of yield load", "%"),
                    Head::Number("Permanent", "mm"),
                ]))
                tbody { @for dolphin in outcome.dolphins { (row(outcome, dolphin)) } }
            }
        }
        ul class="note" {
            li {
                "Deflection, load and energy are peaks of the piles at the height of the fender, sub-steps included; "
                "stiffness and period are of the dolphin without ship and fender."
            }
        }
    }
}

fn row(outcome: &Outcome<'_>, dolphin: &DolphinSummary) -> Markup {
    let body = &outcome.setup.bodies[dolphin.body];
    let share = dolphin.share_of_yield_load;
    html! {
        tr {
            td class="name" { (body.name) }
            td class="number" { (fixed(dolphin.peak_deflection_m * 1e3, 0)) }
            td class="number" { (significant(dolphin.peak_load_n / 1e3, 3)) }
            td class="number" { (significant(dolphin.peak_energy_j / 1e3, 3)) }
            @if let Some(of) = &body.dolphin {
                td class="number" { (significant(of.stiffness_npm / 1e6, 3)) }
                td class="number" { (significant(of.period_s(), 3)) }
            }
            td class="number" { (share.map_or_else(|| "–".to_owned(), |s| fixed(100.0 * s, 0))) }
            td class="number" { (fixed(dolphin.offset_m * 1e3, 0)) }
        }
    }
}
