//! Lines about vessels, tugs, mooring lines, anchors and force providers, for the summary that `run` prints. Findings
//! that need attention are in capitals.

use core::fmt::Write as _;

use super::cells::{NAME_WIDTH, decimal, heads, one_line, values};
use fenderline_report::plot::{shortened, times};
use fenderline_results::{AnchorVerdict, LINES, LineTotals, LineVerdict, Outcome};
use fenderline_sim::MooringSetup;

/// Largest number of lines of text for each kind of part, such as vessels or mooring lines.
const ROWS: usize = 12;

/// The lines about vessels, tugs, mooring lines, anchors and providers; empty if the scenario has none of these.
pub(super) fn lines(outcome: &Outcome<'_>) -> String {
    let mut text = String::new();
    moorings(outcome, &mut text);
    anchors(outcome, &mut text);
    warnings(outcome, &mut text);
    if text.is_empty() { text } else { format!("\n{text}") }
}

/// One line of text per mooring line, the most used first.
fn moorings(outcome: &Outcome<'_>, text: &mut String) {
    let setups = outcome.setup.world.lines.iter();
    let mut lines: Vec<(&MooringSetup, &LineTotals)> = setups.zip(&outcome.world.lines).collect();
    if lines.is_empty() {
        return;
    }
    let share = |line: &LineTotals| line.share_of_break_load().unwrap_or(0.0);
    // A stable sort: equal ones stay in the order of the scenario.
    lines.sort_by(|a, b| share(b.1).total_cmp(&share(a.1)));
    let shown = &lines[..lines.len().min(ROWS)];
    let name_of = |setup: &MooringSetup| shortened(&one_line(&setup.line.name), NAME_WIDTH);
    let longest = shown.iter().map(|(setup, _)| name_of(setup).chars().count()).max().unwrap_or(0);
    let width = longest.max("line".len());
    let [heads, units] = heads(&LINES);
    let _ = writeln!(text, "{:<width$}{heads}", "line");
    let _ = writeln!(text, "{:<width$}{units}", "");
    for (setup, line) in shown {
        let mark = match line.verdict() {
            LineVerdict::Ok => String::new(),
            verdict => verdict.text().to_uppercase(),
        };
        let row = format!("{:<width$}{}  {mark}", name_of(setup), values(&LINES, setup, line));
        let _ = writeln!(text, "{}", row.trim_end());
    }
    if lines.len() > shown.len() {
        let _ = writeln!(text, "and {} more lines, in summary.json", lines.len() - shown.len());
    }
}

/// One line of text per anchor that was used.
fn anchors(outcome: &Outcome<'_>, text: &mut String) {
    let used = outcome.setup.world.anchors.iter().zip(&outcome.world.anchors);
    let used = used.filter(|(_, totals)| totals.verdict() != AnchorVerdict::NotUsed);
    for (anchor, totals) in used.take(ROWS) {
        let _ = writeln!(
            text,
            "anchor {}: {}; most chain out {} m, peak tension {} kN at {} s, dragged {} m",
            shortened(&one_line(&anchor.gear.name), NAME_WIDTH),
            totals.verdict().text(),
            decimal(totals.chain_m.value, 1),
            decimal(totals.tension_n.value / 1e3, 1),
            decimal(totals.tension_n.at_s, 1),
            decimal(totals.dragged_m, 1),
        );
    }
}

fn warnings(outcome: &Outcome<'_>, text: &mut String) {
    let (setup, world) = (outcome.setup, outcome.world);
    for (tug, totals) in setup.world.tugs.iter().zip(&world.tugs).take(ROWS) {
        if totals.limited.s() > 0.0 {
            let _ = writeln!(
                text,
                "tug {}: for {:.1} s its force was less than ordered, because of speed and angle",
                one_line(&tug.tug.name),
                totals.limited.s()
            );
        }
    }
    for (key, count) in outcome.providers.counts() {
        let what = match *key {
            "provider_held" => "the program did not answer in time; its last force was held",
            "provider_dropped" => "the program was silent for too long; its force was DROPPED",
            "provider_refused" => {
                "the program gave a force that is not finite or too large; this force was REFUSED"
            }
            "provider_died" => "the program ENDED before the run did",
            _ => "the program answered again",
        };
        let _ = writeln!(text, "provider: {}: {what}", times(*count));
    }
}
