//! The statistics of a column as JSON.

use fenderline_campaign::report::{quote, words};
use fenderline_campaign::statistics::design::Rarity;
use fenderline_campaign::statistics::fit::{Fit, FitError};
use fenderline_campaign::statistics::{Estimate, Measured};
use serde_json::{Value, json};

use super::column::Column;

/// All of it.
pub(super) fn of(column: &Column<'_>) -> Value {
    let (findings, asked) = (&column.findings, &column.asked);
    let (sample, moments) = (&findings.sample, &findings.moments);
    let quote = quote(findings, &column.head.unit);
    let design = findings.rows.iter().map(|row| {
        let fits = findings.fits.iter().zip(&row.by_fit);
        let fits =
            fits.filter_map(|(fit, value)| Some((fit.as_ref().ok()?.law.key().to_owned(), value)));
        let fits: serde_json::Map<String, Value> =
            fits.map(|(key, value)| (key, value.as_ref().map_or(Value::Null, estimate))).collect();
        let mut own = rarity(row.rarity);
        own["exceedance_per_berthing"] = json!(row.exceedance);
        let data = row.by_data;
        own["data"] = json!({ "value": data.value, "low": data.low, "high": data.high });
        own["fits"] = Value::Object(fits);
        own
    });
    let curve = findings.curve.iter().map(|point| {
        let (value, low, high) = (
            point.probability.value,
            point.probability.interval.low,
            point.probability.interval.high,
        );
        json!({ "value": point.value, "probability": value, "low": low, "high": high })
    });
    json!({
        "file": column.file,
        "column": column.head.name,
        "unit": column.head.unit,
        "count": sample.count(),
        "missing": column.missing,
        "zeros_left_out": column.zeros,
        "law_to_quote": quote.as_ref().and_then(|quote| quote.law).map(|law| law.key()),
        "quote": quote.map(|quote| quote.sentence),
        "remarks": words::remarks(findings),
        "effective_size": sample.effective_size(),
        "confidence": asked.confidence.level(),
        "berthings_per_year": asked.traffic.map(|traffic| traffic.per_year()),
        "least": sample.least(),
        "largest": sample.largest(),
        "mean": measured(moments.mean),
        "standard_deviation": measured(moments.deviation),
        "skewness": moments.skewness,
        "design_values": design.collect::<Vec<_>>(),
        "fits": findings.fits.iter().map(fit).collect::<Vec<_>>(),
        "exceedance": curve.collect::<Vec<_>>(),
    })
}

fn rarity(rarity: Rarity) -> Value {
    match rarity {
        Rarity::Berthing(_) => json!({ "of": "berthing" }),
        Rarity::Period(years) => json!({ "of": "return_period", "years": years }),
        Rarity::Life { years, chance } => json!({ "of": "life", "years": years, "chance": chance }),
    }
}

fn estimate(of: &Estimate) -> Value {
    json!({ "value": of.value, "low": of.interval.low, "high": of.interval.high })
}

fn measured(of: Measured) -> Value {
    json!({ "value": of.value, "standard_error": of.error })
}

fn fit(fit: &Result<Fit, FitError>) -> Value {
    match fit {
        Ok(fit) => {
            let parameters = fit.parameters.iter();
            let parameters: serde_json::Map<String, Value> = parameters
                .map(|own| {
                    let number = Measured { value: own.value, error: own.error };
                    (own.name.to_owned(), measured(number))
                })
                .collect();
            json!({
                "law": fit.law.key(),
                "parameters": parameters,
                "count": fit.count,
                "log_likelihood": fit.log_likelihood,
                "aic": fit.aic,
                "kolmogorov_smirnov": fit.kolmogorov,
                "is_rejected": fit.is_rejected(),
                "anderson_darling": fit.anderson_darling,
                "newton_steps": fit.steps,
            })
        }
        Err(why) => json!({ "law": why.law.key(), "error": why.to_string() }),
    }
}
