//! `fenderline campaign`: many runs of one scenario, their table and their figure or report.

mod axis;
mod check;
mod downtime;
mod gathered;
mod merge;
mod page;
mod places;
mod printed;
mod replay;
mod report;

use std::num::NonZero;
use std::path::Path;
use std::thread;

use self::places::{FIGURE, default_folder};
use fenderline_campaign::store::{Opened, Shard, Store, is_finished};
use fenderline_campaign::{Campaign, Plan};
use fenderline_campaign::{CampaignError, Row, Runs, StopRule, make};

pub(crate) use self::check::check;
pub(crate) use self::gathered::CaseTable;
use self::gathered::Gathered;
use self::page::Layout;
use crate::cli::{CampaignArgs, CampaignPart, CampaignRunArgs};
use crate::documents::{Pdf, cases_workbook};
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::output::write_whole;
use crate::progress::Progress;
use crate::terminal::{answer, say};

/// Makes all runs of the campaign and writes their tables, or does what the subcommand says. A run that cannot be made
/// becomes a row of the table with its error.
///
/// # Errors
/// Fails if the campaign file is wrong, if no run of its scenario can be made, or if a file cannot be written. If a
/// single run of the campaign was not made, all files are written and the exit code is 1. If the user interrupts the
/// campaign, the rows so far are written.
pub(crate) fn campaign(args: &CampaignArgs) -> Result<(), Failure> {
    match (&args.part, &args.run) {
        (Some(CampaignPart::Merge(args)), _) => merge::merge(args),
        (Some(CampaignPart::Replay(args)), _) => replay::replay(args),
        (Some(CampaignPart::Report(args)), _) => report::report_command(args),
        (None, args) => run(args),
    }
}

fn run(args: &CampaignRunArgs) -> Result<(), Failure> {
    let path = args.campaign.as_deref().expect("clap asks for it");
    let campaign = Campaign::load(path).map_err(Failure::input)?;
    let layout = match campaign.plan {
        Plan::FullFactorial => {
            let layout = Layout::of(&campaign, args.x.as_deref(), args.lines.as_deref());
            Some(layout.map_err(|why| Failure::input(format_args!("error: {why}")))?)
        }
        _ if args.x.is_some() || args.lines.is_some() => {
            let why = "--x and --lines belong to the figure of a full factorial plan; this \
                campaign has another plan";
            return Err(Failure::input(format_args!("error: {why}")));
        }
        _ => None,
    };
    let runs = Runs::new(campaign).map_err(Failure::input)?;
    report::check_success(&runs).map_err(|why| Failure::input(format_args!("error: {why}")))?;
    if args.xlsx.is_some() && runs.count() > gathered::MOST_IN_A_WORKBOOK {
        let (count, most) = (runs.count(), gathered::MOST_IN_A_WORKBOOK);
        return Err(Failure::input(format_args!(
            "error: --xlsx: a workbook has at most {most} rows, and there are {count} runs"
        )));
    }
    if let Some(number) = args.command {
        return answer(&replay::command(&runs, number)?);
    }
    let shard = args.shard.unwrap_or(Shard::WHOLE);
    if let Some(refusal) = refusal_of_shard(args, &runs, shard) {
        return Err(Failure::input(format_args!("error: {refusal}")));
    }
    let pdf = Pdf::of(args.pdf.as_deref())?;
    let folder = args.out.clone().unwrap_or_else(|| default_folder(path, shard));
    let opened = match (args.resume, args.replace) {
        (true, _) => Opened::Resumed,
        (_, true) => Opened::Replaced,
        _ => Opened::New,
    };
    if args.resume && is_finished(&folder, &runs, shard).map_err(Failure::input)? {
        // It may have been killed between its table and its report.
        report::write(&runs, path, &folder, pdf.as_ref())?;
        let title = &runs.campaign().title;
        return say(&format!(
            "{title}: finished already\nreport: {}\n",
            folder.join(report::REPORT).display()
        ));
    }
    let interrupt = Interrupt::listen();
    let mut rule = StopRule::of(&runs).map_err(Failure::input)?;
    let mut visit = |row: &Row| {
        if let Some(rule) = &mut rule {
            rule.add(row);
        }
    };
    let mut store =
        Store::open(&folder, &runs, shard, opened, &mut visit).map_err(Failure::input)?;
    if args.replace {
        remove_documents(&folder)?;
    }
    make_missing(&runs, &mut store, &mut rule, threads(args.threads), &|| interrupt.is_asked())
        .map_err(Failure::case)?;
    let ended = rule.as_ref().and_then(StopRule::ended);
    let wanted = ended.unwrap_or(shard.count(runs.count()));
    let is_whole = ended.is_some() || store.done() == wanted;
    let is_held = args.xlsx.is_some() || layout.is_some();
    let gathered = Gathered::of(&runs, &store, ended, is_held).map_err(Failure::case)?;
    if shard == Shard::WHOLE {
        write_documents(args, &folder, &runs, &gathered, layout)?;
    }
    if is_whole {
        store.finish(wanted).map_err(Failure::case)?;
        if shard == Shard::WHOLE {
            report::write(&runs, path, &folder, pdf.as_ref())?;
        }
    } else if shard == Shard::WHOLE {
        store.write_so_far().map_err(Failure::case)?;
    }
    say(&printed::printed(&runs, &gathered, &folder, args, shard, ended, is_whole))?;
    if let Some(plan) = runs.downtime().filter(|_| is_whole && shard == Shard::WHOLE) {
        say(&downtime::printed(&runs, plan, &folder)?)?;
    }
    if !is_whole {
        return Err(Failure::Interrupted);
    }
    gathered.outcome()
}

/// Makes the runs that have no row in the table yet, until the stop rule ends the campaign or the user interrupts.
fn make_missing(
    runs: &Runs,
    store: &mut Store<'_>,
    rule: &mut Option<StopRule>,
    threads: usize,
    is_stopped: &(dyn Fn() -> bool + Sync),
) -> Result<(), CampaignError> {
    if rule.as_ref().is_some_and(|rule| rule.ended().is_some()) {
        return Ok(());
    }
    let missing = store.missing();
    let mut progress = Progress::of(missing.count(), "cases");
    let mut done = 0;
    make(runs, &missing, threads, is_stopped, &mut |row| {
        store.add(&row)?;
        done += 1;
        progress.advance(done);
        if let Some(rule) = rule {
            rule.add(&row);
        }
        Ok(rule.as_ref().is_none_or(|rule| rule.ended().is_none()))
    })
}

/// The number of threads that the user gave, else the number of the machine's threads.
fn threads(given: Option<NonZero<usize>>) -> usize {
    let all = || thread::available_parallelism().map_or(1, NonZero::get);
    given.map_or_else(all, NonZero::get)
}

/// Refuses options that do not go together with `--shard`, which makes only one share of the runs.
fn refusal_of_shard(args: &CampaignRunArgs, runs: &Runs, shard: Shard) -> Option<String> {
    if shard == Shard::WHOLE {
        return None;
    }
    if args.xlsx.is_some() {
        return Some(
            "--xlsx goes with the whole table: use `fenderline campaign merge` first".to_owned(),
        );
    }
    if args.pdf.is_some() {
        return Some(
            "--pdf goes with the whole report: use `fenderline campaign merge` and `campaign report` first"
                .to_owned(),
        );
    }
    if runs.campaign().stop.is_some() {
        return Some(
            "a campaign with a [stop] rule cannot be shared: the rule needs all runs".to_owned(),
        );
    }
    (shard.of > runs.count())
        .then(|| format!("there are {} shards for {} runs", shard.of, runs.count()))
}

/// Removes the report and the figure of the campaign that is replaced, so that they do not stand beside the rows of the
/// new campaign.
fn remove_documents(folder: &Path) -> Result<(), Failure> {
    for name in [report::REPORT, FIGURE] {
        let path = folder.join(name);
        match std::fs::remove_file(&path) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                return Err(Failure::input(format_args!(
                    "error: cannot remove {}: {error}",
                    path.display()
                )));
            }
            _ => {}
        }
    }
    Ok(())
}

fn write_documents(
    args: &CampaignRunArgs,
    folder: &Path,
    runs: &Runs,
    gathered: &Gathered,
    layout: Option<Layout>,
) -> Result<(), Failure> {
    if let Some(layout) = layout {
        let figure = page::render(runs.campaign(), gathered, layout);
        write_whole(&folder.join(FIGURE), figure.as_bytes())?;
    }
    if let Some(path) = &args.xlsx {
        let book = cases_workbook(&runs.campaign().title, gathered.table()).map_err(|error| {
            Failure::case(format_args!("error: cannot make {}: {error}", path.display()))
        })?;
        write_whole(path, &book)?;
    }
    Ok(())
}
