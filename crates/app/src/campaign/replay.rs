//! `fenderline campaign replay` makes one case of a campaign as a run of its own, with its report.

use core::fmt::Write as _;

use clap::Parser as _;
use fenderline_campaign::Campaign;
use fenderline_campaign::Runs;

use crate::cli::{CampaignReplayArgs, Cli, Command};
use crate::failure::Failure;

/// Runs one case of a campaign by itself, and writes its summary, tables and report.
///
/// # Errors
/// Fails like `fenderline run`, and if the campaign has no case of that number.
pub(super) fn replay(args: &CampaignReplayArgs) -> Result<(), Failure> {
    let campaign = Campaign::load(&args.campaign).map_err(Failure::input)?;
    let runs = Runs::new(campaign).map_err(Failure::input)?;
    let mut words = words(&runs, args.case)?;
    words.insert(0, "fenderline".to_owned());
    if let Some(out) = &args.out {
        let place = words.iter().position(|word| word == "--out").expect("it is there") + 1;
        words[place] = out.display().to_string();
    }
    let cli = Cli::try_parse_from(words).map_err(Failure::input)?;
    let Command::Run(run) = cli.command else {
        unreachable!("the command line is one of `fenderline run`")
    };
    crate::run::run(&run)
}

/// The command line that runs one case of a campaign by itself, with its report.
///
/// # Errors
/// Fails if no case has this number.
pub(super) fn command(runs: &Runs, number: u64) -> Result<String, Failure> {
    let mut text = "fenderline".to_owned();
    for word in words(runs, number)? {
        let _ = write!(text, " {}", in_shell(&word));
    }
    text.push('\n');
    Ok(text)
}

fn words(runs: &Runs, number: u64) -> Result<Vec<String>, Failure> {
    let Some(run) = number.checked_sub(1).filter(|run| *run < runs.count()) else {
        let count = runs.count();
        return Err(Failure::input(format_args!(
            "error: there is no case {number}: the cases are numbered from 1 to {count}"
        )));
    };
    let mut words = vec!["run".to_owned(), runs.campaign().scenario.display().to_string()];
    for setting in runs.settings(run) {
        words.extend(["--set".to_owned(), setting]);
    }
    words.extend(["--out".to_owned(), format!("out/case_{number}")]);
    Ok(words)
}

/// A word of a command line, in quotes if the shell needs them.
fn in_shell(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=+:".contains(c);
    match word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}
