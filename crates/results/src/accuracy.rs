//! The accuracy of vessels whose hull, propeller and rudder were estimated from the main particulars.

use fenderline_sim::hydro::EstimateMethod;
use fenderline_sim::hydro::vessels::{Origin, Source};

use crate::json::{Json, object};

/// The errors of an estimation method in one measured quantity: computed value divided by reference value, minus 1.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimateError {
    /// Key of the measure.
    pub measure: &'static str,
    /// The measure in words.
    pub name: &'static str,
    /// Mean of the absolute errors.
    pub size: f64,
    /// Mean of the signed errors.
    pub bias: f64,
    /// The lowest and the highest error, each with its ship.
    pub ends: [(String, f64); 2],
    /// Number of ships.
    pub ships: usize,
}

impl EstimateError {
    /// The error with the largest magnitude, with its sign.
    pub fn largest(&self) -> f64 {
        let [(_, low), (_, high)] = &self.ends;
        if low.abs() > high.abs() { *low } else { *high }
    }
}

/// The accuracy of a vessel's estimated data, one line each: ratios outside the range of the formulas, and the errors
/// of the formulas on ships with known reference values. The list is empty for a vessel with given data of hull,
/// propeller and rudder.
pub fn accuracy(origin: &Origin, errors: &[EstimateError]) -> Vec<String> {
    let Some(route) = origin.estimate_method else { return Vec::new() };
    let mut lines: Vec<String> = origin.outside.iter().map(ToString::to_string).collect();
    match route {
        EstimateMethod::Clarke => lines.push(
            "we found no similar vessel with which to compare the formulas: their error is not \
             known"
                .to_owned(),
        ),
        EstimateMethod::YoshimuraMasumoto => lines.extend(errors.iter().map(|error| {
            let percent = |share: f64| signed_percent(share);
            let [(low_ship, low), (high_ship, high)] = &error.ends;
            format!(
                "{}: off by {} in the mean of {} ships with references, from {} ({low_ship}) to {} ({high_ship}); bias {}",
                error.name,
                percent(error.size).trim_start_matches('+'),
                error.ships,
                percent(*low),
                percent(*high),
                percent(error.bias)
            )
        })),
    }
    lines
}

/// The heading of [`accuracy`].
pub const ACCURACY: &str = "How far these estimates are to be relied on (`fenderline validate`)";

fn signed_percent(share: f64) -> String {
    let text = format!("{:+.0} %", 100.0 * share).replace('-', "−");
    if matches!(text.as_str(), "+0 %" | "−0 %") { "0 %".to_owned() } else { text }
}

/// The content of [`accuracy`] as JSON; null if nothing of hull, propeller and rudder is estimated.
pub fn accuracy_json(origin: &Origin, errors: &[EstimateError]) -> Json {
    let Some(route) = origin.estimate_method else { return Json::Null };
    let outside: Vec<Json> = origin
        .outside
        .iter()
        .map(|outside| {
            object!({
                "ratio": outside.ratio.name(),
                "value": outside.value,
                "low": outside.range[0],
                "high": outside.range[1],
            })
        })
        .collect();
    let (formulas, errors) = match route {
        EstimateMethod::Clarke => ("Clarke, Gedling & Hine (1983)", Vec::new()),
        EstimateMethod::YoshimuraMasumoto => ("Yoshimura & Masumoto (2012)", {
            let object = |error: &EstimateError| {
                object!({
                    "measure": error.measure,
                    "mean_size": error.size,
                    "bias": error.bias,
                    "lowest": error.ends[0].1,
                    "highest": error.ends[1].1,
                    "ships": error.ships,
                })
            };
            errors.iter().map(object).collect()
        }),
    };
    object!({ "formulas": formulas, "outside": outside, "errors": errors })
}

/// A source as JSON.
pub fn source_json(source: &Source) -> Json {
    let figures: Json =
        source.figures.iter().map(|figure| (figure.name.clone(), &figure.text)).collect();
    object!({
        "group": source.group,
        "figures": figures,
        "source": source.source,
        "standing": source.standing.word(),
        "estimated": source.is_estimate,
    })
}
