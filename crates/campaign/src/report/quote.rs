//! Chooses the value that may be quoted: the value of a fitted law, or the value of the data.

use fenderline_report::plot::fixed;

use super::words::{self, with_unit};
use crate::statistics::design::{DesignRow, Findings, Rarity};
use crate::statistics::fit::{Fit, Law};

/// A law contradicts the data in the tail if the number of values that it expects there differs from the number in the
/// data by more than this many standard deviations of a count. For a true law the chance of such a difference is 1 %.
const TAIL_DEVIATIONS: f64 = 2.576;

/// The value that may be quoted for a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quote {
    /// The law to quote; `None` if no law may be quoted.
    pub law: Option<Law>,
    /// Which law or value to quote and why, in one or two sentences for a report.
    pub sentence: String,
}

/// The value that may be quoted. The law to quote is, among the laws for all values that the data do not contradict,
/// the law with the smallest AIC (criterion of Akaike). If there is no such law, it is the law for the values over the
/// threshold, if the data do not contradict it; otherwise the value of the data themselves is quoted. `unit` is the
/// unit of the column.
#[must_use]
pub fn quote(findings: &Findings, unit: &str) -> Option<Quote> {
    let row = quoted_row(&findings.rows)?;
    let order: Vec<(usize, &Fit)> = findings
        .ranking()
        .into_iter()
        .filter_map(|place| Some((place, findings.fits[place].as_ref().ok()?)))
        .collect();
    let mut objections: Vec<(&str, String)> = Vec::new();
    for (place, fit) in order {
        let Some(value) = &row.by_fit[place] else { continue };
        if let Some(objection) = objection(findings, place, fit) {
            objections.push((fit.law.title(), objection));
            continue;
        }
        let title = fit.law.title();
        let why = match (fit.law, &objections[..]) {
            (Law::Pareto, []) => "the data do not contradict this law".to_owned(),
            (Law::Pareto, all) => format!("no law of all values may be quoted ({})", listed(all)),
            (_, []) => {
                "it is the law with the smallest AIC, and the data do not contradict this law"
                    .to_owned()
            }
            (_, all) => format!(
                "of the laws that the data do not contradict, this law has the smallest AIC ({})",
                listed(all)
            ),
        };
        let beyond = match row.by_data.value {
            Some(_) => "",
            None => {
                " The runs do not reach this level: the value is right only if the law is \
                right there."
            }
        };
        let sentence = format!(
            "Quote the law {title}: {why}. Its design value for {} is {}.{beyond}",
            words::rarity(row.rarity),
            with_unit(&words::with_band(value), unit)
        );
        return Some(Quote { law: Some(fit.law), sentence });
    }
    let why = match &objections[..] {
        [] => "No law could be fitted".to_owned(),
        all => format!("Quote none of the fitted laws: {}", listed(all)),
    };
    Some(Quote { law: None, sentence: format!("{why}. {}", of_data(findings, unit)) })
}

/// Lists the objections against the laws; laws with the same objection are named together.
fn listed(objections: &[(&str, String)]) -> String {
    let mut kinds: Vec<(Vec<&str>, &String)> = Vec::new();
    for (law, objection) in objections {
        match kinds.iter_mut().find(|(_, known)| *known == objection) {
            Some((laws, _)) => laws.push(law),
            None => kinds.push((vec![law], objection)),
        }
    }
    let each: Vec<String> =
        kinds.iter().map(|(laws, objection)| format!("{} {objection}", laws.join(", "))).collect();
    each.join("; ")
}

/// The design row to quote: that of the longest return period, or of the rarest level if there is no return period.
fn quoted_row(rows: &[DesignRow]) -> Option<&DesignRow> {
    let is_period = |row: &&DesignRow| matches!(row.rarity, Rarity::Period(_));
    let rarest = |a: &&DesignRow, b: &&DesignRow| a.exceedance.total_cmp(&b.exceedance);
    rows.iter().filter(is_period).min_by(rarest).or_else(|| rows.iter().min_by(rarest))
}

/// The sentence with the value of the data at the rarest level that the data reach.
fn of_data(findings: &Findings, unit: &str) -> String {
    let reached = findings.rows.iter().filter(|row| row.by_data.value.is_some());
    let rarest = reached.min_by(|a, b| a.exceedance.total_cmp(&b.exceedance));
    match rarest {
        Some(row) => format!(
            "Quote the runs themselves: their value of {} is {}. For a rarer level make more runs.",
            words::rarity(row.rarity),
            with_unit(&words::by_data(&row.by_data), unit)
        ),
        None => format!(
            "The {} values do not reach the required levels either: make more runs.",
            findings.sample.count()
        ),
    }
}

/// The reason why a law may not be quoted, in words that follow the law's name; `None` if the data do not contradict
/// the law.
fn objection(findings: &Findings, place: usize, fit: &Fit) -> Option<String> {
    if fit.is_rejected() {
        return Some("rejected by the data (Kolmogorov and Smirnov, 1 %)".to_owned());
    }
    let expected =
        findings.tail.and_then(|tail| Some((tail, tail.expected(fit, &findings.sample)?)));
    if let Some((tail, expected)) = expected {
        let count = tail.count as f64;
        if (expected - count).abs() > TAIL_DEVIATIONS * libm::sqrt(count) {
            let above = words::number(tail.above);
            let expected = fixed(expected, 0);
            return Some(format!(
                "the law expects {expected} values above {above}, but the data have {count}"
            ));
        }
    }
    if words::contradiction(findings, place).is_some() {
        return Some("with a rare design value below the largest value of the data".to_owned());
    }
    words::undecided(findings, place).map(|_| "with a tail that the data do not decide".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::statistics::design::{Asked, findings};
    use crate::statistics::fit::Distribution;
    use crate::statistics::{Confidence, Sample};

    const LAWS: [Law; 3] = [Law::LogNormal, Law::Weibull, Law::Gumbel];

    fn quoted(values: Vec<f64>) -> Quote {
        let asked = Asked {
            confidence: Confidence::USUAL,
            traffic: None,
            periods_years: Vec::new(),
            life_years: None,
            laws: LAWS.to_vec(),
            threshold: None,
        };
        let found = findings(Sample::new(values).unwrap(), &asked).unwrap();
        quote(&found, "kJ").unwrap()
    }

    /// The exact quantiles of a law.
    fn quantiles(law: Distribution, count: u32) -> Vec<f64> {
        let p = |i: u32| (f64::from(i) + 0.5) / f64::from(count);
        (0..count).map(|i| law.value_exceeded(p(i)).unwrap()).collect()
    }

    #[test]
    fn the_law_of_the_values_is_the_one_to_quote() {
        let own = [
            (Law::LogNormal, Distribution::LogNormal { mu: 1.0, sigma: 0.5 }),
            (Law::Weibull, Distribution::Weibull { shape: 1.6, scale: 8.0 }),
            (Law::Gumbel, Distribution::Gumbel { location: 9.0, scale: 2.0 }),
        ];
        for (law, distribution) in own {
            let quote = quoted(quantiles(distribution, 5000));
            assert_eq!(quote.law, Some(law), "{}", quote.sentence);
            assert!(quote.sentence.contains("smallest AIC"), "{}", quote.sentence);
            assert!(quote.sentence.contains(" kJ"), "{}", quote.sentence);
        }
    }

    /// Reactions of a fender on its plateau: two heaps that no law has.
    #[test]
    fn no_law_is_quoted_of_values_that_none_fits() {
        let mut values = quantiles(Distribution::Normal { mean: 10.0, deviation: 1.0 }, 3000);
        values.extend(quantiles(Distribution::Normal { mean: 30.0, deviation: 0.5 }, 3000));
        let quote = quoted(values);
        assert_eq!(quote.law, None, "{}", quote.sentence);
        for words in ["Quote none of the fitted laws", "Quote the runs themselves", "kJ"] {
            assert!(quote.sentence.contains(words), "{}", quote.sentence);
        }
    }
}
