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
            "Diameter of the propeller.",
            &["\"8.5 m\""],
        ),
        FULL: Number = key(
            "full",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: 1e-3, high: 1e3 }),
            Means(
                "the revolutions of the vessel `coefficients_of`, scaled by Froude's law; without \
                 `coefficients_of` the key is required",
            ),
            "Full revolutions of the propeller.",
            &["\"95 rpm\""],
        ),
        REVERSAL: Number = key(
            "reversal",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.1, high: 3600.0 }),
            Means("40 s, assumed"),
            "Time in which the shaft goes from full ahead to full astern.",
            &["\"60 s\""],
        ),
        THRUST: TableOf<FileThrustKey> = key(
            "thrust",
            Kind::Table(&THRUST),
            Means("the thrust coefficient of the series propeller"),
            "Thrust coefficient in the first quadrant, K_T = k0 + k1 J + k2 J².",
            &[],
        ),
        SERIES: OneOf<Series> = key(
            "series",
            Kind::Choice(&SERIES),
            Means("a B4-70 propeller of pitch ratio 0.8, which reports name as an estimate"),
            "The propeller of the Wageningen series that gives the thrust in quadrants that \
             `thrust` does not cover, and the torque.",
            &["\"B4-70 pitch 1.0\""],
        ),
        THRUST_DEDUCTION: Number = key(
            "thrust_deduction",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.5, high: 0.99 }),
            Means(ESTIMATED),
            "Thrust deduction t_P of thrust ahead.",
            &["0.22"],
        ),
        THRUST_DEDUCTION_ASTERN: Number = key(
            "thrust_deduction_astern",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.5, high: 0.99 }),
            Means(ESTIMATED),
            "Thrust deduction t_P of thrust astern.",
            &["0.3"],
        ),
        WAKE: Number = key(
            "wake",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.5, high: 0.99 }),
            Means(ESTIMATED),
            "Effective wake fraction w₀ straight ahead.",
            &["0.35"],
        ),
        WAKE_CHANGE: TableOf<FileWakeChangeKey> = key(
            "wake_change",
            Kind::Table(&WAKE_CHANGE),
            Means("the change of the wake is estimated if `wake` is estimated, and reports name it \
                   as an estimate; otherwise the wake does not change"),
            "How the wake at the propeller changes in a turn.",
            &[],
        ),
        PLACE: Number = key(
            "place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "Place x'_P of the propeller forward of midship, divided by the ship's length.",
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
        K0: Number = coefficient("k0", "Coefficient k0: K_T at zero speed."),
        K1: Number = coefficient("k1", "Coefficient k1 of J in K_T."),
        K2: Number = coefficient("k2", "Coefficient k2 of J² in K_T."),
    }
}

static SERIES: Choices<Series> = Choices(&[
    Choice {
        word: "B4-70 pitch 0.8",
        value: Series::B4Pitch08,
        doc: "Wageningen B4-70 propeller of pitch ratio 0.8",
    },
    Choice {
        word: "B4-70 pitch 1.0",
        value: Series::B4Pitch10,
        doc: "Wageningen B4-70 propeller of pitch ratio 1.0",
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
            "Constant C₂ for an inflow angle β_P below 0.",
            &["1.1"],
        ),
        C2_ABOVE: Number = key(
            "c2_above",
            Kind::Quantity(POSITIVE),
            Refused,
            "Constant C₂ for an inflow angle β_P above 0.",
            &["1.6"],
        ),
    }
}

pub(super) static RUDDER: TableSpec = TableSpec {
    what: "a rudder of a file",
    doc: "A rudder, its interaction with hull and propeller, and the steering gear.",
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
            "Movable area of the rudder.",
            &["\"60 m^2\""],
        ),
        AREA_RATIO: Number = key(
            "area_ratio",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 1e3 }),
            Unless("`area` is given"),
            "Length of the ship times her draught, divided by the movable area of the rudder.",
            &["54.86"],
        ),
        SPAN: Number = key(
            "span",
            Kind::Quantity(LENGTH),
            Unless("`propeller_to_span` and `aspect_ratio` are given"),
            "Span of the rudder.",
            &["\"9 m\""],
        ),
        PROPELLER_TO_SPAN: Number = key(
            "propeller_to_span",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.01, high: 1.0 }),
            Unless("`span` is given"),
            "Ratio η of the propeller's diameter to the span of the rudder.",
            &["0.8"],
        ),
        ASPECT_RATIO: Number = key(
            "aspect_ratio",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.1, high: 20.0 }),
            Unless("`span` or `lift_gradient` is given"),
            "Aspect ratio Λ of the rudder: square of the span divided by the area.",
            &["1.8"],
        ),
        LIFT_GRADIENT: Number = key(
            "lift_gradient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.01, high: 10.0 }),
            Means(ESTIMATED),
            "Lift gradient f_α of the rudder.",
            &["2.747"],
        ),
        WAKE_RATIO: Number = key(
            "wake_ratio",
            Kind::Quantity(POSITIVE),
            Means(ESTIMATED),
            "Wake ratio ε: ratio of the wake at the rudder to the wake at the propeller.",
            &["1.09"],
        ),
        RACE_GAIN: Number = key(
            "race_gain",
            Kind::Quantity(POSITIVE),
            Means(ESTIMATED),
            "Race gain κ: share of the speed gain in the propeller race that reaches the rudder.",
            &["0.5"],
        ),
        STRAIGHTENING: TableOf<FileStraighteningKey> = key(
            "straightening",
            Kind::Table(&STRAIGHTENING),
            Means(ESTIMATED),
            "Flow straightening γ_R at the rudder.",
            &[],
        ),
        STRAIGHTENING_PLACE: Number = key(
            "straightening_place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "Effective place l'_R of the rudder for the flow straightening, divided by the ship's \
             length.",
            &["-0.71"],
        ),
        RESISTANCE_DEDUCTION: Number = key(
            "resistance_deduction",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.99, high: 0.99 }),
            Means(ESTIMATED),
            "Resistance deduction t_R of the rudder.",
            &["0.387"],
        ),
        HULL_GAIN: Number = key(
            "hull_gain",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.99, high: 9.9 }),
            Means(ESTIMATED),
            "Factor a_H: lateral force that steering induces on the hull, divided by the rudder \
             force.",
            &["0.312"],
        ),
        HULL_PLACE: Number = key(
            "hull_place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "Place x'_H of the lateral force that steering induces on the hull, divided by the \
             ship's length.",
            &["-0.464"],
        ),
        PLACE: Number = key(
            "place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "Place x'_R of the rudder, divided by the ship's length.",
            &["-0.5"],
        ),
        RATE: Number = key(
            "rate",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: 1e-4, high: 10.0 }),
            Means(
                "the rudder rate of the vessel `coefficients_of`, scaled by Froude's law; without \
                 `coefficients_of` an assumed 2.32 deg/s",
            ),
            "Rate at which the steering gear turns the rudder.",
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
    doc: "Flow straightening γ_R for water from either side.",
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
            "Flow straightening γ_R for an inflow angle β_R below 0.",
            &["0.395"],
        ),
        ABOVE: Number = key(
            "above",
            Kind::Quantity(POSITIVE),
            Refused,
            "Flow straightening γ_R for an inflow angle β_R above 0.",
            &["0.64"],
        ),
    }
}
