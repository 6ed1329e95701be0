//! Statistics of motions, limits, and cycles of lines.

use fenderline_results::Outcome;
use fenderline_sim::statistics::{MotionName, MotionStatistics, RAINFLOW_BINS};
use maud::{Markup, html};

use crate::plot::{fixed, plain};
use crate::run_page::tables::{ROWS, number};
use crate::{Head, table_head};

/// The sections, if the scenario asks for statistics.
pub(super) fn section(outcome: &Outcome<'_>) -> Markup {
    let Some(statistics) = outcome.statistics else { return html! {} };
    let setup = outcome.setup;
    html! {
        @for (index, vessel) in setup.world.vessels.iter().enumerate().take(ROWS) {
            h3 { "Motions of " (setup.bodies[vessel.body].name) }
            (motions(&statistics.motions(index, setup.step_s)))
        }
        p class="note" {
            "About the mean, from " (plain(statistics.from_s(), 6)) " s; surge and sway of the centre of gravity along and across the mean "
            "heading. A peak is the largest distance from the mean between two crossings of it, a range the distance from a crest to the "
            "trough after it; significant is the mean of the highest third."
        }
        (limits(outcome))
        @if !setup.world.lines.is_empty() {
            h3 { "Cycles of the lines" }
            (cycles(outcome))
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
            p class="note" { "The limits are the scenario's own." }
        }
    }
}

fn cycles(outcome: &Outcome<'_>) -> Markup {
    let Some(statistics) = outcome.statistics else { return html! {} };
    let lines = outcome.setup.world.lines.iter().zip(&statistics.lines);
    let width = 100 / RAINFLOW_BINS;
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Line"),
                    Head::Name("Cycles by range of tension over break load"),
                ]))
                tbody {
                    @for (line, counts) in lines.take(ROWS) {
                        @let counted = counts.cycles();
                        tr {
                            td class="name" { (line.line.name) }
                            td class="name" {
                                @for (bin, cycles) in counted.iter().enumerate().filter(|(_, cycles)| **cycles > 0.0) {
                                    (bin * width) "–" ((bin + 1) * width) " %: " (fixed(*cycles, 1)) "; "
                                }
                            }
                        }
                    }
                }
            }
        }
        p class="note" { "Rainflow counts; what is open at the end counts as half cycles. Fatigue laws of ropes are the reader's." }
    }
}
