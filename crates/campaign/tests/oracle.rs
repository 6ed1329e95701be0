//! Statistics beside SciPy 1.17: `python3 crates/campaign/tests/oracle.py` prints the tables.

use std::path::Path;

use fenderline_campaign::statistics::fit::{Law, fit};
use fenderline_campaign::statistics::{Confidence, Sample, binomial};
use fenderline_campaign::table::Table;

/// Hits, runs, ends of `binomtest(...).proportion_ci(0.95, method="exact")`. The normal approximation for large numbers is good
/// to 10⁻⁷ of the ends; the others to the bisection.
const CLOPPER_PEARSON: [(usize, usize, f64, f64); 8] = [
    (0, 50, 0.0, 0.071_121_736_464_204_58),
    (1, 50, 0.000_506_227_983_115_235_4, 0.106_469_545_711_500_97),
    (3, 1_000_000, 6.186_725_999_192_623e-07, 8.767_247_805_906_18e-06),
    (50, 50, 0.928_878_263_535_795_4, 1.0),
    (25, 50, 0.355_272_997_129_907_7, 0.644_727_002_870_092_2),
    (700, 1500, 0.441_172_927_572_355_8, 0.492_291_153_412_647_3),
    (1000, 1_000_000, 0.000_939_001_207_945_439, 0.001_063_918_107_313_653_5),
    (400_000, 1_000_000, 0.399_039_608_432_534_66, 0.400_960_970_827_776_54),
];

#[test]
fn intervals_of_a_probability_are_scipys() {
    for (hits, runs, low, high) in CLOPPER_PEARSON {
        let interval = binomial(hits, runs, Confidence::USUAL).interval;
        let close = |got: f64, want: f64| (got - want).abs() <= 1e-7 * want;
        assert!(
            close(interval.low, low) && close(interval.high, high),
            "{hits}/{runs}: {interval:?}"
        );
    }
}

/// Law, parameters, log-likelihood, Kolmogorov's distance, Anderson and Darling's A², value exceeded with 1/3,000.
type Row = (Law, &'static [f64], f64, f64, f64, f64);

/// Fits of campaigns/berthing_speeds.csv; of the values above 8 cm/s for the last one.
const FITS: [Row; 6] = [
    (
        Law::Normal,
        &[6.254_2, 3.107_849_6],
        -510.573_916_975,
        0.139_882_551,
        4.705_083_268,
        16.830_003_508,
    ),
    (
        Law::LogNormal,
        &[1.719_223_19, 0.479_714_03],
        -480.719_320_931,
        0.046_339_298,
        0.285_430_204,
        28.550_024_94,
    ),
    (
        Law::Weibull,
        &[2.138_644_22, 7.088_411_7],
        -494.139_255_918,
        0.106_658_044,
        2.436_020_433,
        18.749_198_04,
    ),
    (
        Law::Gumbel,
        &[4.894_396_98, 2.250_609_54],
        -483.078_861_333,
        0.059_062_607,
        0.631_489_792,
        22.913_229_026,
    ),
    (
        Law::Gev,
        &[4.772_615_36, 2.156_872_93, 0.101_907_25],
        -481.367_484_774,
        0.041_942_709,
        0.292_988_881,
        31.465_712_583,
    ),
    (
        Law::Pareto,
        &[8.0, 3.021_923_42, -0.091_700_55],
        -96.681_262_348,
        0.088_219_679,
        0.366_984_94,
        22.928_538_823,
    ),
];

/// Both optimisers stop short of the maximum, SciPy's where the likelihood changes by 10⁻¹³, and the parameters are printed to eight
/// decimals: they agree to 10⁻⁴ of their standard errors, and what follows from them to 10⁻⁵.
#[test]
fn fits_are_scipys() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../campaigns/berthing_speeds.csv");
    let values = Table::open(&file).unwrap().numbers("speed").unwrap().present();
    let sample = Sample::new(values).unwrap();
    for (law, parameters, log_likelihood, kolmogorov, anderson_darling, value) in FITS {
        let found = fit(law, &sample, Some(8.0)).unwrap();
        let close = |what: &str, got: f64, want: f64, tolerance: f64| {
            assert!((got - want).abs() <= tolerance, "{}: {what} {got}, SciPy {want}", law.key());
        };
        for (got, want) in found.parameters.iter().zip(parameters) {
            close(got.name, got.value, *want, 1e-4 * got.error);
        }
        close("log-likelihood", found.log_likelihood, log_likelihood, 1e-7);
        close("distance", found.kolmogorov, kolmogorov, 1e-5);
        close("A²", found.anderson_darling, anderson_darling, 1e-4);
        let exceeded = found.value_exceeded(1.0 / 3000.0, Confidence::USUAL).unwrap();
        close("value", exceeded.value, value, 1e-5 * value);
        assert!(exceeded.interval.low < value && value < exceeded.interval.high);
    }
}
