//! Keys of the hull's coefficients: added mass, and forces under way and at low speed.

use serde_json::json;

use super::shared::{POSITIVE, coefficient};
use fenderline_keys::held::Number;
use fenderline_keys::spec::Absent::Unless;
use fenderline_keys::spec::{Kind, Quantity, TableSpec, key};
use fenderline_keys::table_keys;
use fenderline_keys::units::measures as unit;

pub(super) static ADDED_MASS: TableSpec = TableSpec {
    what: "an added mass of a file",
    doc: "Added mass relative to midship, given either as coefficients, which are divided by ½ρL²d \
          and ½ρL⁴d, or divided by the density of the water.",
    keys: FileAddedMassKey::ALL,
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

table_keys! {
    /// Keys of an added mass of a file.
    pub(crate) FileAddedMassKey {
        SURGE: Number = key(
            "surge",
            Kind::Quantity(POSITIVE),
            Unless("`surge_volume` is given"),
            "Added mass coefficient m'x in surge: added mass divided by ½ρL²d.",
            &["0.022"],
        ),
        SWAY: Number = key(
            "sway",
            Kind::Quantity(POSITIVE),
            Unless("`sway_volume` is given"),
            "Added mass coefficient m'y in sway: added mass divided by ½ρL²d.",
            &["0.223"],
        ),
        YAW: Number = key(
            "yaw",
            Kind::Quantity(POSITIVE),
            Unless("another key gives it"),
            "Added inertia coefficient J'z in yaw: added moment of inertia divided by ½ρL⁴d.",
            &["0.011"],
        ),
        YAW_WITH_SHIP: Number = key(
            "yaw_with_ship",
            Kind::Quantity(POSITIVE),
            Unless("another key gives it"),
            "Sum I'z + J'z of the ship's own and the added moment of inertia in yaw, divided by \
             ½ρL⁴d; the program subtracts the ship's own inertia.",
            &["0.0286"],
        ),
        SURGE_VOLUME: Number = key(
            "surge_volume",
            Kind::Quantity(Quantity { measure: &unit::VOLUME, low: 1e-9, high: 1e8 }),
            Unless("`surge` is given"),
            "Added mass in surge divided by the density of the water, m_x/ρ.",
            &["\"1790.85 m^3\""],
        ),
        SWAY_VOLUME: Number = key(
            "sway_volume",
            Kind::Quantity(Quantity { measure: &unit::VOLUME, low: 1e-9, high: 1e8 }),
            Unless("`sway` is given"),
            "Added mass in sway divided by the density of the water, m_y/ρ.",
            &["\"44324 m^3\""],
        ),
        YAW_VOLUME: Number = key(
            "yaw_volume",
            Kind::Quantity(Quantity {
                measure: &unit::INERTIA_OVER_DENSITY,
                low: 1e-9,
                high: 1e15,
            }),
            Unless("another key gives it"),
            "Added moment of inertia in yaw divided by the density of the water, J_z/ρ.",
            &["\"140067300 m^5\""],
        ),
    }
}

pub(super) static SWAY_POLYNOMIAL: TableSpec = TableSpec {
    what: "a hull polynomial over v'",
    doc: "A polynomial for the hull forces in the form of Yasukawa & Yoshimura (2015).",
    keys: FileSwayPolynomialKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a hull polynomial over v'.
    pub(crate) FileSwayPolynomialKey {
        RESISTANCE: Number = coefficient("resistance", "R'₀, positive."),
        X_VV: Number = coefficient("x_vv", "X'vv."),
        X_VR: Number = coefficient("x_vr", "X'vr."),
        X_RR: Number = coefficient("x_rr", "X'rr."),
        X_VVVV: Number = coefficient("x_vvvv", "X'vvvv."),
        Y_V: Number = coefficient("y_v", "Y'v."),
        Y_R: Number = coefficient("y_r", "Y'r."),
        Y_VVV: Number = coefficient("y_vvv", "Y'vvv."),
        Y_VVR: Number = coefficient("y_vvr", "Y'vvr."),
        Y_VRR: Number = coefficient("y_vrr", "Y'vrr."),
        Y_RRR: Number = coefficient("y_rrr", "Y'rrr."),
        N_V: Number = coefficient("n_v", "N'v."),
        N_R: Number = coefficient("n_r", "N'r."),
        N_VVV: Number = coefficient("n_vvv", "N'vvv."),
        N_VVR: Number = coefficient("n_vvr", "N'vvr."),
        N_VRR: Number = coefficient("n_vrr", "N'vrr."),
        N_RRR: Number = coefficient("n_rrr", "N'rrr."),
    }
}

pub(super) static DRIFT_POLYNOMIAL: TableSpec = TableSpec {
    what: "a hull polynomial over β",
    doc: "A polynomial for the hull forces in the form of Yoshimura & Masumoto (2012).",
    keys: FileDriftPolynomialKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a hull polynomial over β.
    pub(crate) FileDriftPolynomialKey {
        X_0: Number = coefficient("x_0", "X'₀, negative."),
        X_BB: Number = coefficient("x_bb", "X'ββ."),
        X_BR: Number = coefficient("x_br", "X'βr, −m'y within."),
        X_RR: Number = coefficient("x_rr", "X'rr."),
        X_BBBB: Number = coefficient("x_bbbb", "X'ββββ."),
        Y_B: Number = coefficient("y_b", "Y'β."),
        Y_R: Number = coefficient("y_r", "Y'r, −m'x within."),
        Y_BBB: Number = coefficient("y_bbb", "Y'βββ."),
        Y_BBR: Number = coefficient("y_bbr", "Y'ββr."),
        Y_BRR: Number = coefficient("y_brr", "Y'βrr."),
        Y_RRR: Number = coefficient("y_rrr", "Y'rrr."),
        N_B: Number = coefficient("n_b", "N'β."),
        N_R: Number = coefficient("n_r", "N'r."),
        N_BBB: Number = coefficient("n_bbb", "N'βββ."),
        N_BBR: Number = coefficient("n_bbr", "N'ββr."),
        N_BRR: Number = coefficient("n_brr", "N'βrr."),
        N_RRR: Number = coefficient("n_rrr", "N'rrr."),
    }
}

pub(super) static LOW_SPEED: TableSpec = TableSpec {
    what: "a hull at low speed",
    doc: "Hull forces at low speed in the form of Yoshimura, Nakao & Ishibashi (2009), divided by \
          ½ρLdU².",
    keys: FileLowSpeedKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a hull at low speed.
    pub(crate) FileLowSpeedKey {
        AHEAD: Number = coefficient("ahead", "X'₀F, resistance ahead, negative."),
        ASTERN: Number = coefficient("astern", "X'₀A, resistance astern, negative."),
        X_VR: Number = coefficient("x_vr", "X'vr."),
        Y_V: Number = coefficient("y_v", "Y'v."),
        Y_R: Number = coefficient("y_r", "Y'r."),
        N_V: Number = coefficient("n_v", "N'v."),
        N_R: Number = coefficient("n_r", "N'r."),
        DRAG: Number = coefficient("drag", "Drag coefficient C_D of the cross flow."),
        YAW_GAIN_FORCE: Number = coefficient(
            "yaw_gain_force",
            "Factor CrY on the yaw rate in the cross-flow force.",
        ),
        YAW_GAIN_MOMENT: Number = coefficient(
            "yaw_gain_moment",
            "Factor CrN on the yaw rate in the cross-flow moment.",
        ),
    }
}
