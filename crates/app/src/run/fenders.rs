//! The fenders in the summary that `run` prints.

use core::fmt::Write as _;

use fenderline_sim::FenderSummary;

use super::printed::{NAME_WIDTH, decimal, one_line};
use fenderline_report::plot::{counted, shortened};
use fenderline_results::Outcome;
use fenderline_results::{FenderVerdict, worst_first};

/// Most fenders in the table.
const FENDERS: usize = 12;

/// One line per fender, the most used first: its peaks, and the quantity that governs with its share of the rated one.
/// Empty if the scenario has no fenders.
pub(super) fn table(outcome: &Outcome<'_>) -> String {
    let mut text = String::new();
    if outcome.setup.fenders.is_empty() {
        return text;
    }
    if outcome.fenders.is_empty() {
        return "\nno fender was touched\n".to_owned();
    }
    let setups = &outcome.setup.fenders;
    let order = worst_first(setups, outcome.fenders);
    let verdict = |summary: &FenderSummary| FenderVerdict::of(&setups[summary.fender], summary);
    let name_of =
        |summary: &FenderSummary| shortened(&one_line(&setups[summary.fender].name), NAME_WIDTH);
    let shown: Vec<&FenderSummary> =
        order.iter().take(FENDERS).map(|&i| &outcome.fenders[i]).collect();
    let longest = shown.iter().map(|f| name_of(f).chars().count()).max().unwrap_or(0);
    let width = longest.max("fender".len());
    text.push('\n');
    for (name, touch, deflection, reaction, energy, pressure, share) in [
        ("fender", "first touch", "deflection", "reaction", "energy", "on hull", "of rated"),
        ("", "s", "mm", "kN", "kJ", "kN/m2", "%"),
    ] {
        let _ = writeln!(
            text,
            "{name:<width$}  {touch:>11}  {deflection:>10}  {reaction:>10}  {energy:>10}  {pressure:>7}  \
             {share:>14}"
        );
    }
    for summary in shown {
        let share = summary.governing().map_or_else(
            || "-".to_owned(),
            |(quantity, share)| format!("{quantity} {}", decimal(100.0 * share, 0)),
        );
        let pressure = summary.peak_hull_pressure_npm2;
        let pressure = pressure.map_or_else(|| "-".to_owned(), |p| decimal(p / 1e3, 0));
        let verdict = verdict(summary);
        let mark = if verdict.is_grave() { verdict.text().to_uppercase() } else { String::new() };
        let line = format!(
            "{:<width$}  {:>11}  {:>10}  {:>10}  {:>10}  {pressure:>7}  {share:>14}  {mark}",
            name_of(summary),
            decimal(summary.first_touch_s, 2),
            decimal(summary.peak_deflection_m * 1e3, 1),
            decimal(summary.peak_reaction_n / 1e3, 1),
            decimal(summary.peak_energy_j / 1e3, 1),
        );
        let _ = writeln!(text, "{}", line.trim_end());
    }
    if order.len() > FENDERS {
        let more = (order.len() - FENDERS) as u64;
        let more = counted(more, "more fender", "more fenders");
        let _ = writeln!(text, "and {more}, in summary.json");
    }
    text
}

/// The berthing energy by formula and that in the fenders; empty without such a study.
pub(super) fn berthing(outcome: &Outcome<'_>) -> String {
    let Some(Ok(berthing)) = outcome.berthing else { return String::new() };
    let abnormal = berthing.abnormal_energy_j.map_or_else(String::new, |abnormal_j| {
        format!(" ({} kJ abnormal)", decimal(abnormal_j / 1e3, 0))
    });
    format!(
        "\nberthing: {} kJ by PIANC 2002{abnormal}; the fenders took {} kJ in the first hit\n",
        decimal(berthing.energy_j[0] / 1e3, 0),
        decimal(berthing.fender_energy_j / 1e3, 0)
    )
}
