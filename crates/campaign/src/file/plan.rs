//! Reads from a campaign's file how values are chosen, when the campaign ends, what else is reported, and to which
//! events design values refer.

use std::path::PathBuf;

use super::downtime::Downtime;
use super::keys::PLANS;
use super::kinds::{MOST_CASES, PlanKind, Read, Statistic};
use super::variable::{Draw, Variable};
use crate::file::keys::CampaignFileKey;
use crate::file::keys::design::{
    CampaignLimitKey, CampaignOutputKey, CorrelationKey, DesignKey, StopKey,
};
use crate::file::keys::variable::VariableKey;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::choices::AnyChoices as _;
use fenderline_keys::held::Number;
use fenderline_keys::sources::{Sources, quoted};
use fenderline_keys::suggest::nearest;
use fenderline_keys::typed_key::{AnyKey, Key};

/// The plan of a campaign: how the values of its variables are chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Plan {
    /// Every combination.
    FullFactorial,
    /// Independent draws.
    MonteCarlo {
        /// Number of runs.
        number: u64,
    },
    /// Each variable has one draw in each of `number` parts of its range that have equal probability.
    LatinHypercube {
        /// Number of runs.
        number: u64,
    },
    /// A scrambled Sobol sequence.
    Sobol {
        /// Number of runs.
        number: u64,
    },
    /// The rows of a table file give the values, one row for each run.
    Table {
        /// The table file, CSV or Parquet.
        file: PathBuf,
    },
    /// The runs are the states (groups of similar hours) of the weather at a berth, and some single hours.
    Downtime(Downtime),
}

impl Plan {
    /// Its word in files.
    #[must_use]
    pub fn word(&self) -> &'static str {
        let kind = match self {
            Plan::FullFactorial => PlanKind::FullFactorial,
            Plan::MonteCarlo { .. } => PlanKind::MonteCarlo,
            Plan::LatinHypercube { .. } => PlanKind::LatinHypercube,
            Plan::Sobol { .. } => PlanKind::Sobol,
            Plan::Table { .. } => PlanKind::Table,
            Plan::Downtime(_) => return "downtime",
        };
        let words = PLANS.words();
        words.iter().find(|word| word.value::<PlanKind>() == kind).map_or("", |word| word.word)
    }
}

/// Largest number of runs of a Sobol sequence: the library's sequence has no more points.
const MOST_OF_SOBOL: u64 = 1 << 16;

/// Largest product of runs and variables of a Latin hypercube: the order of each variable's parts is held in memory, in
/// 0.4 GB at most.
const MOST_OF_HYPERCUBE: u64 = 100_000_000;

/// A correlation of two variables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correlation {
    /// The indices of the two correlated variables, the lower index first.
    pub variables: [usize; 2],
    /// Correlation of the normal scores of the two variables.
    pub coefficient: f64,
}

/// An output that is computed by the user's expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    /// Name of the output.
    pub name: String,
    /// The formula.
    pub expression: String,
    /// Unit of the output; empty if it has none.
    pub unit: String,
}

/// A value of an output that should seldom be exceeded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limit {
    /// Name of the limit.
    pub name: String,
    /// Column of the output.
    pub output: String,
    /// Number and unit of the limit, as the file has them.
    pub text: String,
}

/// A stop rule: when a campaign may end early.
#[derive(Clone, Debug, PartialEq)]
pub struct Stop {
    /// Column of the output.
    pub output: String,
    /// What is estimated.
    pub statistic: Statistic,
    /// Probability of the quantile; 1/2 for the mean, which has no probability.
    pub probability: f64,
    /// Half the width of the confidence interval as a share of the estimate, at which the campaign ends.
    pub half_width: f64,
    /// Probability of the confidence interval.
    pub confidence: f64,
    /// Runs between two looks.
    pub every: u64,
}

/// The events to which design values refer, and how rare the values are.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// Number of events (such as berthings) in a year.
    pub per_year: f64,
    /// Return periods (years).
    pub return_periods_years: Vec<f64>,
    /// Life of the structure (years).
    pub life_years: f64,
}

/// The kind of plan that the campaign's file names, or that its keys imply.
pub(super) fn kind(file: Of<'_, CampaignFileKey>) -> PlanKind {
    match file.item(CampaignFileKey::PLAN) {
        Some(item) => item.choice(),
        None if file
            .item(CampaignFileKey::VARIABLE)
            .map(Entry::named)
            .unwrap_or_default()
            .iter()
            .any(|(_, own)| own.item(VariableKey::DISTRIBUTION).is_some()) =>
        {
            PlanKind::MonteCarlo
        }
        None => PlanKind::FullFactorial,
    }
}

/// Reads the plan with the keys that belong to it.
pub(super) fn read(
    sources: &Sources<'_>,
    file: Of<'_, CampaignFileKey>,
    kind: PlanKind,
    variables: &[Variable],
) -> Read<Plan> {
    let refused = |key: AnyKey<CampaignFileKey>, message: String| {
        let item = file.given(key);
        Err(sources.error(&item.span, key.name(), message))
    };
    if kind != PlanKind::Table && file.item(CampaignFileKey::TABLE).is_some() {
        return refused(
            CampaignFileKey::TABLE.any(),
            "`table` goes with `plan = \"table\"` alone".to_owned(),
        );
    }
    let number = || match file.item(CampaignFileKey::NUMBER) {
        Some(item) if *item.number() == libm::trunc(*item.number()) => Ok(*item.number() as u64),
        Some(item) => Err(sources.error(
            &item.span,
            CampaignFileKey::NUMBER.name(),
            "`number` must be a whole number".to_owned(),
        )),
        None => {
            let span =
                file.item(CampaignFileKey::PLAN).map_or(&file.span, |item| &item.item().span);
            let error = sources.error(
                span,
                CampaignFileKey::NUMBER.name(),
                "`number` is missing: it says how many runs are to be made".to_owned(),
            );
            Err(error.with_help("write number = 1000 above the first table"))
        }
    };
    if matches!(kind, PlanKind::FullFactorial | PlanKind::Table)
        && file.item(CampaignFileKey::NUMBER).is_some()
    {
        return refused(
            CampaignFileKey::NUMBER.any(),
            "`number` goes with a random plan: in this plan the values determine the number of runs"
                .to_owned(),
        );
    }
    match kind {
        PlanKind::FullFactorial => {
            let counts = variables.iter().map(|variable| variable.choices().len().max(1));
            let cases =
                counts.clone().try_fold(1_usize, |product, count| product.checked_mul(count));
            if cases.is_none_or(|cases| cases > MOST_CASES) {
                let factors = counts.map(|count| count.to_string()).collect::<Vec<_>>().join(" × ");
                let message = format!("{factors} are more than {MOST_CASES} cases");
                return Err(sources.error(
                    &file.given(CampaignFileKey::VARIABLE).span,
                    CampaignFileKey::VARIABLE.name(),
                    message,
                ));
            }
            Ok(Plan::FullFactorial)
        }
        PlanKind::MonteCarlo => Ok(Plan::MonteCarlo { number: number()? }),
        PlanKind::LatinHypercube => {
            let number = number()?;
            let count = variables.len().max(1) as u64;
            if number > MOST_OF_HYPERCUBE / count {
                let most = MOST_OF_HYPERCUBE / count;
                let message = format!(
                    "`number` is {number}, but a Latin hypercube of {count} variables has at most {most} \
                     runs, because the order of its parts is held in memory; a \"Monte Carlo\" \
                     plan has no such bound"
                );
                return refused(CampaignFileKey::NUMBER.any(), message);
            }
            Ok(Plan::LatinHypercube { number })
        }
        PlanKind::Sobol => {
            let number = number()?;
            if number > MOST_OF_SOBOL {
                return refused(
                    CampaignFileKey::NUMBER.any(),
                    format!(
                        "`number` is {number}, but a Sobol sequence has at most {MOST_OF_SOBOL} \
                         runs"
                    ),
                );
            }
            Ok(Plan::Sobol { number })
        }
        PlanKind::Table => match file.item(CampaignFileKey::TABLE) {
            Some(item) => Ok(Plan::Table { file: PathBuf::from(item.text()) }),
            None => {
                let span =
                    file.item(CampaignFileKey::PLAN).map_or(&file.span, |item| &item.item().span);
                Err(sources.error(
                    span,
                    CampaignFileKey::TABLE.name(),
                    "`table` is missing: it names the file with a row for each run".to_owned(),
                ))
            }
        },
    }
}

/// Reads the correlations. Each correlation is between two variables with a probability law or measured values. A pair
/// of variables has at most one correlation.
pub(super) fn correlations(
    sources: &Sources<'_>,
    file: Of<'_, CampaignFileKey>,
    variables: &[Variable],
) -> Read<Vec<Correlation>> {
    let mut all: Vec<Correlation> = Vec::new();
    for table in file.given(CampaignFileKey::CORRELATION).list() {
        let item = table.given(CorrelationKey::VARIABLES);
        let path = table.path_of(CorrelationKey::VARIABLES);
        let refused = |message: String| Err(sources.error(&item.span, &path, message));
        let [one, other] = item.texts() else {
            return refused(format!("`{path}` must be two names of variables"));
        };
        let mut found = [0; 2];
        for (place, name) in found.iter_mut().zip([one, other]) {
            let Some(index) = variables.iter().position(|variable| variable.name == *name) else {
                let names = variables.iter().map(|variable| variable.name.as_str());
                let near = nearest(name, names)
                    .map_or(String::new(), |near| format!(": did you mean {}?", quoted(near)));
                return refused(format!(
                    "`{path}` has {}, which is not a variable{near}",
                    quoted(name)
                ));
            };
            if !matches!(variables[index].draw, Draw::Law(..) | Draw::Measured { .. }) {
                return refused(format!(
                    "`{path}` has {}, which has no distribution",
                    quoted(name)
                ));
            }
            *place = index;
        }
        found.sort_unstable();
        if found[0] == found[1] {
            return refused(format!("`{path}` has one variable twice"));
        }
        if all.iter().any(|known| known.variables == found) {
            return refused(format!("`{path}` has a correlation already"));
        }
        all.push(Correlation {
            variables: found,
            coefficient: *table.given(CorrelationKey::COEFFICIENT).number(),
        });
    }
    Ok(all)
}

/// Reads the outputs by expressions; their names must not be those of variables.
pub(super) fn outputs(
    sources: &Sources<'_>,
    file: Of<'_, CampaignFileKey>,
    variables: &[Variable],
) -> Read<Vec<Output>> {
    let one = |(name, table): (&String, Of<'_, _>)| {
        if variables.iter().any(|variable| variable.name == *name) {
            let message = format!("{} is the name of a variable", quoted(name));
            return Err(sources.error(&table.span, &table.path, message));
        }
        Ok(Output {
            name: name.clone(),
            expression: table.given(CampaignOutputKey::EXPRESSION).text().to_owned(),
            unit: table
                .item(CampaignOutputKey::UNIT)
                .map_or(String::new(), |item| item.text().to_owned()),
        })
    };
    file.given(CampaignFileKey::OUTPUT).named().iter().map(one).collect()
}

/// Limits of outputs.
pub(super) fn limits(file: Of<'_, CampaignFileKey>) -> Vec<Limit> {
    let one = |(name, table): (&String, Of<'_, _>)| Limit {
        name: name.clone(),
        output: table.given(CampaignLimitKey::OUTPUT).text().to_owned(),
        text: table.given(CampaignLimitKey::VALUE).text().to_owned(),
    };
    file.given(CampaignFileKey::LIMIT).named().iter().map(one).collect()
}

/// The stop rule.
pub(super) fn stop(sources: &Sources<'_>, file: Of<'_, CampaignFileKey>) -> Read<Option<Stop>> {
    let Some(item) = file.item(CampaignFileKey::STOP) else { return Ok(None) };
    let table = item.table();
    let statistic: Statistic = table.given(StopKey::STATISTIC).choice();
    let inside = |name: Key<StopKey, Number>| {
        let item = table.given(name);
        let path = table.path_of(name);
        match *item.number() {
            value if 0.0 < value && value < 1.0 => Ok(value),
            value => Err(sources.error(
                &item.span,
                &path,
                format!("`{path}` must be between 0 and 1, but is {value}"),
            )),
        }
    };
    let probability = match (statistic, table.item(StopKey::PROBABILITY)) {
        (Statistic::Quantile, Some(_)) => inside(StopKey::PROBABILITY)?,
        (Statistic::Mean, None) => 0.5,
        (Statistic::Mean, Some(own)) => {
            return Err(sources.error(
                &own.span,
                "stop.probability",
                "`stop.probability` needs `stop.statistic = \"quantile\"`".to_owned(),
            ));
        }
        (Statistic::Quantile, None) => {
            return Err(sources.error(
                &item.span,
                "stop.probability",
                "`stop.probability` is missing".to_owned(),
            ));
        }
    };
    Ok(Some(Stop {
        output: table.given(StopKey::OUTPUT).text().to_owned(),
        statistic,
        probability,
        half_width: *table.given(StopKey::HALF_WIDTH).number(),
        confidence: inside(StopKey::CONFIDENCE)?,
        every: *table.given(StopKey::EVERY).number() as u64,
    }))
}

/// Reads to which events the design values refer.
pub(super) fn design(sources: &Sources<'_>, file: Of<'_, CampaignFileKey>) -> Read<Option<Design>> {
    let Some(item) = file.item(CampaignFileKey::DESIGN) else { return Ok(None) };
    let table = item.table();
    let periods = table.given(DesignKey::RETURN_PERIODS);
    let one = |text: &String| match text.parse::<f64>() {
        Ok(years) if years > 1.0 && years.is_finite() => Ok(years),
        _ => {
            let path = table.path_of(DesignKey::RETURN_PERIODS);
            let message =
                format!("`{path}` has {}, which is not a number of years above 1", quoted(text));
            Err(sources.error(&periods.span, &path, message))
        }
    };
    Ok(Some(Design {
        per_year: *table.given(DesignKey::BERTHINGS_PER_YEAR).number(),
        return_periods_years: periods.texts().iter().map(one).collect::<Read<_>>()?,
        life_years: *table.given(DesignKey::LIFE).number(),
    }))
}
