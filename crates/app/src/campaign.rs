//! `fenderline campaign`: every combination of some values of a scenario's keys, as a table with a row a case, and a figure.

mod axis;
mod case;
mod columns;
mod page;
mod workers;

use core::fmt::Write as _;
use std::path::{Path, PathBuf};

use fenderline_report::plot::{counted, fixed};
use fenderline_scenario::Campaign;

use self::case::{Case, Done};
pub(crate) use self::columns::{CaseTable, Cell};
use self::page::Layout;
use crate::cli::CampaignArgs;
use crate::documents::cases_workbook;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::output::{make_folder, write_whole};
use crate::progress::Progress;
use crate::terminal::{answer, notice, say};

/// Runs all cases and writes table and figure. A case that cannot be run is a row with its error.
///
/// # Errors
/// Bad input: the campaign's file, or a scenario of which no case can be run. A file that cannot be written. A case that did
/// not run: exit code 1, with all files written. An interrupt: the rows so far are written.
pub(crate) fn campaign(args: &CampaignArgs) -> Result<(), Failure> {
    let campaign = Campaign::load(&args.campaign).map_err(Failure::input)?;
    let layout = Layout::of(&campaign, args.x.as_deref(), args.lines.as_deref())
        .map_err(|why| Failure::input(format_args!("error: {why}")))?;
    if let Some(number) = args.command {
        return answer(&command(&campaign, number)?);
    }
    refuse_hopeless(&campaign)?;
    let folder = args.out.clone().unwrap_or_else(|| default_folder(&args.campaign));
    let interrupt = Interrupt::listen();
    make_folder(&folder)?;
    let cases = run_all(&campaign, workers::threads(args.threads), &|| interrupt.is_asked());
    let table = columns::table(&campaign, &cases);
    let csv = table.csv().map_err(|error| Failure::case(format_args!("error: {error}")))?;
    write_whole(&folder.join("cases.csv"), &csv)?;
    let figure = page::render(&campaign, &cases, &table, layout);
    write_whole(&folder.join("figure.html"), figure.as_bytes())?;
    if let Some(path) = &args.xlsx {
        let book = cases_workbook(&campaign.title, &table).map_err(|error| {
            Failure::case(format_args!("error: cannot make {}: {error}", path.display()))
        })?;
        write_whole(path, &book)?;
    }
    say(&printed(&campaign, &cases, &folder, args.xlsx.as_deref()))?;
    if cases.len() < campaign.cases() {
        return Err(Failure::Interrupted);
    }
    let failed = cases.iter().filter(|case| matches!(case.done, Done::Failed(_))).count();
    match failed {
        0 => Ok(()),
        _ => {
            let count = counted(failed as u64, "case", "cases");
            Err(Failure::case(format_args!("error: {count} did not run: see the column `error`")))
        }
    }
}

fn default_folder(campaign: &Path) -> PathBuf {
    Path::new("out").join(campaign.file_stem().unwrap_or_default())
}

/// Refuses a campaign of which no case can start: the first error is then about the file, not about a case.
fn refuse_hopeless(campaign: &Campaign) -> Result<(), Failure> {
    let mut first = None;
    for index in 0..campaign.cases() {
        let changes = campaign.changes_of(index);
        match case::start(&campaign.scenario, &changes) {
            Ok(_) => return Ok(()),
            Err(_) if first.is_some() => {}
            Err(why) => {
                // The whole error, with its place and help.
                let loaded = fenderline_scenario::Scenario::load(&campaign.scenario, &changes);
                let whole = loaded.err().map_or(format!("error: {why}"), |error| error.to_string());
                first = Some(whole);
            }
        }
    }
    let why = first.unwrap_or_default();
    Err(Failure::input(format_args!("{why}\nno case of the campaign can be run")))
}

/// All cases that end before `is_stopped`, in their order.
fn run_all(
    campaign: &Campaign,
    threads: usize,
    is_stopped: &(dyn Fn() -> bool + Sync),
) -> Vec<Case> {
    let mut progress = Progress::of(campaign.cases() as u64, "cases");
    let mut cases: Vec<Case> = Vec::with_capacity(campaign.cases());
    let one = |index: usize| {
        if is_stopped() {
            return None;
        }
        case::run(&campaign.scenario, &campaign.changes_of(index), is_stopped)
    };
    workers::each(campaign.cases(), threads, one, |index, done| {
        cases.push(Case { index, done });
        progress.advance(cases.len() as u64);
    });
    cases.sort_by_key(|case| case.index);
    cases
}

/// The command that runs one case by itself, with its report.
fn command(campaign: &Campaign, number: usize) -> Result<String, Failure> {
    let index = number.checked_sub(1).filter(|index| *index < campaign.cases());
    let Some(index) = index else {
        let count = campaign.cases();
        return Err(Failure::input(format_args!(
            "error: there is no case {number}: they are numbered from 1 to {count}"
        )));
    };
    let mut text = format!("fenderline run {}", in_shell(&campaign.scenario.display().to_string()));
    for setting in campaign.settings_of(index) {
        let _ = write!(text, " --set {}", in_shell(setting));
    }
    let _ = writeln!(text, " --out {}", in_shell(&format!("out/case_{number}")));
    Ok(text)
}

/// A word of a command line, in quotes where it needs them.
fn in_shell(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=+:".contains(c);
    match word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}

fn printed(campaign: &Campaign, cases: &[Case], folder: &Path, xlsx: Option<&Path>) -> String {
    let mut text = format!(
        "{}: {} of {} done\n",
        campaign.title,
        cases.len(),
        counted(campaign.cases() as u64, "case", "cases")
    );
    let mut counts: Vec<(&str, usize)> = Vec::new();
    for case in cases {
        let verdict = match &case.done {
            Done::Run(numbers) => numbers.verdict.text(),
            Done::Failed(_) => "Did not run",
        };
        match counts.iter_mut().find(|(known, _)| *known == verdict) {
            Some((_, count)) => *count += 1,
            None => counts.push((verdict, 1)),
        }
    }
    for (verdict, count) in counts {
        let _ = writeln!(text, "  {count:>5}  {verdict}");
    }
    let share = |case: &Case| match &case.done {
        Done::Run(numbers) => numbers.governing.clone(),
        Done::Failed(_) => None,
    };
    let used = cases.iter().filter_map(|case| Some((case, share(case)?)));
    if let Some((case, (fender, quantity, share))) = used.max_by(|a, b| a.1.2.total_cmp(&b.1.2)) {
        let labels = campaign.labels(case.index);
        let names = campaign.variables.iter().zip(labels);
        let values: Vec<String> =
            names.map(|(variable, label)| format!("{} {label}", variable.name)).collect();
        let _ = writeln!(
            text,
            "most used: {fender}, {quantity} {} % of rated, in case {} ({})",
            fixed(100.0 * share, 1),
            case.index + 1,
            values.join(", ")
        );
    }
    let failed = cases.iter().find_map(|case| match &case.done {
        Done::Failed(why) => Some((case.index + 1, why)),
        Done::Run(_) => None,
    });
    if let Some((number, why)) = failed {
        notice(format_args!("case {number} did not run: {why}"));
    }
    let _ = writeln!(text, "table: {}", folder.join("cases.csv").display());
    let _ = writeln!(text, "figure: {}", folder.join("figure.html").display());
    if let Some(path) = xlsx {
        let _ = writeln!(text, "workbook: {}", path.display());
    }
    text
}
