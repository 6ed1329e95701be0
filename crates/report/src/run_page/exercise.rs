//! The exercise in the report: its result on the title page, and each condition and limit with its deduction.

use fenderline_results::Outcome;
use fenderline_sim::Setup;
use fenderline_sim::exercise::{Assessment, Deduction, Limit, Mark, Measure};
use maud::{Markup, html};

use super::tables::number;
use crate::plot::fixed;
use crate::{Head, table_head};

/// The result of the exercise in a sentence, and the deductions; empty if there is no exercise.
pub(super) fn headline(outcome: &Outcome<'_>) -> Markup {
    let Some(exercise) = outcome.exercise else { return html! {} };
    let class = match exercise.is_passed() {
        Some(true) => "ok",
        Some(false) => "failed",
        None => "not_rated",
    };
    html! {
        div class={ "banner " (class) } {
            p class="headline" { span class="label" { "Exercise" } " " strong { (exercise.sentence()) } }
            @if exercise.deductions().next().is_some() {
                ul class="plain" {
                    @for deduction in exercise.deductions() {
                        li { "−" (fixed(deduction.points, 1)) ": " (deduction.sentence(outcome.setup)) "." }
                    }
                }
            }
        }
    }
}

/// The tables of the exercise's goal and limits.
pub(super) fn section(outcome: &Outcome<'_>) -> Markup {
    let Some(exercise) = outcome.exercise else { return html! {} };
    let of = exercise.setup();
    html! {
        h2 { "Exercise" }
        @if !of.task.is_empty() { p { (of.task) } }
        (goal(exercise))
        @if !of.limits.is_empty() {
            h3 { "Limits" }
            (limits(exercise, outcome.setup))
            p class="note" {
                (format!(
                    "The score begins at 100. A limit that is exceeded costs points in proportion \
                     to the excess; from the limit's worst value on, the limit costs all its points. \
                     The exercise is passed if the goal is reached with {} points and no limit is exceeded that \
                     decides the exercise. What happened after the end of the exercise does not \
                     count.",
                    fixed(of.pass_mark, 0),
                ))
            }
        }
    }
}

fn goal(exercise: &Assessment) -> Markup {
    let of = exercise.setup();
    let when = match exercise.state().ended_s() {
        Some(_) => "At the end of the exercise",
        None => "At the end of the run",
    };
    html! {
        table {
            (table_head(&[Head::Name("Goal"), Head::Name(when), Head::Name("")]))
            tbody {
                @for (condition, now) in of.goal.iter().zip(exercise.conditions()) {
                    tr {
                        td class="name" { (condition.words()) }
                        td class="name" { (now.now) }
                        td { @if now.is_met { "fulfilled" } @else { strong { "not fulfilled" } } }
                    }
                }
            }
        }
        @if of.hold_s > 0.0 {
            p class="note" {
                (format!(
                    "The goal is reached when all conditions hold together for {} s.",
                    fixed(of.hold_s, 0),
                ))
            }
        }
    }
}

fn limits(exercise: &Assessment, setup: &Setup) -> Markup {
    let deductions: Vec<Deduction<'_>> = exercise.deductions().collect();
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Limit"),
                    Head::Name("Rule"),
                    Head::Name("Worst"),
                    Head::Name("Of"),
                    Head::Number("At", "min:s"),
                    Head::Number("First exceeded", "min:s"),
                    Head::Number("Exceeded for", "s"),
                    Head::Number("Points", ""),
                ]))
                tbody {
                    @for (limit, mark) in exercise.setup().limits.iter().zip(exercise.marks()) {
                        @let deduction = deductions.iter().find(|of| of.limit == limit);
                        (row(limit, mark, deduction, setup))
                    }
                    tr class="strong" {
                        td class="name" colspan="7" { "Score" }
                        (number(&fixed(exercise.score(), 1)))
                    }
                }
            }
        }
    }
}

fn row(limit: &Limit, mark: &Mark, deduction: Option<&Deduction<'_>>, setup: &Setup) -> Markup {
    let none = || "–".to_owned();
    // That nothing was touched has no time.
    let shown = mark.worst.filter(|_| limit.measure != Measure::Touch || deduction.is_some());
    let worst = mark.worst.map(|(value, ..)| limit.measure.value_text(value));
    let whose = shown.map(|(_, subject, _)| subject.name(setup));
    let at = shown.map(|(.., at_s)| super::session::clock(at_s));
    let first = mark.first_s.map(super::session::clock);
    let lasting = (mark.lasting_s > 0.0).then(|| fixed(mark.lasting_s, 1));
    let of = fixed(limit.points, 0);
    let taken = match deduction {
        Some(deduction) => format!("−{} of {of}", fixed(deduction.points, 1)),
        None => format!("0 of {of}"),
    };
    html! {
        tr {
            td class="name" { (limit.measure.text()) @if limit.fails { " (decides)" } }
            td class="name" { (limit.words()) }
            td class="name" {
                @if deduction.is_some() { strong class="over" { (worst.unwrap_or_else(none)) } }
                @else { (worst.unwrap_or_else(none)) }
            }
            td class="name" { (whose.unwrap_or_else(none)) }
            (number(&at.unwrap_or_else(none)))
            (number(&first.unwrap_or_else(none)))
            (number(&lasting.unwrap_or_else(none)))
            (number(&taken))
        }
    }
}
