//! Every key of a vessel file, as [`crate::keys`] says those of a scenario.

use fenderline_sim::hydro::Series;
use serde_json::json;

use super::shape::OutlineOrigin;
use crate::choices::{Choice, Choices};
use crate::keys::{AZIMUTH, FORWARD_M, LENGTH_M, STABILITY, STANDINGS, THRUSTER, WINDAGE, key};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec};
use crate::units::measures as unit;

const COEFFICIENT: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: -1e3, high: 1e3 };
const POSITIVE: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 1e-6, high: 1e3 };
const ESTIMATED: &str = "estimated, and said so";

/// The whole file.
pub(crate) static VESSEL_FILE: TableSpec = TableSpec {
    what: "a vessel file",
    doc: "Vessels: particulars, outline, coefficients, propellers, rudders, thrusters, wind areas, stability, \
          chocks, bitts and belting, each number with its source and standing. A plain number is in SI units \
          (angles in radians); a string carries its unit, as \"3 m\".",
    keys: &[key("vessel", Kind::Named(&VESSEL), Refused, "Vessels, by name.", &[])],
    rules: None,
};

static VESSEL: TableSpec = TableSpec {
    what: "a vessel of a file",
    doc: "A vessel. What is not given is estimated where the method needs it, and told to be an estimate.",
    keys: &[
        key("title", Kind::Text, Refused, "Her name in reports.", &["\"KCS, 230 m\""]),
        key(
            "tank_model",
            Kind::Flag,
            Is("false"),
            "A model in a tank: her manoeuvres are in fresh water, and IMO's limits are not for her.",
            &["true"],
        ),
        key(
            "coefficients_of",
            Kind::Text,
            Means("her own, or estimated"),
            "Another vessel, of which she is a model or a sister: coefficients that are not given here are those of \
             that vessel; speed, revolutions and rudder rate follow by Froude's law.",
            &["\"kvlcc2\""],
        ),
        key(
            "length_bp",
            Kind::Quantity(LENGTH_M),
            Refused,
            "Length between perpendiculars.",
            &["\"285 m\""],
        ),
        key(
            "length_overall",
            Kind::Quantity(LENGTH_M),
            Means("not known"),
            "Length overall; the outline must have it.",
            &["\"298 m\""],
        ),
        key("beam", Kind::Quantity(LENGTH_M), Refused, "Beam.", &["\"46 m\""]),
        key("draught", Kind::Quantity(LENGTH_M), Refused, "Draught.", &["\"9 m\""]),
        key(
            "volume",
            Kind::Quantity(Quantity { measure: &unit::VOLUME, low: 1e-6, high: 1e8 }),
            Means("another key says it"),
            "Displaced volume.",
            &["\"312600 m^3\""],
        ),
        key(
            "displacement",
            Kind::Quantity(Quantity { measure: &unit::MASS, low: 1e-3, high: 1e11 }),
            Means("another key says it"),
            "Displacement in sea water of 1025 kg/m³.",
            &["\"87800 t\""],
        ),
        key(
            "block_coefficient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.1, high: 1.0 }),
            Means("another key says it"),
            "Volume over length between perpendiculars, beam and draught.",
            &["0.71"],
        ),
        key(
            "mass_coefficient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1e-3, high: 10.0 }),
            Means("another key says it"),
            "m': mass over ½ρL²d.",
            &["0.2708"],
        ),
        key(
            "centre_of_gravity",
            Kind::Quantity(FORWARD_M),
            Means("amidships, assumed"),
            "Centre of gravity forward of midship.",
            &["\"-3.4 m\""],
        ),
        key(
            "gyradius",
            Kind::Quantity(LENGTH_M),
            Means("a quarter of the length, assumed"),
            "Radius of gyration in yaw about the centre of gravity, without added mass.",
            &["\"72 m\""],
        ),
        key(
            "resistance_of_model",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 100.0 }),
            Means("her resistance is her own, or nobody said"),
            "Length of the model whose resistance she has: its friction is over a ship's share, and crash stops are \
             shown without it too.",
            &["\"7 m\""],
        ),
        key(
            "speed",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.01, high: 50.0 }),
            Means("not known"),
            "Speed at which standard manoeuvres begin.",
            &["\"15.5 kn\""],
        ),
        key(
            "froude",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1e-3, high: 1.0 }),
            Means("`speed` says it"),
            "The same as a Froude number, with g = 9.81 m/s².",
            &["0.26"],
        ),
        key("added_mass", Kind::Table(&ADDED_MASS), Means(ESTIMATED), "Added mass.", &[]),
        key(
            "sway_polynomial",
            Kind::Table(&SWAY_POLYNOMIAL),
            Means("none"),
            "Hull under way over v' and r', by ½ρLdU².",
            &[],
        ),
        key(
            "drift_polynomial",
            Kind::Table(&DRIFT_POLYNOMIAL),
            Means("none"),
            "Hull under way over β and r', by ½ρLdU²; x_br holds −m'y and y_r holds −m'x.",
            &[],
        ),
        key(
            "low_speed",
            Kind::Table(&LOW_SPEED),
            Means(ESTIMATED),
            "Hull at low speed, astern and crabbing.",
            &[],
        ),
        key("propeller", Kind::Table(&PROPELLER), Means("none"), "Propeller and shaft.", &[]),
        key("rudder", Kind::Table(&RUDDER), Means("none"), "Rudder and steering gear.", &[]),
        key("thruster", Kind::Named(&THRUSTER), Is("{}"), "Tunnel thrusters, by name.", &[]),
        key(
            "azimuth",
            Kind::Named(&AZIMUTH),
            Is("{}"),
            "Azimuth units, by name. A vessel without a propeller goes and steers with them.",
            &[],
        ),
        key(
            "windage",
            Kind::Table(&WINDAGE),
            Means("the wind does not move her"),
            "Wind areas.",
            &[],
        ),
        key(
            "stability",
            Kind::Table(&STABILITY),
            Means("she neither heaves nor rolls nor pitches"),
            "What heave, roll and pitch need.",
            &[],
        ),
        key(
            "outline",
            Kind::Table(&OUTLINE),
            Means("bodies give it"),
            "Her outline in the horizontal plane.",
            &[],
        ),
        key(
            "chock",
            Kind::Named(&DECK_POINT),
            Is("{}"),
            "Chocks and fairleads, by name: where lines leave her.",
            &[],
        ),
        key(
            "bitts",
            Kind::Named(&DECK_POINT),
            Is("{}"),
            "Bitts, by name: where lines of others are made fast.",
            &[],
        ),
        key(
            "belting",
            Kind::Named(&BELTING),
            Is("{}"),
            "Straight strips of belting or bow fendering, by name: a fender of a scenario may lie on one.",
            &[],
        ),
        key(
            "source",
            Kind::List(&SOURCE),
            Refused,
            "Where the numbers come from: every number has one source.",
            &[],
        ),
    ],
    rules: Some(|| {
        let one_of = ["volume", "displacement", "block_coefficient", "mass_coefficient"];
        let one_of: Vec<_> = one_of.iter().map(|key| json!({ "required": [key] })).collect();
        json!({
            "oneOf": one_of,
            "not": { "anyOf": [
                { "required": ["speed", "froude"] },
                { "required": ["sway_polynomial", "drift_polynomial"] }
            ] },
            "dependentRequired": { "propeller": ["rudder"], "rudder": ["propeller"] }
        })
    }),
};

static ADDED_MASS: TableSpec = TableSpec {
    what: "an added mass of a file",
    doc: "Added mass about midship: as coefficients over ½ρL²d and ½ρL⁴d, or over the density of the water.",
    keys: &[
        key(
            "surge",
            Kind::Quantity(POSITIVE),
            Means("`surge_volume` says it"),
            "m'x, over ½ρL²d.",
            &["0.022"],
        ),
        key(
            "sway",
            Kind::Quantity(POSITIVE),
            Means("`sway_volume` says it"),
            "m'y, over ½ρL²d.",
            &["0.223"],
        ),
        key(
            "yaw",
            Kind::Quantity(POSITIVE),
            Means("another key says it"),
            "J'z, over ½ρL⁴d.",
            &["0.011"],
        ),
        key(
            "yaw_with_ship",
            Kind::Quantity(POSITIVE),
            Means("another key says it"),
            "I'z + J'z, over ½ρL⁴d: the ship's own inertia is taken off.",
            &["0.0286"],
        ),
        key(
            "surge_volume",
            Kind::Quantity(Quantity { measure: &unit::VOLUME, low: 1e-9, high: 1e8 }),
            Means("`surge` says it"),
            "m_x/ρ.",
            &["\"1790.85 m^3\""],
        ),
        key(
            "sway_volume",
            Kind::Quantity(Quantity { measure: &unit::VOLUME, low: 1e-9, high: 1e8 }),
            Means("`sway` says it"),
            "m_y/ρ.",
            &["\"44324 m^3\""],
        ),
        key(
            "yaw_volume",
            Kind::Quantity(Quantity {
                measure: &unit::INERTIA_OVER_DENSITY,
                low: 1e-9,
                high: 1e15,
            }),
            Means("another key says it"),
            "J_z/ρ.",
            &["\"140067300 m^5\""],
        ),
    ],
    rules: Some(|| {
        json!({ "oneOf": [
            {
                "required": ["surge", "sway"],
                "oneOf": [{ "required": ["yaw"] }, { "required": ["yaw_with_ship"] }],
                "properties": { "surge_volume": false, "sway_volume": false, "yaw_volume": false }
            },
            {
                "required": ["surge_volume", "sway_volume", "yaw_volume"],
                "properties": {
                    "surge": false, "sway": false, "yaw": false, "yaw_with_ship": false
                }
            }
        ] })
    }),
};

macro_rules! coefficients {
    ($($name:literal: $doc:literal),* $(,)?) => {
        &[$(key($name, Kind::Quantity(COEFFICIENT), Refused, $doc, &["-0.04"])),*]
    };
}

static SWAY_POLYNOMIAL: TableSpec = TableSpec {
    what: "a hull polynomial over v'",
    doc: "The form of Yasukawa & Yoshimura (2015).",
    keys: coefficients! {
        "resistance": "R'₀, positive.",
        "x_vv": "X'vv.", "x_vr": "X'vr.", "x_rr": "X'rr.", "x_vvvv": "X'vvvv.",
        "y_v": "Y'v.", "y_r": "Y'r.", "y_vvv": "Y'vvv.", "y_vvr": "Y'vvr.", "y_vrr": "Y'vrr.",
        "y_rrr": "Y'rrr.",
        "n_v": "N'v.", "n_r": "N'r.", "n_vvv": "N'vvv.", "n_vvr": "N'vvr.", "n_vrr": "N'vrr.",
        "n_rrr": "N'rrr.",
    },
    rules: None,
};

static DRIFT_POLYNOMIAL: TableSpec = TableSpec {
    what: "a hull polynomial over β",
    doc: "The form of Yoshimura & Masumoto (2012).",
    keys: coefficients! {
        "x_0": "X'₀, negative.",
        "x_bb": "X'ββ.", "x_br": "X'βr, −m'y within.", "x_rr": "X'rr.", "x_bbbb": "X'ββββ.",
        "y_b": "Y'β.", "y_r": "Y'r, −m'x within.", "y_bbb": "Y'βββ.", "y_bbr": "Y'ββr.",
        "y_brr": "Y'βrr.", "y_rrr": "Y'rrr.",
        "n_b": "N'β.", "n_r": "N'r.", "n_bbb": "N'βββ.", "n_bbr": "N'ββr.", "n_brr": "N'βrr.",
        "n_rrr": "N'rrr.",
    },
    rules: None,
};

static LOW_SPEED: TableSpec = TableSpec {
    what: "a hull at low speed",
    doc: "The form of Yoshimura, Nakao & Ishibashi (2009), over ½ρLdU².",
    keys: coefficients! {
        "ahead": "X'₀F, resistance ahead, negative.",
        "astern": "X'₀A, resistance astern, negative.",
        "x_vr": "X'vr.", "y_v": "Y'v.", "y_r": "Y'r.", "n_v": "N'v.", "n_r": "N'r.",
        "drag": "C_D of the cross flow.",
        "yaw_gain_force": "CrY: what the yaw rate is multiplied with in the cross-flow force.",
        "yaw_gain_moment": "CrN: the same in its moment.",
    },
    rules: None,
};

static PROPELLER: TableSpec = TableSpec {
    what: "a propeller of a file",
    doc: "Propeller, wake and shaft.",
    keys: &[
        key("diameter", Kind::Quantity(LENGTH_M), Refused, "Diameter.", &["\"8.5 m\""]),
        key(
            "full",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: 1e-3, high: 1e3 }),
            Means("by Froude's law from the vessel of `coefficients_of`; needed without it"),
            "Full revolutions.",
            &["\"95 rpm\""],
        ),
        key(
            "reversal",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.1, high: 3600.0 }),
            Means("40 s, assumed"),
            "Time from full ahead to full astern.",
            &["\"60 s\""],
        ),
        key(
            "thrust",
            Kind::Table(&THRUST),
            Means("that of the series"),
            "Thrust coefficient in the first quadrant, K_T = k0 + k1 J + k2 J².",
            &[],
        ),
        key(
            "series",
            Kind::Choice(&SERIES),
            Means("B4-70 of pitch 0.8, and said so"),
            "The series propeller for what `thrust` does not cover, and for torque.",
            &["\"B4-70 pitch 1.0\""],
        ),
        key(
            "thrust_deduction",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.5, high: 0.99 }),
            Means(ESTIMATED),
            "t_P, of thrust ahead.",
            &["0.22"],
        ),
        key(
            "thrust_deduction_astern",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.5, high: 0.99 }),
            Means(ESTIMATED),
            "t_P, of thrust astern.",
            &["0.3"],
        ),
        key(
            "wake",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.5, high: 0.99 }),
            Means(ESTIMATED),
            "w₀, effective wake fraction straight ahead.",
            &["0.35"],
        ),
        key(
            "wake_change",
            Kind::Table(&WAKE_CHANGE),
            Means("estimated where `wake` is, else none; said so"),
            "How the wake changes in a turn.",
            &[],
        ),
        key(
            "place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "x'_P, place of the propeller over the length, forward of midship.",
            &["-0.48"],
        ),
    ],
    rules: None,
};

static THRUST: TableSpec = TableSpec {
    what: "a thrust coefficient",
    doc: "K_T = k0 + k1 J + k2 J².",
    keys: coefficients! { "k0": "At bollard.", "k1": "Over J.", "k2": "Over J²." },
    rules: None,
};

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
    keys: &[
        key("c1", Kind::Quantity(POSITIVE), Refused, "C₁.", &["2.0"]),
        key("c2_below", Kind::Quantity(POSITIVE), Refused, "C₂ for β_P below 0.", &["1.1"]),
        key("c2_above", Kind::Quantity(POSITIVE), Refused, "C₂ for β_P above 0.", &["1.6"]),
    ],
    rules: None,
};

static RUDDER: TableSpec = TableSpec {
    what: "a rudder of a file",
    doc: "Rudder, what hull and propeller make of it, and its steering gear.",
    keys: &[
        key(
            "area",
            Kind::Quantity(Quantity { measure: &unit::AREA, low: 1e-6, high: 1e4 }),
            Means("`area_ratio` says it"),
            "Movable area.",
            &["\"60 m^2\""],
        ),
        key(
            "area_ratio",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 1e3 }),
            Means("`area` says it"),
            "Length times draught over the movable area.",
            &["54.86"],
        ),
        key(
            "span",
            Kind::Quantity(LENGTH_M),
            Means("`propeller_to_span` and `aspect_ratio` say it"),
            "Span.",
            &["\"9 m\""],
        ),
        key(
            "propeller_to_span",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.01, high: 1.0 }),
            Means("`span` says it"),
            "η: diameter of the propeller over span.",
            &["0.8"],
        ),
        key(
            "aspect_ratio",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.1, high: 20.0 }),
            Means("`span` says it, or `lift_gradient` is given"),
            "Λ: span² over area.",
            &["1.8"],
        ),
        key(
            "lift_gradient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.01, high: 10.0 }),
            Means(ESTIMATED),
            "f_α.",
            &["2.747"],
        ),
        key(
            "wake_ratio",
            Kind::Quantity(POSITIVE),
            Means(ESTIMATED),
            "ε: wake at the rudder over wake at the propeller.",
            &["1.09"],
        ),
        key(
            "race_gain",
            Kind::Quantity(POSITIVE),
            Means(ESTIMATED),
            "κ: how much of the race's speed reaches the rudder.",
            &["0.5"],
        ),
        key(
            "straightening",
            Kind::Table(&STRAIGHTENING),
            Means(ESTIMATED),
            "γ_R: flow straightening.",
            &[],
        ),
        key(
            "straightening_place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "l'_R: effective place of the rudder over the length.",
            &["-0.71"],
        ),
        key(
            "resistance_deduction",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.99, high: 0.99 }),
            Means(ESTIMATED),
            "t_R.",
            &["0.387"],
        ),
        key(
            "hull_gain",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.99, high: 9.9 }),
            Means(ESTIMATED),
            "a_H: force that steering puts on the hull, over the rudder's own.",
            &["0.312"],
        ),
        key(
            "hull_place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "x'_H: place of that force over the length.",
            &["-0.464"],
        ),
        key(
            "place",
            Kind::Quantity(COEFFICIENT),
            Means(ESTIMATED),
            "x'_R: place of the rudder over the length.",
            &["-0.5"],
        ),
        key(
            "rate",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: 1e-4, high: 10.0 }),
            Means(
                "by Froude's law from the vessel of `coefficients_of`; without it 2.32 deg/s, assumed",
            ),
            "Rate of the steering gear.",
            &["\"2.5 deg/s\""],
        ),
        key(
            "stop",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: 0.01, high: 1.57 }),
            Means("35 deg, assumed"),
            "Its stop to either side.",
            &["\"35 deg\""],
        ),
    ],
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

static STRAIGHTENING: TableSpec = TableSpec {
    what: "a flow straightening",
    doc: "γ_R by the side from which the water comes.",
    keys: &[
        key("below", Kind::Quantity(POSITIVE), Refused, "For β_R below 0.", &["0.395"]),
        key("above", Kind::Quantity(POSITIVE), Refused, "For β_R above 0.", &["0.64"]),
    ],
    rules: None,
};

static OUTLINE: TableSpec = TableSpec {
    what: "an outline of a file",
    doc: "A vessel's outline in the horizontal plane.",
    keys: &[
        key(
            "origin",
            Kind::Choice(&ORIGINS),
            Refused,
            "From where its points are counted.",
            &["\"midship\""],
        ),
        key(
            "points",
            Kind::Outline(FORWARD_M),
            Refused,
            "Vertices, forward and to starboard, in either direction round; need not be convex.",
            &["[[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]"],
        ),
    ],
    rules: None,
};

static ORIGINS: Choices<OutlineOrigin> = Choices(&[
    Choice {
        word: "midship",
        value: OutlineOrigin::Midship,
        doc: "half the length between perpendiculars, on the centre line",
    },
    Choice {
        word: "after perpendicular",
        value: OutlineOrigin::AfterPerpendicular,
        doc: "the after perpendicular, on the centre line",
    },
    Choice {
        word: "centre of gravity",
        value: OutlineOrigin::CentreOfGravity,
        doc: "the centre of gravity",
    },
]);

static DECK_POINT: TableSpec = TableSpec {
    what: "a point on deck",
    doc: "Where a line meets the vessel.",
    keys: &[
        key(
            "at",
            Kind::Point(FORWARD_M),
            Refused,
            "Forward and starboard of midship.",
            &["[140, 5]"],
        ),
        key(
            "height",
            Kind::Quantity(FORWARD_M),
            Refused,
            "Above the still water at her draught.",
            &["\"12 m\""],
        ),
    ],
    rules: None,
};

static BELTING: TableSpec = TableSpec {
    what: "a belting",
    doc: "A straight strip along her side or her bow, facing away from midship.",
    keys: &[
        key(
            "from",
            Kind::Point(FORWARD_M),
            Refused,
            "One end: forward and starboard of midship.",
            &["[16, -4]"],
        ),
        key(
            "to",
            Kind::Point(FORWARD_M),
            Refused,
            "The other end: forward and starboard of midship.",
            &["[16, 4]"],
        ),
        key(
            "height",
            Kind::Quantity(FORWARD_M),
            Refused,
            "Its middle above the still water at her draught.",
            &["\"2 m\""],
        ),
        key("extent", Kind::Quantity(LENGTH_M), Refused, "Its extent up and down.", &["\"1.5 m\""]),
    ],
    rules: None,
};

static SOURCE: TableSpec = TableSpec {
    what: "a source",
    doc: "Where some of a vessel's numbers come from.",
    keys: &[
        key(
            "of",
            Kind::Texts,
            Refused,
            "Keys of the vessel, as `beam`, `propeller` or `propeller.wake`: a table stands for all in it that no \
             other source names more closely.",
            &["[\"length_bp\", \"beam\", \"rudder\"]"],
        ),
        key(
            "source",
            Kind::Text,
            Refused,
            "Where the numbers come from.",
            &["\"the trials report, table 2\""],
        ),
        key(
            "standing",
            Kind::Choice(&STANDINGS),
            Refused,
            "How well the source is known.",
            &["\"found\""],
        ),
    ],
    rules: None,
};
