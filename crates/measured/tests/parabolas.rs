//! The smoothing against statsmodels and SciPy; `validation/independent/measured_parabolas.py` makes the numbers.

use fenderline_measured::Parabola;
use serde_json::Value;

const CASES: &str = include_str!("parabolas.json");

fn numbers(of: &Value) -> Vec<f64> {
    let all = of.as_array().expect("a list");
    all.iter().map(|value| value.as_f64().expect("a number")).collect()
}

#[test]
fn parabolas_are_those_of_statsmodels_and_savitzky_and_golay() {
    let cases: Value = serde_json::from_str(CASES).expect("JSON");
    let mut filtered = 0;
    for case in cases.as_array().expect("a list") {
        let readings: Vec<(f64, f64)> =
            numbers(&case["t_s"]).into_iter().zip(numbers(&case["y"])).collect();
        let at_s = case["at_s"].as_f64().expect("a time");
        let fit = Parabola::through(&readings, at_s, 0.0).expect("enough readings");
        assert_eq!(fit.left_out, 0);
        let wanted = &case["by_statsmodels"];
        let of = numbers(&wanted["of"]);
        for (own, wanted) in fit.of.iter().zip(&of) {
            assert!((own - wanted).abs() < 1e-9 * (1.0 + wanted.abs()), "{fit:?}");
        }
        let correlation = wanted["correlation"].as_f64().expect("a number");
        assert!((fit.correlation - correlation).abs() < 1e-6);
        let deviation = wanted["deviation"].as_f64().expect("a number");
        assert!((fit.deviation / deviation - 1.0).abs() < 1e-6);
        let factor = match correlation > 2.0 / (readings.len() as f64).sqrt() {
            true => (1.0 + correlation) / (1.0 - correlation),
            false => 1.0,
        };
        for (row, wanted) in wanted["covariance"].as_array().expect("rows").iter().enumerate() {
            for (column, wanted) in numbers(wanted).into_iter().enumerate() {
                let own = fit.covariance[row][column];
                let scale = (fit.covariance[row][row] * fit.covariance[column][column]).sqrt();
                assert!(
                    (own - factor * wanted).abs() < 1e-6 * scale,
                    "{row} {column}: {own}, {wanted}"
                );
            }
        }
        if let Some(ends) = case.get("by_savitzky_golay") {
            let last_s = readings[readings.len() - 1].0;
            let ends = numbers(ends);
            assert!((fit.value(last_s) - ends[0]).abs() < 1e-9);
            assert!((fit.slope(last_s) - ends[1]).abs() < 1e-9);
            filtered += 1;
        }
    }
    assert_eq!(filtered, 4);
}
