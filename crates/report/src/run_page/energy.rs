//! The energy ledger in the report.

use fenderline_contact::number::greater;

use maud::{Markup, html};

use super::charts::{Charts, scaled};
use super::recorder::Recorder;
use super::tables::number;
use crate::plot::{Axis, Series, decimals_for, fixed, significant};
use crate::{Head, table_head};
use fenderline_results::Outcome;
use fenderline_sim::LoadWork;

/// A part of the energy below this share of the largest part is not drawn, because its line would lie on zero.
const LEAST: f64 = 1e-4;

/// The split of the contacts' energy into its parts is drawn if the unexplained rest is below this share of the energy
/// given.
const LARGEST_RESIDUAL: f64 = 0.05;

/// The energy section: table and chart.
pub(super) fn section(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    html! {
        (table(outcome, recorder))
        (chart(&Charts::new(outcome), recorder))
    }
}

/// The chart of the energy over time. If the contacts' stored and lost energies do not add up, as with large explicit
/// steps, only the work of the forces is drawn, which is exact.
fn chart(charts: &Charts<'_>, recorder: &Recorder) -> Markup {
    let trace = &recorder.energy;
    let end = charts.outcome.energy;
    let given_j = recorder.start_energy.kinetic_j + end.load_work_j.abs();
    let is_split = end.contact_residual_j.abs() <= LARGEST_RESIDUAL * given_j;
    let split = [
        ("stored in springs", &trace.stored_j, 1.0),
        ("lost in rubber", &trace.hysteresis_j, 1.0),
        ("lost to restitution", &trace.restitution_j, 1.0),
        ("lost to friction", &trace.friction_j, 1.0),
        ("lost to damping", &trace.damping_j, 1.0),
        ("numerical loss, or gain (−)", &trace.residual_j, 1.0),
    ];
    let whole = [
        ("taken by normal forces", &trace.normal_work_j, -1.0),
        ("taken by friction", &trace.tangential_work_j, -1.0),
        ("residual", &trace.motion_residual_j, 1.0),
    ];
    let parts =
        [("kinetic", &trace.kinetic_j, 1.0), ("work of the loads", &trace.load_work_j, 1.0)];
    let parts = parts.into_iter().chain(if is_split { split.to_vec() } else { whole.to_vec() });
    let all = parts.enumerate().map(|(style, (name, part, sign))| {
        Series::line(name, part.points()).scaled(sign).styled(style)
    });
    let mut series: Vec<Series> = all.collect();
    let largest = series.iter().map(Series::largest).fold(0.0, greater);
    series.retain(|line| line.largest() > LEAST * largest);
    let (unit, series) = scaled(series, "J");
    let axis = Axis::new("energy", &unit).including(0.0);
    let mut chart = charts.chart("Energy over time, added mass included", axis, series);
    if !is_split {
        chart.note =
            "The energy taken by normal forces is not split further here: with this method and time \
                      step the numerical loss is more than 5 %. See the table."
                .to_owned();
    }
    chart.render()
}

/// The table of energies from start to end of the run: the energy at the start, the energy that
/// loads gave, and where the energy went.
fn table(outcome: &Outcome<'_>, recorder: &Recorder) -> Markup {
    let (start, end) = (recorder.start_energy, outcome.energy);
    let works: Vec<(&str, f64)> =
        LoadWork::CAUSES.iter().map(|cause| (cause.label, (cause.work_j)(&end.loads))).collect();
    let pushed_j: f64 = works.iter().map(|(_, work_j)| greater(*work_j, 0.0)).sum();
    let given_j = start.kinetic_j + pushed_j;
    let taken_j = pushed_j - end.load_work_j;
    let cells = |value_j: f64| {
        html! { (number(&amount(value_j, given_j))) (number(&share(value_j, given_j))) }
    };
    let row =
        |name: &str, value_j: f64| html! { tr { td class="name" { (name) } (cells(value_j)) } };
    // A part that is exactly zero has no row.
    let part = |name: &str, value_j: f64| {
        html! {
            @if value_j != 0.0 { tr class="part" { td class="name" { (name) } (cells(value_j)) } }
        }
    };
    let (most_j, at_s) = recorder.most_stored;
    html! {
        div class="wide" {
            table class="narrow" {
                (table_head(&[
                    Head::Name("Energy"),
                    Head::Number("Amount", "kJ"),
                    Head::Number("Share", "%"),
                ]))
                tbody {
                    (row("Kinetic at the start", start.kinetic_j))
                    @if recorder.has_loads() || pushed_j > 0.0 { (row("Given by loads", pushed_j)) }
                    @for &(label, work_j) in &works {
                        @if work_j > 0.0 { (part(label, work_j)) }
                    }
                    tr class="sum" { td class="name" { "Given" } (cells(given_j)) }
                    (row("Kinetic at the end", end.kinetic_j))
                    @if taken_j > 0.0 { (row("Taken by loads", taken_j)) }
                    @for &(label, work_j) in &works {
                        @if work_j < 0.0 { (part(label, -work_j)) }
                    }
                    (row("Taken by normal forces", -end.normal_work_j))
                    (part("stored in springs and stops at the end", end.stored_j))
                    (part("lost to hysteresis of fenders", end.hysteresis_j))
                    (part("lost to restitution", end.restitution_j))
                    (part("lost to damping", end.damping_j))
                    (part("given to tide, heave, roll and pitch by leaning sides", -end.height_work_j))
                    (part("numerical loss, or gain (−), of method and time step", end.contact_residual_j))
                    (row("Taken by tangential forces", -end.tangential_work_j))
                    (part("stored in shear springs at the end", end.shear_stored_j))
                    (part("lost to friction", end.friction_j))
                    (row("Residual of the motion", -end.residual_j))
                }
            }
        }
        @if end.exchanged_j() > 0.0 {
            p class="note" {
                (format!(
                    "Energies are in the ground frame, added mass included. Work is force times \
                     distance over the ground. The residual is {} % of all energy exchanged by loads \
                     and contacts.",
                    share(end.residual_j.abs(), end.exchanged_j()),
                ))
            }
        }
        @if most_j > 0.0 {
            p class="note" {
                (format!(
                    "The springs stored the most energy at {} s: {} kJ.",
                    fixed(at_s, decimals_for(outcome.setup.step_s)),
                    amount(most_j, given_j),
                ))
            }
        }
    }
}

/// The text of an energy in kJ, with as many digits as are significant beside the total energy.
fn amount(value_j: f64, of_j: f64) -> String {
    let whole_kj = (of_j / 1e3).abs();
    match whole_kj {
        whole if whole >= 1e4 => fixed(value_j / 1e3, 0),
        whole if whole >= 100.0 => fixed(value_j / 1e3, 1),
        whole if whole >= 1.0 => fixed(value_j / 1e3, 2),
        _ => significant(value_j / 1e3, 3),
    }
}

fn share(value_j: f64, of_j: f64) -> String {
    if of_j.abs() > 0.0 { fixed(100.0 * value_j / of_j, 1) } else { "–".to_owned() }
}
