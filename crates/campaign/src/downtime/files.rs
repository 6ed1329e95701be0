//! The tables of a downtime analysis as text.

use serde_json::{Value as Json, json};

use super::count::{Count, DowntimeTable};
use super::outcome::Outcome;
use super::plan::{BETWEEN, DowntimePlan};
use super::weather::HOURS_OF_A_YEAR;
use crate::row::Cell;
use crate::statistics::Estimate;

/// File name of the table of lost hours.
pub const DOWNTIME_CSV: &str = "downtime.csv";
/// Name of the JSON file with the lost hours and the error of the states.
pub const DOWNTIME_JSON: &str = "downtime.json";
/// File name of the table of all rows of the weather, each with its state.
pub const HOURS_CSV: &str = "hours.csv";

/// A share in per cent, rounded to a thousandth of a per cent; empty if nothing is known.
fn percent(share: Option<f64>) -> String {
    share.map_or_else(String::new, |share| shortest(100.0 * share))
}

/// A number to three decimals, in its shortest form.
fn shortest(value: f64) -> String {
    Cell::of_number(libm::round(value * 1e3) / 1e3).shown()
}

/// The table of lost hours: in all, by reason, by month and by direction.
///
/// # Errors
/// Gives the reason why the table cannot be written as text.
pub fn downtime_csv(table: &DowntimeTable) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "group",
        "name",
        "hours [h]",
        "lost [h]",
        "lost_share [%]",
        "alone [h]",
        "gravest [h]",
        "not_run [h]",
    ])?;
    let counted = |group: &str, name: &str, count: &Count| {
        [
            group.to_owned(),
            name.to_owned(),
            shortest(count.hours),
            shortest(count.lost),
            percent(count.share()),
            String::new(),
            String::new(),
            shortest(count.not_run),
        ]
    };
    writer.write_record(counted("all", "all", &table.all))?;
    let known = table.all.hours - table.all.not_run;
    for reason in &table.reasons {
        writer.write_record([
            "reason".to_owned(),
            reason.name.clone(),
            shortest(table.all.hours),
            shortest(reason.hours),
            percent((known > 0.0).then(|| reason.hours / known)),
            shortest(reason.alone),
            shortest(reason.gravest),
            shortest(table.all.not_run),
        ])?;
    }
    for group in &table.groups {
        for (name, count) in &group.counts {
            writer.write_record(counted(&group.name, name, count))?;
        }
    }
    Ok(text(writer))
}

/// The table of all rows of the weather: time or number of the row, hours, state, whether the hours are lost, and for
/// which reasons.
///
/// # Errors
/// Gives the reason why the table cannot be written as text.
pub fn hours_csv(plan: &DowntimePlan, table: &DowntimeTable) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let weather = plan.weather();
    let first = if weather.is_series() { "time" } else { "class" };
    writer.write_record([first, "hours [h]", "state", "lost", "lost_by"])?;
    for row in 0..weather.len() {
        let state = plan.state_of(row);
        let (lost, by) = match &table.outcomes[state] {
            Outcome::Works => ("0", String::new()),
            Outcome::Lost(reasons) => ("1", reasons.join(BETWEEN)),
            Outcome::NotRun => ("", "not run".to_owned()),
        };
        let name = weather.times.get(row).cloned().unwrap_or_else(|| (row + 1).to_string());
        writer.write_record([
            name,
            shortest(weather.hours[row]),
            (state + 1).to_string(),
            lost.to_owned(),
            by,
        ])?;
    }
    Ok(text(writer))
}

fn text(writer: csv::Writer<Vec<u8>>) -> String {
    let bytes = writer.into_inner().expect("memory takes all");
    String::from_utf8(bytes).expect("all cells are text")
}

fn count_json(count: &Count) -> Json {
    json!({
        "hours": count.hours,
        "lost_hours": count.lost,
        "lost_share": count.share(),
        "not_run_hours": count.not_run,
    })
}

fn estimate_json(estimate: Option<&Estimate>) -> Json {
    estimate.map_or(
        Json::Null,
        |own| json!({ "share": own.value, "low": own.interval.low, "high": own.interval.high }),
    )
}

/// The downtime for programs.
#[must_use]
pub fn downtime_json(plan: &DowntimePlan, table: &DowntimeTable) -> Json {
    let reasons = table.reasons.iter().map(|reason| {
        json!({
            "name": reason.name,
            "hours": reason.hours,
            "hours_alone": reason.alone,
            "hours_gravest": reason.gravest,
        })
    });
    let groups = table.groups.iter().map(|group| {
        let counts = group.counts.iter().map(|(name, count)| {
            let mut json = count_json(count);
            json["name"] = json!(name);
            json
        });
        json!({ "group": group.name, "counts": counts.collect::<Vec<_>>() })
    });
    let check = table.check.as_ref().map(|check| {
        json!({
            "hours_drawn": check.drawn,
            "hours_compared": check.compared,
            "lost_by_both": check.both,
            "lost_by_state_alone": check.by_state_alone,
            "lost_as_it_is_alone": check.as_it_is_alone,
            "lost_by_neither": check.neither,
            "confidence": check.confidence.level(),
            "disagree": estimate_json(check.disagree.as_ref()),
            "lost_as_they_are": estimate_json(check.lost_as_they_are.as_ref()),
        })
    });
    json!({
        "weather": plan.weather().file_name(),
        "states": plan.states(),
        "all": count_json(&table.all),
        "lost_hours_a_year": table.all.share().map(|share| share * HOURS_OF_A_YEAR),
        "reasons": reasons.collect::<Vec<_>>(),
        "groups": groups.collect::<Vec<_>>(),
        "sample": check,
    })
}
