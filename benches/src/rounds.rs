//! Times by rounds: every contender runs once a round, so that what slows the machine down slows
//! all of them down, and what counts is the median of the ratios.

use std::time::{Duration, Instant};

/// One contender: what it does in a round, and how many calls that is.
pub(crate) struct Contender<'a> {
    /// Runs a whole round and says how long its calls took.
    pub(crate) round: Box<dyn FnMut() -> Duration + 'a>,
    /// Calls in a round.
    pub(crate) calls: usize,
}

impl<'a> Contender<'a> {
    /// A contender whose whole round is on the clock.
    pub(crate) fn clocked(mut round: impl FnMut() + 'a, calls: usize) -> Contender<'a> {
        let round = move || {
            let start = Instant::now();
            round();
            start.elapsed()
        };
        Contender { round: Box::new(round), calls }
    }
}

/// Nanoseconds a call, for every contender (outer) and round (inner).
pub(crate) fn nanoseconds_a_call(contenders: &mut [Contender<'_>], rounds: usize) -> Vec<Vec<f64>> {
    let mut times = vec![Vec::with_capacity(rounds); contenders.len()];
    for contender in contenders.iter_mut() {
        (contender.round)();
    }
    for round in 0..rounds {
        for turn in 0..contenders.len() {
            // A different one goes first each round.
            let index = (turn + round) % contenders.len();
            let contender = &mut contenders[index];
            let elapsed_s = (contender.round)().as_secs_f64();
            times[index].push(elapsed_s * 1e9 / contender.calls as f64);
        }
    }
    times
}

/// The least of the values: on a machine with other work, the time without it, if a round is short.
pub(crate) fn least(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

pub(crate) fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

/// Median over the rounds of `slower / faster`.
pub(crate) fn median_ratio(slower: &[f64], faster: &[f64]) -> f64 {
    median(&slower.iter().zip(faster).map(|(s, f)| s / f).collect::<Vec<_>>())
}
