//! The report's statistics of motions, the limits of a scenario, and the load cycles of mooring lines.

use fenderline_results::Outcome;
use fenderline_sim::seakeeping::Seakeeping;
use fenderline_sim::statistics::{MotionName, MotionStatistics, RAINFLOW_BINS};
use maud::{Markup, html};

use crate::plot::{fixed, plain};
use crate::run_page::tables::{ROWS, number};
use crate::{Head, table_head};

/// The tables of motions and limits, if the scenario asks for statistics.
pub(super) fn section(outcome: &Outcome<'_>) -> Markup {
    let Some(statistics) = outcome.statistics else { return html! {} };
    let setup = outcome.setup;
    html! {
        (limits(outcome))
        @for (index, vessel) in setup.world.vessels.iter().enumerate().take(ROWS) {
            h3 { "Motions of " (setup.bodies[vessel.body].name) }
            (motions(&statistics.motions(index, setup.step_s)))
            @if let Some(ship) = &vessel.seakeeping {
                (data(&setup.bodies[vessel.body].name, ship))
            } @else {
                p {
                    span class="verdict over_rated" { "NO HYDRODYNAMIC DATA" }
                    (format!(
                        " Heave, roll and pitch of {} are oscillators that do not act on the motion \
                         in the plane. ",
                        setup.bodies[vessel.body].name,
                    ))
                    "In surge, sway and yaw, waves push only by their mean drift: these motions \
                     are not the motions of a moored ship in waves."
                }
            }
        }
        p class="note" {
            (format!(
                "The motions are about the mean, from {} s on; surge and sway are those of the \
                 centre of gravity, along and across the mean heading. ",
                plain(statistics.from_s(), 6),
            ))
            "A peak is the \
                largest distance from the mean between two crossings of the mean, a range the \
                distance from a crest to the next trough; significant is the mean of the highest \
                third."
        }
    }
}

/// The note on what a vessel's hydrodynamic data contain and lack.
fn data(name: &str, ship: &Seakeeping) -> Markup {
    html! {
        p class="note" {
            (format!(
                "{name} moves in six degrees of freedom by her hydrodynamic data ({} frequencies, {}). ",
                ship.data.radiation().count(),
                match ship.data.depth_m() {
                    Some(depth_m) => format!("{} m of water", plain(depth_m, 4)),
                    None => "deep water".to_owned(),
                },
            ))
            @if ship.data.has_drift() {
                "Slow drift is computed from the mean drift of the data by Newman's approximation. \
                 "
            } @else {
                "The data have no mean drift, which is therefore estimated. "
            }
            (format!(
                "The data include waves that a quay reflects only if the quay was part of the \
                 panel run. Viscous damping of roll is {} % of the critical damping.",
                plain(100.0 * ship.roll_damping, 3),
            ))
        }
    }
}

fn motions(all: &[MotionStatistics; 6]) -> Markup {
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Motion"),
                    Head::Number("Maximum", "from the mean"),
                    Head::Number("Significant", "amplitude"),
                    Head::Number("Standard deviation", ""),
                    Head::Number("Largest range", ""),
                    Head::Number("Significant range", ""),
                    Head::Number("Zero-crossing period", "s"),
                    Head::Number("Peaks", ""),
                ]))
                tbody {
                    @for (name, of) in MotionName::ALL.into_iter().zip(all) {
                        @let (unit, factor) = if name.is_angle() { ("deg", 1.0_f64.to_degrees()) } else { ("m", 1.0) };
                        tr {
                            td class="name" { (name.word()) " [" (unit) "]" }
                            @for value in [
                                of.maximum, of.significant, of.deviation, of.maximum_range, of.significant_range,
                            ] {
                                (number(&fixed(factor * value, 3)))
                            }
                            (number(&if of.zero_crossing_s > 0.0 { fixed(of.zero_crossing_s, 1) } else { "–".into() }))
                            (number(&of.peaks.to_string()))
                        }
                    }
                }
            }
        }
    }
}

fn limits(outcome: &Outcome<'_>) -> Markup {
    let limits = &outcome.setup.world.statistics.limits;
    html! {
        @if !limits.is_empty() {
            h3 { "Limits of the scenario" }
            div class="wide" {
                table {
                    (table_head(&[
                        Head::Name("Limit"),
                        Head::Name("Of"),
                        Head::Number("Found", ""),
                        Head::Number("Limit", ""),
                        Head::Text("Verdict", ""),
                    ]))
                    tbody {
                        @for (limit, value) in limits.iter().zip(outcome.limit_values) {
                            tr {
                                td class="name" { (limit.name) }
                                td class="name" { (limit.subject(outcome.setup)) }
                                (number(&limit.shown(*value)))
                                (number(&limit.shown(limit.most)))
                                td {
                                    @if *value > limit.most { span class="verdict over_rated" { "exceeded" } }
                                    @else { span class="verdict ok" { "kept" } }
                                }
                            }
                        }
                    }
                }
            }
            p class="note" { "The limits come from the scenario." }
        }
    }
}

/// The table of the mooring lines' load cycles by the range of their tension, if the scenario asks for statistics.
pub(super) fn cycles(outcome: &Outcome<'_>) -> Markup {
    let Some(statistics) = outcome.statistics else { return html! {} };
    let lines = outcome.setup.world.lines.iter().zip(&statistics.lines).take(ROWS);
    let counted: Vec<_> = lines.map(|(line, counts)| (&line.line.name, counts.cycles())).collect();
    // Ranges in which no line has a cycle have no column.
    let bins: Vec<usize> = (0..RAINFLOW_BINS)
        .filter(|&bin| counted.iter().any(|(_, cycles)| cycles[bin] > 0.0))
        .collect();
    let width = 100 / RAINFLOW_BINS;
    let heads: Vec<String> =
        bins.iter().map(|bin| format!("{}–{}", bin * width, (bin + 1) * width)).collect();
    let heads = heads.iter().map(|head| Head::Number(head, "%"));
    let heads: Vec<Head<'_>> = std::iter::once(Head::Name("Line")).chain(heads).collect();
    html! {
        h3 { "Cycles of the lines" }
        @if bins.is_empty() {
            p class="note" { "No line has a cycle." }
        } @else {
            div class="wide" {
                table {
                    (table_head(&heads))
                    tbody {
                        @for (name, cycles) in &counted {
                            tr {
                                td class="name" { (name) }
                                @for &bin in &bins {
                                    (number(&if cycles[bin] > 0.0 { fixed(cycles[bin], 1) } else { "–".into() }))
                                }
                            }
                        }
                    }
                }
            }
            p class="note" {
                (format!(
                    "Cycles by the range of the tension as a share of the break load, by rainflow \
                     counting, from {} s on; cycles that are open at the end count as half cycles. ",
                    plain(statistics.from_s(), 6),
                ))
                "The report does not contain a fatigue law of ropes."
            }
        }
    }
}
