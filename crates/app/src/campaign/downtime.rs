//! The documents of a downtime analysis: its tables and its report.

use core::fmt::Write as _;
use std::path::Path;

use fenderline_campaign::Runs;
use fenderline_campaign::downtime::{
    DOWNTIME_CSV, DOWNTIME_JSON, DowntimePlan, DowntimeTable, HOURS_CSV, downtime_csv,
    downtime_json, hours_csv,
};
use fenderline_campaign::report::{DowntimeReport, downtime_page};
use fenderline_campaign::statistics::Confidence;
use fenderline_campaign::store::TABLE_PARQUET;
use fenderline_campaign::table::Table;
use fenderline_report::plot::{fixed, significant};

use crate::documents::Pdf;
use crate::failure::Failure;
use crate::output::write_whole;

fn refused(why: &dyn core::fmt::Display) -> Failure {
    Failure::input(format_args!("error: {why}"))
}

fn table(folder: &Path) -> Result<Table, Failure> {
    Table::open(&folder.join(TABLE_PARQUET)).map_err(|why| refused(&why))
}

/// Counts the hours lost to downtime from the table of a finished campaign.
fn counted(runs: &Runs, plan: &DowntimePlan, table: &Table) -> Result<DowntimeTable, Failure> {
    let limits = runs.base().setup.world.statistics.limits.iter();
    let limits: Vec<String> = limits.map(|limit| limit.name.clone()).collect();
    DowntimeTable::of(plan, table, &limits, Confidence::USUAL).map_err(|why| refused(&why))
}

/// Writes the tables of a finished downtime analysis, and its report to the file name `report`.
///
/// # Errors
/// Fails if the table cannot be read, a file cannot be written, or the browser that prints the PDF fails.
pub(super) fn write(
    runs: &Runs,
    plan: &DowntimePlan,
    file: &Path,
    (folder, report): (&Path, &str),
    pdf: Option<&Pdf>,
) -> Result<(), Failure> {
    let table = table(folder)?;
    let counted = counted(runs, plan, &table)?;
    let csv = downtime_csv(&counted).map_err(|why| refused(&why))?;
    write_whole(&folder.join(DOWNTIME_CSV), csv.as_bytes())?;
    let hours = hours_csv(plan, &counted).map_err(|why| refused(&why))?;
    write_whole(&folder.join(HOURS_CSV), hours.as_bytes())?;
    let json = format!("{:#}\n", downtime_json(plan, &counted));
    write_whole(&folder.join(DOWNTIME_JSON), json.as_bytes())?;
    let (campaign, setup) = (runs.campaign(), &runs.base().setup);
    let limits = setup.world.statistics.limits.iter();
    let limits: Vec<(String, String)> = limits
        .map(|limit| {
            let words = format!("{}: at most {}", limit.subject(setup), limit.shown(limit.most));
            (limit.name.clone(), words)
        })
        .collect();
    let notices: Vec<String> =
        runs.base().notices.iter().map(|notice| notice.message.clone()).collect();
    let page = downtime_page(&DowntimeReport {
        title: &campaign.title,
        scenario: &campaign.scenario.file_name().unwrap_or_default().to_string_lossy(),
        duration_s: setup.duration_s,
        plan,
        counted: &counted,
        limits: &limits,
        table: &table,
        notices: &notices,
        seed: campaign.seed,
        replay: &|row| format!("fenderline campaign replay {} {}", file.display(), row + 1),
    });
    let page = page.map_err(|why| refused(&why))?;
    write_whole(&folder.join(report), page.as_bytes())?;
    match pdf {
        Some(pdf) => pdf.write(&page),
        None => Ok(()),
    }
}

/// What the terminal shows of a finished downtime analysis.
///
/// # Errors
/// Fails if the table cannot be read.
pub(super) fn printed(runs: &Runs, plan: &DowntimePlan, folder: &Path) -> Result<String, Failure> {
    let counted = counted(runs, plan, &table(folder)?)?;
    let all = &counted.all;
    let percent = |share: Option<f64>| {
        share.map_or_else(|| "–".to_owned(), |share| significant(100.0 * share, 3))
    };
    let known = all.hours - all.not_run;
    let mut text = format!(
        "lost: {} h of {} h, {} %\n",
        fixed(all.lost, 0),
        fixed(known, 0),
        percent(all.share())
    );
    for reason in counted.reasons.iter().filter(|reason| reason.hours > 0.0) {
        let _ = writeln!(text, "  {:>8} h  {}", fixed(reason.hours, 0), reason.name);
    }
    if let Some(check) = &counted.check
        && let Some(disagree) = &check.disagree
    {
        let _ = writeln!(
            text,
            "of {} single hours {} do not agree with their state: {} % ({} to {} %); {} would be \
             lost in addition, {} would not be lost",
            check.compared,
            check.by_state_alone + check.as_it_is_alone,
            percent(Some(disagree.value)),
            percent(Some(disagree.interval.low)),
            percent(Some(disagree.interval.high)),
            check.as_it_is_alone,
            check.by_state_alone,
        );
    }
    let _ = writeln!(text, "hours lost: {}", folder.join(DOWNTIME_CSV).display());
    Ok(text)
}
