//! The units that scenario files may use.

use super::Dimension;
use super::decimal::Scale;

/// A unit with its symbol and its exact factor to SI.
pub(super) struct NamedUnit {
    pub(super) symbol: &'static str,
    pub(super) scale: Scale,
    pub(super) dimension: Dimension,
    /// Wrong spellings of the unit, which are refused with this unit as the suggestion.
    pub(super) also: &'static [&'static str],
}

const LENGTH: Dimension = Dimension::new(1, 0, 0, 0);
const MASS: Dimension = Dimension::new(0, 1, 0, 0);
const TIME: Dimension = Dimension::new(0, 0, 1, 0);
const FREQUENCY: Dimension = Dimension::new(0, 0, -1, 0);
const ANGLE: Dimension = Dimension::new(0, 0, 0, 1);
const TURN_RATE: Dimension = Dimension::new(0, 0, -1, 1);
const SPEED: Dimension = Dimension::new(1, 0, -1, 0);
const FORCE: Dimension = Dimension::new(1, 1, -2, 0);
const PRESSURE: Dimension = Dimension::new(-1, 1, -2, 0);
const ENERGY: Dimension = Dimension::new(2, 1, -2, 0);
const POWER: Dimension = Dimension::new(2, 1, -3, 0);

const fn unit(
    symbol: &'static str,
    dimension: Dimension,
    (numerator, denominator, ten, pi): (u128, u128, i32, i32),
    also: &'static [&'static str],
) -> NamedUnit {
    NamedUnit { symbol, scale: Scale { numerator, denominator, ten, pi }, dimension, also }
}

/// One pound-force in units of 10^-13 N: the product of 0.45359237 and 9.80665.
const LBF: u128 = 44_482_216_152_605;

/// 10^n.
const fn ten(n: i32) -> (u128, u128, i32, i32) {
    (1, 1, n, 0)
}

/// Every unit. Sources of the factors: SI brochure, 9th edition; international nautical mile
/// 1852 m; a shackle of anchor chain 27.5 m;
/// international foot 0.3048 m and pound 0.45359237 kg (1959), a long ton of 2240 and a short ton of 2000
/// pounds; standard gravity 9.80665 m/s² for forces in tonnes, in which bollard pull is quoted, and pounds.
pub(super) static UNITS: &[NamedUnit] = &[
    unit("1", Dimension::NONE, ten(0), &[]),
    unit("%", Dimension::NONE, ten(-2), &["percent", "pct"]),
    unit("m", LENGTH, ten(0), &["metre", "metres", "meter", "meters"]),
    unit("km", LENGTH, ten(3), &[]),
    unit("cm", LENGTH, ten(-2), &[]),
    unit("mm", LENGTH, ten(-3), &[]),
    unit("nmi", LENGTH, (1852, 1, 0, 0), &["NM", "nm", "sm", "mile", "miles"]),
    unit("shackle", LENGTH, (275, 1, -1, 0), &["shot"]),
    unit("shackles", LENGTH, (275, 1, -1, 0), &["shots"]),
    unit("in", LENGTH, (254, 1, -4, 0), &["inch", "inches"]),
    unit("ft", LENGTH, (3048, 1, -4, 0), &["foot", "feet"]),
    unit("kg", MASS, ten(0), &["kilo", "kilogram", "kilograms"]),
    unit("g", MASS, ten(-3), &["gram", "grams"]),
    unit("t", MASS, ten(3), &["T", "mt"]),
    unit("tonne", MASS, ten(3), &["tonnes"]),
    unit("LT", MASS, (10_160_469_088, 1, -7, 0), &["long ton", "longton"]),
    unit("ST", MASS, (90_718_474, 1, -5, 0), &["shortton"]),
    unit("lb", MASS, (45_359_237, 1, -8, 0), &["lbs", "pound", "pounds", "lbm"]),
    unit("Mt", MASS, ten(9), &[]),
    unit("s", TIME, ten(0), &["sec", "secs", "second", "seconds"]),
    unit("ms", TIME, ten(-3), &[]),
    unit("min", TIME, (60, 1, 0, 0), &["mins", "minute", "minutes"]),
    unit("h", TIME, (3600, 1, 0, 0), &["hr", "hrs", "hour", "hours"]),
    unit("Hz", FREQUENCY, ten(0), &["hertz"]),
    unit("rad", ANGLE, ten(0), &["radian", "radians"]),
    unit("deg", ANGLE, (1, 180, 0, 1), &["degree", "degrees"]),
    unit("°", ANGLE, (1, 180, 0, 1), &[]),
    unit("rev", ANGLE, (2, 1, 0, 1), &["turn", "revolution", "revolutions"]),
    unit("rpm", TURN_RATE, (1, 30, 0, 1), &["RPM"]),
    unit("kn", SPEED, (1852, 3600, 0, 0), &["kts", "knot", "knots", "KN", "Kn"]),
    unit("mph", SPEED, (44_704, 1, -5, 0), &["mi/h"]),
    unit("N", FORCE, ten(0), &["newton", "newtons"]),
    unit("kN", FORCE, ten(3), &[]),
    unit("MN", FORCE, ten(6), &[]),
    unit("GN", FORCE, ten(9), &[]),
    unit("tf", FORCE, (980_665, 1, -2, 0), &["tonf", "Tf", "mtf"]),
    unit("kgf", FORCE, (980_665, 1, -5, 0), &["kp"]),
    unit("lbf", FORCE, (LBF, 1, -13, 0), &[]),
    unit("kip", FORCE, (LBF, 1, -10, 0), &["klbf", "kilopound"]),
    unit("kips", FORCE, (LBF, 1, -10, 0), &[]),
    unit("LTf", FORCE, (996_401_641_818_352, 1, -11, 0), &["ltf"]),
    unit("Pa", PRESSURE, ten(0), &["pascal"]),
    unit("kPa", PRESSURE, ten(3), &[]),
    unit("MPa", PRESSURE, ten(6), &[]),
    unit("GPa", PRESSURE, ten(9), &[]),
    unit("bar", PRESSURE, ten(5), &["bars"]),
    unit("psi", PRESSURE, (LBF, 64_516, -5, 0), &["lbf/in2"]),
    unit("ksi", PRESSURE, (LBF, 64_516, -2, 0), &[]),
    unit("psf", PRESSURE, (LBF, 9_290_304, -5, 0), &[]),
    unit("ksf", PRESSURE, (LBF, 9_290_304, -2, 0), &[]),
    unit("Nm", ENERGY, ten(0), &[]),
    unit("kNm", ENERGY, ten(3), &["knm", "kN-m"]),
    unit("MNm", ENERGY, ten(6), &[]),
    unit("J", ENERGY, ten(0), &["joule", "joules"]),
    unit("kJ", ENERGY, ten(3), &[]),
    unit("MJ", ENERGY, ten(6), &[]),
    unit("GJ", ENERGY, ten(9), &[]),
    unit("W", POWER, ten(0), &["watt", "watts"]),
    unit("kW", POWER, ten(3), &[]),
    unit("MW", POWER, ten(6), &[]),
];

/// The unit with the symbol `symbol`.
pub(super) fn find(symbol: &str) -> Option<&'static NamedUnit> {
    UNITS.iter().find(|unit| unit.symbol == symbol)
}
