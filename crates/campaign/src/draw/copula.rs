//! Correlated draws by a Gaussian copula.

use crate::file::Correlation;
use crate::file::law::Law;
use fenderline_contact::number::bounded;

/// A Gaussian copula: makes probabilities whose normal scores are correlated, while each probability alone stays
/// uniform.
pub(super) struct Copula {
    /// Indices of the correlated variables, in rising order.
    variables: Vec<usize>,
    /// The lower triangle L of the correlation matrix R = L Lᵀ, row by row.
    factor: Vec<Vec<f64>>,
    score: Law,
}

impl Copula {
    /// Makes the copula of the given correlations; all other correlations are 0.
    ///
    /// # Errors
    /// Fails if the correlation matrix is not positive definite.
    pub(super) fn new(correlations: &[Correlation]) -> Result<Copula, String> {
        let mut variables: Vec<usize> = correlations.iter().flat_map(|own| own.variables).collect();
        variables.sort_unstable();
        variables.dedup();
        let coefficient = |row: usize, column: usize| {
            let pair = [variables[column], variables[row]];
            let found = correlations.iter().find(|own| own.variables == pair);
            found.map_or(0.0, |own| own.coefficient)
        };
        let mut factor: Vec<Vec<f64>> = Vec::new();
        for row in 0..variables.len() {
            let mut own: Vec<f64> = Vec::new();
            for (column, above) in factor.iter().enumerate() {
                let known: f64 = own.iter().zip(above).map(|(a, b)| a * b).sum();
                own.push((coefficient(row, column) - known) / above[column]);
            }
            let left = 1.0 - own.iter().map(|a| a * a).sum::<f64>();
            // A smaller value is rounding: one of the variables would be a function of the others.
            if left < 1e-12 {
                return Err(
                    "the matrix of the correlations is not positive definite: no variables \
                    can have all these correlations"
                        .to_owned(),
                );
            }
            own.push(libm::sqrt(left));
            factor.push(own);
        }
        let score = Law::normal(0.0, 1.0).expect("the standard normal law");
        Ok(Copula { variables, factor, score })
    }

    /// Makes the independent probabilities of a run correlated.
    pub(super) fn correlate(&self, probabilities: &mut [f64]) {
        let scores: Vec<f64> = self
            .variables
            .iter()
            .map(|variable| self.score.quantile(probabilities[*variable]))
            .collect();
        for (variable, row) in self.variables.iter().zip(&self.factor) {
            let score: f64 = row.iter().zip(&scores).map(|(a, b)| a * b).sum();
            probabilities[*variable] =
                bounded(self.score.cdf(score), f64::MIN_POSITIVE, 1.0 - f64::EPSILON / 2.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair(variables: [usize; 2], coefficient: f64) -> Correlation {
        Correlation { variables, coefficient }
    }

    #[test]
    fn matrices_that_no_variables_have_are_refused() {
        let bad = [pair([0, 1], 0.9), pair([1, 2], 0.9), pair([0, 2], -0.9)];
        assert!(Copula::new(&bad).is_err());
        assert!(Copula::new(&[pair([0, 1], 1.0)]).is_err());
        assert!(Copula::new(&[pair([0, 1], 0.9), pair([1, 2], 0.9), pair([0, 2], 0.7)]).is_ok());
    }

    /// The correlation of n normal scores has the standard error (1 − ρ²)/√n.
    #[test]
    fn normal_scores_have_the_correlation_and_stay_uniform() {
        let copula = Copula::new(&[pair([0, 2], 0.6)]).expect("a copula");
        let plan = super::super::plan::Probabilities::new(
            &crate::file::Plan::MonteCarlo { number: 1 },
            3,
            5,
        );
        let plan = plan.expect("a plan").expect("a random one");
        let law = Law::normal(0.0, 1.0).expect("a law");
        let n = 20_000;
        let (mut sums, mut middle) = ([0.0; 5], 0.0);
        for run in 0..n {
            let mut p = plan.of_run(run);
            let second = p[1];
            copula.correlate(&mut p);
            assert_eq!(p[1], second, "a variable without correlation keeps its bits");
            let (x, y) = (law.quantile(p[0]), law.quantile(p[2]));
            for (sum, value) in sums.iter_mut().zip([x, y, x * x, y * y, x * y]) {
                *sum += value / n as f64;
            }
            middle += p[2] / n as f64;
        }
        let [x, y, xx, yy, xy] = sums;
        let correlation = (xy - x * y) / ((xx - x * x) * (yy - y * y)).sqrt();
        let error = (1.0 - 0.36) / (n as f64).sqrt();
        assert!((correlation - 0.6).abs() < 4.0 * error, "{correlation}");
        assert!((middle - 0.5).abs() < 4.0 / (12.0 * n as f64).sqrt(), "{middle}");
    }
}
