//! Keys of a vessel's wind areas and of the method that computes wind forces from them.

use serde_json::{Value as Json, json};

use super::quantities::{LENGTH, PLACE};

use crate::choices::{Choice, Choices};
use crate::held::{Number, OneOf, Text};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::typed_key::AnyKey;
use crate::units::measures as unit;
use crate::{any_keys, table_keys};

const AREA: Quantity = Quantity { measure: &unit::AREA, low: 1e-4, high: 1e6 };

/// Areas above the water.
pub static WINDAGE: TableSpec = TableSpec {
    what: "a windage",
    doc: "Wind areas of a vessel, and the method that computes wind forces from the areas.",
    keys: WindageKey::ALL,
    rules: Some(|| {
        let with = |method: WindageMethod| {
            let foreign = METHODS.0.iter().filter(|other| other.value != method);
            let refused: serde_json::Map<String, Json> = foreign
                .flat_map(|other| other.value.keys())
                .map(|key| (key.name().to_owned(), json!(false)))
                .collect();
            let needed: Vec<&str> = method.keys().iter().map(|key| key.name()).collect();
            json!({ "required": needed, "properties": refused })
        };
        let others = METHODS.0.iter().rev().filter(|other| other.value != DEFAULT_METHOD);
        others.fold(with(DEFAULT_METHOD), |otherwise, method| {
            json!({
                "if": {
                    "properties": { "method": { "const": method.word } }, "required": ["method"]
                },
                "then": with(method.value),
                "else": otherwise
            })
        })
    }),
};

table_keys! {
    /// Keys of a windage.
    pub WindageKey {
        METHOD: OneOf<WindageMethod> = key(
            "method",
            Kind::Choice(&METHODS),
            Is("\"blendermann\""),
            "Method that gives the wind coefficients. Each method for the wind coefficients needs \
             other particulars of the ship.",
            &["\"blendermann\""],
        ),
        FRONTAL_AREA: Number = key(
            "frontal_area",
            Kind::Quantity(AREA),
            Refused,
            "Frontal area of the ship above the water, seen from ahead.",
            &["\"1700 m^2\""],
        ),
        LATERAL_AREA: Number = key(
            "lateral_area",
            Kind::Quantity(AREA),
            Refused,
            "Lateral area of the ship above the water, seen from the side.",
            &["\"9000 m^2\""],
        ),
        LENGTH_OVERALL: Number = key(
            "length_overall",
            Kind::Quantity(LENGTH),
            Means("the length between perpendiculars"),
            "Length overall of the ship, to which the wind coefficients refer.",
            &["\"298 m\""],
        ),
        CENTROID_FORWARD: Number = key(
            "centroid_forward",
            Kind::Quantity(PLACE),
            Is("0"),
            "Distance of the centroid of the lateral area forward of midship.",
            &["\"-5 m\""],
        ),
        CENTROID_HEIGHT: Number = key(
            "centroid_height",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1e-3, high: 200.0 }),
            Refused,
            "Height of the centroid of the lateral area above the water.",
            &["\"16 m\""],
        ),
        TYPE: Text = key(
            "type",
            Kind::Text,
            Means("`method` does not need this key"),
            "For Blendermann's method: type of ship in Blendermann's table.",
            &["\"container ship, loaded\""],
        ),
        PERIMETER: Number = key(
            "perimeter",
            Kind::Quantity(LENGTH),
            Means("`method` does not need this key"),
            "For Isherwood's method: length of the side view's outline, from the waterline at the \
             bow over hull and superstructure to the waterline at the stern, without masts and \
             ventilators.",
            &["\"700 m\""],
        ),
        SUPERSTRUCTURE_AREA: Number = key(
            "superstructure_area",
            Kind::Quantity(Quantity { measure: &unit::AREA, low: 0.0, high: 1e6 }),
            Means("`method` does not need this key"),
            "For Isherwood's method: area of the superstructure seen from the side, which is a \
             part of `lateral_area`.",
            &["\"1500 m^2\""],
        ),
        MAST_GROUPS: Number = key(
            "mast_groups",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 50.0 }),
            Means("`method` does not need this key"),
            "For Isherwood's method: number of groups of masts or king posts seen from the side.",
            &["1"],
        ),
        DECK_AREA: Number = key(
            "deck_area",
            Kind::Quantity(AREA),
            Means("`method` does not need this key"),
            "For Fujiwara's method: area of superstructures, tanks and containers on deck seen \
             from the side, which is a part of `lateral_area`.",
            &["\"1500 m^2\""],
        ),
        DECK_CENTROID_FORWARD: Number = key(
            "deck_centroid_forward",
            Kind::Quantity(PLACE),
            Means("`method` does not need this key"),
            "For Fujiwara's method: distance of the centroid of `deck_area` forward of midship.",
            &["\"0 m\""],
        ),
        TOP_HEIGHT: Number = key(
            "top_height",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1e-3, high: 300.0 }),
            Means("`method` does not need this key"),
            "For Fujiwara's method: height of the top of the superstructure above the water.",
            &["\"45 m\""],
        ),
    }
}

/// How wind forces are computed from a vessel's wind areas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WindageMethod {
    /// By Blendermann.
    Blendermann,
    /// By Isherwood.
    Isherwood,
    /// By Fujiwara.
    Fujiwara,
}

/// The method for wind forces if the file names no method.
const DEFAULT_METHOD: WindageMethod = WindageMethod::Blendermann;

impl WindageMethod {
    /// The keys of a windage that this method needs and that no other method may have.
    pub fn keys(self) -> &'static [AnyKey<WindageKey>] {
        match self {
            WindageMethod::Blendermann => any_keys![WindageKey: TYPE],
            WindageMethod::Isherwood => {
                any_keys![WindageKey: PERIMETER, SUPERSTRUCTURE_AREA, MAST_GROUPS]
            }
            WindageMethod::Fujiwara => {
                any_keys![WindageKey: DECK_AREA, DECK_CENTROID_FORWARD, TOP_HEIGHT]
            }
        }
    }
}

/// The methods.
pub static METHODS: Choices<WindageMethod> = Choices(&[
    Choice {
        word: "blendermann",
        value: WindageMethod::Blendermann,
        doc: "Blendermann 1994: the wind forces follow from four parameters of a type of ship; we \
              read formulas and table in a public toolbox, not in the paper",
    },
    Choice {
        word: "isherwood",
        value: WindageMethod::Isherwood,
        doc: "Isherwood 1972: a regression over merchant ships; we read its tables in a public \
              toolbox, not in the paper",
    },
    Choice {
        word: "fujiwara",
        value: WindageMethod::Fujiwara,
        doc: "Fujiwara, Ueno & Nimura 1998: a regression over ships with a superstructure; we read \
              the coefficients in a public code, not in the paper, and found no printed result for \
              comparison",
    },
]);
