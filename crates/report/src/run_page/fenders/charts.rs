//! Charts of the fenders: use of the ratings, reactions over time, and reaction against deflection.

use fenderline_contact::number::greater;
use fenderline_contact::{FenderLaw, Unloading};
use fenderline_sim::{FenderSetup, FenderSummary};
use maud::{Markup, html};

use super::table::kind_of;
use crate::plot::{Axis, Bars, Chart, Group, Point, STYLES, Series, significant};
use crate::run_page::charts::{Charts, scaled};
use crate::run_page::recorder::{FenderTrace, Recorder};
use fenderline_results::Outcome;
use fenderline_results::worst_first;

/// Largest number of fenders with bars.
const BARS: usize = 16;
/// Largest number of diagrams of reaction against deflection, one per type of fender.
const DIAGRAMS: usize = 4;

/// The bar chart of the use of ratings: one group of bars per fender, in the order of the scenario; empty if no fender
/// has a rating.
pub(super) fn utilisation(outcome: &Outcome<'_>) -> Markup {
    let setups = &outcome.setup.fenders;
    let rated = |f: &&FenderSummary| {
        f.share_of_rated_energy.is_some() || f.share_of_hull_pressure.is_some()
    };
    let order = worst_first(setups, outcome.fenders);
    let mut shown: Vec<&FenderSummary> =
        order.iter().map(|&i| &outcome.fenders[i]).filter(rated).collect();
    let all = shown.len();
    shown.truncate(BARS);
    shown.sort_by_key(|f| f.fender);
    if shown.is_empty() {
        return html! {};
    }
    let has_pressure = shown.iter().any(|f| f.share_of_hull_pressure.is_some());
    let mut kinds = vec!["energy", "reaction", "deflection"];
    if has_pressure {
        kinds.push("hull pressure");
    }
    let groups = shown.iter().map(|f| {
        let mut shares =
            vec![f.share_of_rated_energy, f.share_of_rated_reaction, f.share_of_rated_deflection];
        if has_pressure {
            shares.push(f.share_of_hull_pressure);
        }
        let values = shares.into_iter().map(|share| share.map(|s| 100.0 * s)).collect();
        Group { name: setups[f.fender].name.clone(), values }
    });
    Bars {
        title: "Use of the fenders".to_owned(),
        kinds,
        groups: groups.collect(),
        axis: "peak as a share of its limit [%]",
        note: if all > shown.len() {
            format!("The {} most used of {all} touched fenders are shown.", shown.len())
        } else {
            String::new()
        },
    }
    .render()
}

/// The chart of reactions over time, for the fenders with the largest reactions.
pub(super) fn reactions(charts: &Charts<'_>, recorder: &Recorder) -> Markup {
    let outcome = charts.outcome;
    let mut traces: Vec<(f64, &FenderTrace)> = recorder
        .fenders
        .iter()
        .map(|trace| (Series::line("", trace.reaction_n.points()).largest(), trace))
        .collect();
    traces.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.fender.cmp(&b.1.fender)));
    traces.truncate(STYLES);
    traces.sort_by_key(|(_, trace)| trace.fender);
    let drawn = traces.len();
    let series = traces.into_iter().map(|(_, trace)| {
        let name = &outcome.setup.fenders[trace.fender].name;
        Series::line(name, trace.reaction_n.points())
    });
    let (unit, series) = scaled(series.collect(), "N");
    let axis = Axis::new("reaction", &unit).including(0.0);
    let mut chart = charts.chart("Reactions of the fenders", axis, series);
    if outcome.fenders.len() > drawn {
        let all = outcome.fenders.len();
        chart.note = format!(
            "The {drawn} fenders with the largest reactions are shown, of {all} touched fenders."
        );
    }
    chart.render()
}

/// The chart of the turns of panels on several cones over time; empty if no panel turned.
pub(super) fn turns(charts: &Charts<'_>, recorder: &Recorder) -> Markup {
    let setups = &charts.outcome.setup.fenders;
    let in_degrees = |p: &Point| Point { x: p.x, y: p.y.to_degrees() };
    let series = recorder.held.panels.iter().map(|trace| {
        Series::line(&setups[trace.fender].name, trace.tilt_rad.points()).mapped(in_degrees)
    });
    let series = largest(series.collect());
    if series.is_empty() {
        return html! {};
    }
    let axis = Axis::new("turn", "deg").including(0.0);
    charts.chart("Turns of the panels", axis, series).render()
}

/// The chart of the tensions of fender chains over time; empty if no chain was taut.
pub(super) fn tensions(charts: &Charts<'_>, recorder: &Recorder) -> Markup {
    let setups = &charts.outcome.setup.fenders;
    let series = recorder.held.chains.iter().map(|trace| {
        let fender = &setups[trace.fender];
        let kind = fender.chains[trace.chain].kind;
        let of_kind = fender.chains.iter().filter(|chain| chain.kind == kind).count();
        let number = if of_kind > 1 { format!(" {}", trace.chain + 1) } else { String::new() };
        Series::line(&format!("{}, {}{number}", fender.name, kind.word()), trace.tension_n.points())
    });
    let series = largest(series.collect());
    if series.is_empty() {
        return html! {};
    }
    let (unit, series) = scaled(series, "N");
    let axis = Axis::new("tension", &unit).including(0.0);
    charts.chart("Tensions of the chains", axis, series).render()
}

/// Selects the series with the largest values, as many as can be told apart, and keeps their order; a series of zeros
/// is left out.
fn largest(series: Vec<Series>) -> Vec<Series> {
    let mut all: Vec<(usize, Series)> =
        series.into_iter().filter(|line| line.largest() > 0.0).enumerate().collect();
    all.sort_by(|a, b| b.1.largest().total_cmp(&a.1.largest()).then(a.0.cmp(&b.0)));
    all.truncate(STYLES);
    all.sort_by_key(|(place, _)| *place);
    all.into_iter().map(|(_, line)| line).collect()
}

/// For the most used fender of each type, a diagram of its reaction curve and of the path during the run.
pub(super) fn diagrams(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    let setups = &outcome.setup.fenders;
    let mut worst: Vec<&FenderSummary> = Vec::new();
    for index in worst_first(setups, outcome.fenders) {
        let summary = &outcome.fenders[index];
        let is_new =
            |other: &&FenderSummary| !is_same_type(&setups[other.fender], &setups[summary.fender]);
        if worst.len() < DIAGRAMS && worst.iter().all(is_new) {
            worst.push(summary);
        }
    }
    worst.sort_by_key(|f| f.fender);
    html! {
        @for summary in worst {
            @if let Some(trace) = recorder.fenders.iter().find(|t| t.fender == summary.fender) {
                (diagram(&setups[summary.fender], summary, trace))
            }
        }
    }
}

fn is_same_type(a: &FenderSetup, b: &FenderSetup) -> bool {
    let designation = |f: &FenderSetup| f.source.as_ref().map(|s| s.designation.clone());
    (designation(a), &a.law, &a.rated) == (designation(b), &b.law, &b.rated)
}

fn diagram(fender: &FenderSetup, summary: &FenderSummary, trace: &FenderTrace) -> Markup {
    let path = trace.path.points();
    let mut series = vec![
        Series::line("loading", going(&path, |from, to| to.x >= from.x)),
        Series::line("unloading", going(&path, |from, to| to.x < from.x)),
    ];
    if let FenderLaw::Curve(_) = fender.law {
        let factor = significant(summary.factor, 4);
        let name = match &fender.panel {
            Some(panel) => {
                format!("{} cones equally compressed × {factor}", panel.cones_m.len())
            }
            None => format!("the fender's curve × {factor}"),
        };
        series.push(Series::line(&name, curve(fender, summary, None)));
        if let Some(unloading) = &fender.unloading {
            series
                .push(Series::line("its unloading curve", curve(fender, summary, Some(unloading))));
        }
    }
    let to_mm = |p: &Point| Point { x: p.x * 1e3, y: p.y };
    let in_mm = |s: Series| s.mapped(to_mm);
    let (unit, series) = scaled(series.into_iter().map(in_mm).collect(), "N");
    let mut note = match fender.unloading {
        Some(_) => {
            "The values are means over the time step. The area between loading and unloading is \
             the energy lost in rubber and by damping."
        }
        None => {
            "The values are means over the time step. The area between loading and unloading is \
             the energy lost to restitution, damping and the momentum limit."
        }
    }
    .to_owned();
    if let (Some(unloading), Some(rated)) = (&fender.unloading, fender.rated) {
        let share = unloading.returned_share(&fender.law, rated.deflection_m);
        note.push_str(&format!(
            " The rubber of the fender returns {} % of the energy that it absorbs up to its rated deflection.",
            significant(100.0 * share, 3)
        ));
    }
    if fender.panel.is_some() {
        note.push_str(" The deflection is of the most compressed cone, the reaction of all cones.");
    }
    if fender.law == FenderLaw::Area {
        note.push_str(
            " The deflection is of the deepest point of the face. The reaction follows from the \
             overlap of the whole face, and is less if the hull is at an angle.",
        );
    }
    if let Some(rated) = fender.rated {
        note.push_str(&format!(
            " Rated: {} mm, {} kN, {} kJ before factors.",
            significant(rated.deflection_m * 1e3, 3),
            significant(rated.reaction_n / 1e3, 3),
            significant(rated.energy_j / 1e3, 3)
        ));
    }
    Chart {
        title: format!("Reaction against deflection, {} ({})", fender.name, kind_of(fender)),
        x: Axis::new("deflection", "mm").including(0.0),
        y: Axis::new("reaction", &unit).including(0.0),
        series,
        references: Vec::new(),
        linked: None,
        note,
    }
    .render()
}

/// The parts of a path whose segments satisfy `wanted`, with breaks between the parts.
fn going(path: &[Point], wanted: fn(&Point, &Point) -> bool) -> Vec<Point> {
    let mut points: Vec<Point> = Vec::new();
    for two in path.windows(2).filter(|two| wanted(&two[0], &two[1])) {
        if points.last() != Some(&two[0]) {
            points.push(Point { x: f64::NAN, y: f64::NAN });
            points.push(two[0]);
        }
        points.push(two[1]);
    }
    points
}

/// The reaction curve that the run used for a fender: the catalogue curve times the fender's reaction factor, with the
/// rise at the fender's stop. The curve ends at the larger of peak and rated deflection. With
/// `unloading`, each point of the curve is the reaction when the fender begins to unload at that deflection.
fn curve(
    fender: &FenderSetup,
    summary: &FenderSummary,
    unloading: Option<&Unloading>,
) -> Vec<Point> {
    const POINTS: u32 = 300;
    let rated_m = fender.rated.map_or(0.0, |rated| rated.deflection_m);
    let end_m = greater(summary.peak_deflection_m, rated_m);
    let at = |deflection_m: f64| {
        let past_m = fender.stop.map_or(0.0, |stop| greater(deflection_m - stop.from_m, 0.0));
        let stop_n = fender.stop.map_or(0.0, |stop| stop.stiffness_npm * past_m);
        let reaction_n = fender.law.reaction_n(deflection_m);
        let share = match unloading {
            Some(unloading) if reaction_n > 0.0 => {
                unloading.reaction_n(&fender.law, deflection_m, reaction_n) / reaction_n
            }
            _ => 1.0,
        };
        fender.cones() * summary.factor * share * (reaction_n + stop_n)
    };
    (0..=POINTS)
        .map(|k| end_m * f64::from(k) / f64::from(POINTS))
        .map(|x| Point { x, y: at(x) })
        .collect()
}
