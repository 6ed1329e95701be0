//! `fenderline report`: scenario → simulation → documents, without tables.

use std::path::PathBuf;

use fenderline_report::run_page;

use crate::cli::ReportArgs;
use crate::documents::Documents;
use crate::failure::Failure;
use crate::load::stem;
use crate::output::write_whole;
use crate::played::Start;
use crate::run::{end, exercise_lines, interrupted_line, verdict_lines};
use crate::terminal::say;

/// Runs the scenario that `args` name and writes the documents that `args` ask for; if they ask for none, the report
/// page.
///
/// # Errors
/// As `run`.
pub(crate) fn report(args: &ReportArgs) -> Result<(), Failure> {
    let overrides = args.overrides().map_err(Failure::input)?;
    let start = Start::open(&args.scenario, args.branch, &overrides)?;
    let documents = Documents::of(&args.documents, start.setup())?;
    let mut sheets = documents.sheets(&start)?;
    let played = start.play(|step| sheets.write(step))?;
    let page = run_page::render(&played.outcome(), &played.recorder);
    let html = args.html.clone().or_else(|| documents.is_none().then(|| default_page(args)));
    if let Some(path) = html {
        write_whole(&path, page.as_bytes())?;
        say(&format!("report: {}\n", path.display()))?;
    }
    documents.write(&played, &page, sheets)?;
    say(&interrupted_line(&played))?;
    say(&verdict_lines(&played))?;
    say(&exercise_lines(&played))?;
    end(&played, args.allow_failures, false)
}

/// Default path of the report page: in the current folder, with the name of the scenario.
fn default_page(args: &ReportArgs) -> PathBuf {
    PathBuf::from(stem(&args.scenario)).with_added_extension("html")
}
