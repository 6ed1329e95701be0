//! The sentences about vessels, tugs, mooring lines and force providers at the top of the report.

use fenderline_contact::number::greater;

use maud::{Markup, html};

use crate::plot::{counted, fixed, plain, times};
use crate::words::world_event_text;
use fenderline_results::Outcome;
use fenderline_results::{LineVerdict, Who};

/// Most events listed.
const EVENTS: usize = 12;

/// The result for the mooring lines in a sentence; empty if there are none.
pub(in crate::run_page) fn headline(outcome: &Outcome<'_>) -> Markup {
    let world = outcome.world;
    let share = world.lines.iter().filter_map(|line| line.share_of_break_load());
    let share = share.fold(0.0, greater);
    let parted = world.lines.iter().filter(|line| line.parted_s.is_some()).count();
    html! {
        @if !world.lines.is_empty() {
            p {
                (counted(world.lines.len() as u64, "line", "lines"))
                @if parted > 0 { ", " strong { (parted) " PARTED" } }
                (format!(
                    "; the most used line reached {} % of its break load.",
                    fixed(100.0 * share, 0),
                ))
            }
        }
    }
}

/// The CSS class that colours the verdict on a mooring line.
pub(super) fn class(verdict: LineVerdict) -> &'static str {
    match verdict {
        LineVerdict::Ok => "ok",
        LineVerdict::NotMadeFast => "not_rated",
        LineVerdict::Rendered | LineVerdict::OverWorking => "over_rated",
        LineVerdict::Parted => "failed",
    }
}

/// The list of events of vessels, tugs, mooring lines and force providers, in the order of time.
pub(in crate::run_page) fn remarks(outcome: &Outcome<'_>) -> Markup {
    let events = &outcome.world.events;
    let all: u64 = events.counts().iter().map(|(_, count)| count).sum();
    let providers = outcome.providers;
    html! {
        @if all > 0 || !providers.counts().is_empty() {
            h3 { "Events" }
            ul class="plain" {
                @for (t_s, event) in events.first().iter().take(EVENTS) {
                    @let who = Who::of(event, outcome.setup);
                    li {
                        (plain(*t_s, 6)) " s: " (who.kind) " " strong { (who.name) } ": "
                        (world_event_text(event.kind))
                    }
                }
                @if all > EVENTS as u64 {
                    li { "and " (all - EVENTS as u64) " more events; the first events are in summary.json" }
                }
                @for (key, count) in providers.counts() {
                    li { "Providers: " (key.trim_start_matches("provider_")) ", " (times(*count)) }
                }
            }
        }
    }
}
