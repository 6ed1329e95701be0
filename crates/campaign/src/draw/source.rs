//! The sources of the variables' values: choices, laws, formulas, and files, which this module reads.

use std::path::{Path, PathBuf};

use crate::file::law::Law;
use crate::file::{Choice, Draw, Target, Variable};
use fenderline_scenario::Origin;

use crate::downtime::Given;
use crate::error::CampaignError;
use crate::row::Head;
use crate::table::Table;

/// Where a variable's value comes from.
pub(super) enum Source {
    Choices {
        choices: Vec<Choice>,
        /// The numbers of the choices; `None` if the choices are names.
        numbers: Option<Vec<f64>>,
        /// Sum of the weights up to each choice, divided by the sum of all weights.
        cumulative: Vec<f64>,
    },
    Law(Law, Target),
    /// Measured values.
    Measured(Measured),
    Formula(Target),
    Numbers(Column<f64>),
    Texts(Column<String>),
    /// The numbers of the states and hours of a downtime campaign, one for each run.
    States {
        values: Vec<f64>,
        target: Target,
    },
    /// Words about the states and hours of a downtime campaign, which change nothing in the scenario.
    Words {
        values: Vec<String>,
        target: Target,
    },
}

/// The measured values of a column of a file.
pub(super) struct Measured {
    /// The measured values, in rising order.
    pub(super) values: Vec<f64>,
    /// The row of each value in the file, counted from 0.
    pub(super) rows: Vec<usize>,
    file: PathBuf,
    column: String,
    pub(super) target: Target,
}

/// A column of the campaign's table, with a value for each run.
pub(super) struct Column<T> {
    pub(super) values: Vec<T>,
    file: PathBuf,
    name: String,
    pub(super) target: Target,
}

impl Source {
    /// The scenario keys that get the values; `None` for choices, which have changes of their own.
    pub(super) fn target(&self) -> Option<&Target> {
        match self {
            Source::Choices { .. } => None,
            Source::Law(_, target) | Source::Formula(target) => Some(target),
            Source::Measured(own) => Some(&own.target),
            Source::Numbers(own) => Some(&own.target),
            Source::Texts(own) => Some(&own.target),
            Source::States { target, .. } | Source::Words { target, .. } => Some(target),
        }
    }

    /// The number of choices; 1 for a source without choices.
    pub(super) fn choices(&self) -> usize {
        match self {
            Source::Choices { choices, .. } => choices.len().max(1),
            _ => 1,
        }
    }

    /// The file from which the values come, if there is one.
    pub(super) fn file(&self) -> Option<&Path> {
        match self {
            Source::Measured(own) => Some(&own.file),
            Source::Numbers(own) => Some(&own.file),
            Source::Texts(own) => Some(&own.file),
            Source::Choices { .. }
            | Source::Law(..)
            | Source::Formula(_)
            | Source::States { .. }
            | Source::Words { .. } => None,
        }
    }

    /// Place of the value in row `row` (from 0) of its file; for a law or formula the place in the campaign's file.
    pub(super) fn origin(&self, row: usize) -> Option<Origin> {
        let column = match self {
            Source::Measured(own) => own.column.as_str(),
            Source::Numbers(own) => own.name.as_str(),
            Source::Texts(own) => own.name.as_str(),
            Source::Choices { .. }
            | Source::Law(..)
            | Source::Formula(_)
            | Source::States { .. }
            | Source::Words { .. } => "",
        };
        let found = self.file().and_then(|file| Some(Table::open(file).ok()?.origin(column, row)));
        found.or_else(|| self.target()?.origins.values.clone())
    }
}

pub(super) fn open(file: &Path) -> Result<Table, CampaignError> {
    Table::open(file).map_err(CampaignError::from)
}

/// Reads the numbers of a column; none of them may be missing.
fn numbers(table: &Table, file: &Path, column: &str) -> Result<(Vec<f64>, String), CampaignError> {
    let read = table.numbers(column)?;
    if let Some(row) = read.values.iter().position(|value| value.is_nan()) {
        // The heads are line 1 of a text.
        let why = format!(
            "column `{column}` has no value in row {}, line {} of a text",
            row + 1,
            row + 2
        );
        return Err(CampaignError::values(file, why));
    }
    if read.values.is_empty() {
        return Err(CampaignError::values(file, format!("column `{column}` has no rows")));
    }
    let unit =
        table.heads().iter().find(|head| head.name == column).map_or("", |head| head.unit.as_str());
    Ok((read.values, unit.to_owned()))
}

/// The target of a variable; if the campaign names no unit, the target gets the unit from the head of the file's
/// column.
///
/// # Errors
/// Fails if the campaign's file and the head of the column name different units.
fn with_unit(variable: &Variable, target: &Target, unit: String) -> Result<Target, CampaignError> {
    match (target.unit.as_str(), unit.as_str()) {
        ("", _) => Ok(Target { unit, ..target.clone() }),
        (_, "") => Ok(target.clone()),
        (own, other) if own == other => Ok(target.clone()),
        (own, other) => {
            let why = format!(
                "the variable's `unit` is {own}, but the head of the file's column says {other}"
            );
            Err(CampaignError::part(format!("variable.{}", variable.name), why))
        }
    }
}

/// Reads the source of a variable's values, with its files, and returns the source and the unit.
pub(super) fn source(
    variable: &Variable,
    table: Option<&Table>,
) -> Result<(Source, String), CampaignError> {
    Ok(match &variable.draw {
        Draw::Choices(choices) => {
            let whole: f64 = choices.iter().map(|choice| choice.weight).sum();
            let mut sum = 0.0;
            let cumulative = choices
                .iter()
                .map(|choice| {
                    sum += choice.weight;
                    sum / whole
                })
                .collect();
            let found = variable.numbers();
            let unit = found.as_ref().map_or(String::new(), |(_, unit)| (*unit).to_owned());
            let numbers = found.map(|(numbers, _)| numbers);
            (Source::Choices { choices: choices.clone(), numbers, cumulative }, unit)
        }
        Draw::Law(law, target) => (Source::Law(*law, target.clone()), target.unit.clone()),
        Draw::Measured { file, column, target } => {
            let (read, unit) = numbers(&open(file)?, file, column)?;
            let mut rows: Vec<usize> = (0..read.len()).collect();
            rows.sort_by(|a, b| read[*a].total_cmp(&read[*b]));
            let values = rows.iter().map(|row| read[*row]).collect();
            let target = with_unit(variable, target, unit)?;
            if target.unit.is_empty() && !target.is_plain && !target.keys.is_empty() {
                let why = format!(
                    "column `{column}` of {} has no unit: write it in its head, as in `{column} \
                     [cm/s]`, or give `unit`; `unit = \"\"` means plain numbers",
                    file.display()
                );
                return Err(CampaignError::part(format!("variable.{}", variable.name), why));
            }
            let unit = target.unit.clone();
            let (file, column) = (file.clone(), column.clone());
            (Source::Measured(Measured { values, rows, file, column, target }), unit)
        }
        Draw::Expression { target, .. } => (Source::Formula(target.clone()), target.unit.clone()),
        Draw::Column { column, target } => {
            let table = table.expect("a variable with a column has the plan \"table\"");
            let (file, name) = (table.path().to_owned(), column.clone());
            match numbers(table, &file, column) {
                Ok((values, unit)) => {
                    let target = with_unit(variable, target, unit)?;
                    let unit = target.unit.clone();
                    (Source::Numbers(Column { values, file, name, target }), unit)
                }
                Err(error) => {
                    // Names, such as those of vessels, or numbers with their units.
                    let texts = table.texts(column).map_err(|_| error.clone())?;
                    let values: Vec<String> = texts.iter().map(str::to_owned).collect();
                    if values.iter().any(|text| text.trim().is_empty()) || !target.unit.is_empty() {
                        return Err(error);
                    }
                    let target = target.clone();
                    (Source::Texts(Column { values, file, name, target }), String::new())
                }
            }
        }
    })
}

/// The source and the table head of a variable of a downtime campaign.
pub(super) fn of_downtime(variable: &Variable, values: Given) -> (Source, Head) {
    let Draw::Column { target, .. } = &variable.draw else {
        unreachable!("the variables of a downtime campaign are columns")
    };
    let meaning = variable.source.as_deref().unwrap_or_default();
    let target = target.clone();
    match values {
        Given::Numbers(values) => {
            let head = Head::new(&variable.name, &target.unit, meaning);
            (Source::States { values, target }, head)
        }
        Given::Texts(values) => {
            (Source::Words { values, target }, Head::of_text(&variable.name, meaning))
        }
    }
}

/// The number of rows of the campaign's table, if a variable takes its values from the table.
pub(super) fn rows(sources: &[Source]) -> Option<u64> {
    sources.iter().find_map(|source| match source {
        Source::Numbers(all) => Some(all.values.len() as u64),
        Source::Texts(all) => Some(all.values.len() as u64),
        _ => None,
    })
}
