//! The weather of a berth: a series of hours, or a scatter diagram.

use std::path::{Path, PathBuf};

use fenderline_scenario::{LoadError, ScenarioError, nearest};

use super::quantity::{Agent, HOURS, QUANTITIES, Quantity, Role, SECONDS, SHARE, TIME};
use super::time::Time;
use crate::error::CampaignError;
use crate::table::Table;

/// Hours of a year.
pub const HOURS_OF_A_YEAR: f64 = 8760.0;

/// Breaking limit: no single wave is higher than this share of the water depth (McCowan 1894, by Turner 2010, "Testing
/// a ratio for the relationship between wave height and water depth"): a significant height above this share is a
/// mistake in the file or in the depth.
const BREAKING: f64 = 0.78;

/// Rounded shares of a scatter diagram may miss a sum of 1 by this much.
const ROUNDED: f64 = 0.01;

/// The weather of a berth: a row for each hour of a series, or a row for each class of a scatter diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct Weather {
    table: Table,
    /// The quantities that the weather has.
    pub(super) quantities: Vec<&'static Quantity>,
    /// The values of each row, in the order of the quantities.
    pub(super) rows: Vec<Vec<f64>>,
    /// Hours for which each row stands.
    pub(super) hours: Vec<f64>,
    /// Time of each row as written in the file; empty for a scatter diagram.
    pub(super) times: Vec<String>,
    /// Month of each row, counted from 0 for January; `None` if the file has no dates.
    pub(super) months: Option<Vec<usize>>,
}

impl Weather {
    /// Reads a weather's file.
    ///
    /// # Errors
    /// Fails if the file is no table, if a column is unknown or missing, if a cell is empty or out of bounds, if a
    /// series has a gap, or if the shares of a scatter diagram do not sum to 1. Errors about a row point at its line.
    pub(super) fn read(file: &Path) -> Result<Weather, CampaignError> {
        let table = Table::open(file)?;
        let quantities = quantities(&table)?;
        let mut columns = Vec::new();
        for quantity in &quantities {
            columns.push(bounded_column(&table, quantity.column, quantity.range)?);
        }
        let count = columns[0].len();
        if count == 0 {
            return Err(refused(file, "the file has no rows below its head"));
        }
        let mut rows: Vec<Vec<f64>> =
            (0..count).map(|row| columns.iter().map(|column| column[row]).collect()).collect();
        let mut kept: Vec<usize> = (0..count).collect();
        let mut hours: Vec<f64>;
        let (mut times, mut months) = (Vec::new(), None);
        let given: Vec<&str> =
            [TIME, SECONDS, HOURS, SHARE].into_iter().filter(|name| table.has(name)).collect();
        match given[..] {
            [TIME] => {
                let read = dates(&table)?;
                hours = steps(
                    &table,
                    TIME,
                    &read.iter().map(|time| time.s as f64).collect::<Vec<_>>(),
                )?;
                times = table.texts(TIME)?.iter().map(|text| text.trim().to_owned()).collect();
                months = Some(read.iter().map(|time| time.month).collect());
            }
            [SECONDS] => {
                let read = bounded_column(&table, SECONDS, [-1e12, 1e12])?;
                hours = steps(&table, SECONDS, &read)?;
                times = read.iter().map(f64::to_string).collect();
            }
            [HOURS] => hours = bounded_column(&table, HOURS, [0.0, 1e9])?,
            [SHARE] => {
                let shares = bounded_column(&table, SHARE, [0.0, 1.0])?;
                let sum: f64 = shares.iter().sum();
                if (sum - 1.0).abs() > ROUNDED {
                    let why = format!(
                        "the column `{SHARE}` sums to {sum:.4}: for a whole year it must sum to 1"
                    );
                    return Err(refused(file, &why));
                }
                hours = shares.iter().map(|share| share / sum * HOURS_OF_A_YEAR).collect();
            }
            [] => {
                let why = "a series has a column `time` or `t_s`, a scatter diagram a column \
                    `hours` or `share`: the file has none of these";
                return Err(refused(file, why));
            }
            _ => {
                let why = format!("the columns {} do not go together", given.join(" and "));
                return Err(refused(file, &why));
            }
        }
        if times.is_empty() {
            // Classes of a diagram in which no hour fell.
            kept.retain(|row| hours[*row] > 0.0);
            if kept.is_empty() {
                return Err(refused(file, "no class of the diagram has hours"));
            }
            rows = kept.iter().map(|row| rows[*row].clone()).collect();
            hours = kept.iter().map(|row| hours[*row]).collect();
        }
        Ok(Weather { table, quantities, rows, hours, times, months })
    }

    /// Whether the weather is a series of hours, rather than a scatter diagram.
    #[must_use]
    pub fn is_series(&self) -> bool {
        !self.times.is_empty()
    }

    /// Name of the file, without its folder.
    #[must_use]
    pub fn file_name(&self) -> String {
        self.table.path().file_name().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// It has rows always.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The index of the agent's quantity that has the given role, if the weather has this quantity.
    pub(super) fn index(&self, agent: Agent, role: Role) -> Option<usize> {
        self.quantities.iter().position(|own| own.agent == agent && own.role == role)
    }

    /// Refuses waves that are too high for the water depth. `level_m` is the highest water level of the scenario's
    /// tide, for a weather without levels.
    ///
    /// # Errors
    /// The first such row.
    pub(super) fn check_breaking(&self, depth_m: f64, level_m: f64) -> Result<(), CampaignError> {
        let Some(height) = self.index(Agent::Waves, Role::Strength) else { return Ok(()) };
        let level = self.index(Agent::Level, Role::Level);
        for (row, values) in self.rows.iter().enumerate() {
            let water_m = depth_m + level.map_or(level_m, |level| values[level]);
            let (hs_m, most_m) = (values[height], BREAKING * water_m);
            if hs_m > most_m {
                let why = format!(
                    "a significant height of {hs_m} m in water of {water_m} m: waves break at \
                     {BREAKING} of the water depth (McCowan 1894), here at {most_m:.2} m"
                );
                return Err(in_row(&self.table, self.quantities[height].column, row, why));
            }
        }
        Ok(())
    }
}

/// The quantities that a weather file has; of each agent it must have all quantities or none.
fn quantities(table: &Table) -> Result<Vec<&'static Quantity>, CampaignError> {
    let others = [TIME, SECONDS, HOURS, SHARE];
    let known = || QUANTITIES.iter().map(|own| own.column).chain(others);
    for head in table.heads() {
        let title = head.title();
        if !known().any(|name| name == title) {
            let near = match nearest(&title, known()) {
                Some(near) => format!("; did you mean `{near}`?"),
                None => format!("; there are {}", known().collect::<Vec<_>>().join(", ")),
            };
            return Err(refused(
                table.path(),
                &format!("the column `{title}` is not one of a weather{near}"),
            ));
        }
    }
    let found: Vec<&Quantity> = QUANTITIES.iter().filter(|own| table.has(own.column)).collect();
    for own in &found {
        let missing =
            QUANTITIES.iter().find(|other| other.agent == own.agent && !table.has(other.column));
        if let Some(missing) = missing {
            let why =
                format!("the column `{}` is missing: `{}` needs it", missing.column, own.column);
            return Err(refused(table.path(), &why));
        }
    }
    if found.iter().all(|own| own.agent == Agent::Level) {
        let why = "the file has neither waves (hs_m), wind (wind_speed_mps) nor current \
             (current_speed_mps)";
        return Err(refused(table.path(), why));
    }
    Ok(found)
}

/// Reads a column of numbers; all must be within bounds, and none may be missing.
fn bounded_column(
    table: &Table,
    column: &str,
    [low, high]: [f64; 2],
) -> Result<Vec<f64>, CampaignError> {
    let values = table.numbers(column)?.values;
    if let Some(row) = values.iter().position(|value| value.is_nan()) {
        let why = format!(
            "`{column}` is empty here: fill the gap, or leave its hours out of the weather"
        );
        return Err(in_row(table, column, row, why));
    }
    if let Some(row) = values.iter().position(|value| !(low..=high).contains(value)) {
        let why = format!("`{column}` must be between {low} and {high}, but is {}", values[row]);
        return Err(in_row(table, column, row, why));
    }
    Ok(values)
}

/// Reads the times of a weather series.
fn dates(table: &Table) -> Result<Vec<Time>, CampaignError> {
    let read = |(row, text): (usize, &str)| {
        Time::parse(text).ok_or_else(|| {
            let why = format!("`{text}` is not a time as 2025-01-31T23:00, in UTC");
            in_row(table, TIME, row, why)
        })
    };
    table.texts(TIME)?.iter().enumerate().map(read).collect()
}

/// The hours for which each row of a series stands: the step of the series.
fn steps(table: &Table, column: &str, times_s: &[f64]) -> Result<Vec<f64>, CampaignError> {
    let [first_s, second_s, ..] = times_s else {
        return Err(refused(table.path(), "a series needs at least two rows"));
    };
    let step_s = second_s - first_s;
    for (row, pair) in times_s.windows(2).enumerate() {
        let own_s = pair[1] - pair[0];
        if own_s <= 0.0 {
            return Err(in_row(
                table,
                column,
                row + 1,
                "the row is not later than the row before".to_owned(),
            ));
        }
        // Steps are compared to a second.
        if (own_s - step_s).abs() > 1.0 {
            let why = format!(
                "{} h after the row before, but the step of the series is {} h: fill the gap",
                own_s / 3600.0,
                step_s / 3600.0
            );
            return Err(in_row(table, column, row + 1, why));
        }
    }
    Ok(vec![step_s / 3600.0; times_s.len()])
}

fn in_row(table: &Table, column: &str, row: usize, why: String) -> CampaignError {
    let origin = table.origin(column, row);
    LoadError::Refused(ScenarioError::in_row(&origin, "downtime.file", why)).into()
}

fn refused(file: &Path, why: &str) -> CampaignError {
    CampaignError::Values { file: PathBuf::from(file), why: why.to_owned() }
}
