//! Keys of tables with the user's own wind and current coefficients.

use serde_json::{Value as Json, json};

use super::quantities::{LENGTH, PLACE};
use crate::choices::{Choice, Choices};
use crate::held::{Number, OneOf, Text, Texts};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec, key};
use crate::typed_key::{AnyKey, ReadAs};
use crate::units::measures as unit;
use crate::{any_keys, table_keys};

const AREA: Quantity = Quantity { measure: &unit::AREA, low: 1e-4, high: 1e6 };
const FLOW_SPEED: Quantity = Quantity { measure: &unit::SPEED, low: 0.01, high: 200.0 };

const FILE: KeySpec = key(
    "file",
    Kind::FileName,
    Refused,
    "File of the table with the columns `angle_deg` (or `angle_rad`), `cx`, `cy` and `cn` (or \
     `cxy`). The lateral coefficients `cyf` and `cya` at the fore and aft perpendicular may stand \
     in place of `cy` and `cn`. A table for current may have a column `depth_ratio`, the depth of \
     water divided by the draught. A column `draught_m` gives coefficients for several draughts; \
     they are interpolated linearly at the draught of the vessel. With `quantity = \"forces\"` the \
     columns are `x_kn`, `y_kn` and `n_knm`, or `yf_kn` and `ya_kn` (also `_n`, `_nm`, `_tf`, \
     `_tfm`). Cells are separated by commas, semicolons, tabs or blanks. If the angles cover only \
     one side of the ship, from 0 to 180, the table is mirrored for the other side.",
    &["\"wind.csv\""],
);
const COLUMNS: KeySpec = key(
    "columns",
    Kind::Texts,
    Means("the first line of the file names the columns"),
    "Names of the file's columns from left to right, for a file whose first line has other names \
     or no names; `-` marks a column to skip.",
    &["[\"angle_deg\", \"cx\", \"cy\", \"cn\"]"],
);
const SKIP: KeySpec = key(
    "skip_lines",
    Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1000.0 }),
    Means("0"),
    "Number of lines to skip at the top of the file, such as titles; if `columns` is given, the \
     header line of the file counts as a line to skip.",
    &["2"],
);
const CONVENTION: KeySpec = key(
    "convention",
    Kind::Choice(&CONVENTIONS),
    Refused,
    "Convention for the angles and signs in the table.",
    &["\"ocimf\""],
);
const ZERO: KeySpec = key(
    "angle_zero",
    Kind::Choice(&ZEROS),
    Means("`convention` gives the direction"),
    "With `convention = \"own\"`: direction from which wind or current comes at angle 0.",
    &["\"ahead\""],
);
const SIDE: KeySpec = key(
    "angle_side",
    Kind::Choice(&SIDES),
    Means("`convention` gives the direction"),
    "With `convention = \"own\"`: direction from which wind or current comes at an angle of 90 \
     degrees.",
    &["\"from_starboard\""],
);
const SURGE: KeySpec = key(
    "surge_positive",
    Kind::Choice(&SURGES),
    Means("`convention` gives the direction"),
    "With `convention = \"own\"`: direction of a positive surge force in the table.",
    &["\"forward\""],
);
const SWAY: KeySpec = key(
    "sway_positive",
    Kind::Choice(&SWAYS),
    Means("`convention` gives the direction"),
    "With `convention = \"own\"`: direction of a positive side force in the table, also of the \
     side forces at the perpendiculars.",
    &["\"to_starboard\""],
);
const YAW: KeySpec = key(
    "yaw_positive",
    Kind::Choice(&YAWS),
    Means("`convention` gives the direction"),
    "With `convention = \"own\"`: direction of a positive yaw moment in the table.",
    &["\"bow_to_port\""],
);
const SURGE_AREA: KeySpec = key(
    "surge_area",
    Kind::Quantity(AREA),
    Refused,
    "Reference area A of `cx`: X = ½ρV² cx A. For wind this is usually the frontal area above the \
     water; for current OCIMF takes length times draught.",
    &["\"1130 m^2\""],
);
const SWAY_AREA: KeySpec = key(
    "sway_area",
    Kind::Quantity(AREA),
    Refused,
    "Reference area A of `cy`, `cyf`, `cya` and `cn`: Y = ½ρV² cy A.",
    &["\"3690 m^2\""],
);
const YAW_LENGTH: KeySpec = key(
    "yaw_length",
    Kind::Quantity(LENGTH),
    Refused,
    "Reference length L of `cn`: N = ½ρV² cn A L, where A is the reference area of `cy`. OCIMF \
     takes the length between perpendiculars as reference length.",
    &["\"325 m\""],
);
const POINT: KeySpec = key(
    "moment_about",
    Kind::Quantity(PLACE),
    Is("0"),
    "Distance forward of midship of the point to which the yaw moments of the table refer.",
    &["\"-3.4 m\""],
);
const QUANTITY: KeySpec = key(
    "quantity",
    Kind::Choice(&QUANTITIES),
    Is("\"coefficients\""),
    "Kind of numbers in the columns of the table: coefficients or forces. If the columns hold \
     forces, the program divides them by ½ρV², with the speed `at_speed` and the density \
     `at_density`.",
    &["\"coefficients\""],
);
const AT_SPEED: KeySpec = key(
    "at_speed",
    Kind::Quantity(FLOW_SPEED),
    Means("`quantity` is not \"forces\""),
    "Speed of wind or current for which the table gives forces.",
    &["\"25 m/s\""],
);
const AT_DENSITY: KeySpec = key(
    "at_density",
    Kind::Quantity(Quantity { measure: &unit::DENSITY, low: 0.1, high: 2000.0 }),
    Means("`quantity` is not \"forces\""),
    "Density of the air or water for which the table gives forces.",
    &["\"1.28 kg/m^3\""],
);
const SOURCE: KeySpec = key(
    "source",
    Kind::Text,
    Refused,
    "Source of the table, in your words; the report shows it.",
    &["\"wind tunnel, report 12-345, model 1:250\""],
);

pub(super) static WIND_COEFFICIENTS: TableSpec = TableSpec {
    what: "a table of wind coefficients",
    doc: "Your wind coefficients, in place of the coefficients of `windage`.",
    keys: &WIND_KEYS,
    rules: Some(rules),
};

table_keys! {
    /// Keys that a table of wind coefficients and a table of current coefficients share.
    pub CoefficientsKey {
        FILE: Text = FILE,
        COLUMNS: Texts = COLUMNS,
        SKIP_LINES: Number = SKIP,
        CONVENTION: OneOf<Option<Convention>> = CONVENTION,
        ANGLE_ZERO: OneOf<bool> = ZERO,
        ANGLE_SIDE: OneOf<bool> = SIDE,
        SURGE_POSITIVE: OneOf<bool> = SURGE,
        SWAY_POSITIVE: OneOf<bool> = SWAY,
        YAW_POSITIVE: OneOf<bool> = YAW,
        SURGE_AREA: Number = SURGE_AREA,
        SWAY_AREA: Number = SWAY_AREA,
        YAW_LENGTH: Number = YAW_LENGTH,
        MOMENT_ABOUT: Number = POINT,
        QUANTITY: OneOf<Held> = QUANTITY,
        AT_SPEED: Number = AT_SPEED,
        AT_DENSITY: Number = AT_DENSITY,
        SOURCE: Text = SOURCE,
    }
}

table_keys! {
    /// Further keys of a table of wind coefficients.
    pub WindCoefficientsKey of &WIND_KEYS; {
        REFERENCE_HEIGHT: Number = key(
            "reference_height",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 300.0 }),
            Is("10"),
            "Height above the water of the wind speed to which the coefficients refer.",
            &["\"10 m\""],
        ),
        CENTROID_HEIGHT: Number = key(
            "centroid_height",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1e-3, high: 200.0 }),
            Means(
                "the height of `windage`, or half of the mean height of the lateral area, which is \
                 `sway_area` divided by `yaw_length`",
            ),
            "Height above the water at which the wind force acts; heel and trim follow from this \
             height.",
            &["\"12 m\""],
        ),
    }
}

static WIND_KEYS: [KeySpec; SHARED + WindCoefficientsKey::ALL.len()] =
    with_shared(WindCoefficientsKey::ALL);

/// The keys that both tables of coefficients share, followed by the further keys of one table.
const fn with_shared<const COUNT: usize>(further: &[KeySpec]) -> [KeySpec; COUNT] {
    let mut keys = [FILE; COUNT];
    let mut index = 0;
    while index < COUNT {
        keys[index] =
            if index < SHARED { CoefficientsKey::ALL[index] } else { further[index - SHARED] };
        index += 1;
    }
    keys
}

const SHARED: usize = CoefficientsKey::ALL.len();

impl ReadAs<CoefficientsKey> for WindCoefficientsKey {}
impl ReadAs<CoefficientsKey> for CurrentCoefficientsKey {}

pub(super) static CURRENT_COEFFICIENTS: TableSpec = TableSpec {
    what: "a table of current coefficients",
    doc: "Your current coefficients: they give the hull force at low speed through the water, in \
        place of the manoeuvring model. The hull force from the rate of turn still comes from the \
        manoeuvring model.",
    keys: &CURRENT_KEYS,
    rules: Some(rules),
};

table_keys! {
    /// Further keys of a table of current coefficients.
    pub CurrentCoefficientsKey of &CURRENT_KEYS; {
        ALONE_UNTIL: Number = key(
            "alone_until",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.0, high: 20.0 }),
            Is("\"5 kn\""),
            "Speed through the water up to which the table alone gives the hull force. The default \
             of 5 kn is our choice.",
            &["\"5 kn\""],
        ),
        GONE_FROM: Number = key(
            "gone_from",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.1, high: 40.0 }),
            Is("\"8 kn\""),
            "Speed through the water from which the manoeuvring model alone gives the hull force; \
             between `alone_until` and this speed, the force passes without a jump from the table \
             to the model. The default of 8 kn is our choice.",
            &["\"8 kn\""],
        ),
    }
}

static CURRENT_KEYS: [KeySpec; SHARED + CurrentCoefficientsKey::ALL.len()] =
    with_shared(CurrentCoefficientsKey::ALL);

/// The keys that `convention = "own"` needs and that no other convention may have.
pub const OF_OWN: &[AnyKey<CoefficientsKey>] = any_keys![
    CoefficientsKey: ANGLE_ZERO, ANGLE_SIDE, SURGE_POSITIVE, SWAY_POSITIVE, YAW_POSITIVE
];
/// The keys that `quantity = "forces"` needs and that a table of coefficients may not have.
pub const OF_FORCES: &[AnyKey<CoefficientsKey>] = any_keys![CoefficientsKey: AT_SPEED, AT_DENSITY];

fn rules() -> Json {
    let with = |key: &str, word: &str, keys: &[AnyKey<CoefficientsKey>]| {
        let names: Vec<&str> = keys.iter().map(|key| key.name()).collect();
        let refused: serde_json::Map<String, Json> =
            names.iter().map(|name| ((*name).to_owned(), json!(false))).collect();
        json!({
            "if": { "properties": { key: { "const": word } }, "required": [key] },
            "then": { "required": names },
            "else": { "properties": refused }
        })
    };
    json!({ "allOf": [with("convention", "own", OF_OWN), with("quantity", "forces", OF_FORCES)] })
}

/// Angles and signs in a table of coefficients; each field is true if the table agrees with the program's own
/// convention.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Convention {
    /// True if angle 0 means wind or current from ahead.
    pub zero_is_ahead: bool,
    /// True if angle 90 degrees means wind or current from port.
    pub side_is_port: bool,
    /// True if the surge force X is positive forward.
    pub surge_forward: bool,
    /// True if the side force Y is positive to starboard.
    pub sway_to_starboard: bool,
    /// True if the yaw moment N is positive when it turns the bow to starboard.
    pub yaw_to_starboard: bool,
}

static CONVENTIONS: Choices<Option<Convention>> = Choices(&[
    Choice {
        word: "ocimf",
        value: Some(Convention {
            zero_is_ahead: false,
            side_is_port: false,
            surge_forward: true,
            sway_to_starboard: false,
            yaw_to_starboard: false,
        }),
        doc: "the convention of OCIMF's guidelines: angle 0 is from astern, 90 from starboard, 180 \
              from ahead; X is positive forward, Y to port, N with the bow to port (as users of \
              the guidelines print it; we have not read the guidelines)",
    },
    Choice {
        word: "ship",
        value: Some(Convention {
            zero_is_ahead: true,
            side_is_port: false,
            surge_forward: true,
            sway_to_starboard: true,
            yaw_to_starboard: true,
        }),
        doc: "the ship's axes with relative bearings: angle 0 is from ahead, 90 from starboard, \
              180 from astern; X is positive forward, Y to starboard, N with the bow to starboard",
    },
    Choice {
        word: "own",
        value: None,
        doc: "your own convention, which the five keys `angle_zero`, `angle_side`, \
              `surge_positive`, `sway_positive` and `yaw_positive` describe",
    },
]);

static ZEROS: Choices<bool> = Choices(&[
    Choice { word: "ahead", value: true, doc: "from ahead" },
    Choice { word: "astern", value: false, doc: "from astern" },
]);

static SIDES: Choices<bool> = Choices(&[
    Choice { word: "from_port", value: true, doc: "from port" },
    Choice { word: "from_starboard", value: false, doc: "from starboard" },
]);

static SURGES: Choices<bool> = Choices(&[
    Choice { word: "forward", value: true, doc: "forward" },
    Choice { word: "aft", value: false, doc: "aft" },
]);

static SWAYS: Choices<bool> = Choices(&[
    Choice { word: "to_starboard", value: true, doc: "to starboard" },
    Choice { word: "to_port", value: false, doc: "to port" },
]);

static YAWS: Choices<bool> = Choices(&[
    Choice {
        word: "bow_to_starboard",
        value: true,
        doc: "a positive moment turns the bow to starboard",
    },
    Choice { word: "bow_to_port", value: false, doc: "a positive moment turns the bow to port" },
]);

/// What the columns of a table hold: coefficients or forces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// Coefficients.
    Coefficients,
    /// Forces and moments.
    Forces,
}

static QUANTITIES: Choices<Held> = Choices(&[
    Choice { word: "coefficients", value: Held::Coefficients, doc: "coefficients" },
    Choice { word: "forces", value: Held::Forces, doc: "forces and moments at one speed" },
]);
