//! The report's table of fenders, and the sources of their data.

use std::collections::{BTreeMap, BTreeSet};

use fenderline_contact::Unloading;
use fenderline_sim::{FenderSetup, FenderSource, FenderSummary, HullPressure, Setup};
use maud::{Markup, html};

use crate::plot::{fixed, plain};
use crate::run_page::quantities;
use crate::table::breakable;
use crate::{Head, table_head};
use fenderline_results::{FENDERS, FenderVerdict, Outcome, worst_first};

/// Largest number of shown fenders; if there are more, the most used are shown.
const ROWS: usize = 40;

/// The table with one row for each fender in the order of the scenario; the most used fender is marked.
pub(super) fn table(outcome: &Outcome<'_>) -> Markup {
    let setups = &outcome.setup.fenders;
    let order = worst_first(setups, outcome.fenders);
    let worst = order.first().map(|&i| outcome.fenders[i].fender);
    let shown = shown(outcome, &order);
    let one_kind = setups.iter().all(|fender| kind_of(fender) == kind_of(&setups[0]));
    html! {
        @if one_kind && setups.len() > 1 {
            p { (setups.len()) " fenders of one type: " (kind_of(&setups[0])) "." }
        }
        div class="wide" {
            table class="fenders" {
                (table_head(&heads()))
                tbody {
                    @for &index in &shown {
                        @let summary = outcome.fenders.iter().find(|f| f.fender == index);
                        tr class=[(worst == Some(index) && setups.len() > 1).then_some("strong")] {
                            (cells(outcome, index, summary, !one_kind || setups.len() == 1))
                        }
                    }
                }
            }
        }
        ul class="note" {
            @if setups.len() > 1 && worst.is_some() { li { "The most used fender is marked." } }
            li { strong { "Verdict" } ". Below the verdict stands the quantity that governs, \
                with its share of the rated value." }
            @if setups.len() > shown.len() {
                li {
                    (format!(
                        "The table has the {} most used of {} fenders; all fenders that were \
                         touched are in summary.json.",
                        shown.len(),
                        setups.len(),
                    ))
                }
            }
            li {
                "Values are peaks, sub-steps included. The share below each value is the share of \
                 the rated deflection, of the rated reaction or energy times its factor, or of the \
                 permissible hull pressure. The share of the rating in the catalogue, without the \
                 factors of this run, stands in brackets if it differs."
            }
            li {
                strong { "Deflection" }
                ". The deflection is the mean over the width for a fender with a curve, that of \
                 the deepest point for a fender by area"
                @if setups.iter().any(|fender| fender.panel.is_some()) {
                    ", and the deflection of the most compressed cone for a panel on several \
                     cones. The shares of rated deflection, energy and reaction are then those of \
                     this cone too"
                }
                "."
            }
            (hull_pressure_note(setups))
            li { strong { "Approach" } ". The approach is the speed, and the angle between face and hull, at the first touch." }
            li {
                strong { "Factor" }
                ". The factor is the product of the factors of temperature, tolerance, speed and angle, on the \
                 reaction and, in the line below, on the energy. In some families of fenders the angle has \
                 another factor on the energy."
            }
        }
    }
}

/// The note that says how the hull pressures were computed, for each method that applies to one of the fenders.
fn hull_pressure_note(setups: &[FenderSetup]) -> Markup {
    let any = |wanted: fn(&HullPressure) -> bool| setups.iter().any(|f| wanted(&f.hull_pressure));
    let limit_of = |fender: &FenderSetup| fender.hull_pressure_limit_npm2;
    let limit = setups.iter().find_map(limit_of);
    html! {
        @if let Some(limit_npm2) = limit && setups.iter().all(|f| limit_of(f) == limit) {
            li {
                strong { "Hull pressure" }
                ": the permissible value is " (plain(limit_npm2 / 1e3, 4)) " kN/m²."
            }
        }
        @if any(|way| matches!(way, HullPressure::OverFace)) {
            li {
                strong { "Hull pressure" }
                ". For a fender with a panel, the pressure is the reaction of the fender divided by \
                 the area of its face."
            }
        }
        @if any(|way| matches!(way, HullPressure::Inner { .. })) {
            li {
                strong { "Hull pressure" }
                ". For a pneumatic fender, the pressure is the internal pressure, interpolated \
                 linearly from the initial pressure at no deflection to the published pressure at \
                 the rated deflection. The true curve is convex: the line is conservative up to \
                 the rated deflection, and not beyond."
            }
        }
        @if any(|way| matches!(way, HullPressure::Unknown)) {
            li {
                strong { "Hull pressure" }
                ". The sign – stands for a fender without a panel whose data give no hull pressure."
            }
        }
    }
}

/// The fenders to show, in the order of the scenario.
fn shown(outcome: &Outcome<'_>, order: &[usize]) -> Vec<usize> {
    let touched = order.iter().map(|&i| outcome.fenders[i].fender);
    let untouched = (0..outcome.setup.fenders.len())
        .filter(|index| outcome.fenders.iter().all(|f| f.fender != *index));
    let mut shown: Vec<usize> = touched.chain(untouched).take(ROWS).collect();
    shown.sort_unstable();
    shown
}

fn cells(
    outcome: &Outcome<'_>,
    index: usize,
    summary: Option<&FenderSummary>,
    names_kind: bool,
) -> Markup {
    let fender = &outcome.setup.fenders[index];
    html! {
        td class="name" {
            (breakable(&fender.name))
            @if names_kind { small { (kind_of(fender)) } }
        }
        @if let Some(summary) = summary {
            @let verdict = FenderVerdict::of(fender, summary);
            (quantities::cells(&FENDERS, fender, summary, outcome.setup.step_s))
            td class="number" {
                (fixed(summary.approach_speed_mps, 3))
                small { (fixed(summary.approach_angle_rad.to_degrees(), 1)) "°" }
            }
            td class="number" {
                (fixed(summary.factor, 3))
                small { (fixed(energy_factor(fender, summary), 3)) }
            }
            td {
                span class={ "verdict " (verdict.key()) } { (verdict.text()) }
                @if let Some((quantity, share)) = summary.governing() {
                    small class="line" { (quantity) " " (fixed(100.0 * share, 0)) " %" }
                }
            }
        } @else {
            td class="untouched" colspan=(heads().len() - 1) { "not touched" }
        }
    }
}

/// The factor on the rated energy; for a fender without a rating, the factor on the reaction.
fn energy_factor(fender: &FenderSetup, summary: &FenderSummary) -> f64 {
    let two = summary.capacity_j.zip(fender.rated);
    two.map_or(summary.factor, |(capacity_j, rated)| capacity_j / rated.energy_j)
}

fn heads() -> Vec<Head<'static>> {
    let mut heads = vec![Head::Name("Fender")];
    heads.extend(quantities::heads(&FENDERS));
    heads.extend([
        Head::Number("Approach", "m/s, deg"),
        Head::Number("Factor", "reaction, energy"),
        Head::Text("Verdict", ""),
    ]);
    heads
}

/// Type and size of a fender, or the size of its face if no type is given.
pub(in crate::run_page) fn kind_of(fender: &FenderSetup) -> String {
    match &fender.source {
        Some(source) => source.designation.clone(),
        None => format!(
            "{} × {} m, projects {} m",
            plain(fender.width_m, 3),
            plain(fender.height_m, 3),
            plain(fender.projection_m, 3)
        ),
    }
}

/// The sources of the fenders' data, each source once. Data that were not read in a source are marked. Nothing without
/// fenders.
pub(in crate::run_page) fn data(setup: &Setup) -> Markup {
    if setup.fenders.is_empty() {
        html! {}
    } else {
        sources(&setup.fenders)
    }
}

/// The fender data that have to be checked, each once.
pub(in crate::run_page) fn to_check(setup: &Setup) -> Vec<String> {
    let sources = setup.fenders.iter().filter_map(|fender| fender.source.as_ref());
    let doubtful = sources.filter(|source| {
        source.standing.contains("recalled") || source.standing.contains("derived")
    });
    let texts: BTreeSet<String> = doubtful
        .map(|source| format!("Fender {}: {}", source.designation, source.standing))
        .collect();
    texts.into_iter().collect()
}

/// The list of sources of the given fenders' data, each source once. Data that were not read in a source are marked.
fn sources(setups: &[FenderSetup]) -> Markup {
    let mut designations: BTreeMap<(&str, String), &FenderSource> = BTreeMap::new();
    for fender in setups {
        if let Some(source) = &fender.source {
            designations.entry((&source.designation, returned(fender))).or_insert(source);
        }
    }
    let is_unnamed = setups.iter().any(|fender| fender.source.is_none());
    html! {
        h3 { "Fender data" }
        ul class="plain" {
            @for ((designation, returned), source) in &designations {
                li {
                    (designation) ": " (source.source) " – "
                    (standing(&source.standing))
                    ". " (returned)
                }
            }
            @if designations.values().any(|source| source.standing.contains("rating given")) {
                li { "Rating given: the rated reaction is from the scenario, on the curve of the family." }
            }
            @if is_unnamed { li { "Data of fenders without a type are from the scenario." } }
        }
    }
}

/// The sentence on the energy that the fender returns; empty for a fender without an unloading law.
fn returned(fender: &FenderSetup) -> String {
    match &fender.unloading {
        None => String::new(),
        Some(Unloading::ReturnedEnergy(share)) => {
            format!("The rubber returns {} % of the absorbed energy.", plain(100.0 * share, 3))
        }
        Some(Unloading::Curve(_)) => "The rubber returns energy by the unloading curve.".to_owned(),
    }
}

/// Says how certain a fender's data are. The curve may be less certain than the rating, as in `curve recalled, rating
/// given`. Data that
/// were not read in a source are marked.
fn standing(standing: &str) -> Markup {
    let holds = |word: &str| standing.contains(word);
    html! {
        @if holds("recalled") {
            strong { (standing) ": check it against the document before use" }
        } @else if holds("derived") {
            strong { (standing) ": computed from other data" }
        } @else {
            (standing)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_that_was_not_read_in_a_source_is_marked() {
        let marked = |text: &str| standing(text).into_string().contains("<strong>");
        for text in ["recalled", "curve recalled, rating given", "derived"] {
            assert!(marked(text), "{text}");
        }
        for text in ["found", "given", "curve found, rating given"] {
            assert!(!marked(text), "{text}");
        }
    }
}
