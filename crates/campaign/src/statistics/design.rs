//! Computes all statistics of one column: moments, exceedance, fits and design values. The command `statistics` prints
//! these numbers and the reports show them.

use super::exceedance::{self, Point};
use super::fit::{Fit, FitError, Law, fit};
use super::return_value::{Traffic, TrafficError};
use super::{Confidence, Estimate, Moments, Quantile, Sample, value_exceeded};

/// Number of points of an exceedance curve.
const CURVE: usize = 160;

/// Chances that the largest berthing of a lifetime exceeds its design value: the median, 10 % and 5 %.
const LIFE_CHANCES: [f64; 3] = [0.5, 0.1, 0.05];

/// Probabilities of one berthing, which are shown if no number of berthings a year is given.
const PER_BERTHING: [f64; 3] = [1e-2, 1e-3, 1.0 / 3000.0];

/// The options for the statistics of a column.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// Confidence level of all bands.
    pub confidence: Confidence,
    /// Number of berthings a year, if known.
    pub traffic: Option<Traffic>,
    /// Return periods (years); they need the number of berthings a year.
    pub periods_years: Vec<f64>,
    /// Lifetime (years); it needs the number of berthings a year.
    pub life_years: Option<f64>,
    /// Laws to fit.
    pub laws: Vec<Law>,
    /// Threshold of [`Law::Pareto`], in the unit of the column.
    pub threshold: Option<f64>,
}

/// How rarely a design value is exceeded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rarity {
    /// One berthing exceeds the value with this probability.
    Berthing(f64),
    /// The value has a return period of this number of years: in a year it is exceeded with a chance of one divided by
    /// the period.
    Period(f64),
    /// The value is exceeded in a lifetime with a given chance.
    Life {
        /// Lifetime (years).
        years: f64,
        /// Chance that the largest berthing of the lifetime exceeds the value.
        chance: f64,
    },
}

/// A design value by the data and by each fit.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignRow {
    /// How rarely the value is exceeded.
    pub rarity: Rarity,
    /// Probability that one berthing exceeds the value.
    pub exceedance: f64,
    /// The value by the data alone.
    pub by_data: Quantile,
    /// The value by each fit, in the order of the laws; `None` if the fit failed or has no value at this level.
    pub by_fit: Vec<Option<Estimate>>,
}

/// Number of values that a fit expects in the tail of the data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TailCheck {
    /// Value above which the tail begins.
    pub above: f64,
    /// Number of values of the data in the tail.
    pub count: usize,
}

/// The statistics of a column.
#[derive(Clone, Debug, PartialEq)]
pub struct Findings {
    /// The values.
    pub sample: Sample,
    /// Their moments.
    pub moments: Moments,
    /// Their exceedance curve.
    pub curve: Vec<Point>,
    /// A fit for each law, or the reason why the law could not be fitted.
    pub fits: Vec<Result<Fit, FitError>>,
    /// The design values.
    pub rows: Vec<DesignRow>,
    /// The tail in which fits are compared with the data; `None` for fewer than 20 values.
    pub tail: Option<TailCheck>,
}

impl Asked {
    /// The levels of rarity for which design values are asked.
    ///
    /// # Errors
    /// Fails if a return period is a year or less, or if the lifetime is not positive.
    pub fn rarities(&self) -> Result<Vec<(Rarity, f64)>, TrafficError> {
        let Some(traffic) = self.traffic else {
            return Ok(PER_BERTHING.map(|p| (Rarity::Berthing(p), p)).to_vec());
        };
        let period =
            |years: &f64| Ok((Rarity::Period(*years), traffic.exceedance_of_period(*years)?));
        let mut all: Vec<(Rarity, f64)> =
            self.periods_years.iter().map(period).collect::<Result<_, TrafficError>>()?;
        if let Some(years) = self.life_years {
            for chance in LIFE_CHANCES {
                let p = traffic.exceedance_of_life(years, chance)?;
                all.push((Rarity::Life { years, chance }, p));
            }
        }
        Ok(all)
    }
}

/// How many values of 0 belong to runs in which nothing happened. Zeros are taken for such runs if no value is negative
/// and fewer values are 0 than positive. The statistics then leave out the zeros and take correspondingly fewer events
/// a year; for rare values the result equals the statistics of all values.
#[must_use]
pub fn zeros_apart(values: &[f64]) -> usize {
    let count = |is: fn(f64) -> bool| values.iter().filter(|value| is(**value)).count();
    let (zeros, positive) = (count(|value| value == 0.0), count(|value| value > 0.0));
    if positive > zeros && count(|value| value < 0.0) == 0 { zeros } else { 0 }
}

/// What a sample tells.
///
/// # Errors
/// As [`Asked::rarities`].
pub fn findings(sample: Sample, asked: &Asked) -> Result<Findings, TrafficError> {
    let rarities = asked.rarities()?;
    let fits: Vec<Result<Fit, FitError>> =
        asked.laws.iter().map(|law| fit(*law, &sample, asked.threshold)).collect();
    let row = |(rarity, p): (Rarity, f64)| DesignRow {
        rarity,
        exceedance: p,
        by_data: value_exceeded(&sample, p, asked.confidence),
        by_fit: fits
            .iter()
            .map(|fit| fit.as_ref().ok()?.value_exceeded(p, asked.confidence))
            .collect(),
    };
    Ok(Findings {
        moments: Moments::of(&sample),
        curve: exceedance::curve(&sample, CURVE, asked.confidence),
        rows: rarities.into_iter().map(row).collect(),
        tail: tail(&sample),
        fits,
        sample,
    })
}

/// The tail of a sample: the highest tenth of a small sample, about the highest hundredth of a large sample, and at
/// least ten values.
fn tail(sample: &Sample) -> Option<TailCheck> {
    let n = sample.count();
    if n < 20 || sample.is_weighted() {
        return None;
    }
    let wanted = (n / 100).max(10).min(n / 2);
    let above = sample.values()[n - 1 - wanted];
    Some(TailCheck { above, count: n - sample.count_to(above) })
}

impl TailCheck {
    /// How many values a fit expects in the tail; `None` if the tail begins below the threshold of the fit.
    #[must_use]
    pub fn expected(&self, fit: &Fit, sample: &Sample) -> Option<f64> {
        match fit.distribution.threshold() {
            Some((threshold, _)) if self.above < threshold => None,
            _ => Some(fit.distribution.above(self.above) * sample.count() as f64),
        }
    }
}

impl Findings {
    /// The indices of the fits in the order of Akaike's criterion, the best first; fits over a threshold and failed
    /// fits come last, because their criterion cannot be compared.
    #[must_use]
    pub fn ranking(&self) -> Vec<usize> {
        let rank = |place: &usize| match &self.fits[*place] {
            Ok(fit) if fit.law != Law::Pareto => (0, fit.aic),
            Ok(_) => (1, 0.0),
            Err(_) => (2, 0.0),
        };
        let mut order: Vec<usize> = (0..self.fits.len()).collect();
        order.sort_by(|a, b| {
            let (a, b) = (rank(a), rank(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        order
    }
}
