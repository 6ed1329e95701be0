//! Operability: how often runs succeed, by one or two conditions such as wind speed.

use fenderline_contact::number::{greater, lesser};

use super::{Confidence, Estimate, binomial};

/// Runs of one bin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bin {
    /// Number of runs.
    pub runs: usize,
    /// Number of runs that succeeded.
    pub successes: usize,
    /// Probability of success with the interval of [`binomial`]; `None` for a bin without runs.
    pub success: Option<Estimate>,
}

impl Bin {
    fn of(runs: usize, successes: usize, confidence: Confidence) -> Bin {
        let success = (runs > 0).then(|| binomial(successes, runs, confidence));
        Bin { runs, successes, success }
    }
}

/// Bins of one condition: from each edge to the next; the last bin includes its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Edges(Vec<f64>);

/// An error: the edges do not rise, or there are fewer than two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgesDoNotRise;

impl Edges {
    /// Edges that were chosen.
    ///
    /// # Errors
    /// Fails if the edges do not rise, or if there are fewer than two.
    pub fn new(edges: Vec<f64>) -> Result<Edges, EdgesDoNotRise> {
        let rises = edges.len() > 1 && edges.windows(2).all(|two| two[0] < two[1]);
        if rises { Ok(Edges(edges)) } else { Err(EdgesDoNotRise) }
    }

    /// Makes `count` bins of equal width over the range of the finite values; `None` if these values have no range.
    #[must_use]
    pub fn over(values: &[f64], count: usize) -> Option<Edges> {
        let finite = || values.iter().copied().filter(|value| value.is_finite());
        let low = finite().fold(f64::INFINITY, lesser);
        let high = finite().fold(f64::NEG_INFINITY, greater);
        let edge = |index: usize| match index == count {
            true => high,
            false => low + (high - low) * index as f64 / count as f64,
        };
        (high > low && count > 0).then(|| Edges((0..=count).map(edge).collect()))
    }

    /// Number of bins.
    #[must_use]
    pub fn count(&self) -> usize {
        self.0.len() - 1
    }

    /// The edges.
    #[must_use]
    pub fn edges(&self) -> &[f64] {
        &self.0
    }

    /// The middle of a bin.
    #[must_use]
    pub fn middle(&self, bin: usize) -> f64 {
        0.5 * (self.0[bin] + self.0[bin + 1])
    }

    /// The bin of a value.
    #[must_use]
    pub fn of(&self, value: f64) -> Option<usize> {
        let last = self.0[self.count()];
        if !(value >= self.0[0] && value <= last) {
            return None;
        }
        Some((self.0.partition_point(|edge| *edge <= value) - 1).min(self.count() - 1))
    }
}

/// Probability of success by one condition.
#[must_use]
pub fn by_one(x: &[f64], is_success: &[bool], edges: &Edges, confidence: Confidence) -> Vec<Bin> {
    let mut counts = vec![(0, 0); edges.count()];
    for (x, success) in x.iter().zip(is_success) {
        if let Some(bin) = edges.of(*x) {
            counts[bin].0 += 1;
            counts[bin].1 += usize::from(*success);
        }
    }
    counts.into_iter().map(|(runs, successes)| Bin::of(runs, successes, confidence)).collect()
}

/// Probability of success by two conditions: one row for each bin of `y`, with the bins of `x` in each row.
#[must_use]
pub fn by_two(
    (x, x_edges): (&[f64], &Edges),
    (y, y_edges): (&[f64], &Edges),
    is_success: &[bool],
    confidence: Confidence,
) -> Vec<Vec<Bin>> {
    let mut counts = vec![vec![(0, 0); x_edges.count()]; y_edges.count()];
    for ((x, y), success) in x.iter().zip(y).zip(is_success) {
        if let (Some(i), Some(j)) = (x_edges.of(*x), y_edges.of(*y)) {
            counts[j][i].0 += 1;
            counts[j][i].1 += usize::from(*success);
        }
    }
    let bin = |(runs, successes): (usize, usize)| Bin::of(runs, successes, confidence);
    counts.into_iter().map(|row| row.into_iter().map(bin).collect()).collect()
}

/// The sector in which a direction lies (degrees, also beyond 0 to 360). There are `count` equal sectors; the first
/// sector is centred on 0.
#[must_use]
pub fn sector(direction_deg: f64, count: usize) -> usize {
    let width = 360.0 / count as f64;
    let turned = direction_deg / 360.0;
    let share = turned - libm::floor(turned);
    (libm::floor(share * 360.0 / width + 0.5) as usize) % count
}

/// The limit of a condition, such as the wind speed, up to which runs succeed often enough.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// The probability of success falls below the required probability at this value, by interpolation
    /// between the middles of two bins.
    At(f64),
    /// The required probability is not reached even in the first bin with runs; holds the middle of that bin.
    Below(f64),
    /// The required probability is reached in all bins with runs; holds the middle of the last bin.
    Beyond(f64),
    /// No bin has runs.
    Unknown,
}

/// The value up to which the probability of success is at least `required`, from the lowest bin upwards.
#[must_use]
pub fn limit(bins: &[Bin], edges: &Edges, required: f64) -> Limit {
    let known = bins.iter().enumerate();
    let known = known.filter_map(|(bin, of)| Some((edges.middle(bin), of.success?.value)));
    let mut last: Option<(f64, f64)> = None;
    for (middle, share) in known {
        if share < required {
            return match last {
                None => Limit::Below(middle),
                Some((x, p)) => Limit::At(x + (middle - x) * (p - required) / (p - share)),
            };
        }
        last = Some((middle, share));
    }
    last.map_or(Limit::Unknown, |(middle, _)| Limit::Beyond(middle))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_lies_where_success_falls_below_what_is_required() {
        // Success up to 10 m/s, then none: the limit at 50 % is the border of the bins.
        let wind: Vec<f64> = (0..2000).map(|i| f64::from(i) * 0.01).collect();
        let success: Vec<bool> = wind.iter().map(|wind| *wind < 10.0).collect();
        let edges = Edges::new((0..=10).map(|i| 2.0 * f64::from(i)).collect()).unwrap();
        let bins = by_one(&wind, &success, &edges, Confidence::USUAL);
        assert_eq!(bins.iter().map(|bin| bin.runs).sum::<usize>(), 2000);
        assert_eq!(limit(&bins, &edges, 0.5), Limit::At(10.0));
        assert_eq!(limit(&bins[..3], &edges, 0.5), Limit::Beyond(5.0));
        assert_eq!(limit(&bins, &edges, 1.1), Limit::Below(1.0));
        let empty = [Bin::of(0, 0, Confidence::USUAL)];
        assert_eq!(limit(&empty, &edges, 0.5), Limit::Unknown);
    }

    #[test]
    fn north_is_the_middle_of_the_first_sector() {
        let of = |direction: f64| sector(direction, 8);
        assert_eq!(
            [0.0, 22.0, 23.0, 90.0, 337.0, 338.0, -1.0, 720.0].map(of),
            [0, 0, 1, 2, 7, 0, 0, 0]
        );
    }

    #[test]
    fn two_conditions_are_counted_together() {
        let edges = Edges::new(vec![0.0, 1.0, 2.0]).unwrap();
        let (x, y) = ([0.5, 1.5, 2.0, 0.1], [0.5, 0.5, 1.5, 9.0]);
        let bins =
            by_two((&x, &edges), (&y, &edges), &[true, false, true, true], Confidence::USUAL);
        let counts: Vec<Vec<(usize, usize)>> =
            bins.iter().map(|row| row.iter().map(|b| (b.runs, b.successes)).collect()).collect();
        assert_eq!(counts, [[(1, 1), (1, 0)], [(0, 0), (1, 1)]]);
        assert_eq!(Edges::new(vec![1.0, 1.0]), Err(EdgesDoNotRise));
        assert_eq!(Edges::over(&[3.0, 3.0], 4), None);
    }
}
