//! The stop rule: a campaign ends when an estimate is good enough. The rule takes the rows in the order of the runs, so
//! that the end of the campaign does not depend on the order in which runs are finished.

use std::collections::BTreeMap;

use crate::file::{Statistic, Stop};

use crate::error::CampaignError;
use crate::row::Row;
use crate::run::Runs;
use crate::statistics::{Confidence, Moments, Sample, quantile};

/// Applies a stop rule to the rows of a campaign.
pub struct StopRule {
    rule: Stop,
    column: usize,
    /// Values of the rule's output for the runs from the first on, up to the first run without a row; NaN for a run
    /// without the output.
    values: Vec<f64>,
    /// Values of the runs after the first run without a row.
    waiting: BTreeMap<u64, f64>,
    ended: Option<u64>,
}

impl StopRule {
    /// The stop rule of a campaign, if it has one.
    ///
    /// # Errors
    /// Fails if the campaign does not have the rule's output.
    pub fn of(runs: &Runs) -> Result<Option<StopRule>, CampaignError> {
        let Some(rule) = runs.campaign().stop.clone() else { return Ok(None) };
        let found = runs.heads().iter().position(|head| head.name == rule.output);
        let column = found
            .ok_or_else(|| CampaignError::part("stop.output", "the campaign has no such output"))?;
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

    /// The number of runs after which the rule ends the campaign; `None` if the rule does not end it yet.
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

/// Half the width of the confidence interval divided by the estimate; `None` if there are too few values.
fn half_width(rule: &Stop, values: Vec<f64>) -> Option<f64> {
    let confidence =
        Confidence::new(rule.confidence).expect("the key `confidence` is within its bounds");
    let sample = Sample::new(values).ok()?;
    match rule.statistic {
        Statistic::Mean => {
            let mean = Moments::of(&sample).mean;
            Some(confidence.normal_quantile() * mean.error / mean.value.abs())
        }
        Statistic::Quantile => {
            let found = quantile(&sample, rule.probability, confidence);
            Some(0.5 * (found.high? - found.low?) / found.value?.abs())
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
        // Ranks 40 and 61 (David and Nagaraja, Order Statistics) about 50.5.
        assert_eq!(half_width(&rule(Statistic::Quantile), all), Some(10.5 / 50.5));
        assert_eq!(half_width(&rule(Statistic::Quantile), vec![1.0; 3]), None);
    }
}
