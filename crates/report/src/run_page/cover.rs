//! The report's title page: kind of document, verdict, governing numbers, a picture.

use fenderline_sim::constants::KNOT_MPS;
use maud::{Markup, html};

use super::governing::{Governing, governing};
use super::harbour_key::harbour;
use super::recorder::Recorder;
use super::tables::{TONNE_N, number};
use super::{approach, exercise, scene, session, verdict};
use crate::plot::{decimals_for, fenders_legend, fixed, ordinal, outlined_legend, significant};
use crate::words::interrupted_text;
use crate::{Head, table_head};
use fenderline_results::Outcome;

/// Longest text of a detail that shares its line with another detail (characters).
const HALF_LINE: usize = 26;

/// The title page.
pub(super) fn cover(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    html! {
        section class="cover" {
            p class="kicker" { "Ship contact simulation" }
            h1 { (outcome.title) }
            (details(outcome))
            (approach::sentences(outcome))
            (verdict::headline(outcome))
            (exercise::headline(outcome))
            @if let Some(interrupted) = &outcome.interrupted {
                p { strong { "Interrupted: " } (interrupted_text(interrupted)) "." }
            }
            (numbers(outcome, &governing(outcome)))
            div class="picture" {
                (scene::first(outcome, recorder))
                (outlined_legend())
                @if !outcome.setup.fenders.is_empty() { (fenders_legend()) }
                (harbour(outcome))
            }
        }
    }
}

/// The details of the document, such as project and client. Scenario and program are always given.
fn details(outcome: &Outcome<'_>) -> Markup {
    html! {
        dl class="details" {
            @for (key, text) in outcome.report { (detail(&detail_label(key), text)) }
            (detail("Scenario", outcome.scenario_file))
            @if let Some(recorded) = outcome.session {
                (detail("Session", &session::name(recorded)))
            }
            (detail("Computed by", concat!("fenderline ", env!("CARGO_PKG_VERSION"))))
        }
    }
}

/// A detail of the title page. A long detail takes the whole width.
fn detail(label: &str, text: &str) -> Markup {
    let is_long = text.chars().count() > HALF_LINE;
    html! { div class=[is_long.then_some("long")] { dt { (label) } dd { (text) } } }
}

/// The label of a detail on the title page, from its key.
#[must_use]
pub fn detail_label(key: &str) -> String {
    let text = match key {
        "number" => "document number".to_owned(),
        key => key.replace('_', " "),
    };
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn numbers(outcome: &Outcome<'_>, governing: &[Governing]) -> Markup {
    if governing.is_empty() {
        return html! {};
    }
    let decimals = decimals_for(outcome.setup.step_s);
    html! {
        h3 { "Governing numbers" }
        table class="governing" {
            (table_head(&[
                Head::Name("Quantity"),
                Head::Name("Of"),
                Head::Number("Value", ""),
                Head::Number("Share of limit", ""),
                Head::Number("At", "s"),
            ]))
            tbody {
                @for row in governing {
                    tr {
                        td class="name" { (row.quantity) }
                        td class="name" { (if row.subject.is_empty() { "–" } else { &row.subject }) }
                        (number(&value(row)))
                        td class="number" {
                            @match row.share {
                                Some((share, of)) => {
                                    strong class=[row.is_over.then_some("over")] {
                                        (fixed(100.0 * share, 0)) " %"
                                    }
                                    " of " (of)
                                }
                                None => "–",
                            }
                        }
                        (number(&time(row, decimals)))
                    }
                }
            }
        }
    }
}

/// The time of a governing number, and the hit of the berthing in which it occurred.
fn time(row: &Governing, decimals: usize) -> String {
    let at = row.at_s.map_or_else(|| "–".to_owned(), |at_s| fixed(at_s, decimals));
    row.hit.map_or(at.clone(), |hit| format!("{at}, {} hit", ordinal(hit)))
}

/// The text of a governing number with its unit, also in tonnes or knots where mariners use them.
fn value(row: &Governing) -> String {
    match row.unit {
        "m/s" => {
            let knots = fixed(row.value / KNOT_MPS, 2);
            format!("{} m/s ({knots} kn)", fixed(row.value, 3))
        }
        "kN" if row.quantity.ends_with("of highest share") => {
            let tonnes = significant(row.value * 1e3 / TONNE_N, 3);
            format!("{} kN ({tonnes} t)", significant(row.value, 4))
        }
        "m" => format!("{} m", fixed(row.value, 2)),
        "mm" => format!("{} mm", fixed(row.value, 0)),
        unit => format!("{} {unit}", significant(row.value, 4)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_words() {
        assert_eq!(detail_label("checked_by"), "Checked by");
        assert_eq!(detail_label("number"), "Document number");
        assert_eq!(detail_label("client"), "Client");
    }
}
