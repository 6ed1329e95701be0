//! Counts the hours that a berth loses to the weather: an hour is lost if the run of its state (its group of similar
//! hours) exceeds a limit.

use core::fmt;

use super::check::StatesCheck;
use super::outcome::Outcome;
use super::plan::{BETWEEN, DowntimePlan, LOST_BY};
use super::quantity::{Agent, Role};
use super::time::MONTHS;
use crate::statistics::Confidence;
use crate::statistics::operability::sector;
use crate::table::{Table, TableError};

/// Names of the sixteen compass directions, clockwise from north.
pub const SECTOR_NAMES: [&str; 16] = [
    "N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE", "S", "SSW", "SW", "WSW", "W", "WNW", "NW",
    "NNW",
];

/// A count of hours: all, lost and not run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Count {
    /// Number of all hours.
    pub hours: f64,
    /// Number of lost hours.
    pub lost: f64,
    /// Number of hours whose state could not be run.
    pub not_run: f64,
    /// Lost hours by their gravest reason, in the order of [`DowntimeTable::reasons`].
    pub by_reason: Vec<f64>,
}

impl Count {
    /// Share of lost hours among all hours with a result.
    #[must_use]
    pub fn share(&self) -> Option<f64> {
        let known = self.hours - self.not_run;
        (known > 0.0).then(|| self.lost / known)
    }
}

/// A reason for which hours are lost.
#[derive(Clone, Debug, PartialEq)]
pub struct Reason {
    /// Name of the exceeded limit, or the verdict in words.
    pub name: String,
    /// Hours that are lost for this reason, alone or with other reasons.
    pub hours: f64,
    /// Hours for which this reason is the only reason.
    pub alone: f64,
    /// Hours for which this reason is the gravest.
    pub gravest: f64,
}

/// Lost hours grouped by one property, such as the month.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Name of the property: `month`, `wave direction` or `wind direction`.
    pub name: String,
    /// Each value of the property, such as January, with its count of hours.
    pub counts: Vec<(String, Count)>,
}

/// The downtime of a berth.
#[derive(Clone, Debug, PartialEq)]
pub struct DowntimeTable {
    /// How each run ended: first the runs of the states, then the runs of the sampled hours.
    pub outcomes: Vec<Outcome>,
    /// All hours.
    pub all: Count,
    /// Reasons, the reason with most hours first; limits of the scenario that were never exceeded
    /// are listed with 0.
    pub reasons: Vec<Reason>,
    /// Lost hours by month, wave direction and wind direction, as far as the weather has these properties.
    pub groups: Vec<Group>,
    /// The single hours compared with their states; `None` without a sample.
    pub check: Option<StatesCheck>,
}

/// Why a downtime cannot be counted.
#[derive(Clone, Debug, PartialEq)]
pub enum DowntimeError {
    /// The campaign's table cannot be read.
    Table(TableError),
    /// The number of rows of the table differs from the number of runs.
    Rows {
        /// Rows of the table.
        own: usize,
        /// Runs.
        wanted: u64,
    },
}

impl fmt::Display for DowntimeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DowntimeError::Table(why) => why.fmt(f),
            DowntimeError::Rows { own, wanted } => {
                write!(f, "the table has {own} rows, and there are {wanted} runs")
            }
        }
    }
}

impl core::error::Error for DowntimeError {}

impl From<TableError> for DowntimeError {
    fn from(why: TableError) -> DowntimeError {
        DowntimeError::Table(why)
    }
}

impl DowntimeTable {
    /// Counts the lost hours from a campaign's table. `limits` are the names of the scenario's limits.
    ///
    /// # Errors
    /// Fails if the table cannot be read, or if it has another number of rows than there are runs.
    pub fn of(
        plan: &DowntimePlan,
        table: &Table,
        limits: &[String],
        confidence: Confidence,
    ) -> Result<DowntimeTable, DowntimeError> {
        let (verdicts, lost_by) = (table.texts("verdict")?, table.texts(LOST_BY)?);
        if verdicts.len() as u64 != plan.runs() {
            return Err(DowntimeError::Rows { own: verdicts.len(), wanted: plan.runs() });
        }
        let outcome = |(verdict, reasons): (&str, &str)| match (verdict, reasons) {
            ("error", _) => Outcome::NotRun,
            (_, "") => Outcome::Works,
            (_, reasons) => Outcome::Lost(reasons.split(BETWEEN).map(str::to_owned).collect()),
        };
        let outcomes: Vec<Outcome> = verdicts.iter().zip(lost_by.iter()).map(outcome).collect();
        let reasons = reasons(plan, &outcomes, limits);
        let weather = plan.weather();
        let mut all = Count { by_reason: vec![0.0; reasons.len()], ..Count::default() };
        let mut groups = empty_groups(plan, &all);
        for row in 0..weather.len() {
            let hours = weather.hours[row];
            let outcome = &outcomes[plan.state_of(row)];
            add(&mut all, hours, outcome, &reasons);
            for (group, place) in &mut groups {
                add(&mut group.counts[place(row)].1, hours, outcome, &reasons);
            }
        }
        let groups = groups.into_iter().map(|(group, _)| group).collect();
        let check = StatesCheck::of(plan, &outcomes, confidence);
        Ok(DowntimeTable { outcomes, all, reasons, groups, check })
    }
}

/// The lost hours grouped by one property, and the function that says to which value of the property a weather row
/// belongs.
type Placed<'p> = (Group, Box<dyn Fn(usize) -> usize + 'p>);

/// The groups that a weather has (month, wave direction, wind direction), still without counted hours.
fn empty_groups<'p>(plan: &'p DowntimePlan, none: &Count) -> Vec<Placed<'p>> {
    let weather = plan.weather();
    let mut groups: Vec<Placed<'p>> = Vec::new();
    let empty = |name: &str, values: &[&str]| Group {
        name: name.to_owned(),
        counts: values.iter().map(|value| ((*value).to_owned(), none.clone())).collect(),
    };
    if let Some(months) = &weather.months {
        groups.push((empty("month", &MONTHS), Box::new(|row| months[row])));
    }
    for (agent, name) in [(Agent::Waves, "wave direction"), (Agent::Wind, "wind direction")] {
        let Some(index) = weather.index(agent, Role::Direction) else { continue };
        let place = move |row: usize| sector(weather.rows[row][index], SECTOR_NAMES.len());
        groups.push((empty(name, &SECTOR_NAMES), Box::new(place)));
    }
    groups
}

fn add(count: &mut Count, hours: f64, outcome: &Outcome, reasons: &[Reason]) {
    count.hours += hours;
    match outcome {
        Outcome::Works => {}
        Outcome::NotRun => count.not_run += hours,
        Outcome::Lost(_) => {
            count.lost += hours;
            let place = reasons.iter().position(|own| Some(own.name.as_str()) == outcome.reason());
            count.by_reason[place.expect("all reasons of the states are known")] += hours;
        }
    }
}

/// All reasons for which the states are lost.
fn reasons(plan: &DowntimePlan, outcomes: &[Outcome], limits: &[String]) -> Vec<Reason> {
    let new = |name: &String| Reason { name: name.clone(), hours: 0.0, alone: 0.0, gravest: 0.0 };
    let mut all: Vec<Reason> = limits.iter().map(new).collect();
    for (state, outcome) in outcomes[..plan.states()].iter().enumerate() {
        let Outcome::Lost(names) = outcome else { continue };
        let hours = plan.hours_of(state);
        for (place, name) in names.iter().enumerate() {
            let known = all.iter().position(|own| own.name == *name);
            let known = known.unwrap_or_else(|| {
                all.push(new(name));
                all.len() - 1
            });
            let own = &mut all[known];
            own.hours += hours;
            own.alone += if names.len() == 1 { hours } else { 0.0 };
            own.gravest += if place == 0 { hours } else { 0.0 };
        }
    }
    all.sort_by(|one, other| other.hours.total_cmp(&one.hours));
    all
}
