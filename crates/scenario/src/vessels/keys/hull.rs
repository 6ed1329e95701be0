//! Keys of the hull's coefficients: added mass, and forces under way and at low speed.

use serde_json::json;

use super::shared::{COEFFICIENT, POSITIVE, coefficients};
use fenderline_keys::spec::Absent::Unless;
use fenderline_keys::spec::{Kind, Quantity, TableSpec, key};
use fenderline_keys::units::measures as unit;

pub(super) static ADDED_MASS: TableSpec = TableSpec {
    what: "an added mass of a file",
    doc: "Added mass about midship: as coefficients over ½ρL²d and ½ρL⁴d, or over the density of the water.",
    keys: &[
        key(
            "surge",
            Kind::Quantity(POSITIVE),
            Unless("`surge_volume` is given"),
            "m'x, over ½ρL²d.",
            &["0.022"],
        ),
        key(
            "sway",
            Kind::Quantity(POSITIVE),
            Unless("`sway_volume` is given"),
            "m'y, over ½ρL²d.",
            &["0.223"],
        ),
        key(
            "yaw",
            Kind::Quantity(POSITIVE),
            Unless("another key gives it"),
            "J'z, over ½ρL⁴d.",
            &["0.011"],
        ),
        key(
            "yaw_with_ship",
            Kind::Quantity(POSITIVE),
            Unless("another key gives it"),
            "I'z + J'z, over ½ρL⁴d: the ship's own inertia is subtracted.",
            &["0.0286"],
        ),
        key(
            "surge_volume",
            Kind::Quantity(Quantity { measure: &unit::VOLUME, low: 1e-9, high: 1e8 }),
            Unless("`surge` is given"),
            "m_x/ρ.",
            &["\"1790.85 m^3\""],
        ),
        key(
            "sway_volume",
            Kind::Quantity(Quantity { measure: &unit::VOLUME, low: 1e-9, high: 1e8 }),
            Unless("`sway` is given"),
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
            Unless("another key gives it"),
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

pub(super) static SWAY_POLYNOMIAL: TableSpec = TableSpec {
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

pub(super) static DRIFT_POLYNOMIAL: TableSpec = TableSpec {
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

pub(super) static LOW_SPEED: TableSpec = TableSpec {
    what: "a hull at low speed",
    doc: "The form of Yoshimura, Nakao & Ishibashi (2009), over ½ρLdU².",
    keys: coefficients! {
        "ahead": "X'₀F, resistance ahead, negative.",
        "astern": "X'₀A, resistance astern, negative.",
        "x_vr": "X'vr.", "y_v": "Y'v.", "y_r": "Y'r.", "n_v": "N'v.", "n_r": "N'r.",
        "drag": "C_D of the cross flow.",
        "yaw_gain_force": "CrY: factor on the yaw rate in the cross-flow force.",
        "yaw_gain_moment": "CrN: factor on the yaw rate in the cross-flow moment.",
    },
    rules: None,
};
