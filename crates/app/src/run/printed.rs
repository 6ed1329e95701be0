//! The summary that `run` prints.

use core::fmt::Write as _;
use std::path::Path;

use fenderline_scenario::printable_number;
use fenderline_sim::PairSummary;

use super::cells::{NAME_WIDTH, decimal, one_line};
use fenderline_report::plot::{counted, shortened};
use fenderline_report::words::interrupted_text;
use fenderline_results::{Outcome, WrittenFile, integrator_text, method_text};

/// Largest number of pairs of bodies in the printed table.
const ROWS: usize = 20;

/// The printed summary: title and method; one line per pair of bodies, the largest force first; one line per fender,
/// the most used first; and the files.
pub(super) fn summary(outcome: &Outcome<'_>, folder: &Path, files: &[WrittenFile]) -> String {
    let setup = outcome.setup;
    let mut text = format!(
        "{}\n{} of {} s, {} method, {} integrator\n\n",
        one_line(outcome.title),
        counted(outcome.steps, "step", "steps"),
        printable_number(setup.step_s),
        method_text(setup.method),
        integrator_text(setup.integrator).replace('_', "-")
    );
    for approach in &setup.approaches {
        let _ = writeln!(text, "{}\n", one_line(&approach.sentence(setup)));
    }
    text += &interrupted(outcome);
    let mut pairs: Vec<&PairSummary> = outcome.pairs.iter().collect();
    pairs.sort_by(|a, b| b.peak_normal_force_n.total_cmp(&a.peak_normal_force_n));
    if pairs.is_empty() {
        text.push_str("no bodies touched\n");
    } else {
        let more = pairs.len().saturating_sub(ROWS);
        pairs.truncate(ROWS);
        text.push_str(&table(outcome, &pairs));
        text.push_str(
            "approach speed: positive when closing; final speed: positive when separating\n",
        );
        let by_fender = pairs.iter().filter(|pair| pair.peak_depth_fender.is_some()).count();
        if by_fender > 0 && by_fender < pairs.len() {
            text.push_str(
                "peak depth: for a contact through a fender, the deflection of the fender\n",
            );
        }
        if more > 0 {
            let more = counted(more as u64, "more pair", "more pairs");
            let _ = writeln!(text, "and {more}, in summary.json");
        }
    }
    text.push_str(&super::fenders::table(outcome));
    text.push_str(&super::fenders::dolphins(outcome));
    text.push_str(&super::berthing::lines(outcome));
    text.push_str(&super::world::lines(outcome));
    text.push('\n');
    text.push_str(&super::verdict::lines(outcome));
    text.push_str(&super::exercise::lines(outcome));
    text.push('\n');
    let names: Vec<String> = files.iter().map(described).collect();
    let _ = writeln!(text, "in {}: {}", folder.display(), names.join(", "));
    text
}

/// A line that says that and when the run was interrupted; empty if it was not.
pub(super) fn interrupted(outcome: &Outcome<'_>) -> String {
    let told = |interrupted| format!("INTERRUPTED: {}\n\n", interrupted_text(interrupted));
    outcome.interrupted.as_ref().map_or_else(String::new, told)
}

fn described(file: &WrittenFile) -> String {
    match file.rows {
        Some(rows) => format!("{} ({rows} rows)", file.name),
        None => file.name.clone(),
    }
}

fn table(outcome: &Outcome<'_>, pairs: &[&PairSummary]) -> String {
    let names: Vec<String> = pairs
        .iter()
        .map(|pair| {
            let [a, b] = pair.bodies.map(|i| outcome.setup.bodies[i].name.as_str());
            let still = if pair.touching_at_end { " (still touching)" } else { "" };
            let longest = NAME_WIDTH - still.len();
            shortened(&one_line(&format!("{a} - {b}")), longest) + still
        })
        .collect();
    let longest = names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
    let width = longest.max("contact".len());
    let mut text = String::new();
    // A contact through a fender has no penetration but the fender's deflection.
    let depth = if pairs.iter().all(|pair| pair.peak_depth_fender.is_some()) {
        "deflection"
    } else {
        "peak depth"
    };
    let heads = [
        ("contact", "first touch", "peak force", depth, "impulse", "approach", "final"),
        ("", "s", "kN", "mm", "kN s", "m/s", "m/s"),
    ];
    for (name, touch, force, depth, impulse, approach, last) in heads {
        let _ = writeln!(
            text,
            "{name:<width$}  {touch:>11}  {force:>10}  {depth:>10}  {impulse:>10}  {approach:>8}  \
             {last:>8}"
        );
    }
    for (name, pair) in names.iter().zip(pairs) {
        let _ = writeln!(
            text,
            "{name:<width$}  {:>11}  {:>10}  {:>10}  {:>10}  {:>8}  {:>8}",
            decimal(pair.first_touch_s, 2),
            decimal(pair.peak_normal_force_n / 1e3, 1),
            decimal(pair.peak_depth_m * 1e3, 1),
            impulse(pair.impulse_ns / 1e3),
            speed(pair.approach_speed_mps),
            speed(pair.final_speed_mps)
        );
    }
    text
}

/// The text of an impulse, with a decimal only if the impulse is small.
fn impulse(impulse_kns: f64) -> String {
    let decimals = if impulse_kns.abs() < 100.0 { 1 } else { 0 };
    decimal(impulse_kns, decimals)
}

/// The text of a speed, rounded to a tenth of a millimetre per second. A speed that rounds to zero has no sign.
fn speed(speed_mps: f64) -> String {
    let text = decimal(speed_mps, 4);
    if text == "-0.0000" { "0.0000".to_owned() } else { text }
}
