//! Lines about the fenders, for the summary that `run` prints.

use core::fmt::Write as _;

use fenderline_sim::{
    ChainSummary, ConeSummary, DolphinSummary, FenderSetup, FenderSummary, PanelSummary,
};

use super::cells::{NAME_WIDTH, decimal, heads, one_line, values};
use fenderline_report::plot::{counted, shortened};
use fenderline_results::{DOLPHINS, FENDERS, FenderVerdict, Outcome, worst_first};

/// Largest number of fenders in the printed table.
const ROWS: usize = 12;

/// A table with one line per fender, the most used first: its peak values, and the governing quantity as a share of its
/// rated value. Empty if the scenario has no fenders.
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
        order.iter().take(ROWS).map(|&i| &outcome.fenders[i]).collect();
    let longest = shown.iter().map(|f| name_of(f).chars().count()).max().unwrap_or(0);
    let width = longest.max("fender".len());
    text.push('\n');
    let [heads, units] = heads(&FENDERS);
    for (name, touch, columns, catalogue, share) in [
        ("fender", "first touch", heads, "of catalogue", "of rated"),
        ("", "s", units, "defl/reac/en, %", "%"),
    ] {
        let _ =
            writeln!(text, "{name:<width$}  {touch:>11}{columns}  {catalogue:>15}  {share:>14}");
    }
    for summary in shown {
        let share = summary.governing().map_or_else(
            || "-".to_owned(),
            |(quantity, share)| format!("{quantity} {}", decimal(100.0 * share, 0)),
        );
        let setup = &setups[summary.fender];
        let catalogue = of_catalogue(setup, summary);
        let verdict = verdict(summary);
        let mark = if verdict.is_grave() { verdict.text().to_uppercase() } else { String::new() };
        let line = format!(
            "{:<width$}  {:>11}{}  {catalogue:>15}  {share:>14}  {mark}",
            name_of(summary),
            decimal(summary.first_touch_s, 2),
            values(&FENDERS, setup, summary),
        );
        let _ = writeln!(text, "{}", line.trim_end());
    }
    for &index in order.iter().take(ROWS) {
        let summary = &outcome.fenders[index];
        if let Some(panel) = &summary.panel {
            let _ = writeln!(text, "{:<width$}  {}", name_of(summary), panel_line(panel));
        }
        for chain in &summary.chains {
            let _ = writeln!(text, "{:<width$}  {}", name_of(summary), chain_line(chain));
        }
    }
    if order.len() > ROWS {
        let more = (order.len() - ROWS) as u64;
        let more = counted(more, "more fender", "more fenders");
        let _ = writeln!(text, "and {more}, in summary.json");
    }
    text
}

/// A line about a panel on several cones: its turn, its moment and the deflection of each cone, from left to right as
/// one looks at the panel's face.
fn panel_line(panel: &PanelSummary) -> String {
    let mut cones = panel.cones.clone();
    cones.sort_by(|one, other| one.at_m.total_cmp(&other.at_m));
    let of_cone = |cone: &ConeSummary| decimal(cone.peak_deflection_m * 1e3, 1);
    let cones: Vec<String> = cones.iter().map(of_cone).collect();
    format!(
        "panel: turned by {} deg, {} kN m; cones {} mm",
        decimal(panel.peak_tilt_rad.to_degrees(), 2),
        decimal(panel.peak_moment_nm / 1e3, 1),
        cones.join(", ")
    )
}

/// A line with the peak tension of a fender's chain.
fn chain_line(chain: &ChainSummary) -> String {
    let parted = if chain.parted_at_s.is_some() { ", PARTED" } else { "" };
    format!(
        "{} chain: {} kN, {} % of its break load{parted}",
        chain.kind.word(),
        decimal(chain.peak_tension_n / 1e3, 1),
        decimal(100.0 * chain.share_of_break_load, 0)
    )
}

/// One line per flexible dolphin, the most loaded first: its peak values, its share of the yield load, and its
/// remaining deflection. Empty without one.
pub(super) fn dolphins(outcome: &Outcome<'_>) -> String {
    let mut text = String::new();
    if outcome.dolphins.is_empty() {
        return text;
    }
    let name_of = |dolphin: &DolphinSummary| {
        shortened(&one_line(&outcome.setup.bodies[dolphin.body].name), NAME_WIDTH)
    };
    let mut shown: Vec<&DolphinSummary> = outcome.dolphins.iter().collect();
    shown.sort_by(|one, other| other.peak_load_n.total_cmp(&one.peak_load_n));
    let more = shown.len().saturating_sub(ROWS);
    shown.truncate(ROWS);
    let longest = shown.iter().map(|d| name_of(d).chars().count()).max().unwrap_or(0);
    let width = longest.max("dolphin".len());
    text.push('\n');
    let [heads, units] = heads(&DOLPHINS);
    let _ = writeln!(text, "{:<width$}{heads}", "dolphin");
    let _ = writeln!(text, "{:<width$}{units}", "");
    for dolphin in shown {
        let mark = match dolphin.yielded_at_s {
            Some(_) => format!("YIELDED, {} mm stay", decimal(dolphin.offset_m * 1e3, 1)),
            None => String::new(),
        };
        let setup = &outcome.setup.bodies[dolphin.body];
        let values = values(&DOLPHINS, setup, dolphin);
        let line = format!("{:<width$}{values}  {mark}", name_of(dolphin));
        let _ = writeln!(text, "{}", line.trim_end());
    }
    if more > 0 {
        let more = counted(more as u64, "more dolphin", "more dolphins");
        let _ = writeln!(text, "and {more}, in summary.json");
    }
    text
}

/// Deflection, reaction and energy of a fender as shares of the catalogue's rated values, without the factors of this
/// run (%).
fn of_catalogue(setup: &FenderSetup, summary: &FenderSummary) -> String {
    let shares = [
        summary.share_of_rated_deflection,
        summary.share_of_catalogue_reaction(),
        summary.share_of_catalogue_energy(setup),
    ];
    let percent = |share: Option<f64>| share.map(|share| decimal(100.0 * share, 0));
    let shares: Option<Vec<String>> = shares.into_iter().map(percent).collect();
    shares.map_or_else(|| "-".to_owned(), |shares| shares.join(" / "))
}
