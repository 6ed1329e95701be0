//! The error of grouping hours into states: compares single hours, run with their own weather, with the states that
//! stand for them.

use super::outcome::Outcome;
use super::plan::DowntimePlan;
use crate::statistics::{Confidence, Estimate, wilson};

/// A comparison of single hours, which were run with their own weather, with the states (groups of similar hours) that
/// stand for these hours.
#[derive(Clone, Debug, PartialEq)]
pub struct StatesCheck {
    /// Number of hours that were drawn.
    pub drawn: usize,
    /// Number of drawn hours for which both the hour and its state could be run: the following numbers are of these
    /// hours.
    pub compared: usize,
    /// Number of hours that are lost in both runs: in the run with the hour's own weather, and in the run of the hour's
    /// state.
    pub both: usize,
    /// Number of hours that are lost in the run of their state, but not in the run with their own weather: for these
    /// hours the states count too much downtime.
    pub by_state_alone: usize,
    /// Number of hours that are lost in the run with their own weather, but not in the run of their state: for these
    /// hours the states count too little downtime.
    pub as_it_is_alone: usize,
    /// Number of hours that are lost neither in the run with their own weather nor in the run of their state.
    pub neither: usize,
    /// Share of hours for which the run with the hour's own weather and the run of the hour's state disagree, with
    /// Wilson's interval; `None` if no hour could be compared.
    pub disagree: Option<Estimate>,
    /// Share of hours that are lost in the run with their own weather, with Wilson's interval.
    pub lost_as_they_are: Option<Estimate>,
    /// Probability of the confidence intervals.
    pub confidence: Confidence,
}

impl StatesCheck {
    /// Compares the hours of a sample with their states; `None` if there is no sample.
    pub(super) fn of(
        plan: &DowntimePlan,
        outcomes: &[Outcome],
        confidence: Confidence,
    ) -> Option<StatesCheck> {
        let sample = plan.sample();
        if sample.is_empty() {
            return None;
        }
        let is_lost = |outcome: &Outcome| match outcome {
            Outcome::NotRun => None,
            Outcome::Works => Some(false),
            Outcome::Lost(_) => Some(true),
        };
        let hours = sample.iter().zip(&outcomes[plan.states()..]);
        let pairs: Vec<(bool, bool)> = hours
            .filter_map(|(row, own)| {
                Some((is_lost(own)?, is_lost(&outcomes[plan.state_of(*row)])?))
            })
            .collect();
        let count = |wanted: (bool, bool)| pairs.iter().filter(|pair| **pair == wanted).count();
        let (both, neither) = (count((true, true)), count((false, false)));
        let (as_it_is_alone, by_state_alone) = (count((true, false)), count((false, true)));
        let share =
            |hits: usize| (!pairs.is_empty()).then(|| wilson(hits, pairs.len(), confidence));
        Some(StatesCheck {
            drawn: sample.len(),
            compared: pairs.len(),
            both,
            by_state_alone,
            as_it_is_alone,
            neither,
            disagree: share(as_it_is_alone + by_state_alone),
            lost_as_they_are: share(both + as_it_is_alone),
            confidence,
        })
    }
}
