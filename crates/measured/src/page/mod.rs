//! The report of measured berthings.

mod approach;
mod cloud;
mod followed;
mod map;
mod used;

use fenderline_report::plot::{counted, fixed, page as whole_page};
use fenderline_report::{Head, table_head};
use maud::{Markup, html};

use crate::berthing::{Berthing, Berthings};
use crate::estimate::Uncertain;
use crate::flag::Flag;
use crate::log::LogKind;
use crate::remark::Weight;
use crate::table::{most_used, time_text};

/// What the report says beside the berthings.
#[derive(Clone, Copy, Debug)]
pub struct Page<'a> {
    /// Title of the berth's scenario.
    pub title: &'a str,
    /// Names of the logs.
    pub logs: &'a [String],
    /// Notices of the scenario.
    pub notices: &'a [String],
}

/// The report as a page without outside resources.
#[must_use]
pub fn page(of: &Page<'_>, berthings: &Berthings) -> String {
    let title = format!("Measured berthings: {}", of.title);
    let body = html! {
        p class="kicker" { "fenderline berthings" }
        h1 { (title) }
        p class="subtitle" { (subtitle(of, berthings)) }
        (headline(berthings))
        (remarks(berthings))
        h2 { "Berthings" }
        (list(berthings))
        (map::section(berthings))
        (cloud::section(berthings))
        (used::section(berthings))
        h2 { "Each approach" }
        p class="note" {
            "Time runs from the first touch at 0. Dots are readings. Lines are parabolas through the readings of one \
             bandwidth; none of them uses readings after the touch. The grey band is two standard deviations to each side."
        }
        @for (index, own) in berthings.all.iter().enumerate() {
            (approach::section(berthings, index, own))
        }
        h2 { "How it was computed" }
        (methods(of, berthings))
        footer { "Made by fenderline " (env!("CARGO_PKG_VERSION")) "." }
    };
    whole_page(&title, &body)
}

fn subtitle(of: &Page<'_>, berthings: &Berthings) -> String {
    let count = counted(berthings.all.len() as u64, "berthing", "berthings");
    format!("{count}, from {}", of.logs.join(", "))
}

/// The answers first: the hardest berthing, the most energy, the most used fender, and what was exceeded.
fn headline(berthings: &Berthings) -> Markup {
    let by_speed = |own: &&Berthing| own.touch.speed_mps.value;
    let fastest = berthings.all.iter().max_by(|a, b| by_speed(a).total_cmp(&by_speed(b)));
    let runs = || berthings.all.iter().filter_map(|own| Some((own, own.run.as_ref().ok()?)));
    let hardest = runs().max_by(|a, b| a.1.energy_j.value.total_cmp(&b.1.energy_j.value));
    let used = runs()
        .filter_map(|(own, run)| Some((own, most_used(run)?)))
        .max_by(|a, b| a.1.2.total_cmp(&b.1.2));
    let exceeded = runs().filter(|(_, run)| !run.exceeded.is_empty()).count();
    let number = |wanted: &Berthing| {
        let place = berthings.all.iter().position(|own| core::ptr::eq(own, wanted));
        place.map_or(0, |place| place + 1)
    };
    let class = if exceeded > 0 { "banner over_rated" } else { "banner ok" };
    html! {
        div class=(class) {
            @if let Some(own) = fastest {
                p class="headline" {
                    span class="label" { "Fastest" } strong { (fixed(100.0 * own.touch.speed_mps.value, 1)) " ± " (fixed(200.0 * own.touch.speed_mps.sd, 1)) " cm/s" }
                    " in berthing " (number(own)) ", " (own.ship)
                }
            }
            @if let Some((own, run)) = hardest {
                p class="headline" {
                    span class="label" { "Most energy" } strong { (fixed(run.energy_j.value / 1e3, 0)) " ± " (band(run.energy_j.sd / 1e3, 0)) " kJ" }
                    " in the first hit of berthing " (number(own)) ", " (own.ship)
                }
            }
            @if let Some((own, (fender, quantity, share))) = used {
                p class="headline" {
                    span class="label" { "Most used fender" } strong { (berthings.berths[own.berth].fender(fender)) ": " (fixed(100.0 * share, 0)) " %" }
                    " of its rated " (quantity) ", in berthing " (number(own))
                }
            }
            p class="headline" {
                span class="label" { "Exceeded" }
                @if exceeded == 0 { strong { "nothing" } " in any run from a measured state" }
                @else { strong { (counted(exceeded as u64, "berthing", "berthings")) } " of " (berthings.all.len()) " exceeded something; see the sections below" }
            }
            p class="note" { "± is two standard deviations, about 95 %." }
        }
    }
}

/// What was left out and guessed, gravest first.
fn remarks(berthings: &Berthings) -> Markup {
    let of = |weight: Weight| berthings.remarks.iter().filter(move |own| own.weight == weight);
    let part = |weight: Weight, title: &str| {
        html! {
            @if of(weight).next().is_some() {
                h3 { (title) }
                ul class="plain" { @for own in of(weight) { li { (own.to_string()) "." } } }
            }
        }
    };
    html! {
        @if !berthings.remarks.is_empty() {
            h2 { "What was left out, mended and guessed" }
            (part(Weight::Refused, "Berthings left out"))
            (part(Weight::Rows, "Rows left out or mended"))
            (part(Weight::Guess, "Guesses"))
        }
    }
}

/// Two standard deviations; a question mark if the deviation is not known.
fn band(sd: f64, decimals: usize) -> String {
    if sd.is_finite() { fixed(2.0 * sd, decimals) } else { "?".to_owned() }
}

/// A value with two standard deviations.
fn with_band(value: Uncertain, factor: f64, decimals: usize) -> Markup {
    html! {
        td class="number" { (fixed(value.value * factor, decimals)) small { "± " (band(value.sd * factor, decimals)) } }
    }
}

fn list(berthings: &Berthings) -> Markup {
    let heads = [
        Head::Number("No.", ""),
        Head::Name("Time and ship"),
        Head::Number("Speed", "cm/s"),
        Head::Number("Angle", "°"),
        Head::Number("Turn", "°/min"),
        Head::Text("First fender", "place on ship, m"),
        Head::Number("Formula", "kJ"),
        Head::Number("Run", "kJ"),
        Head::Text("Most used", "share of rating"),
    ];
    html! {
        div class="wide" { table {
            (table_head(&heads))
            tbody { @for (index, own) in berthings.all.iter().enumerate() { tr {
                td class="number" { (index + 1) }
                td class="name" { (own.ship) small { (time_text(own)) } small { (own.kind.words()) } }
                (with_band(own.touch.speed_mps, 100.0, 1))
                (with_band(own.touch.angle_rad, 1.0_f64.to_degrees(), 2))
                (with_band(own.touch.turn_radps, 60.0_f64.to_degrees(), 1))
                td { (berthings.berths[own.berth].fender(own.touch.fender))
                    small { (fixed(own.touch.forward_m.value, 1)) " ± " (fixed(2.0 * own.touch.forward_m.sd, 1)) } }
                @match &own.run {
                    Ok(run) => {
                        (with_band(run.formula_j, 1e-3, 0))
                        (with_band(run.energy_j, 1e-3, 0))
                        td { @match most_used(run) {
                            Some((fender, quantity, share)) => {
                                (berthings.berths[own.berth].fender(fender))
                                small class=[(share > 1.0).then_some("over")] { (fixed(100.0 * share, 0)) " % of " (quantity) }
                            }
                            None => "–",
                        } }
                    }
                    Err(why) => td colspan="3" { small class="over" { "no run: " (why) } },
                }
            } } }
        } }
        p class="note" {
            "± is two standard deviations, about 95 %. Speed: of the point of contact, square to the quay. Angle: positive \
             with the bow towards the quay. Place: forward of the centre of gravity. Formula: the berthing energy of the \
             scenario's [berthing] with the measured speed of the centre of gravity. Run: energy of all fenders in the \
             first hit of the run from the measured state."
        }
    }
}

fn methods(of: &Page<'_>, berthings: &Berthings) -> Markup {
    let mut flags: Vec<Flag> =
        berthings.all.iter().flat_map(|own| own.flags.iter().copied()).collect();
    flags.sort_unstable();
    flags.dedup();
    let has_ais = berthings.all.iter().any(|own| own.kind == LogKind::Ais);
    html! {
        ul class="plain" {
            li { "Smoothing: a parabola by least squares through the readings of one bandwidth before the touch, all with \
                the same weight. The bandwidth of each berthing stands in its section and in the table. There is no other filter." }
            li { "Readings more than 4.5 deviations from the parabola are left out and counted." }
            li { "Deviations: from the scatter of the readings about the parabola, never less than their rounding, widened \
                where what is left follows itself; carried to the results to first order." }
            li { "The touch: the moment at which the scenario's hull, at the measured distances or position, meets the \
                face of a fender." }
            li { "The run starts from the measured state some metres off. Drag, depth and current act; no wind, wave, tug, \
                engine or line does. Energies differ from the truth where those acted on the last metres." }
            @if berthings.all.iter().any(|own| own.followed.is_some()) {
                li { "What tugs, thrusters and wind gave: a second run from farther off is held on the measured path by a spring and \
                    a damper on its distance and speed from the path. Their force, added up from the start to the touch, is what \
                    all loads but the water gave. Deviations follow from those of the measured speeds at both ends and from the \
                    ship's mass with its added mass; errors of the scenario's drag and added mass come on top." }
            }
            @if has_ais {
                li { "AIS alone is coarse: its deviation stands beside each result. A speed from AIS is no measurement for \
                    the design of fenders where the band is as wide as the speed." }
            }
        }
        @if !flags.is_empty() {
            h3 { "Flags" }
            dl { @for flag in flags { dt { (flag.word().replace('_', " ")) } dd { (flag.meaning()) } } }
        }
        @if !of.notices.is_empty() {
            h3 { "Notices of the scenario" }
            ul class="plain" { @for notice in of.notices { li { (notice) } } }
        }
    }
}
