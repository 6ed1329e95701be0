//! Declares every key of a fender file, in the same way as [`fenderline_keys::keys`] declares the keys of a scenario.

use core::f64::consts::FRAC_PI_2;

use serde_json::json;

use fenderline_keys::held::{Curve, ListOf, NamedOf, Number, OneOf, TableOf, Text};
use fenderline_keys::keys::STANDINGS;
use fenderline_keys::keys::quantities::RETURNED_ENERGY;
use fenderline_keys::spec::Absent::{Is, Means, Refused, Unless};
use fenderline_keys::spec::{CurveSpec, KeySpec, Kind, Quantity, TableSpec, key};
use fenderline_keys::units::measures as unit;
use fenderline_keys::{shared_keys, table_keys};
use fenderline_sim::hydro::vessels::Standing;

/// The whole file.
pub(crate) static FENDER_FILE: TableSpec = TableSpec {
    what: "a fender file",
    doc: "A fender file has families of fenders with their performance curves and sizes, and hull \
          pressure limits. A plain number is in SI units (angles in radians); a number with \
          another unit is a string, as \"3 m\".",
    keys: FenderFileKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a fender file.
    pub(crate) FenderFileKey {
        FAMILY: NamedOf<FamilyKey> = key(
            "family",
            Kind::Named(&FAMILY),
            Is("{}"),
            "Families of fenders, by name.",
            &[],
        ),
        HULL_PRESSURE: NamedOf<HullPressureKey> = key(
            "hull_pressure",
            Kind::Named(&HULL_PRESSURE),
            Is("{}"),
            "Hull pressure that a ship's side can bear, by type of ship.",
            &[],
        ),
    }
}

const SOURCE: KeySpec = key(
    "source",
    Kind::Text,
    Refused,
    "Source of the numbers.",
    &["\"the maker's catalogue of 2021, page 12\""],
);

const STANDING: KeySpec = key(
    "standing",
    Kind::Choice(&STANDINGS),
    Refused,
    "How well the source of the numbers is known.",
    &["\"found\""],
);

static FAMILY: TableSpec = TableSpec {
    what: "a family of fenders",
    doc: "A family of fenders of one shape: sizes, and a curve that all sizes share. A table with \
          the name of a known family of fenders may only add sizes to this family.",
    keys: FamilyKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a family of fenders.
    pub(crate) FamilyKey {
        RATED_DEFLECTION: Number = key(
            "rated_deflection",
            Kind::Quantity(OF_HEIGHT),
            Means("the family is known already"),
            "Rated deflection divided by the height of the fender.",
            &["0.72"],
        ),
        REFERENCE: Text = key(
            "reference",
            Kind::Text,
            Means("no sizes are scaled from another size"),
            "Designation of the size from which other sizes are scaled; the reaction scales with \
             the square of the height.",
            &["\"1000 A\""],
        ),
        CURVE: TableOf<CurveKey> = key(
            "curve",
            Kind::Table(&CURVE),
            Means("the family is known already"),
            "Performance curve: normalised reaction by normalised deflection.",
            &[],
        ),
        UNLOADING: TableOf<UnloadingKey> = key(
            "unloading",
            Kind::Table(&UNLOADING),
            Means("the fenders return 55 % of the energy, which is assumed for solid rubber"),
            "Law by which the fender's reaction falls in unloading.",
            &[],
        ),
        TEMPERATURE: TableOf<TemperatureKey> = key(
            "temperature",
            Kind::Table(&TEMPERATURE),
            Means("no correction"),
            "Factors on the reaction by temperature.",
            &[],
        ),
        VELOCITY: TableOf<VelocityKey> = key(
            "velocity",
            Kind::Table(&VELOCITY),
            Means("no correction"),
            "Factors on the reaction by the time to the rated deflection.",
            &[],
        ),
        ANGLE_ENERGY: TableOf<AngleKey> = key(
            "angle_energy",
            Kind::Table(&ANGLE),
            Means("no correction"),
            "Factors on the energy by the angle of compression.",
            &[],
        ),
        ANGLE_REACTION: TableOf<AngleKey> = key(
            "angle_reaction",
            Kind::Table(&ANGLE),
            Means("no correction"),
            "Factors on the reaction by the angle of compression.",
            &[],
        ),
        TOLERANCE: TableOf<ToleranceKey> = key(
            "tolerance",
            Kind::Table(&TOLERANCE),
            Means("the tolerance is not known"),
            "Manufacturing tolerance of reaction and energy.",
            &[],
        ),
        SIZE: ListOf<SizeKey> = key(
            "size",
            Kind::List(&SIZE),
            Is("[]"),
            "Sizes of the family, each with its rated reaction.",
            &[],
        ),
    }
}

const OF_HEIGHT: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1.0 };
const OF_RATED: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 100.0 };
const FACTOR: (&str, Quantity) =
    ("factor", Quantity { measure: &unit::PLAIN_NUMBER, low: 0.01, high: 100.0 });

static CURVE: TableSpec = TableSpec {
    what: "a performance curve",
    doc: "A performance curve: normalised reaction by normalised deflection.",
    keys: CurveKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a performance curve.
    pub(crate) CurveKey {
        POINTS: Curve = key(
            "points",
            Kind::Curve(&CurveSpec {
                from: ("deflection", OF_HEIGHT),
                to: ("reaction", OF_RATED),
                fewest: 2,
            }),
            Refused,
            "Rows of the curve, joined by straight lines: deflection divided by the height, and \
             reaction divided by the rated reaction. The rows go from [0, 0] to the rated \
             deflection or beyond.",
            &["[[0, 0], [0.25, 0.9], [0.5, 1]]"],
        ),
        PUBLISHED_ENERGY: Curve = key(
            "published_energy",
            Kind::Curve(&CurveSpec {
                from: ("deflection", OF_HEIGHT),
                to: ("energy", OF_RATED),
                fewest: 2,
            }),
            Means("none was published"),
            "Rows of the published energy curve: deflection divided by the height, and energy \
             divided by the rated energy. The curve is for comparison only, because the program \
             integrates the reaction.",
            &["[[0, 0], [0.25, 0.4], [0.5, 1]]"],
        ),
        SOURCE: Text = SOURCE,
        STANDING: OneOf<Standing> = STANDING,
    }
}

static UNLOADING: TableSpec = TableSpec {
    what: "an unloading law",
    doc: "Law by which the reaction falls in unloading, given by `returned_energy` or `points`.",
    keys: UnloadingKey::ALL,
    rules: Some(|| {
        json!({
            "oneOf": [{ "required": ["returned_energy"] }, { "required": ["points"] }]
        })
    }),
};

table_keys! {
    /// Keys of an unloading law.
    pub(crate) UnloadingKey {
        RETURNED_ENERGY: Number = key(
            "returned_energy",
            Kind::Quantity(RETURNED_ENERGY),
            Unless("`points` is given"),
            "Share of the absorbed energy that unloading from any deflection returns.",
            &["\"55 %\""],
        ),
        POINTS: Curve = key(
            "points",
            Kind::Curve(&CurveSpec {
                from: ("deflection", OF_HEIGHT),
                to: ("reaction", OF_RATED),
                fewest: 2,
            }),
            Unless("`returned_energy` is given"),
            "Rows of the unloading curve, joined by straight lines: deflection divided by the \
             height, and reaction divided by the rated reaction. The rows begin at [0, 0], and the \
             unloading curve may nowhere lie above the loading curve. Beyond its last row the \
             unloading curve keeps the share of the loading curve that it has at the last row.",
            &["[[0, 0], [0.25, 0.4], [0.5, 0.9]]"],
        ),
        SOURCE: Text = SOURCE,
        STANDING: OneOf<Standing> = STANDING,
    }
}

const HOLDS: KeySpec = key(
    "holds",
    Kind::Text,
    Means("the factors hold for all fenders of the family"),
    "Conditions for which the factors hold.",
    &["\"blended rubber\""],
);

static TEMPERATURE_POINTS: CurveSpec = CurveSpec {
    from: ("temperature", Quantity { measure: &unit::PLAIN_NUMBER, low: -100.0, high: 150.0 }),
    to: FACTOR,
    fewest: 1,
};

static VELOCITY_POINTS: CurveSpec = CurveSpec {
    from: ("time", Quantity { measure: &unit::TIME, low: 0.0, high: 1e6 }),
    to: FACTOR,
    fewest: 1,
};

static ANGLE_POINTS: CurveSpec = CurveSpec {
    from: ("angle", Quantity { measure: &unit::ANGLE, low: 0.0, high: FRAC_PI_2 }),
    to: FACTOR,
    fewest: 1,
};

static TEMPERATURE: TableSpec = TableSpec {
    what: "a temperature table",
    doc: "Factors on the reaction of a fender by temperature.",
    keys: TemperatureKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a temperature table.
    pub(crate) TemperatureKey {
        POINTS: Curve = key(
            "points",
            Kind::Curve(&TEMPERATURE_POINTS),
            Refused,
            "Rows of the table: temperature as a plain number in degrees Celsius, and factor on \
             the reaction.",
            &["[[-10, 1.13], [23, 1], [50, 0.916]]"],
        ),
        HOLDS: Text = HOLDS,
        SOURCE: Text = SOURCE,
        STANDING: OneOf<Standing> = STANDING,
    }
}

static VELOCITY: TableSpec = TableSpec {
    what: "a velocity table",
    doc: "Factors on the reaction of a fender by the time to the rated deflection.",
    keys: VelocityKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a velocity table.
    pub(crate) VelocityKey {
        POINTS: Curve = key(
            "points",
            Kind::Curve(&VELOCITY_POINTS),
            Refused,
            "Rows of the table: time to the rated deflection, and factor on the reaction.",
            &["[[\"1 s\", 1.2], [\"20 s\", 1.03]]"],
        ),
        HOLDS: Text = HOLDS,
        SOURCE: Text = SOURCE,
        STANDING: OneOf<Standing> = STANDING,
    }
}

static ANGLE: TableSpec = TableSpec {
    what: "an angle table",
    doc: "Factors on energy or reaction of a fender by the angle of compression.",
    keys: AngleKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of an angle table.
    pub(crate) AngleKey {
        POINTS: Curve = key(
            "points",
            Kind::Curve(&ANGLE_POINTS),
            Refused,
            "Rows of the table: angle between hull and panel, and factor on energy or reaction.",
            &["[[\"0 deg\", 1], [\"20 deg\", 0.739]]"],
        ),
        HOLDS: Text = HOLDS,
        SOURCE: Text = SOURCE,
        STANDING: OneOf<Standing> = STANDING,
    }
}

static TOLERANCE: TableSpec = TableSpec {
    what: "a tolerance",
    doc: "Manufacturing tolerance of a fender's reaction and energy.",
    keys: ToleranceKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a tolerance.
    pub(crate) ToleranceKey {
        VALUE: Number = key(
            "value",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 0.9 }),
            Refused,
            "Manufacturing tolerance to either side.",
            &["\"10 %\""],
        ),
        SOURCE: Text = SOURCE,
        STANDING: OneOf<Standing> = STANDING,
    }
}

const METRES: Quantity = Quantity { measure: &unit::LENGTH, low: 1e-3, high: 100.0 };

static SIZE: TableSpec = TableSpec {
    what: "a size",
    doc: "One size of a family of fenders, as in a catalogue.",
    keys: SizeKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a size.
    pub(crate) SizeKey {
        DESIGNATION: Text = key(
            "designation",
            Kind::Text,
            Refused,
            "Name of the size within the family.",
            &["\"1000x1500 50kPa\""],
        ),
        HEIGHT: Number = key(
            "height",
            Kind::Quantity(METRES),
            Refused,
            "Extent of the fender in the direction of compression: its height or its diameter.",
            &["\"1000 mm\""],
        ),
        LENGTH: Number = key(
            "length",
            Kind::Quantity(METRES),
            Means("no pressure"),
            "Length of the fender along the berth.",
            &["\"1500 mm\""],
        ),
        REACTION: Number = key(
            "reaction",
            Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e9 }),
            Refused,
            "Rated reaction of the fender.",
            &["\"182 kN\""],
        ),
        PUBLISHED_ENERGY: Number = key(
            "published_energy",
            Kind::Quantity(Quantity { measure: &unit::MOMENT, low: 1.0, high: 1e10 }),
            Means("none was published"),
            "Published rated energy, for comparison only.",
            &["\"32 kJ\""],
        ),
        HULL_PRESSURE: Number = key(
            "hull_pressure",
            Kind::Quantity(PRESSURE),
            Means("the panel sets the pressure"),
            "Pressure of the fender on the hull at the rated deflection.",
            &["\"122 kPa\""],
        ),
        INITIAL_PRESSURE: Number = key(
            "initial_pressure",
            Kind::Quantity(PRESSURE),
            Means("pressures below the rated deflection are not known"),
            "Inner pressure of a pneumatic fender at zero deflection.",
            &["\"50 kPa\""],
        ),
        SOURCE: Text = SOURCE,
        STANDING: OneOf<Standing> = STANDING,
    }
}

const PRESSURE: Quantity = Quantity { measure: &unit::STIFFNESS_PER_AREA, low: 1.0, high: 1e9 };

static HULL_PRESSURE: TableSpec = TableSpec {
    what: "a hull pressure limit",
    doc: "Hull pressure that the side of a type of ship can bear.",
    keys: HullPressureKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a hull pressure limit.
    pub(crate) HullPressureKey {
        LIMIT: Number = key(
            "limit",
            Kind::Quantity(PRESSURE),
            Refused,
            "Greatest mean pressure under a fender panel that the ship's side can bear.",
            &["\"150 kN/m^2\""],
        ),
        SOURCE: Text = SOURCE,
        STANDING: OneOf<Standing> = STANDING,
    }
}

shared_keys! {
    /// Keys that say where a number comes from.
    pub(crate) OriginKey of CurveKey and UnloadingKey and TemperatureKey and VelocityKey and AngleKey
        and ToleranceKey and SizeKey and HullPressureKey
    {
        SOURCE: Text,
        STANDING: OneOf<Standing>,
    }
}

shared_keys! {
    /// Keys of a table of factors.
    pub(crate) FactorTableKey of TemperatureKey and VelocityKey and AngleKey {
        POINTS: Curve,
        HOLDS: Text,
    }
}
