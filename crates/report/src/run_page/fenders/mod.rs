//! The report's section on fenders.

mod boxes;
mod charts;
mod dolphins;
mod hull;
mod panels;
mod setup;
mod table;

use maud::{Markup, html};

use super::charts::Charts;
use super::recorder::Recorder;
use crate::plot::fixed;
use fenderline_results::Outcome;
use fenderline_results::worst_first;

pub(super) use boxes::{boxes, names, used};
pub(super) use setup::setup_table;
pub(super) use table::{data, to_check};

/// The result for the fenders in one or two sentences, for the top of the page; empty if there are no fenders.
pub(super) fn headline(outcome: &Outcome<'_>) -> Markup {
    let setups = &outcome.setup.fenders;
    if setups.is_empty() {
        return html! {};
    }
    let unrated = outcome.fenders.iter().filter(|f| setups[f.fender].rated.is_none()).count();
    if outcome.fenders.is_empty() {
        return html! { p { "None of the " (setups.len()) " fenders was touched." } };
    }
    let most = worst_first(setups, outcome.fenders).first().map(|&i| &outcome.fenders[i]);
    html! {
        p {
            (outcome.fenders.len()) " of " (setups.len()) " fenders touched"
            @if let Some((summary, (quantity, share))) = most.and_then(|f| Some((f, f.governing()?))) {
                "; most used " strong { (setups[summary.fender].name) } ", "
                (fixed(100.0 * share, 0)) " % of its rated " (quantity)
            }
            "."
            @if unrated > 0 && unrated < outcome.fenders.len() {
                " " (unrated) " of them " @if unrated == 1 { "has" } @else { "have" } " no rating."
            }
        }
    }
}

/// Writes the section on fenders; empty if there are no fenders.
pub(super) fn section(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    if outcome.setup.fenders.is_empty() {
        return html! {};
    }
    html! {
        h2 { "Fenders" }
        @if outcome.fenders.is_empty() {
            p { "None of the " (outcome.setup.fenders.len()) " fenders was touched." }
        } @else {
            (table::table(outcome))
            (dolphins::table(outcome))
            (hull::table(outcome))
            (panels::panels(outcome))
            (panels::chains(outcome))
            (charts::utilisation(outcome))
            @let page = Charts::new(outcome);
            (charts::reactions(&page, recorder))
            (charts::turns(&page, recorder))
            (charts::tensions(&page, recorder))
            (charts::diagrams(outcome, recorder))
        }
    }
}
