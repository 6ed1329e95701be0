//! The section of one berthing: distance and speed over time, with the touch, and what the run gave.

use fenderline_report::plot::{Axis, Chart, Point, Reference, Series, fixed};
use fenderline_report::{Head, table_head};
use maud::{Markup, html};

use crate::berthing::{Berthing, Berthings};
use crate::curves::Line;
use crate::table::time_text;

fn points(line: &Line, factor: f64) -> Vec<Point> {
    line.iter().map(|(t, value)| Point { x: *t, y: value * factor }).collect()
}

/// The section of a berthing.
pub(super) fn section(berthings: &Berthings, index: usize, own: &Berthing) -> Markup {
    let touch = &own.touch;
    let berth = &berthings.berths[own.berth];
    let ship = if own.ship.is_empty() { "ship without a name" } else { own.ship.as_str() };
    html! {
        section {
            h3 { (index + 1) ". " (ship) ", " (time_text(own)) }
            p class="note" {
                (own.file) ", line " (own.line) "; " (own.kind.words()) "; bandwidth " (fixed(touch.bandwidth_s, 0)) " s with "
                (touch.readings) " readings"
                @if touch.left_out > 0 { ", " (touch.left_out) " left out" }
                @if let Some(zero_m) = own.zero_m { "; track moved by " (fixed(zero_m, 2)) " m" }
                @if !own.flags.is_empty() { "; flags: " (own.flags.iter().map(|flag| flag.word().replace('_', " ")).collect::<Vec<_>>().join(", ")) }
            }
            (distances(own))
            (speeds(own))
            @match &own.run {
                Err(why) => p { strong class="over" { "No run: " } (why) "." },
                Ok(run) => {
                    p {
                        "Touch: " strong { (fixed(100.0 * touch.speed_mps.value, 1)) " cm/s" } " at " (berth.fender(touch.fender)) ", "
                        (fixed(touch.angle_rad.value.to_degrees(), 2)) "°. The run from " (fixed(run.from_m, 2)) " m off touches "
                        (berth.fender(run.fender)) " at " (fixed(100.0 * run.speed_mps, 1)) " cm/s."
                    }
                    @if run.exceeded.is_empty() {
                        p { "Nothing was exceeded in the run." }
                    } @else {
                        ul class="plain" { @for finding in &run.exceeded { li { strong class="over" { (finding) } } } }
                    }
                    (fenders(berthings, own))
                }
            }
            (super::followed::table(own))
        }
    }
}

fn distances(own: &Berthing) -> Markup {
    let mut series: Vec<Series> = own
        .curves
        .readings
        .iter()
        .enumerate()
        .map(|(style, (name, line))| Series::dots(name, points(line, 1.0)).styled(style))
        .collect();
    series
        .push(Series::line("hull to the nearest fender", points(&own.curves.gap_m, 1.0)).styled(6));
    let touch = vec![Point { x: 0.0, y: 0.0 }];
    series.push(Series::marks("first touch", touch).styled(1));
    Chart {
        title: "Distance".to_owned(),
        x: time_axis(own),
        y: Axis::new("distance", "m").including(0.0),
        series,
        references: Vec::new(),
        linked: None,
        note: String::new(),
    }
    .render()
}

/// The same times for both charts.
fn time_axis(own: &Berthing) -> Axis {
    let lines = own.curves.readings.iter().map(|(_, line)| line).chain([&own.curves.speed_mps]);
    let axis = Axis::new("time from the first touch", "s").tight();
    lines.flatten().fold(axis, |axis, (t_s, _)| axis.including(*t_s))
}

fn speeds(own: &Berthing) -> Markup {
    let curves = &own.curves;
    let touch = vec![Point { x: 0.0, y: 100.0 * own.touch.speed_mps.value }];
    let mut references = Vec::new();
    if let Ok(run) = &own.run {
        let label = format!("run {}", fixed(100.0 * run.speed_mps, 1));
        references.push(Reference { label, value: 100.0 * run.speed_mps });
    }
    Chart {
        title: "Speed of the point of contact towards the quay".to_owned(),
        x: time_axis(own),
        y: Axis::new("speed", "cm/s").including(0.0),
        series: vec![
            Series::band(
                "two deviations",
                points(&curves.speed_low_mps, 100.0),
                points(&curves.speed_high_mps, 100.0),
            )
            .styled(6),
            Series::line("speed", points(&curves.speed_mps, 100.0)).styled(0),
            Series::marks("first touch", touch).styled(1),
        ],
        references,
        linked: None,
        note: String::new(),
    }
    .render()
}

fn fenders(berthings: &Berthings, own: &Berthing) -> Markup {
    let Ok(run) = &own.run else { return html! {} };
    let berth = &berthings.berths[own.berth];
    let heads = [
        Head::Name("Fender in the run"),
        Head::Number("Reaction", "kN"),
        Head::Number("Deflection", "mm"),
        Head::Number("Energy", "kJ"),
        Head::Number("Share of rating", "%"),
    ];
    html! {
        div class="wide" { table class="narrow" {
            (table_head(&heads))
            tbody { @for of in &run.fenders { tr {
                td class="name" { (berth.fender(of.fender)) }
                td class="number" { (fixed(of.reaction_n / 1e3, 0)) }
                td class="number" { (fixed(of.deflection_m * 1e3, 0)) }
                td class="number" { (fixed(of.energy_j / 1e3, 1)) }
                td class="number" { @match of.governing {
                    Some((quantity, share)) => { (fixed(100.0 * share, 0)) small class=[(share > 1.0).then_some("over")] { (quantity) } }
                    None => "–",
                } }
            } } }
        } }
    }
}
