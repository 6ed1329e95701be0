//! Writes numbers and levels of design values in words.

use fenderline_contact::number::lesser;
use fenderline_report::plot::{fixed, plain, significant};

use crate::statistics::design::{DesignRow, Findings, Rarity};
use crate::statistics::fit::Fit;
use crate::statistics::{Estimate, Quantile};

/// The text of a probability: `1 in 3000` for the rare `0.0003333`, per cent for frequent events.
#[must_use]
pub fn one_in(p: f64) -> String {
    match p {
        p if p <= 0.0 => "never".to_owned(),
        p if p > 0.2 => format!("{} %", significant(100.0 * p, 3)),
        p => format!("1 in {}", significant(1.0 / p, 3)),
    }
}

/// Words that say how rarely a design value is exceeded.
#[must_use]
pub fn rarity(rarity: Rarity) -> String {
    match rarity {
        Rarity::Berthing(p) => format!("{} berthings", one_in(p)),
        Rarity::Period(years) => format!("{} years", plain(years, 4)),
        Rarity::Life { years, chance } => {
            format!("{} % in {} years", plain(100.0 * chance, 3), plain(years, 4))
        }
    }
}

/// The text of a value with its band, such as `28.5 (24.6 to 33.0)`.
#[must_use]
pub fn with_band(estimate: &Estimate) -> String {
    let [low, high] = [estimate.interval.low, estimate.interval.high];
    format!("{} ({} to {})", number(estimate.value), number(low), number(high))
}

/// The text of a quantile of the data; it says if the data do not reach so far.
#[must_use]
pub fn by_data(quantile: &Quantile) -> String {
    let Some(value) = quantile.value else {
        return match quantile.low {
            Some(low) => format!("beyond the data (above {})", number(low)),
            None => "beyond the data".to_owned(),
        };
    };
    match (quantile.low, quantile.high) {
        (Some(low), Some(high)) => {
            format!("{} ({} to {})", number(value), number(low), number(high))
        }
        (Some(low), None) => format!("{} ({} to ?)", number(value), number(low)),
        (None, Some(high)) => format!("{} (? to {})", number(value), number(high)),
        (None, None) => number(value),
    }
}

/// The text of a fit's parameters with their standard errors.
#[must_use]
pub fn parameters(fit: &Fit) -> String {
    let one = |own: &crate::statistics::fit::Parameter| match own.error > 0.0 {
        true => format!("{} {} ± {}", own.name, number(own.value), significant(own.error, 2)),
        false => format!("{} {}", own.name, number(own.value)),
    };
    fit.parameters.iter().map(one).collect::<Vec<_>>().join(", ")
}

/// The text of a number to three digits; a number of four digits has no space between thousands.
#[must_use]
pub fn number(value: f64) -> String {
    if value.abs() >= 1000.0 { fixed(value, 0) } else { significant(value, 3) }
}

/// If the band of a value spans a greater factor than this, the data do not decide the value.
const WIDEST: f64 = 10.0;

/// Warnings for the reader of a design value: laws that the data contradict, levels that the data
/// do not reach, values that contradict the data.
#[must_use]
pub fn remarks(findings: &Findings) -> Vec<String> {
    let sample = &findings.sample;
    let mut all = Vec::new();
    let negative = sample.values().partition_point(|value| *value < 0.0);
    if negative > 0 && negative < sample.count() {
        all.push(format!(
            "{negative} of {} values are negative, the least {}: laws of positive values cannot be fitted",
            sample.count(),
            number(sample.least())
        ));
    }
    let fits = || {
        findings
            .fits
            .iter()
            .enumerate()
            .filter_map(|(place, fit)| Some((place, fit.as_ref().ok()?)))
    };
    let rejected: Vec<&str> =
        fits().filter(|(_, fit)| fit.is_rejected()).map(|(_, fit)| fit.law.title()).collect();
    if !rejected.is_empty() {
        all.push(format!(
            "the data contradict {} (Kolmogorov and Smirnov, 1 %): its design values mean nothing",
            rejected.join(", ")
        ));
    }
    let reach = 1.0 / sample.count() as f64;
    let rarest = findings.rows.iter().map(|row| row.exceedance).fold(1.0, lesser);
    if rarest < reach && !sample.is_weighted() {
        all.push(format!(
            "{} is rarer than {} values can show: only the fitted laws give values there, and the \
             laws differ",
            one_in(rarest),
            sample.count()
        ));
    }
    for (place, fit) in fits().filter(|(_, fit)| !fit.is_rejected()) {
        let law = fit.law.title();
        if let Some((row, value)) = contradiction(findings, place) {
            all.push(format!(
                "by {law} the value of {}, {}, is below the largest of the data, {}",
                rarity(row.rarity),
                number(value.value),
                number(sample.largest())
            ));
        }
        if let Some((row, value)) = undecided(findings, place) {
            all.push(format!(
                "the data do not decide the tail of {law}: its value of {} lies between {} and {}",
                rarity(row.rarity),
                number(value.interval.low),
                number(value.interval.high)
            ));
        }
    }
    all
}

/// The design values of a fit.
fn values(findings: &Findings, place: usize) -> impl Iterator<Item = (&DesignRow, &Estimate)> {
    findings.rows.iter().filter_map(move |row| Some((row, row.by_fit[place].as_ref()?)))
}

/// The first design value of a fit that belongs to a rarer level than the data reach and yet lies below the largest
/// value of the data.
pub(super) fn contradiction(findings: &Findings, place: usize) -> Option<(&DesignRow, &Estimate)> {
    let sample = &findings.sample;
    let reach = 1.0 / sample.count() as f64;
    values(findings, place)
        .find(|(row, value)| row.exceedance < reach && value.value < sample.largest())
}

/// The first design value of a fit whose band is so wide that the data do not decide the value.
pub(super) fn undecided(findings: &Findings, place: usize) -> Option<(&DesignRow, &Estimate)> {
    values(findings, place)
        .find(|(_, value)| value.value > 0.0 && value.interval.high > WIDEST * value.interval.low)
}

/// Puts the unit after the value in a text with a band such as `28.5 (24.6 to 33.0)`.
pub(super) fn with_unit(text: &str, unit: &str) -> String {
    match text.split_once(" (") {
        _ if unit.is_empty() => text.to_owned(),
        Some((value, band)) => format!("{value} {unit} ({band}"),
        None => format!("{text} {unit}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_data_do_not_reach_says_so() {
        let quantile = |value, low, high| Quantile { value, low, high };
        assert_eq!(by_data(&quantile(Some(1.0), Some(0.5), Some(2.0))), "1.00 (0.500 to 2.00)");
        assert_eq!(by_data(&quantile(Some(1.0), Some(0.5), None)), "1.00 (0.500 to ?)");
        assert_eq!(by_data(&quantile(None, Some(9.0), None)), "beyond the data (above 9.00)");
        assert_eq!(rarity(Rarity::Life { years: 50.0, chance: 0.1 }), "10 % in 50 years");
        assert_eq!(rarity(Rarity::Berthing(1.0 / 3000.0)), "1 in 3000 berthings");
        assert_eq!(one_in(0.5), "50.0 %");
    }
}
