//! The report of a campaign: `report.html` beside its table.

use std::path::Path;

use fenderline_campaign::report::{self, Input};
use fenderline_campaign::statistics::Confidence;
use fenderline_campaign::statistics::design::Asked;
use fenderline_campaign::statistics::fit::Law;
use fenderline_campaign::statistics::return_value::Traffic;
use fenderline_campaign::store::{self, Shard, TABLE_PARQUET};
use fenderline_campaign::table::Table;
use fenderline_campaign::{Campaign, Draw, Plan, Variable};
use fenderline_campaign::{Formula, Head, Runner, Runs, Seen};

use super::downtime;
use super::places::default_folder;
use crate::cli::CampaignReportArgs;
use crate::documents::Pdf;
use crate::failure::Failure;
use crate::output::write_whole;
use crate::terminal::say;

/// Name of the report.
pub(super) const REPORT: &str = "report.html";

/// Output numbers that the report of every campaign shows, the most important first.
const SHOWN: [&str; 6] =
    ["energy", "reaction", "deflection", "governing_share", "hull_pressure", "line_share"];

/// Largest number of runs whose paths the report draws, and of time steps that are simulated again for the paths, which
/// takes some seconds.
const SEEN_RUNS: u64 = 200;
const SEEN_STEPS: f64 = 2e6;

/// Laws that are fitted.
const LAWS: [Law; 4] = [Law::LogNormal, Law::Weibull, Law::Gumbel, Law::Gev];

/// `fenderline campaign report` writes the report of an existing table, such as that of merged shares.
///
/// # Errors
/// Fails if the folder has no table or the table of another campaign, or if the report cannot be written.
pub(super) fn report_command(args: &CampaignReportArgs) -> Result<(), Failure> {
    let campaign = Campaign::load(&args.campaign).map_err(Failure::input)?;
    let runs = Runs::new(campaign).map_err(Failure::input)?;
    let folder = args.out.clone().unwrap_or_else(|| default_folder(&args.campaign, Shard::WHOLE));
    store::check(&folder, &runs).map_err(Failure::input)?;
    let pdf = Pdf::of(args.pdf.as_deref())?;
    write(&runs, &args.campaign, &folder, pdf.as_ref())?;
    say(&format!("report: {}\n", folder.join(REPORT).display()))
}

/// Writes the report of the table in a folder, and as PDF where one is asked for.
///
/// # Errors
/// Fails if the table cannot be read, a file cannot be written, or the browser that prints the PDF fails.
pub(super) fn write(
    runs: &Runs,
    file: &Path,
    folder: &Path,
    pdf: Option<&Pdf>,
) -> Result<(), Failure> {
    if let Some(plan) = runs.downtime() {
        return downtime::write(runs, plan, file, (folder, REPORT), pdf);
    }
    let refused = |why: &dyn core::fmt::Display| Failure::input(format_args!("error: {why}"));
    let table = Table::open(&folder.join(TABLE_PARQUET)).map_err(|why| refused(&why))?;
    let campaign = runs.campaign();
    let design = campaign.design.as_ref();
    let traffic = design
        .map(|design| Traffic::new(design.per_year))
        .transpose()
        .map_err(|why| refused(&why))?;
    let asked = Asked {
        confidence: Confidence::USUAL,
        traffic,
        periods_years: design.map_or_else(Vec::new, |design| design.return_periods_years.clone()),
        life_years: design.map(|design| design.life_years),
        laws: LAWS.to_vec(),
        threshold: None,
    };
    let inputs: Vec<Input> = campaign.variables.iter().map(input).collect();
    let outputs = outputs(runs, &table);
    let scenario = campaign.scenario.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let notices: Vec<String> =
        runs.base().notices.iter().map(|notice| notice.message.clone()).collect();
    let replay = |row: usize| format!("fenderline campaign replay {} {}", file.display(), row + 1);
    let page = report::render(&report::Campaign {
        title: &campaign.title,
        scenario: &scenario,
        plan: &plan(campaign),
        planned: runs.count(),
        notices: &notices,
        table: &table,
        inputs: &inputs,
        outputs: &outputs,
        weights: None,
        success: campaign.success.as_deref(),
        limits: runs.limits(),
        seen: &seen(runs),
        asked: &asked,
        replay: &replay,
    });
    let page = page.map_err(|why| refused(&why))?;
    write_whole(&folder.join(REPORT), page.as_bytes())?;
    match pdf {
        Some(pdf) => pdf.write(&page),
        None => Ok(()),
    }
}

/// The campaign's plan in words; with the seed, if the plan draws random values.
pub(super) fn plan(campaign: &Campaign) -> String {
    match campaign.plan {
        Plan::FullFactorial | Plan::Table { .. } => campaign.plan.word().to_owned(),
        // The seed draws the sample, and the phases of waves and gusts.
        Plan::Downtime(_) => format!("{}, seed {}", campaign.plan.word(), campaign.seed),
        _ => format!("{}, seed {}", campaign.plan.word(), campaign.seed),
    }
}

/// Names of the output numbers that the report shows: the usual ones that this campaign has, and those that the user
/// asks for. A number that one of the user's formulas uses is not shown by itself.
fn outputs(runs: &Runs, table: &Table) -> Vec<String> {
    let campaign = runs.campaign();
    let used: Vec<String> =
        campaign.expressions.iter().flat_map(|own| names_of(&own.expression)).collect();
    let own = campaign
        .outputs
        .iter()
        .filter(|name| !used.contains(name))
        .chain(campaign.expressions.iter().map(|output| &output.name));
    let shown = SHOWN.iter().map(|name| (*name).to_owned()).chain(own.cloned());
    let limited = runs.limits().iter().map(|limit| limit.output.clone());
    let limited: Vec<String> = limited.filter(|name| !SHOWN.contains(&name.as_str())).collect();
    let mut all: Vec<String> = Vec::new();
    for name in shown.chain(limited) {
        if !all.contains(&name) {
            all.push(name);
        }
    }
    let is_known = |name: &String| {
        let numbers = table.numbers(name);
        numbers.is_ok_and(|numbers| {
            numbers.values.iter().any(|value| value.is_finite() && *value != 0.0)
        })
    };
    all.into_iter()
        .filter(|name| Some(name.as_str()) != campaign.success.as_deref())
        .filter(is_known)
        .collect()
}

/// The ships' paths of the first runs. To find the paths, as many runs are simulated again as a limited number of time
/// steps allows.
fn seen(runs: &Runs) -> Vec<Seen> {
    let setup = &runs.base().setup;
    let affordable = (SEEN_STEPS * setup.step_s / setup.duration_s) as u64;
    let count = affordable.clamp(1, SEEN_RUNS).min(runs.count());
    let mut runner = Runner::new(runs);
    (0..count).filter_map(|run| runner.see(run)).collect()
}

/// Names of the output numbers that a formula uses.
fn names_of(expression: &str) -> Vec<String> {
    Formula::parse(expression).map_or_else(|_| Vec::new(), |formula| formula.names().to_vec())
}

/// Describes a variable of the campaign with its law in words.
pub(super) fn input(variable: &Variable) -> Input {
    let with_unit = |text: String, unit: &str| match unit {
        "" => text,
        unit => format!("{text} (in {unit})"),
    };
    let distribution = match &variable.draw {
        Draw::Choices(choices) => {
            let whole: f64 = choices.iter().map(|choice| choice.weight).sum();
            let share = |weight: f64| fenderline_report::plot::plain(100.0 * weight / whole, 3);
            let each: Vec<String> = choices
                .iter()
                .map(|choice| format!("{}: {} %", choice.label, share(choice.weight)))
                .collect();
            each.join(", ")
        }
        Draw::Law(law, target) => with_unit(law.to_string(), &target.unit),
        Draw::Measured { file, column, .. } => {
            let file = file.file_name().unwrap_or_default().to_string_lossy();
            format!(
                "the measured values of column {column} of {file}, all with the same \
                probability"
            )
        }
        Draw::Expression { text, target } => with_unit(text.clone(), &target.unit),
        Draw::Column { column, .. } => format!("column {column} of the campaign's table"),
    };
    Input {
        column: variable.name.clone(),
        distribution,
        // A formula is its own source.
        source: match (&variable.source, &variable.draw) {
            (Some(source), _) => source.clone(),
            (None, Draw::Expression { .. }) => "computed".to_owned(),
            (None, _) => String::new(),
        },
    }
}

/// Refuses a campaign whose key `success` names no number of its table.
///
/// # Errors
/// Why.
pub(super) fn check_success(runs: &Runs) -> Result<(), String> {
    let Some(success) = &runs.campaign().success else { return Ok(()) };
    let is_it = |head: &&Head| head.name == *success && !head.is_text;
    if runs.heads().iter().any(|head| is_it(&head)) {
        return Ok(());
    }
    let near =
        fenderline_scenario::nearest(success, runs.heads().iter().map(|head| head.name.as_str()));
    let near = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
    Err(format!("`success`: there is no number `{success}`{near}"))
}
