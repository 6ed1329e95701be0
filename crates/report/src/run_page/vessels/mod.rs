//! The report's sections on vessels, tugs, mooring lines and anchors, if the scenario has any.

mod anchors;
mod charts;
mod headline;
mod motions;
mod orders;
mod passing;
mod plan;
mod tables;

use std::fmt::Write;

use fenderline_sim::Setup;
use maud::{Markup, html};

use super::charts::Charts;
use super::recorder::Recorder;
use fenderline_results::Outcome;

pub(super) use headline::{headline, remarks};
pub(super) use orders::compass;
pub use orders::{addressee, order_text};

/// Largest number of vessel names in a sentence.
const NAMED: usize = 8;

/// The data of the vessels that must be checked because they are estimated or recalled.
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

/// Sentences on which vessels move in six degrees of freedom, and on how vessels without hydrodynamic data move.
pub(super) fn degrees_of_freedom(setup: &Setup) -> String {
    let names = |has_data: bool| -> Vec<&str> {
        let vessels = setup.world.vessels.iter();
        let vessels = vessels.filter(|vessel| vessel.seakeeping.is_some() == has_data);
        vessels.map(|vessel| setup.bodies[vessel.body].name.as_str()).take(NAMED).collect()
    };
    let (with, without) = (names(true), names(false));
    let mut text = String::new();
    if !with.is_empty() {
        let _ = write!(
            text,
            "With hydrodynamic data ({}): motion in six degrees of freedom by Cummins' equation; \
             heave, roll and pitch move fairleads and contact points, and lines and fenders act \
             back on them. ",
            with.join(", ")
        );
    }
    if !without.is_empty() {
        let _ = write!(
            text,
            "Without hydrodynamic data ({}): heave, roll and pitch are oscillators that do not act \
             on the motion in the plane; they do not move fairleads or contact points, and waves \
             push only by their mean drift.",
            without.join(", ")
        );
    }
    text
}

/// The section on the vessels' motions about their means and on the limits of the scenario, if the scenario asks for
/// statistics.
pub(super) fn motions(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    let page = Charts::new(outcome);
    html! {
        @if outcome.statistics.is_some() {
            h2 { "Motions and limits" }
            (motions::section(outcome))
            (charts::motions(&page, recorder))
        }
    }
}

/// All sections.
pub(super) fn sections(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    let world = &outcome.setup.world;
    let page = Charts::new(outcome);
    html! {
        @if !world.vessels.is_empty() {
            h2 { "Vessels" }
            (tables::vessels(outcome))
            (plan::section(outcome, recorder))
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
            (motions::cycles(outcome))
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
