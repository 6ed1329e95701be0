use super::table::UNITS;
use super::{Dimension, measures, parse};
use proptest::prelude::*;

fn si(text: &str) -> f64 {
    parse(text).unwrap_or_else(|error| panic!("{text}: {error:?}")).si
}

fn dimension(text: &str) -> Dimension {
    parse(text).unwrap_or_else(|error| panic!("{text}: {error:?}")).dimension
}

#[track_caller]
fn check_error(text: &str, message: &str, help: &str) {
    let error = parse(text).expect_err(text);
    assert!(error.message.contains(message), "{text}: {error:?}");
    assert!(error.help.unwrap_or_default().contains(help), "{text}: lacks the help {help}");
}

#[test]
fn known_quantities_are_exact() {
    let cases = [
        ("4 kn", 4.0 * 1852.0 / 3600.0),
        ("1 kn", 1852.0 / 3600.0),
        ("87800 t", 87_800_000.0),
        ("500 kN/m^2", 500_000.0),
        ("500 kN/m²", 500_000.0),
        ("500 kPa", 500_000.0),
        ("0.1 s", 0.1),
        ("100 ms", 0.1),
        ("0.07 km", 70.0),
        ("1.2e3 kN.m", 1.2e6),
        ("20 kN.s/m^2", 20_000.0),
        ("20 kN·s/m^2", 20_000.0),
        ("20 kN*s*m^-2", 20_000.0),
        ("20 kN s/m^2", 20_000.0),
        ("3 kN/(m.s)", 3_000.0),
        ("-500 kN", -500_000.0),
        ("\u{2212}500 kN", -500_000.0),
        ("+1 m", 1.0),
        ("60 tf", 588_399.0),
        ("1 nmi", 1852.0),
        ("10 ft", 3.048),
        ("1 bar", 1e5),
        ("2 h", 7200.0),
        ("12 %", 0.12),
        ("0.5", 0.5),
        ("0.5 1", 0.5),
        ("4kn", 4.0 * 1852.0 / 3600.0),
        ("36 km/h", 10.0),
        ("180 deg", core::f64::consts::PI),
        ("90 deg", core::f64::consts::FRAC_PI_2),
        ("270°", 1.5 * core::f64::consts::PI),
        ("1 rev", core::f64::consts::TAU),
        ("60 rpm", core::f64::consts::TAU),
        ("0 deg/s", 0.0),
        ("1 J/m^2", 1.0),
        ("1 in", 0.0254),
        ("12 in", 0.3048),
        ("1 lb", 0.453_592_37),
        ("1 LT", 1_016.046_908_8),
        ("20000 LT", 20_320_938.176),
        ("1 ST", 907.184_74),
        ("200 tonne", 200_000.0),
        ("1 lbf", 4.448_221_615_260_5),
        ("1 kip", 4_448.221_615_260_5),
        ("100 kips", 444_822.161_526_05),
        ("1 LTf", 9_964.016_418_183_52),
        ("1 mph", 0.447_04),
        ("1 kNm", 1000.0),
        ("2 MNm", 2e6),
        ("1000 kN·m", 1e6),
        ("20 tf.m", 196_133.0),
    ];
    for (text, expected) in cases {
        assert_eq!(si(text).to_bits(), f64::to_bits(expected), "{text}: {}", si(text));
    }
}

/// Pressures in pounds, by their definitions.
#[test]
fn pressures_of_the_profession() {
    let near = |text: &str, expected: f64| {
        let error = si(text) / expected - 1.0;
        assert!(error.abs() < 4.0 * f64::EPSILON, "{text}: {}", si(text));
    };
    near("1 psi", 4.448_221_615_260_5 / (0.0254 * 0.0254));
    near("1 psi", 6_894.757_293_168_361);
    near("1 ksi", 4_448.221_615_260_5 / (0.0254 * 0.0254));
    near("1 ksf", 4_448.221_615_260_5 / (0.3048 * 0.3048));
    near("1 kip/ft^2", si("1 ksf"));
    near("1 lbf/in^2", si("1 psi"));
    near("1 kip.ft", 4_448.221_615_260_5 * 0.3048);
}

#[test]
fn temperatures_are_degrees_celsius() {
    let celsius = |text: &str| super::celsius(text).unwrap();
    for text in ["40", "40 degC", "40degC", "40 °C", "104 degF", "104 °F", " 104 degF "] {
        assert_eq!(celsius(text), 40.0, "{text}");
    }
    assert_eq!(celsius("-40 degF"), -40.0);
    assert_eq!(celsius("-17.5"), -17.5);
    let refused = |text: &str, message: &str, help: &str| {
        let error = super::celsius(text).expect_err(text);
        assert!(error.message.contains(message), "{text}: {error:?}");
        assert!(error.help.unwrap_or_default().contains(help), "{text}: lacks {help}");
    };
    refused("300 K", "kelvin is not accepted", "26.85 degC");
    refused("300 kelvin", "kelvin is not accepted", "26.85 degC");
    refused("40 C", "`C`", "`degC`");
    refused("40 deg", "`deg`", "`degC`");
    refused("104 F", "`F`", "`degF`");
    refused("40 m", "`m` is not a unit of temperature", "degC or degF");
    refused("warm", "does not start with a number", "");
}

#[test]
fn same_dimensions_meet() {
    assert_eq!(dimension("1 kN/m^2"), dimension("1 Pa"));
    assert_eq!(dimension("1 N.m"), dimension("1 J"));
    assert_eq!(dimension("1 rpm"), dimension("1 deg/s"));
    assert_eq!(dimension("1 kn"), dimension("1 m/s"));
    assert_eq!(dimension("1 kg.m/s^2"), dimension("1 N"));
    assert_eq!(dimension("1 W.s"), dimension("1 J"));
    assert_ne!(dimension("1 Hz"), dimension("1 rad/s"));
    assert_eq!(dimension("4 kn").to_string(), "a speed [m/s]");
    assert_eq!(dimension("4 kg^2.m/s^3/rad").to_string(), "a quantity [kg²·m/(rad·s³)]");
    assert_eq!(dimension("4 1/kg").to_string(), "a quantity [1/kg]");
}

#[test]
fn every_measure_states_a_unit_of_its_dimension() {
    for measure in measures::ALL {
        assert_eq!(dimension(&format!("1 {}", measure.unit)), measure.dimension, "{measure}");
        assert_eq!(si(&format!("1 {}", measure.unit)), 1.0, "{measure} is not in SI");
        assert_eq!(dimension(measure.example), measure.dimension, "{measure}");
    }
}

#[test]
fn mistakes_are_named() {
    check_error("", "does not start with a number", "");
    check_error("kn", "does not start with a number", "");
    check_error("nan", "NaN", "");
    check_error("-inf kN", "infinity", "");
    check_error("1e400 m", "too large", "");
    check_error("1e99999999999 m", "too large", "");
    check_error("1e308 km", "too large", "");
    check_error("0,5 m", "comma", "0.5");
    check_error(".5 m", "starts with a digit", "0.5");
    check_error("4 kts", "`kts` is not a known unit", "`kn`");
    check_error("4 knots", "`knots` is not a known unit", "`kn`");
    check_error("4 kt", "knots or as kilotonnes", "`kn`");
    check_error("4 ton", "metric, a long or a short ton", "`LT` for 1016 kg");
    check_error("4 lt", "`lt` is not a known unit", "`LT`");
    check_error("4 Kip", "`Kip`", "`kip`");
    check_error("4 lbs", "`lbs`", "`lb`");
    check_error("4 inches", "`inches`", "`in`");
    check_error("4 kip-ft", "`-` does not belong", "kip.ft");
    check_error("4 degC", "`degC` is a temperature", "");
    check_error("4 KN/m^2", "`KN`", "`kn`");
    check_error("4 kn/m2", "digit right after the unit `m`", "`m^2`");
    check_error("4 blubb", "`blubb` is not a known unit", "known units: ");
    check_error("4 kN/m.s", "two ways", "kN/(m.s)");
    check_error("4 kN/", "breaks off", "");
    check_error("4 (kN", "without its `)`", "");
    check_error("4 kN)", "without its `(`", "");
    check_error("4 m^99", "1 to 9", "m^2");
    check_error("4 m^0", "1 to 9", "m^2");
    check_error("4 m^", "1 to 9", "");
    check_error("4 m!", "does not belong", "");
    check_error("4..m", "stands in the unit", "");
    check_error("4 Mt^9.Mt^9.Mt^9.Mt^9.Mt^9.Mt^9.Mt^9.Mt^9", "", "");
    check_error("4 nmi^9.nmi^9.nmi^9", "too high", "");
    check_error(&"(".repeat(1000), "at most", "");
}

proptest! {
    #[test]
    fn a_plain_number_is_itself(number in -1e30_f64..1e30) {
        // Up to 2^53 exactly; beyond, the text is parsed as Rust does.
        prop_assert_eq!(si(&format!("{number}")), number);
        prop_assert_eq!(si(&format!("{number:e}")), number);
    }

    #[test]
    fn decimal_prefixes_only_move_the_point(digits in 0_u64..1_000_000_000_000, places in 0_i32..9) {
        let number = format!("{digits}e-{places}");
        let expected: f64 = format!("{digits}e{}", 3 - places).parse().unwrap();
        prop_assert_eq!(si(&format!("{number} kN")), expected);
        prop_assert_eq!(si(&format!("{number} t")), expected);
    }

    #[test]
    fn knots_are_rounded_once(hundredths in 0_u64..10_000_000) {
        // hundredths · 1852 and 360000 are whole numbers that f64 holds exactly.
        let expected = (hundredths * 1852) as f64 / 360_000.0;
        let text = format!("{}.{:02} kn", hundredths / 100, hundredths % 100);
        prop_assert_eq!(si(&text), expected);
    }

    #[test]
    fn a_unit_times_and_over_itself_cancels(
        index in 0..UNITS.len(), other in 0..UNITS.len(), number in -1e9_f64..1e9,
    ) {
        let (unit, other) = (UNITS[index].symbol, UNITS[other].symbol);
        let round_trip = parse(&format!("{number} {other}.{unit}/{unit}")).unwrap();
        let plain = parse(&format!("{number} {other}")).unwrap();
        prop_assert_eq!(round_trip.dimension, plain.dimension);
        let error = (round_trip.si - plain.si).abs();
        prop_assert!(error <= 4.0 * f64::EPSILON * plain.si.abs());
    }

    #[test]
    fn any_text_is_answered(text in "\\PC{0,40}") {
        if let Ok(quantity) = parse(&text) {
            prop_assert!(quantity.si.is_finite());
        }
    }

    #[test]
    fn anything_like_a_unit_is_answered(text in "[-+]?[0-9.]{1,5}(e[-0-9]{1,4})?[ kmNst.*/^()0-9²°-]{0,20}") {
        if let Ok(quantity) = parse(&text) {
            prop_assert!(quantity.si.is_finite());
        }
    }
}
