//! The report's table of where hulls with outlines at several heights met the fenders.

use fenderline_results::Outcome;
use maud::{Markup, html};

use crate::plot::{fixed, significant};
use crate::run_page::tables::{ROWS, more, number};
use crate::table::breakable;
use crate::{Head, table_head};

/// The table with one row for each fender that met a hull with outlines at heights; empty if no fender did.
pub(super) fn table(outcome: &Outcome<'_>) -> Markup {
    let met = outcome.fenders.iter().filter_map(|summary| Some((summary, summary.hull?)));
    let all: Vec<_> = met.collect();
    if all.is_empty() {
        return html! {};
    }
    html! {
        h3 { "Hull by height" }
        div class="wide" {
            table class="narrow" {
                (table_head(&[
                    Head::Name("Fender"),
                    Head::Number("Met at height", "on the hull, m"),
                    Head::Number("Flare there", "deg"),
                    Head::Number("Peak vertical force", "on the hull, kN"),
                ]))
                tbody {
                    @for (summary, hull) in all.iter().take(ROWS) {
                        tr {
                            td class="name" { (breakable(&outcome.setup.fenders[summary.fender].name)) }
                            (number(&fixed(hull.height_m, 2)))
                            (number(&fixed(hull.vertical_angle_rad.to_degrees(), 1)))
                            (number(&significant(hull.peak_vertical_force_n / 1e3, 3)))
                        }
                    }
                }
            }
        }
        (more(all.len()))
        p class="note" {
            "Height: of the first touch, above the keel of a floating body or above the datum of a \
             fixed body. Flare: how far the ship's side leans out over the fender, negative if the \
             side leans in. Vertical force: positive up, a mean over a time step."
        }
    }
}
