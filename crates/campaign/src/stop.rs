//! The stop rule: a campaign ends when an estimate is good enough. It looks at the rows in the order of the runs, so that the end does
//! not depend on which run was done first.

use std::collections::BTreeMap;

use fenderline_scenario::{Law, Statistic, Stop};

use crate::error::CampaignError;
use crate::row::Row;
use crate::run::Runs;

/// A stop rule at work.
pub struct StopRule {
    rule: Stop,
    column: usize,
    /// The output of the runs from the first on without a gap; NaN for a run that has none.
    values: Vec<f64>,
    /// Those of later runs.
    waiting: BTreeMap<u64, f64>,
    ended: Option<u64>,
}

impl StopRule {
    /// The rule of a campaign, if it has one.
    ///
    /// # Errors
    /// An output that the campaign does not have.
    pub fn of(runs: &Runs) -> Result<Option<StopRule>, CampaignError> {
        let Some(rule) = runs.campaign().stop.clone() else { return Ok(None) };
        let found = runs.heads().iter().position(|head| head.name == rule.output);
        let column =
            found.ok_or_else(|| CampaignError::part("stop.output", "there is no such output"))?;
        Ok(Some(StopRule {
            rule,
            column,
            values: Vec::new(),
            waiting: BTreeMap::new(),
            ended: None,
        }))
    }

    /// Adds a row.
    pub fn add(&mut self, row: &Row) {
        let value = row.cells[self.column].number().unwrap_or(f64::NAN);
        self.waiting.insert(row.run, value);
        while let Some(value) = self.waiting.remove(&(self.values.len() as u64)) {
            self.values.push(value);
            let count = self.values.len() as u64;
            if self.ended.is_none() && count.is_multiple_of(self.rule.every) && self.is_good() {
                self.ended = Some(count);
            }
        }
    }

    /// The number of runs after which the rule ends the campaign; `None` before.
    #[must_use]
    pub fn ended(&self) -> Option<u64> {
        self.ended
    }

    fn is_good(&self) -> bool {
        let known: Vec<f64> = self.values.iter().copied().filter(|value| !value.is_nan()).collect();
        let half = half_width(&self.rule, known);
        half.is_some_and(|half| half <= self.rule.half_width)
    }
}

/// Half of the confidence interval over the estimate; `None` where there are too few values.
fn half_width(rule: &Stop, mut values: Vec<f64>) -> Option<f64> {
    let n = values.len() as f64;
    let score = Law::normal(0.0, 1.0)
        .expect("the standard normal law")
        .quantile(0.5 + 0.5 * rule.confidence);
    match rule.statistic {
        Statistic::Mean => {
            let mean = values.iter().sum::<f64>() / n;
            let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
            (values.len() >= 2).then(|| score * libm::sqrt(squares / (n - 1.0) / n) / mean.abs())
        }
        Statistic::Quantile => {
            // Ranks by the normal approximation of the binomial law: https://en.wikipedia.org/wiki/Binomial_proportion_confidence_interval
            values.sort_by(f64::total_cmp);
            let p = rule.probability;
            let spread = score * libm::sqrt(n * p * (1.0 - p));
            let (low, high) = (libm::floor(n * p - spread), libm::ceil(n * p + spread));
            if low < 1.0 || high > n {
                return None;
            }
            let at = |rank: f64| values[rank as usize - 1];
            let estimate = at(libm::ceil(n * p));
            Some(0.5 * (at(high) - at(low)) / estimate.abs())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rule(statistic: Statistic) -> Stop {
        Stop {
            output: String::new(),
            statistic,
            probability: 0.5,
            half_width: 0.1,
            confidence: 0.95,
            every: 10,
        }
    }

    /// Of the numbers 1 to n: standard deviation √((n² + n)/12).
    #[test]
    fn half_widths_by_hand() {
        let all: Vec<f64> = (1..=100).map(f64::from).collect();
        let mean = half_width(&rule(Statistic::Mean), all.clone()).expect("a width");
        let wanted = 1.959_963_985 * (10_100.0_f64 / 12.0 / 100.0).sqrt() / 50.5;
        assert!((mean - wanted).abs() < 1e-9, "{mean} for {wanted}");
        // Ranks 50 ± 9.8: 40 and 60.
        assert_eq!(half_width(&rule(Statistic::Quantile), all), Some(0.2));
        assert_eq!(half_width(&rule(Statistic::Quantile), vec![1.0; 3]), None);
    }
}
