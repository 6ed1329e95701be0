//! `report.html`: one page that an engineer can put before a client. The page holds no date but the one that the user
//! gives, and no path, so that the same scenario gives the same bytes.

mod approach;
mod assumptions;
mod berthing;
mod branches;
mod charts;
mod cover;
mod energy;
mod exercise;
mod factors;
mod fenders;
mod governing;
mod harbour_key;
mod method_notes;
mod parts;
mod quantities;
mod recorder;
mod scene;
mod session;
mod signed;
mod strongest;
mod system;
mod tables;
mod verdict;
mod vessels;

use fenderline_contact::EventKind;
use maud::{Markup, html};

use crate::plot::{fenders_legend, outlined_legend, page_of, shortened};
use crate::words::{event_text, with_code};
use fenderline_results::{Outcome, is_plain};

pub use cover::detail_label;
pub use governing::{Governing, governing};
pub use recorder::{Recorder, WindTrace};
pub use vessels::{addressee, order_text};

use harbour_key::harbour;
use recorder::PairTrace;
use strongest::strongest;

/// Longest title at the foot of printed pages (characters).
const TITLE: usize = 80;
/// Largest number of pairs of bodies that are shown in a close-up.
const CLOSE_UPS: usize = 2;

/// Writes the report page from the outcome of the run and the record of its time steps.
pub fn render(outcome: &Outcome<'_>, recorder: &Recorder) -> String {
    let drawn = strongest(recorder);
    let body = html! {
        (cover::cover(outcome, recorder))
        @if outcome.session.is_some() {
            // What an instructor asks first: what came of it, and who did what when.
            (exercise::section(outcome))
            (branches::section(outcome))
            (session::section(outcome))
            (results(outcome, recorder))
            (assumptions::section(outcome, recorder))
        } @else {
            (assumptions::section(outcome, recorder))
            (results(outcome, recorder))
        }
        (system::section(outcome, recorder))
        (fenders::section(outcome, recorder))
        (berthing::section(outcome))
        (views(outcome, recorder, &drawn))
        (vessels::sections(outcome, recorder))
        h2 { "Time series" }
        (left_out(recorder, &drawn))
        (charts::all(outcome, recorder, &drawn))
        (parts::chart(&charts::Charts::new(outcome), recorder))
        h2 { "Energy" }
        (energy::section(outcome, recorder))
        h2 { "Set-up" }
        (tables::setup(outcome))
        footer {
            "Made by fenderline " (env!("CARGO_PKG_VERSION")) " from " (outcome.scenario_file)
            @if outcome.session.is_some() {
                ". The same recording gives this page again, byte for byte."
            } @else {
                ". The same scenario gives this page again, byte for byte."
            }
        }
    };
    page_of(outcome.title, &footer(outcome), &body)
}

/// The section of results. For a session, the section on its exercise stands before this section, otherwise in it.
fn results(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    html! {
        h2 { "Results" }
        (fenders::headline(outcome))
        (vessels::headline(outcome))
        (tables::results(outcome))
        (remarks(outcome))
        (vessels::remarks(outcome))
        @if outcome.session.is_none() { (exercise::section(outcome)) }
        (vessels::motions(outcome, recorder))
        (factors::section(outcome))
    }
}

/// The plan views besides that of the title page; empty if there are none.
fn views(outcome: &Outcome<'_>, recorder: &Recorder, drawn: &[&PairTrace]) -> Markup {
    let whole = [scene::whole(outcome, recorder), scene::moored(outcome, recorder)];
    let close_ups = drawn.iter().take(CLOSE_UPS).map(|trace| scene::close_up(outcome, trace));
    let views: Vec<Markup> =
        whole.into_iter().chain(close_ups).filter(|view| !view.0.is_empty()).collect();
    html! {
        @if !views.is_empty() {
            h2 { "Plan views" }
            (outlined_legend())
            @if !outcome.setup.fenders.is_empty() { (fenders_legend()) }
            (harbour(outcome))
            @for view in &views { (view) }
        }
    }
}

/// The footer of each printed page: document number, revision and title.
fn footer(outcome: &Outcome<'_>) -> String {
    let detail = |key: &str| outcome.report.iter().find(|(own, _)| *own == key);
    let number = detail("number").map(|(_, text)| text.clone());
    let revision = detail("revision").map(|(_, text)| format!("rev. {text}"));
    let title = shortened(outcome.title, TITLE);
    let parts: Vec<String> = number.into_iter().chain(revision).chain([title]).collect();
    parts.join(" · ")
}

fn left_out(recorder: &Recorder, drawn: &[&PairTrace]) -> Markup {
    let touched = recorder.pairs.len();
    html! {
        @if recorder.pairs_not_followed {
            p class="note" {
                (format!(
                    "More than {touched} pairs touched. The charts draw the {} pairs with the \
                     largest forces among the first {touched}; all pairs are in summary.json and in \
                     the contacts table.",
                    drawn.len(),
                ))
            }
        } @else if touched > drawn.len() {
            p class="note" {
                (format!(
                    "{touched} pairs touched; the charts draw the {} pairs with the largest forces. \
                     All pairs are in summary.json and in the contacts table.",
                    drawn.len(),
                ))
            }
        }
    }
}

/// The remarks that the author of the scenario and the reader should know about this run.
fn remarks(outcome: &Outcome<'_>) -> Markup {
    let count = |wanted| {
        let found = outcome.events.counts().find(|(kind, _)| *kind == wanted);
        found.map_or(0, |(_, count)| count)
    };
    let (begun, ended) = (count(EventKind::ContactBegan), count(EventKind::ContactEnded));
    // Those of fenders are listed by name.
    let is_listed = |kind| {
        is_plain(kind)
            || matches!(kind, EventKind::FenderRatingExceeded(_) | EventKind::FenderFailed(_))
    };
    let grave: Vec<_> = outcome.events.counts().filter(|(kind, _)| !is_listed(*kind)).collect();
    html! {
        @if begun > 0 {
            p class="note" { "Contacts begun: " (begun) "; ended: " (ended) "." }
        }
        @if !grave.is_empty() {
            h3 { "Needs attention" }
            ul class="plain" {
                @for (kind, count) in grave {
                    li { (event_text(kind)) @if count > 1 { " (" (count) " times)" } }
                }
            }
        }
        @if !outcome.notices.is_empty() {
            h3 { "Notices" }
            ul class="plain" {
                @for notice in outcome.notices.iter().take(20) { li { (with_code(notice)) } }
                @if outcome.notices.len() > 20 {
                    li { "and " (outcome.notices.len() - 20) " more, in summary.json" }
                }
            }
        }
    }
}
