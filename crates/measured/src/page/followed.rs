//! What tugs, thrusters and wind together gave on the way to the touch.

use fenderline_report::plot::fixed;
use fenderline_report::{Head, table_head};
use maud::{Markup, html};

use super::with_band;
use crate::berthing::Berthing;

/// The table of a berthing whose mapping asks for a run along the measured path; empty for another.
pub(super) fn table(own: &Berthing) -> Markup {
    let run = match &own.followed {
        None => return html! {},
        Some(Err(why)) => {
            return html! { p { strong class="over" { "No run along the measured path: " } (why) "." } };
        }
        Some(Ok(run)) => run,
    };
    let heads = [
        Head::Name("Tugs, thrusters and wind"),
        Head::Number("Mean", "kN, MN m"),
        Head::Number("Impulse", "MN s, GN m s"),
    ];
    let names = [
        ("Along the quay, positive ahead", 1e-3),
        ("Towards the quay", 1e-3),
        ("Moment, positive with the bow towards the quay", 1e-6),
    ];
    html! {
        div class="wide" { table class="narrow" {
            (table_head(&heads))
            tbody { @for ((name, factor), (mean, impulse)) in names.into_iter().zip(run.mean().into_iter().zip(run.impulse)) { tr {
                td class="name" { (name) }
                (with_band(mean, factor, if factor < 1e-4 { 2 } else { 0 }))
                (with_band(impulse, 1e-3 * factor, 2))
            } } }
        } }
        p class="note" {
            "What all loads but the water gave from " (fixed(run.from_m, 1)) " m off to the touch, in " (fixed(run.duration_s, 0))
            " s, by a run that is held on the measured path. The run was at most " (fixed(run.off_m, 2)) " m off the path."
        }
    }
}
