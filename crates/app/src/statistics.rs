//! `fenderline statistics`: exceedance, fits and design values of a column of a table.

mod column;
mod json;
mod printed;

use self::column::Column;
use fenderline_campaign::report::column_page;
use fenderline_campaign::statistics::Sample;
use fenderline_campaign::statistics::design::{Asked, findings, zeros_apart};
use fenderline_campaign::statistics::fit::Law;
use fenderline_campaign::statistics::return_value::Traffic;
use fenderline_campaign::table::{Head, Table};
use fenderline_scenario::printable_line;
use serde_json::json;

use crate::cli::StatisticsArgs;
use crate::failure::Failure;
use crate::output::{make_folder, write_whole};
use crate::terminal::{answer, say, say_json};

/// Return periods that are used if the user gives none (years).
const PERIODS_YEARS: [f64; 3] = [10.0, 50.0, 100.0];

/// Probability laws that are fitted if the user gives none.
const LAWS: [Law; 4] = [Law::LogNormal, Law::Weibull, Law::Gumbel, Law::Gev];

/// Reads a column of a table, prints its statistics, and writes a page if `args` asks for one.
///
/// # Errors
/// Fails if the table cannot be read, if the column is missing or holds too few numbers, if the number of berthings or
/// years is impossible, if no law can be fitted, or if a file cannot be written.
pub(crate) fn statistics(args: &StatisticsArgs) -> Result<(), Failure> {
    let refused = |why: &dyn core::fmt::Display| Failure::input(format_args!("error: {why}"));
    let table = Table::open(&args.table).map_err(|why| refused(&why))?;
    let Some(name) = &args.column else {
        return list(&table, args.json);
    };
    let mut asked = asked(args)?;
    // Impossible years are refused before a long table is read.
    asked.rarities().map_err(|why| refused(&why))?;
    let head = table.head(name).map_err(|why| refused(&why))?;
    let numbers = table.numbers(name).map_err(|why| refused(&why))?;
    let in_column = |why: &dyn core::fmt::Display| {
        let file = args.table.display().to_string();
        refused(&format_args!("{}: column `{}`: {why}", printable_line(&file), head.name))
    };
    // In the table of a campaign, 0 is a run in which nothing was touched; in measurements it is a value.
    let is_of_campaign = table.has("verdict") && args.weights.is_none();
    let zeros = if is_of_campaign { zeros_apart(&numbers.values) } else { 0 };
    let all = numbers.present();
    if let Some(traffic) = asked.traffic.filter(|_| zeros > 0) {
        let share = (all.len() - zeros) as f64 / all.len() as f64;
        asked.traffic =
            Some(Traffic::new(traffic.per_year() * share).map_err(|why| refused(&why))?);
    }
    let sample = match &args.weights {
        None if zeros > 0 => Sample::new(all.into_iter().filter(|value| *value > 0.0).collect()),
        None => Sample::new(all),
        Some(weights) => {
            let weights = table.numbers(weights).map_err(|why| refused(&why))?;
            let pairs = numbers.values.iter().zip(&weights.values);
            let (values, weights): (Vec<f64>, Vec<f64>) =
                pairs.filter(|(value, _)| value.is_finite()).unzip();
            Sample::weighted(&values, &weights)
        }
    };
    let sample = sample.map_err(|why| in_column(&why))?;
    let found = findings(sample, &asked).map_err(|why| refused(&why))?;
    // A law that was named must be possible; of those that were not, some.
    let failed = found.fits.iter().filter_map(|fit| fit.as_ref().err());
    let mut failed = failed.filter(|_| args.weights.is_none());
    if let Some(why) = failed.next().filter(|_| !args.fit.is_empty()) {
        return Err(in_column(why));
    }
    let file = args.table.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let column = Column { file, head, missing: numbers.missing, zeros, findings: found, asked };
    let text = format!("{:#}\n", json::of(&column));
    if let Some(folder) = &args.out {
        make_folder(folder)?;
        let page = column_page(&column.file, head, column.missing, &column.findings, &column.asked);
        write_whole(&folder.join("statistics.html"), page.as_bytes())?;
        write_whole(&folder.join("statistics.json"), text.as_bytes())?;
    }
    if args.json {
        return say_json(&text);
    }
    answer(&printed::text(&column))?;
    match &args.out {
        Some(folder) => {
            say(&format!("in {}: statistics.html, statistics.json\n", folder.display()))
        }
        None => Ok(()),
    }
}

fn asked(args: &StatisticsArgs) -> Result<Asked, Failure> {
    let traffic = args.per_year.map(Traffic::new).transpose();
    let traffic =
        traffic.map_err(|why| Failure::input(format_args!("error: --per-year: {why}")))?;
    if args.threshold.is_some_and(|threshold| !threshold.is_finite()) {
        return Err(Failure::input("error: --threshold must be a finite number"));
    }
    let is_named = !args.fit.is_empty();
    if is_named && args.fit.contains(&Law::Pareto) && args.threshold.is_none() {
        return Err(Failure::input(
            "error: --fit gpd needs --threshold: the law is fitted to the values above the \
             threshold",
        ));
    }
    if is_named && !args.fit.contains(&Law::Pareto) && args.threshold.is_some() {
        return Err(Failure::input("error: --threshold belongs to --fit gpd, which is not given"));
    }
    let mut laws = if is_named { args.fit.clone() } else { LAWS.to_vec() };
    if !is_named && args.threshold.is_some() {
        laws.push(Law::Pareto);
    }
    // Each law once, in one order.
    laws.sort();
    laws.dedup();
    let periods_years = match (args.return_period.is_empty(), args.life) {
        (true, None) => PERIODS_YEARS.to_vec(),
        (true, Some(years)) => [10.0, years].into_iter().filter(|years| *years > 1.0).collect(),
        (false, _) => args.return_period.clone(),
    };
    Ok(Asked {
        confidence: args.confidence,
        traffic,
        periods_years,
        life_years: args.life,
        laws,
        threshold: args.threshold,
    })
}

/// Prints the names of the columns of a table.
fn list(table: &Table, is_json: bool) -> Result<(), Failure> {
    if is_json {
        let heads = table.heads().iter();
        let heads = heads
            .map(|head| json!({ "name": head.name, "unit": head.unit, "meaning": head.meaning }));
        return say_json(&format!("{:#}\n", json!(heads.collect::<Vec<_>>())));
    }
    let line = |head: &Head| match head.meaning.as_str() {
        "" => format!("{}\n", head.title()),
        meaning => format!("{}: {meaning}\n", head.title()),
    };
    let lines: String = table.heads().iter().map(line).collect();
    answer(&format!("{lines}--column NAME gives the statistics of one column\n"))
}
