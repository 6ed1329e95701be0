//! Random plans: for each run and variable a probability between 0 and 1, both excluded.

use crate::file::Plan;
use fenderline_contact::number::bounded;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};

/// Number of dimensions of the library's Sobol sequence.
const MOST_DIMENSIONS: usize = sobol_burley::NUM_DIMENSIONS as usize;

/// A random plan of a campaign.
pub(super) struct Probabilities {
    seed: u64,
    dimensions: usize,
    kind: Kind,
}

enum Kind {
    Independent,
    /// A Latin hypercube: for each variable, the part of its range in which each run lies.
    Hypercube(Vec<Vec<u32>>),
    Sobol,
}

impl Probabilities {
    /// Makes the random plan for a number of variables; `None` for plans without random numbers.
    ///
    /// # Errors
    /// Fails if there are more variables than a Sobol sequence has dimensions.
    pub(super) fn new(
        plan: &Plan,
        dimensions: usize,
        seed: u64,
    ) -> Result<Option<Probabilities>, String> {
        let kind = match *plan {
            Plan::FullFactorial | Plan::Table { .. } | Plan::Downtime(_) => return Ok(None),
            Plan::MonteCarlo { .. } => Kind::Independent,
            Plan::LatinHypercube { number } => Kind::Hypercube(
                (0..dimensions).map(|dimension| shuffled(number, dimension, seed)).collect(),
            ),
            Plan::Sobol { .. } if dimensions > MOST_DIMENSIONS => {
                return Err(format!(
                    "a Sobol sequence has at most {MOST_DIMENSIONS} variables, but there are {dimensions}"
                ));
            }
            Plan::Sobol { .. } => Kind::Sobol,
        };
        Ok(Some(Probabilities { seed, dimensions, kind }))
    }

    /// The probabilities of a run, one for each variable.
    pub(super) fn of_run(&self, run: u64) -> Vec<f64> {
        // Each run has a separate stream.
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        random.set_stream(run);
        let mut one = |dimension: usize| {
            let inside = between_0_and_1(random.next_u64());
            match &self.kind {
                Kind::Independent => inside,
                Kind::Hypercube(parts) => {
                    let parts = &parts[dimension];
                    (f64::from(parts[run as usize]) + inside) / parts.len() as f64
                }
                // The library's numbers have 24 bits: the lower bits come from the random numbers of the run.
                Kind::Sobol => {
                    let seed = (self.seed ^ (self.seed >> 32)) as u32;
                    let coarse = sobol_burley::sample(run as u32, dimension as u32, seed);
                    f64::from(coarse) + inside / f64::from(1_u32 << 24)
                }
            }
        };
        // Rounding of the sum must not reach the ends.
        (0..self.dimensions).map(|dimension| bounded(one(dimension), LEAST, 1.0 - LEAST)).collect()
    }
}

/// The distance between 1 and the next smaller number.
const LEAST: f64 = f64::EPSILON / 2.0;

/// The upper 53 bits as a number between 0 and 1, both excluded.
fn between_0_and_1(bits: u64) -> f64 {
    ((bits >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
}

/// The whole numbers from 0 to below `number`, in random order (Fisher–Yates shuffle).
fn shuffled(number: u64, dimension: usize, seed: u64) -> Vec<u32> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    // Streams counted from the other end than the streams of the runs.
    random.set_stream(u64::MAX - dimension as u64);
    let mut order: Vec<u32> = (0..number).map(|part| part as u32).collect();
    for last in (1..order.len()).rev() {
        // By 128 bits: the part of a product is uniform to 2^-64 times the number.
        let other = ((u128::from(random.next_u64()) * (last as u128 + 1)) >> 64) as usize;
        order.swap(last, other);
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plan(plan: &Plan, dimensions: usize, seed: u64) -> Probabilities {
        Probabilities::new(plan, dimensions, seed).expect("a good plan").expect("a random plan")
    }

    #[test]
    fn a_run_draws_the_same_whatever_was_drawn_before() {
        let one = plan(&Plan::MonteCarlo { number: 10 }, 3, 7);
        let other = plan(&Plan::MonteCarlo { number: 1000 }, 3, 7);
        let first = one.of_run(5);
        let _ = other.of_run(900);
        assert_eq!(first, other.of_run(5));
        assert_ne!(first, plan(&Plan::MonteCarlo { number: 10 }, 3, 8).of_run(5));
    }

    #[test]
    fn a_latin_hypercube_has_one_run_in_each_part() {
        let number = 1000;
        let plan = plan(&Plan::LatinHypercube { number }, 2, 3);
        for dimension in 0..2 {
            let mut parts: Vec<u64> = (0..number)
                .map(|run| (plan.of_run(run)[dimension] * number as f64) as u64)
                .collect();
            assert!(!parts.is_sorted());
            parts.sort_unstable();
            assert_eq!(parts, (0..number).collect::<Vec<_>>());
        }
    }

    /// A Sobol sequence of 2^k runs has one in each of 2^k parts, in each dimension, and in each square of 2^(k/2) by
    /// 2^(k/2) of the first two.
    #[test]
    fn a_sobol_sequence_fills_every_part_and_square() {
        let plan = plan(&Plan::Sobol { number: 256 }, 4, 11);
        let runs: Vec<Vec<f64>> = (0..256).map(|run| plan.of_run(run)).collect();
        for dimension in 0..4 {
            let mut parts: Vec<u32> =
                runs.iter().map(|run| (run[dimension] * 256.0) as u32).collect();
            parts.sort_unstable();
            assert_eq!(parts, (0..256).collect::<Vec<_>>(), "dimension {dimension}");
        }
        let square = |run: &Vec<f64>| (run[0] * 16.0) as u32 * 16 + (run[1] * 16.0) as u32;
        let mut squares: Vec<u32> = runs.iter().map(square).collect();
        squares.sort_unstable();
        assert_eq!(squares, (0..256).collect::<Vec<_>>());
    }

    /// Kolmogorov's distance of 20,000 draws from the uniform law: below 1.95/√n with probability 0.999.
    #[test]
    fn independent_draws_are_uniform() {
        let number = 20_000;
        let plan = plan(&Plan::MonteCarlo { number }, 1, 1);
        let mut draws: Vec<f64> = (0..number).map(|run| plan.of_run(run)[0]).collect();
        draws.sort_by(f64::total_cmp);
        let distance = draws
            .iter()
            .enumerate()
            .map(|(index, draw)| (draw - index as f64 / number as f64).abs())
            .fold(0.0, fenderline_contact::number::greater);
        assert!(distance < 1.95 / (number as f64).sqrt(), "{distance}");
    }
}
