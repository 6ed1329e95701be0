//! What the terminal shows of a campaign.

use core::fmt::Write as _;
use std::path::Path;

use fenderline_campaign::Plan;
use fenderline_campaign::store::{MOST_CSV_ROWS, Shard, TABLE_CSV, TABLE_PARQUET};
use fenderline_campaign::{Cell, Runs};
use fenderline_report::plot::{counted, fixed};

use super::gathered::Gathered;
use super::places::FIGURE;
use super::report::REPORT;
use crate::cli::CampaignRunArgs;
use crate::terminal::notice;

/// Prints the summary of a campaign, and a notice for the first run that was not made.
pub(super) fn printed(
    runs: &Runs,
    gathered: &Gathered,
    folder: &Path,
    args: &CampaignRunArgs,
    shard: Shard,
    ended: Option<u64>,
    is_whole: bool,
) -> String {
    let campaign = runs.campaign();
    let of = counted(shard.count(runs.count()), "case", "cases");
    let mut text = format!("{}: {} of {of} done\n", campaign.title, gathered.count);
    if ended.is_some() {
        let _ =
            writeln!(text, "the campaign was ended by its stop rule: the estimate is good enough");
    }
    for (verdict, count) in &gathered.verdicts {
        let _ = writeln!(text, "  {count:>5}  {verdict}");
    }
    if let Some((case, fender, quantity, share)) = &gathered.governing {
        let share = fixed(*share, 1);
        let values = values(runs, *case);
        let _ = writeln!(
            text,
            "most used fender: {fender}, {quantity} {share} % of rated, in case {case} ({values})"
        );
    }
    if let Some((number, why)) = &gathered.failed {
        notice(format_args!("case {number} did not run: {why}"));
    }
    if shard != Shard::WHOLE {
        let _ = writeln!(text, "share {} of {}: {}", shard.number, shard.of, folder.display());
        return text;
    }
    let table = if gathered.count <= MOST_CSV_ROWS { TABLE_CSV } else { TABLE_PARQUET };
    let _ = writeln!(text, "table: {}", folder.join(table).display());
    if campaign.plan == Plan::FullFactorial {
        let _ = writeln!(text, "figure: {}", folder.join(FIGURE).display());
    }
    if is_whole {
        let _ = writeln!(text, "report: {}", folder.join(REPORT).display());
    }
    if let Some(path) = &args.xlsx {
        let _ = writeln!(text, "workbook: {}", path.display());
    }
    text
}

/// Names and values of the campaign's variables in one case.
fn values(runs: &Runs, case: u64) -> String {
    let drawn = runs.draws().of_run(case - 1);
    let shown = |cell: &Cell, unit: &str| match (cell, unit) {
        (Cell::Number(value), "") => fixed_short(*value),
        (Cell::Number(value), unit) => format!("{} {unit}", fixed_short(*value)),
        (other, _) => other.shown(),
    };
    let each = runs.draws().heads().iter().zip(&drawn.values);
    let each = each.filter(|(_, cell)| **cell != Cell::Empty);
    let named: Vec<String> =
        each.map(|(head, cell)| format!("{} {}", head.name, shown(cell, &head.unit))).collect();
    named.join(", ")
}

/// A number with at most four digits.
fn fixed_short(value: f64) -> String {
    fenderline_report::plot::plain(value, 4)
}
