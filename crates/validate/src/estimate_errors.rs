//! The errors of ships that are estimated from their main particulars, which are reported with every estimated ship.
//! The errors come from the rows of `validation/estimated_ships.toml`, which compare estimated ships with reference
//! values.

use std::sync::OnceLock;

use fenderline_results::EstimateError;
use fenderline_sim::hydro::EstimateMethod;
use fenderline_sim::hydro::vessels;

use super::computed::Values;
use super::computed::estimates::{MEASURES, ROUTES, ReferenceShip, compute_route};
use super::published::{Number, Origin, Source};

/// The file.
const ESTIMATED_SHIPS: &str =
    include_str!(concat!(env!("FENDERLINE_DATA"), "/validation/estimated_ships.toml"));

/// The measures of the manoeuvres in words, in the order of [`MEASURES`].
const NAMES: [&str; 4] = [
    "advance at 35°",
    "tactical diameter at 35°",
    "first overshoot of 10°/10°",
    "first overshoot of 20°/20°",
];

/// The errors of the formulas with which a vessel was estimated; empty if none of her data are estimated, or if the
/// errors of the formulas are not known.
pub fn errors_of(origin: &vessels::Origin) -> &'static [EstimateError] {
    match origin.estimate_method {
        Some(EstimateMethod::YoshimuraMasumoto) => {
            estimate_errors(EstimateMethod::YoshimuraMasumoto)
        }
        Some(EstimateMethod::Clarke) | None => &[],
    }
}

/// The errors of an estimation method (route), by measure. The errors of a route are computed once in a program.
fn estimate_errors(route: EstimateMethod) -> &'static [EstimateError] {
    static ERRORS: [OnceLock<Vec<EstimateError>>; 2] = [OnceLock::new(), OnceLock::new()];
    let index = ROUTES.iter().position(|(_, known)| *known == route).expect("every route is there");
    ERRORS[index].get_or_init(|| {
        let (name, mut values) = (ROUTES[index].0, Values::default());
        compute_route(&mut values, name, route);
        errors(&values, name)
    })
}

/// Puts the errors of both estimation methods among the values of `validate` (%).
pub(super) fn put(values: &mut Values) {
    for (route, _) in ROUTES {
        for error in errors(values, route) {
            let name = |kind| format!("estimate_error/{route}/{}/{kind}", error.measure);
            for (kind, value) in
                [("size", error.size), ("bias", error.bias), ("largest", error.largest())]
            {
                values.put(name(kind), 100.0 * value, "%");
            }
        }
    }
}

fn errors(values: &Values, route: &str) -> Vec<EstimateError> {
    let sources = Source::parse(ESTIMATED_SHIPS)
        .unwrap_or_else(|error| panic!("the built-in validation/estimated_ships.toml: {error}"));
    let numbers: Vec<&Number> = sources.iter().flat_map(|source| &source.numbers).collect();
    MEASURES
        .iter()
        .zip(NAMES)
        .map(|((measure, _), name)| {
            let of_ship = |ship: ReferenceShip| {
                let ship = ship.name();
                let value = format!("estimated/{route}/{ship}/{measure}");
                let is_its = |number: &&&Number| number.origin == Origin::Computed(value.clone());
                let number = numbers.iter().find(is_its)?;
                let error = values.get(&value).value / number.published - 1.0;
                // "KCS, advance, …"
                let title = number.case.split(',').next().unwrap_or_default();
                Some((title.to_owned(), error))
            };
            let all: Vec<(String, f64)> =
                ReferenceShip::ALL.into_iter().filter_map(of_ship).collect();
            let mean = |of: fn(f64) -> f64| {
                all.iter().map(|(_, error)| of(*error)).sum::<f64>() / all.len() as f64
            };
            let mut ordered = all.clone();
            ordered.sort_by(|a, b| a.1.total_cmp(&b.1));
            let ends = [ordered.first(), ordered.last()]
                .map(|end| end.expect("a measure has references").clone());
            EstimateError {
                measure,
                name,
                size: mean(f64::abs),
                bias: mean(|error| error),
                ends,
                ships: all.len(),
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The errors that are reported with ships by the usual route, and the goal of that route.
    #[test]
    fn estimated_ships_turn_within_15_percent_in_the_mean_and_25_each() {
        let errors = estimate_errors(EstimateMethod::YoshimuraMasumoto);
        for error in &errors[..2] {
            assert!(error.ships == 6 && error.size <= 0.15, "{error:?}");
            assert!(error.largest().abs() <= 0.25, "{error:?}");
        }
        // The older route: larger largest errors, and a bias to the stable side.
        let before = estimate_errors(EstimateMethod::Clarke);
        for (error, before) in errors.iter().zip(before) {
            assert!(error.largest().abs() < before.largest().abs(), "{error:?} {before:?}");
            assert!(error.bias.abs() < before.bias.abs(), "{error:?} {before:?}");
        }
    }
}
