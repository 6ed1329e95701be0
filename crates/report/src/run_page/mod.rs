//! `report.html`: one page that an engineer can put before a client. It holds no date but the one that the user gives, and
//! no path, so that the same scenario gives the same bytes.

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
mod parts;
mod recorder;
mod scene;
mod session;
mod system;
mod tables;
mod verdict;
mod vessels;

use fenderline_contact::EventKind;
use fenderline_sim::Method;
use maud::{Markup, html};

use crate::plot::{
    chart_note, fenders_legend, harbour_legend, outlined_legend, page_of, shortened,
};
use crate::words::{event_text, with_code};
use fenderline_results::{Outcome, is_plain};

pub use cover::detail_label;
pub use governing::{Governing, governing};
pub use recorder::{Recorder, WindTrace};
pub use vessels::{addressee, order_text};

use recorder::PairTrace;

/// Most pairs in a chart: more lines cannot be told apart.
const DRAWN_PAIRS: usize = 6;
/// Longest title at the foot of printed pages (characters).
const TITLE: usize = 80;
/// Most pairs with a close-up.
const CLOSE_UPS: usize = 2;

/// The page, from the outcome of the run and the record of its steps.
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

/// The results in numbers. Those of a session come after its exercise.
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

/// Views beside that of the title page; nothing if there are none.
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

/// Document number, revision and title, at the foot of each printed page.
fn footer(outcome: &Outcome<'_>) -> String {
    let detail = |key: &str| outcome.report.iter().find(|(own, _)| *own == key);
    let number = detail("number").map(|(_, text)| text.clone());
    let revision = detail("revision").map(|(_, text)| format!("rev. {text}"));
    let title = shortened(outcome.title, TITLE);
    let parts: Vec<String> = number.into_iter().chain(revision).chain([title]).collect();
    parts.join(" · ")
}

/// The key to lines, tugs, banks and passing ships, if there are any.
fn harbour(outcome: &Outcome<'_>) -> Markup {
    let world = &outcome.setup.world;
    let (has_lines, has_tugs) = (!world.lines.is_empty(), !world.tugs.is_empty());
    let has_banks = !world.environment.banks.is_empty();
    let has = [has_lines, has_tugs, has_banks, !world.flow.passing.is_empty()];
    html! {
        @if has.contains(&true) { (harbour_legend(has)) }
        @if !world.chart.features.is_empty() { (chart_note()) }
    }
}

/// The pairs with the largest forces, largest first.
fn strongest(recorder: &Recorder) -> Vec<&PairTrace> {
    let mut pairs: Vec<&PairTrace> = recorder.pairs.iter().collect();
    pairs.sort_by(|a, b| b.peak.normal_n.total_cmp(&a.peak.normal_n));
    pairs.truncate(DRAWN_PAIRS);
    pairs
}

fn left_out(recorder: &Recorder, drawn: &[&PairTrace]) -> Markup {
    let touched = recorder.pairs.len();
    html! {
        @if recorder.pairs_not_followed {
            p class="note" {
                "More than " (touched) " pairs touched. The charts draw the " (drawn.len())
                " with the largest forces among the first " (touched)
                "; all pairs are in summary.json and in the contacts table."
            }
        } @else if touched > drawn.len() {
            p class="note" {
                (touched) " pairs touched; the charts draw the " (drawn.len())
                " with the largest forces. All are in summary.json and in the contacts table."
            }
        }
    }
}

/// What the author of the scenario and the reader should know about this run.
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

fn method_notes(outcome: &Outcome<'_>) -> Markup {
    html! {
        ul class="plain" {
            li {
                "Contact forces: the overlap method of Moreno, Sasaki, Makiyama and Tannuri "
                "(TransNav 17(4), 2023), with its sign errors corrected: normal force from the overlap "
                "area and its rate, friction by a shear spring that sticks and slips, and an "
                "impulse-momentum limiter that sets the rebound by the coefficient of restitution."
            }
            @match outcome.setup.method {
                Method::Paper => (paper_notes(outcome.setup.step_s)),
                Method::Coupled => (coupled_notes(outcome.setup.step_s)),
            }
            li {
                "Bodies are rigid, and move in the horizontal plane. "
                @if outcome.setup.world.vessels.is_empty() {
                    "The water acts by added mass alone, without damping, wind or current."
                } @else {
                    "On vessels act hull, propeller, rudder and thrusters by the MMG method, extended to low "
                    "speed, and wind, current and mean wave drift; on other bodies the water acts by added "
                    "mass alone. "
                    (vessels::degrees_of_freedom(outcome.setup))
                }
            }
            li {
                "Energy: the kinetic energy at the start plus the work of the loads equals the kinetic energy at "
                "the end plus the work done against contact forces. Work is force times the mean velocity of the "
                "step, so this balance is exact. The residual is rounding and, if surge and sway \
                 have "
                "different added mass, the integration error of the Coriolis terms. Energy taken by contact forces "
                "is stored, lost to restitution, damping and friction, or is a numerical loss or gain of method and "
                "time step. The numerical part decreases with the step, except where outlines meet \
                 in a corner, "
                "because the contact law there has no potential."
            }
            @if !outcome.setup.fenders.is_empty() {
                li {
                    "The force of a fender is the gradient of its stored energy: its reaction at the mean "
                    "deflection over its width, times the factor that speed, angle, temperature and "
                    "tolerance gave at the first touch. The energy is the integral of the \
                     reaction. Beyond the fender's travel the "
                    "stop acts, then the structure behind it."
                }
            }
        }
    }
}

fn paper_notes(step_s: f64) -> Markup {
    html! {
        li {
            "Paper method: the limiter treats each pair separately, without the other contacts and \
             the "
            "loads. If a body rests on several other bodies at once, or a steady load presses it, "
            "depth and rebound may be wrong (docs/contact_model.md, section 5). The limiter uses the mass "
            "with the smallest added mass."
        }
        li {
            "Forces are computed at the start of the time step over which they act (" (step_s)
            " s here). The peak rises and the contact shortens with a smaller step, while the "
            "impulse stays the same; compare two steps before you use a peak in design."
        }
    }
}

fn coupled_notes(step_s: f64) -> Markup {
    html! {
        li {
            "Coupled method: the forces of all contacts of a step are solved together, with the "
            "external loads and the full mass matrix of each body, so that several fenders "
            "share one rebound and a steady load is held at the static deflection."
        }
        li {
            "Forces in the charts are means over the time step (" (step_s) " s here). If it is "
            "too long for a contact, the engine takes sub-steps. Peaks in the tables "
            "include the sub-steps."
        }
    }
}
