//! Keys of the user's wind and current coefficients.

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
    "File of the table, in columns: `angle_deg` (or `angle_rad`), `cx`, `cy` and `cn` (or `cxy`); \
     in place of `cy` and `cn` the lateral coefficients at the fore and aft perpendicular, `cyf` \
     and `cya`. For current also `depth_ratio`, depth of water over draught. For several draughts \
     `draught_m`; the coefficients are interpolated linearly at the draught of the vessel. With \
     `quantity = \"forces\"` the columns are `x_kn`, `y_kn` and `n_knm`, or `yf_kn` and `ya_kn` \
     (also `_n`, `_nm`, `_tf`, `_tfm`). Cells are separated by commas, semicolons, tabs or blanks. \
     Angles over one side, from 0 to 180, are mirrored for the other.",
    &["\"wind.csv\""],
);
const COLUMNS: KeySpec = key(
    "columns",
    Kind::Texts,
    Means("the first line of the file names the columns"),
    "Names of the file's columns from left to right, for a file with other names or no names; `-` \
     for a column to skip.",
    &["[\"angle_deg\", \"cx\", \"cy\", \"cn\"]"],
);
const SKIP: KeySpec = key(
    "skip_lines",
    Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1000.0 }),
    Means("0"),
    "Number of lines at the top of the file to skip, such as titles; with `columns` count the \
     file's header line too.",
    &["2"],
);
const CONVENTION: KeySpec = key(
    "convention",
    Kind::Choice(&CONVENTIONS),
    Refused,
    "Convention for angles and signs of the table.",
    &["\"ocimf\""],
);
const ZERO: KeySpec = key(
    "angle_zero",
    Kind::Choice(&ZEROS),
    Means("that of `convention`"),
    "Direction from which the flow comes at angle 0; with `convention = \"own\"`.",
    &["\"ahead\""],
);
const SIDE: KeySpec = key(
    "angle_side",
    Kind::Choice(&SIDES),
    Means("that of `convention`"),
    "Direction from which the flow comes at an angle of 90 degrees; with `convention = \"own\"`.",
    &["\"from_starboard\""],
);
const SURGE: KeySpec = key(
    "surge_positive",
    Kind::Choice(&SURGES),
    Means("that of `convention`"),
    "Direction of a positive surge force; with `convention = \"own\"`.",
    &["\"forward\""],
);
const SWAY: KeySpec = key(
    "sway_positive",
    Kind::Choice(&SWAYS),
    Means("that of `convention`"),
    "Direction of a positive side force, also at the perpendiculars; with `convention = \"own\"`.",
    &["\"to_starboard\""],
);
const YAW: KeySpec = key(
    "yaw_positive",
    Kind::Choice(&YAWS),
    Means("that of `convention`"),
    "Direction of a positive yaw moment; with `convention = \"own\"`.",
    &["\"bow_to_port\""],
);
const SURGE_AREA: KeySpec = key(
    "surge_area",
    Kind::Quantity(AREA),
    Refused,
    "Reference area of `cx`: X = ½ρV² cx A. For wind usually the frontal area above the water; for \
     current OCIMF takes length times draught.",
    &["\"1130 m^2\""],
);
const SWAY_AREA: KeySpec = key(
    "sway_area",
    Kind::Quantity(AREA),
    Refused,
    "Reference area of `cy`, `cyf`, `cya` and `cn`: Y = ½ρV² cy A.",
    &["\"3690 m^2\""],
);
const YAW_LENGTH: KeySpec = key(
    "yaw_length",
    Kind::Quantity(LENGTH),
    Refused,
    "Reference length of `cn`: N = ½ρV² cn A L, with the area of `cy`. OCIMF takes the length between perpendiculars.",
    &["\"325 m\""],
);
const POINT: KeySpec = key(
    "moment_about",
    Kind::Quantity(PLACE),
    Is("0"),
    "Point to which the yaw moment refers, forward of midship.",
    &["\"-3.4 m\""],
);
const QUANTITY: KeySpec = key(
    "quantity",
    Kind::Choice(&QUANTITIES),
    Is("\"coefficients\""),
    "Kind of numbers in the columns. Forces are divided by ½ρV² with `at_speed` and `at_density`.",
    &["\"coefficients\""],
);
const AT_SPEED: KeySpec = key(
    "at_speed",
    Kind::Quantity(FLOW_SPEED),
    Means("`quantity` is not \"forces\""),
    "Speed of the flow to which the table's forces belong.",
    &["\"25 m/s\""],
);
const AT_DENSITY: KeySpec = key(
    "at_density",
    Kind::Quantity(Quantity { measure: &unit::DENSITY, low: 0.1, high: 2000.0 }),
    Means("`quantity` is not \"forces\""),
    "Density of the air or water to which the table's forces belong.",
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
    /// Keys of both tables of coefficients.
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
            "Height of the wind speed to which the coefficients refer.",
            &["\"10 m\""],
        ),
        CENTROID_HEIGHT: Number = key(
            "centroid_height",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1e-3, high: 200.0 }),
            Means(
                "the height of `windage`, or half of the mean height `sway_area` over \
                `yaw_length`",
            ),
            "Height above the water at which the wind force acts, for heel and trim.",
            &["\"12 m\""],
        ),
    }
}

static WIND_KEYS: [KeySpec; SHARED + WindCoefficientsKey::ALL.len()] =
    with_shared(WindCoefficientsKey::ALL);

/// The shared keys and further keys.
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
    doc: "Your current coefficients: the hull force at low speed through the water, in place of \
        the force of the manoeuvring model. The effect of the rate of turn still comes from the \
        model.",
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
            "Speed through the water up to which the table acts alone. The default is our choice.",
            &["\"5 kn\""],
        ),
        GONE_FROM: Number = key(
            "gone_from",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.1, high: 40.0 }),
            Is("\"8 kn\""),
            "Speed through the water from which the manoeuvring model acts alone; between the two \
             speeds, table and model are mixed without a jump. The default is our choice.",
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
/// Likewise of `quantity = "forces"`.
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

/// Angles and signs of a table; each is true if it agrees with this program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Convention {
    /// Angle 0: a flow from ahead.
    pub zero_is_ahead: bool,
    /// Angle 90 degrees: a flow from port.
    pub side_is_port: bool,
    /// X is positive forward.
    pub surge_forward: bool,
    /// Y is positive to starboard.
    pub sway_to_starboard: bool,
    /// N is positive with the bow to starboard.
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
        doc: "as in OCIMF's guidelines: 0 from astern, 90 from starboard, 180 from ahead; X positive forward, Y to port, N with the bow to \
              port (as users of the guidelines print them; the guidelines were not read)",
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
        doc: "ship's axes with relative bearings: 0 from ahead, 90 from starboard, 180 from astern; X positive forward, Y to starboard, N with the \
              bow to starboard",
    },
    Choice {
        word: "own",
        value: None,
        doc: "your convention, by the five keys `angle_zero` to `yaw_positive`",
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
    Choice { word: "bow_to_starboard", value: true, doc: "the bow goes to starboard" },
    Choice { word: "bow_to_port", value: false, doc: "the bow goes to port" },
]);

/// What a table's columns hold.
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
