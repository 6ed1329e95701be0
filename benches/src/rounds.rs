//! Times contenders by rounds: every contender runs once in a round, so that a disturbance of the machine slows them
//! all down, and the median of the ratios counts.

use std::time::{Duration, Instant};

/// One contender: what it does in a round, and the number of calls in a round.
pub(crate) struct Contender<'a> {
    /// Runs a whole round and returns how long its calls took.
    pub(crate) round: Box<dyn FnMut() -> Duration + 'a>,
    /// Calls in a round.
    pub(crate) calls: usize,
}

impl<'a> Contender<'a> {
    /// Makes a contender for which the time of the whole round counts.
    pub(crate) fn clocked(mut round: impl FnMut() + 'a, calls: usize) -> Contender<'a> {
        let round = move || {
            let start = Instant::now();
            round();
            start.elapsed()
        };
        Contender { round: Box::new(round), calls }
    }
}

/// Nanoseconds a call, for every contender (outer list) and round (inner list).
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

/// The least of the values; if rounds are short, this is a time that no other program of the machine has disturbed.
pub(crate) fn least(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

pub(crate) fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

/// Median over the rounds of the ratio `slower / faster`.
pub(crate) fn median_ratio(slower: &[f64], faster: &[f64]) -> f64 {
    median(&slower.iter().zip(faster).map(|(s, f)| s / f).collect::<Vec<_>>())
}
