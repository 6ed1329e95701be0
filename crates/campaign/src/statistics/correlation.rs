//! Rank correlation of inputs and outputs.

use super::{Confidence, Estimate, Interval};

/// Smallest number of pairs for which a correlation has a confidence interval.
const FEWEST: usize = 4;

/// Spearman's rank correlation of the pairs whose two numbers are finite; equal values get their mean rank. The
/// interval is that of Fisher's transformation with the variance (1 + r²/2)/(n − 3) of Bonett and Wright (Psychometrika
/// 65, 2000). `None` for fewer than four pairs, or if one of the two quantities is constant.
#[must_use]
pub fn spearman(x: &[f64], y: &[f64], confidence: Confidence) -> Option<Estimate> {
    let pairs = x.iter().zip(y).filter(|(x, y)| x.is_finite() && y.is_finite());
    let (x, y): (Vec<f64>, Vec<f64>) = pairs.unzip();
    let n = x.len();
    if n < FEWEST {
        return None;
    }
    let value = pearson(&ranks(&x), &ranks(&y))?;
    let half =
        confidence.normal_quantile() * libm::sqrt((1.0 + 0.5 * value * value) / (n as f64 - 3.0));
    // Of a perfect correlation the transformation is infinite.
    let interval = if value.abs() >= 1.0 {
        Interval { low: value, high: value }
    } else {
        let z = libm::atanh(value);
        Interval { low: libm::tanh(z - half), high: libm::tanh(z + half) }
    };
    Some(Estimate { value, interval })
}

/// The ranks of values, from 1; equal values have the mean of their ranks.
fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    let mut start = 0;
    while start < order.len() {
        let value = values[order[start]];
        let same = order[start..].iter().take_while(|index| values[**index] == value).count();
        let rank = start as f64 + 0.5 * (same as f64 + 1.0);
        for index in &order[start..start + same] {
            ranks[*index] = rank;
        }
        start += same;
    }
    ranks
}

/// Pearson's correlation of two quantities; `None` if one of them is constant.
fn pearson(x: &[f64], y: &[f64]) -> Option<f64> {
    let n = x.len() as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / n;
    let (mx, my) = (mean(x), mean(y));
    let (mut xx, mut yy, mut xy) = (0.0, 0.0, 0.0);
    for (x, y) in x.iter().zip(y) {
        xx += (x - mx) * (x - mx);
        yy += (y - my) * (y - my);
        xy += (x - mx) * (y - my);
    }
    let scale = libm::sqrt(xx) * libm::sqrt(yy);
    (scale > 0.0).then(|| fenderline_contact::number::bounded(xy / scale, -1.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_monotone_relation_has_correlation_one_whatever_its_form() {
        let x: Vec<f64> = (1..50).map(f64::from).collect();
        let y: Vec<f64> = x.iter().map(|x| libm::exp(*x)).collect();
        let down: Vec<f64> = x.iter().map(|x| 1.0 / x).collect();
        let of = |y: &[f64]| spearman(&x, y, Confidence::USUAL).unwrap().value;
        assert!((of(&y) - 1.0).abs() < 1e-12 && (of(&down) + 1.0).abs() < 1e-12);
        assert_eq!(spearman(&x, &[1.0; 49], Confidence::USUAL), None);
        assert_eq!(spearman(&x[..3], &y[..3], Confidence::USUAL), None);
    }

    /// `scipy.stats.spearmanr([1,2,2,4,5,6,7,7], [2,1,4,3,7,5,8,6])`.
    #[test]
    fn ties_have_their_mean_rank_as_in_scipy() {
        let x = [1.0, 2.0, 2.0, 4.0, 5.0, 6.0, 7.0, 7.0];
        let y = [2.0, 1.0, 4.0, 3.0, 7.0, 5.0, 8.0, 6.0];
        let got = spearman(&x, &y, Confidence::USUAL).unwrap().value;
        assert!((got - 0.831_385_644_927_992_7).abs() < 1e-12, "{got}");
    }
}
