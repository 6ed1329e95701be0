//! The report's table of anchors, with the tensions of their chains.

use fenderline_results::{AnchorTotals, AnchorVerdict, Outcome};
use fenderline_sim::AnchorSetup;
use fenderline_sim::anchor::SHACKLE_M;
use maud::{Markup, html};

use crate::plot::{fixed, plain, significant};
use crate::run_page::tables::{ROWS, more, number};
use crate::{Head, table_head};

/// The table.
pub(super) fn table(outcome: &Outcome<'_>) -> Markup {
    let (setup, world) = (outcome.setup, outcome.world);
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Anchor"),
                    Head::Number("Mass", "t"),
                    Head::Number("Chain", "mm × shackles"),
                    Head::Number("Break load", "kN"),
                    Head::Number("Most chain out", "shackles (m)"),
                    Head::Number("Peak tension", "kN"),
                    Head::Number("of break load", "%"),
                    Head::Number("at", "s"),
                    Head::Number("On the bottom", "min"),
                    Head::Number("Dragged", "m"),
                    Head::Number("Energy to the bottom", "kJ"),
                    Head::Number("At the end", "kN"),
                    Head::Text("Verdict", ""),
                ]))
                tbody {
                    @for (anchor, totals) in setup.world.anchors.iter().zip(&world.anchors).take(ROWS) {
                        tr {
                            td class="name" { (anchor.gear.name) }
                            (cells(anchor, totals))
                        }
                    }
                }
            }
        }
        (more(world.anchors.len()))
        p class="note" {
            "The tension is that of the chain at the hawse pipe. Holding power: the holding factor \
             times the anchor's weight, which is less if the chain lifts the shank, plus friction \
             of the chain on the bottom. "
            strong { "No anchor was compared with a test." }
        }
    }
}

fn cells(anchor: &AnchorSetup, totals: &AnchorTotals) -> Markup {
    let (gear, verdict) = (&anchor.gear, totals.verdict());
    let was_used = verdict != AnchorVerdict::NotUsed;
    let used = |text: String| if was_used { text } else { "–".to_owned() };
    let shackles = |length_m: f64| fixed(length_m / SHACKLE_M, 1);
    let share = 100.0 * totals.tension_n.value / totals.break_load_n;
    let chain_m = totals.chain_m.value;
    html! {
        (number(&plain(gear.mass_kg / 1e3, 3)))
        (number(&format!("{} × {}", plain(1e3 * gear.chain_diameter_m, 3), shackles(gear.chain_length_m))))
        (number(&significant(totals.break_load_n / 1e3, 3)))
        (number(&used(format!("{} ({})", shackles(chain_m), fixed(chain_m, 1)))))
        (number(&used(significant(totals.tension_n.value / 1e3, 3))))
        (number(&used(fixed(share, 1))))
        (number(&used(fixed(totals.tension_n.at_s, 1))))
        (number(&used(fixed(totals.on_bottom.s() / 60.0, 1))))
        (number(&used(fixed(totals.dragged_m, 1))))
        (number(&used(significant(totals.dragged_j / 1e3, 3))))
        (number(&used(significant(totals.last_tension_n / 1e3, 3))))
        td { span class={ "verdict " (class(verdict)) } { (verdict.text()) } }
    }
}

/// The CSS class that colours the verdict on an anchor.
fn class(verdict: AnchorVerdict) -> &'static str {
    match verdict {
        AnchorVerdict::Held => "ok",
        AnchorVerdict::NotUsed | AnchorVerdict::Slipped => "not_rated",
        AnchorVerdict::Dragged => "over_rated",
        AnchorVerdict::Lost => "failed",
    }
}
