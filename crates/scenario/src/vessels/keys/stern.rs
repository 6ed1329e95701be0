//! Keys of propeller and rudder.

use fenderline_sim::hydro::Series;
use serde_json::json;

use super::shared::{COEFFICIENT, ESTIMATED, POSITIVE, coefficient};
use fenderline_keys::choices::{Choice, Choices};
use fenderline_keys::held::{Number, OneOf, TableOf};
use fenderline_keys::keys::quantities::LENGTH;
use fenderline_keys::spec::Absent::{Means, Refused, Unless};
use fenderline_keys::spec::{Kind, Quantity, TableSpec, key};
use fenderline_keys::table_keys;
use fenderline_keys::units::measures as unit;

pub(super) static PROPELLER: TableSpec = TableSpec {
    what: "a propeller of a file",
    doc: "Propeller, wake and shaft.",
    keys: FilePropellerKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a propeller of a file.
    pub(crate) FilePropellerKey {
        DIAMETER: Number = key(
            "diameter",
            Kind::Quantity(LENGTH),
            Refused,
            "Diameter.",
            &["\"8.5 m\""],
        ),
        FULL: Number = key(
            "full",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: 1e-3, high: 1e3 }),
            Means(
                "by Froude's law from the vessel of `coefficients_of`; required without \
                `coefficients_of`",
            ),
            "Full revolutions.",
            &["\"95 rpm\""],
        ),
        REVERSAL: Number = key(
            "reversal",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.1, high: 3600.0 }),
            Means("40 s, assumed"),
            "Time from full ahead to full astern.",
            &["\"60 s\""],
        ),
        THRUST: TableOf<FileThrustKey> = key(
            "thrust",
            Kind::Table(&THRUST),
            Means("that of the series"),
            "Thrust coefficient in the first quadrant, K_T = k0 + k1 J + k2 J².",
            &[],
        ),
        SERIES: OneOf<Series> = key(
            "series",
            Kind::Choice(&SERIES),
            Means("B4-70 of pitch ratio 0.8; reports name it as an estimate"),
            "The series propeller for quadrants that `thrust` does not cover, and for torque.",
            &["\"B4-70 pitch 1.0\""],
        ),
        THRUST_DEDUCTION: Number = key(
            "thrust_deduction",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.5, high: 0.99 }),
            Means(ESTIMATED),
            "t_P, of thrust ahead.",
            &["0.22"],
        ),
        THRUST_DEDUCTION_ASTERN: Number = key(
            "thrust_deduction_astern",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.5, high: 0.99 }),
            Means(ESTIMATED),
            "t_P, thrust deduction of thrust astern.",
            &["0.3"],
        ),
        WAKE: Number = key(
            "wake",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.5, high: 0.99 }),
            Means(ESTIMATED),
            "w₀, effective wake fraction straight ahead.",
            &["0.35"],
        ),
        WAKE_CHANGE: TableOf<FileWakeChangeKey> = key(
            "wake_change",
            Kind::Table(&WAKE_CHANGE),
            Means("estimated if `wake` is estimated, otherwise none; reports name an estimate"),
            "How the wake changes in a turn.",
            &[],
        ),
        PLACE: Number = key(
            "place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "x'_P, place of the propeller over the length, forward of midship.",
            &["-0.48"],
        ),
    }
}

static THRUST: TableSpec = TableSpec {
    what: "a thrust coefficient",
    doc: "K_T = k0 + k1 J + k2 J².",
    keys: FileThrustKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a thrust coefficient.
    pub(crate) FileThrustKey {
        K0: Number = coefficient("k0", "At bollard."),
        K1: Number = coefficient("k1", "Over J."),
        K2: Number = coefficient("k2", "Over J²."),
    }
}

static SERIES: Choices<Series> = Choices(&[
    Choice {
        word: "B4-70 pitch 0.8",
        value: Series::B4Pitch08,
        doc: "Wageningen B4-70, pitch ratio 0.8",
    },
    Choice {
        word: "B4-70 pitch 1.0",
        value: Series::B4Pitch10,
        doc: "Wageningen B4-70, pitch ratio 1.0",
    },
]);

static WAKE_CHANGE: TableSpec = TableSpec {
    what: "a change of the wake",
    doc: "(1 − w)/(1 − w₀) = 1 + (1 − e^{−C₁|β_P|})(C₂ − 1), Yasukawa & Yoshimura (2015).",
    keys: FileWakeChangeKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a change of the wake.
    pub(crate) FileWakeChangeKey {
        C1: Number = key("c1", Kind::Quantity(POSITIVE), Refused, "C₁.", &["2.0"]),
        C2_BELOW: Number = key(
            "c2_below",
            Kind::Quantity(POSITIVE),
            Refused,
            "C₂ for β_P below 0.",
            &["1.1"],
        ),
        C2_ABOVE: Number = key(
            "c2_above",
            Kind::Quantity(POSITIVE),
            Refused,
            "C₂ for β_P above 0.",
            &["1.6"],
        ),
    }
}

pub(super) static RUDDER: TableSpec = TableSpec {
    what: "a rudder of a file",
    doc: "Rudder, its interaction with hull and propeller, and its steering gear.",
    keys: FileRudderKey::ALL,
    rules: Some(|| {
        json!({
            "allOf": [{ "oneOf": [{ "required": ["area"] }, { "required": ["area_ratio"] }] }],
            "oneOf": [
                { "required": ["span"], "properties": { "propeller_to_span": false, "aspect_ratio": false } },
                { "required": ["propeller_to_span"] }
            ]
        })
    }),
};

table_keys! {
    /// Keys of a rudder of a file.
    pub(crate) FileRudderKey {
        AREA: Number = key(
            "area",
            Kind::Quantity(Quantity { measure: &unit::AREA, low: 1e-6, high: 1e4 }),
            Unless("`area_ratio` is given"),
            "Movable area.",
            &["\"60 m^2\""],
        ),
        AREA_RATIO: Number = key(
            "area_ratio",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 1e3 }),
            Unless("`area` is given"),
            "Length times draught over the movable area.",
            &["54.86"],
        ),
        SPAN: Number = key(
            "span",
            Kind::Quantity(LENGTH),
            Unless("`propeller_to_span` and `aspect_ratio` are given"),
            "Span.",
            &["\"9 m\""],
        ),
        PROPELLER_TO_SPAN: Number = key(
            "propeller_to_span",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.01, high: 1.0 }),
            Unless("`span` is given"),
            "η: diameter of the propeller over span.",
            &["0.8"],
        ),
        ASPECT_RATIO: Number = key(
            "aspect_ratio",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.1, high: 20.0 }),
            Unless("`span` or `lift_gradient` is given"),
            "Λ: span² over area.",
            &["1.8"],
        ),
        LIFT_GRADIENT: Number = key(
            "lift_gradient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.01, high: 10.0 }),
            Means(ESTIMATED),
            "f_α.",
            &["2.747"],
        ),
        WAKE_RATIO: Number = key(
            "wake_ratio",
            Kind::Quantity(POSITIVE),
            Means(ESTIMATED),
            "ε: wake at the rudder over wake at the propeller.",
            &["1.09"],
        ),
        RACE_GAIN: Number = key(
            "race_gain",
            Kind::Quantity(POSITIVE),
            Means(ESTIMATED),
            "κ: share of the speed gain in the propeller race that reaches the rudder.",
            &["0.5"],
        ),
        STRAIGHTENING: TableOf<FileStraighteningKey> = key(
            "straightening",
            Kind::Table(&STRAIGHTENING),
            Means(ESTIMATED),
            "γ_R: flow straightening.",
            &[],
        ),
        STRAIGHTENING_PLACE: Number = key(
            "straightening_place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "l'_R: effective place of the rudder over the length.",
            &["-0.71"],
        ),
        RESISTANCE_DEDUCTION: Number = key(
            "resistance_deduction",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.99, high: 0.99 }),
            Means(ESTIMATED),
            "t_R.",
            &["0.387"],
        ),
        HULL_GAIN: Number = key(
            "hull_gain",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.99, high: 9.9 }),
            Means(ESTIMATED),
            "a_H: lateral force that steering induces on the hull, over the rudder force.",
            &["0.312"],
        ),
        HULL_PLACE: Number = key(
            "hull_place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "x'_H: place of the lateral force on the hull over the length.",
            &["-0.464"],
        ),
        PLACE: Number = key(
            "place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "x'_R: place of the rudder over the length.",
            &["-0.5"],
        ),
        RATE: Number = key(
            "rate",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: 1e-4, high: 10.0 }),
            Means(
                "by Froude's law from the vessel of `coefficients_of`; without `coefficients_of` \
                 2.32 deg/s, assumed",
            ),
            "Rate of the steering gear.",
            &["\"2.5 deg/s\""],
        ),
        STOP: Number = key(
            "stop",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: 0.01, high: 1.57 }),
            Means("35 deg, assumed"),
            "Largest rudder angle to either side.",
            &["\"35 deg\""],
        ),
    }
}

static STRAIGHTENING: TableSpec = TableSpec {
    what: "a flow straightening",
    doc: "γ_R by the side from which the water comes.",
    keys: FileStraighteningKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a flow straightening.
    pub(crate) FileStraighteningKey {
        BELOW: Number = key(
            "below",
            Kind::Quantity(POSITIVE),
            Refused,
            "For β_R below 0.",
            &["0.395"],
        ),
        ABOVE: Number = key(
            "above",
            Kind::Quantity(POSITIVE),
            Refused,
            "For β_R above 0.",
            &["0.64"],
        ),
    }
}
