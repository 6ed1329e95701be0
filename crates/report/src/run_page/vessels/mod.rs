//! The sections of vessels, tugs, lines and anchors, if the scenario has any.

mod anchors;
mod charts;
mod headline;
mod motions;
mod orders;
mod passing;
mod tables;

use maud::{Markup, html};

use super::Recorder;
use super::charts::Charts;
use fenderline_results::Outcome;

pub(super) use headline::{headline, remarks};
pub(super) use orders::compass;
pub use orders::{addressee, order_text};

/// What of the vessels' data has to be checked: estimates, and what was recalled.
pub(super) fn to_check(outcome: &Outcome<'_>) -> Vec<String> {
    let vessels = outcome.setup.world.vessels.iter();
    let mut all = Vec::new();
    for vessel in vessels {
        let estimated: Vec<&str> =
            vessel.origin.estimates().map(|source| source.group.as_str()).collect();
        if !estimated.is_empty() {
            let name = &outcome.setup.bodies[vessel.body].name;
            all.push(format!("Vessel {name}, estimated: {}", estimated.join(", ")));
        }
    }
    all
}

/// All sections.
pub(super) fn sections(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    let world = &outcome.setup.world;
    let page = Charts::new(outcome);
    html! {
        @if !world.vessels.is_empty() {
            h2 { "Vessels" }
            (tables::vessels(outcome))
            (motions::section(outcome))
            (charts::vessels(&page, recorder))
        }
        @if !world.flow.hulls.is_empty() {
            h2 { "Passing ships and interaction" }
            (passing::section(outcome))
            (charts::passing(&page, recorder))
        }
        @if !world.tugs.is_empty() {
            h2 { "Tugs" }
            (tables::tugs(outcome))
            (charts::tugs(&page, recorder))
        }
        @if !world.lines.is_empty() {
            h2 { "Mooring lines" }
            (tables::lines(outcome))
            (charts::lines(&page, recorder))
        }
        @if !world.anchors.is_empty() {
            h2 { "Anchors" }
            (anchors::table(outcome))
            (charts::anchors(&page, recorder))
        }
        @if !world.orders.is_empty() {
            h2 { "Orders" }
            (orders::table(outcome))
        }
    }
}
