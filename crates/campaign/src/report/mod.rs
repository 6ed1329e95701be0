//! Pages about the numbers of many runs.
//!
//! [`render`] makes the report of a campaign from its table; [`column_page`] makes the page of one column of any table.
//! Both functions return whole pages without outside resources, and hold no more than a few columns in memory.

mod column;
mod convergence;
mod downtime;
mod inputs;
mod limits;
mod operability;
mod plan;
mod quote;
mod scatter;
mod sensitivity;
mod verdicts;
pub mod words;
mod worst;

use fenderline_report::plot::page;
use maud::html;

use crate::limit::Limit;
use crate::statistics::design::{Asked, Findings, findings, zeros_apart};
use crate::statistics::fit::Law;
use crate::statistics::return_value::Traffic;
use crate::statistics::{Sample, SampleError};
use crate::table::{Head, Table, TableError};

pub use column::column_page;
pub use downtime::{DowntimeReport, downtime_page};
pub use quote::{Quote, quote};

/// An input of a campaign.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Input {
    /// Column of the input in the table.
    pub column: String,
    /// Distribution of the input in words, such as `lognormal, mean 7.1 cm/s, deviation 4.47 cm/s`.
    pub distribution: String,
    /// Source of the distribution; empty if none was given.
    pub source: String,
}

/// The contents of a campaign's report.
pub struct Campaign<'a> {
    /// Title of the campaign.
    pub title: &'a str,
    /// Name of the varied scenario, as the report shows it.
    pub scenario: &'a str,
    /// How the runs were drawn, such as `Latin hypercube, seed 7`.
    pub plan: &'a str,
    /// Number of runs that the campaign's plan has.
    pub planned: u64,
    /// Notices of the scenario, which concern every run.
    pub notices: &'a [String],
    /// The campaign's table, with a row for each run.
    pub table: &'a Table,
    /// The inputs. Two inputs with the columns `wind_speed` and `wind_direction` (degrees) are shown as a wind rose.
    pub inputs: &'a [Input],
    /// Columns of numbers that the report shows, the most important first.
    pub outputs: &'a [String],
    /// The column with the weights of importance sampling, if the runs have any.
    pub weights: Option<&'a str>,
    /// Column that is 1 if a run succeeds and 0 if not; without this column the verdict decides.
    pub success: Option<&'a str>,
    /// Limits of outputs.
    pub limits: &'a [Limit],
    /// Runs whose ships' paths are drawn; empty for a table whose runs cannot be made again.
    pub seen: &'a [crate::run::Seen],
    /// What is asked of the statistics: berthings a year, return periods, laws.
    pub asked: &'a Asked,
    /// Gives the command that makes the run of a row (counted from 0) again, with its report.
    pub replay: &'a dyn Fn(usize) -> String,
}

/// An output of the campaign with its statistics.
struct Output<'a> {
    head: &'a Head,
    /// A value for each run; NaN for a run without a value.
    values: Vec<f64>,
    missing: usize,
    /// Number of values of 0, which are left out of the statistics.
    apart: usize,
    /// What is asked of the statistics (such as return periods) for the values other than 0.
    asked: Asked,
    findings: Result<Findings, SampleError>,
}

/// Writes the report of a campaign as a page.
///
/// # Errors
/// Fails if the table cannot be read or lacks a column, or if a return period is impossible.
pub fn render(campaign: &Campaign<'_>) -> Result<String, ReportError> {
    let weights = campaign.weights.map(|name| campaign.table.numbers(name)).transpose()?;
    let verdicts = verdicts::Verdicts::of(campaign.table)?;
    let weights = weights.as_ref().map(|weights| weights.values.as_slice());
    let outputs = all_outputs(campaign, weights)?;
    let body = html! {
        p class="kicker" { "fenderline campaign" }
        h1 { (campaign.title) }
        p class="subtitle" { (subtitle(campaign, verdicts.runs)) }
        h2 { "Verdicts" }
        (verdicts.section(campaign.asked.confidence))
        (plan::section(campaign.seen))
        @for output in &outputs { (section(output, campaign.limits)) }
        (scatter::section(campaign.table)?)
        (worst::section(campaign, &outputs, &verdicts))
        (convergence::section(&outputs, campaign.asked))
        (sensitivity::section(campaign, &outputs)?)
        (operability::section(campaign, &verdicts)?)
        (inputs::section(campaign)?)
        h2 { "How it was computed" }
        (provenance(campaign))
        (column::methods(campaign.asked))
        footer { "Made by fenderline " (env!("CARGO_PKG_VERSION")) ". " (column::USERS_OWN) }
    };
    Ok(page(campaign.title, &body))
}

/// The sentence with the number of runs and the scenario. If there are fewer runs than planned, the sentence says so:
/// the campaign was interrupted, or its stop rule ended it.
fn subtitle(campaign: &Campaign<'_>, runs: usize) -> String {
    let (scenario, planned) = (campaign.scenario, campaign.planned);
    match runs as u64 {
        runs if runs < planned => format!("{runs} of {planned} planned runs of {scenario}."),
        runs => format!("{runs} runs of {scenario}."),
    }
}

/// Plan and notices.
fn provenance(campaign: &Campaign<'_>) -> maud::Markup {
    let replay = (campaign.replay)(0);
    html! {
        ul class="plain" {
            li { "Plan: " (campaign.plan) ". The same file gives the same runs, bit for bit." }
            @for notice in campaign.notices { li { "Notice of the scenario: " (notice) } }
            li { "The sources of the data of ships and fenders, and the estimates, are in the \
                report of a single run (" code { (replay) } " and the like)." }
        }
    }
}

/// Share of the values that lie above the threshold of the tail law (generalised Pareto).
const TAIL: f64 = 0.1;

/// The statistics of each output, in the order of the outputs; each output is computed on a separate thread.
fn all_outputs<'a>(
    campaign: &Campaign<'a>,
    weights: Option<&[f64]>,
) -> Result<Vec<Output<'a>>, ReportError> {
    let (table, asked, names) = (campaign.table, campaign.asked, campaign.outputs);
    std::thread::scope(|scope| {
        let find = |name: &'a String| scope.spawn(move || output(table, asked, name, weights));
        let all: Vec<_> = names.iter().map(find).collect();
        all.into_iter()
            .map(|found| found.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    })
}

/// Reads a column and computes its statistics; values of 0 are left out by the rule of [`zeros_apart`].
fn output<'a>(
    table: &'a Table,
    asked: &Asked,
    name: &str,
    weights: Option<&[f64]>,
) -> Result<Output<'a>, ReportError> {
    let head = table.head(name)?;
    let numbers = table.numbers(name)?;
    let is_there = |value: &f64| value.is_finite();
    let apart = zeros_apart(&numbers.values);
    let is_apart = apart > 0;
    let counts = |value: &f64| is_there(value) && (!is_apart || *value > 0.0);
    let ones = vec![1.0; numbers.values.len()];
    let all = numbers.values.iter().zip(weights.unwrap_or(&ones));
    let (kept, kept_weights): (Vec<f64>, Vec<f64>) =
        all.clone().filter(|(value, _)| counts(value)).unzip();
    let whole: f64 = all.filter(|(value, _)| is_there(value)).map(|(_, weight)| weight).sum();
    let share = if is_apart { kept_weights.iter().sum::<f64>() / whole } else { 1.0 };
    let mut asked = asked.clone();
    asked.traffic = match asked.traffic {
        Some(traffic) => {
            Some(Traffic::new(traffic.per_year() * share).map_err(ReportError::Traffic)?)
        }
        None => None,
    };
    if weights.is_none() && !asked.laws.contains(&Law::Pareto) {
        let mut sorted = kept.clone();
        sorted.sort_by(f64::total_cmp);
        let place = ((1.0 - TAIL) * sorted.len() as f64) as usize;
        asked.threshold = sorted.get(place).copied();
        asked.laws.extend(asked.threshold.map(|_| Law::Pareto));
    }
    let sample = match weights {
        None => Sample::new(kept),
        Some(_) => Sample::weighted(&kept, &kept_weights),
    };
    let found = match sample {
        Ok(sample) => Ok(findings(sample, &asked)?),
        Err(why) => Err(why),
    };
    Ok(Output {
        head,
        values: numbers.values,
        missing: numbers.missing,
        apart,
        findings: found,
        asked,
    })
}

/// The section of the report about one output.
fn section(output: &Output<'_>, limits: &[Limit]) -> maud::Markup {
    let own: Vec<&Limit> = limits.iter().filter(|limit| limit.output == output.head.name).collect();
    let name = capital(&column::words_of(output.head));
    html! {
        h2 { (name) }
        @match &output.findings {
            Ok(findings) => {
                p class="note" { (column::counts(output.head, output.missing, findings)) }
                @if output.apart > 0 {
                    p class="note" {
                        (format!(
                            "{} further runs have 0: nothing was touched, or the run ended before \
                             the ship arrived (a longer time.duration shows which). ",
                            output.apart,
                        ))
                        "The statistics are of the other runs"
                        @if let Some(traffic) = output.asked.traffic {
                            (format!(", of which there are {} a year", words::number(traffic.per_year())))
                        }
                        "."
                    }
                }
                (column::sections(output.head, findings, &output.asked, &own))
            }
            Err(why) => p { "No statistics: " (why) "." },
        }
    }
}

/// With a capital letter.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Why a report cannot be made.
#[derive(Clone, Debug, PartialEq)]
pub enum ReportError {
    /// The table cannot be read.
    Table(TableError),
    /// The number of berthings a year, a return period or the lifetime is impossible.
    Traffic(crate::statistics::return_value::TrafficError),
}

impl core::fmt::Display for ReportError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            ReportError::Table(why) => why.fmt(f),
            ReportError::Traffic(why) => why.fmt(f),
        }
    }
}

impl core::error::Error for ReportError {}

impl From<TableError> for ReportError {
    fn from(why: TableError) -> ReportError {
        ReportError::Table(why)
    }
}

impl From<crate::statistics::return_value::TrafficError> for ReportError {
    fn from(why: crate::statistics::return_value::TrafficError) -> ReportError {
        ReportError::Traffic(why)
    }
}
