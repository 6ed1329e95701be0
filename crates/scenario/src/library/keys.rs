//! Every key of a fender file, as [`crate::keys`] says those of a scenario.

use core::f64::consts::FRAC_PI_2;

use fenderline_contact::Unloading;
use serde_json::json;

use crate::keys::STANDINGS;
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{CurveSpec, KeySpec, Kind, Quantity, TableSpec};
use crate::units::measures as unit;

/// The whole file.
pub(crate) static FENDER_FILE: TableSpec = TableSpec {
    what: "a fender file",
    doc: "Families of fenders with their performance curves and sizes, and hull pressure limits. A \
          plain number is in SI units (angles in radians); a string carries its unit, as \"3 m\".",
    keys: &[
        KeySpec {
            name: "family",
            kind: Kind::Named(&FAMILY),
            absent: Is("{}"),
            doc: "Families of fenders, by name.",
            examples: &[],
        },
        KeySpec {
            name: "hull_pressure",
            kind: Kind::Named(&HULL_PRESSURE),
            absent: Is("{}"),
            doc: "What a ship's side bears, by type of ship.",
            examples: &[],
        },
    ],
    rules: None,
};

const SOURCE: KeySpec = KeySpec {
    name: "source",
    kind: Kind::Text,
    absent: Refused,
    doc: "Where the numbers come from.",
    examples: &["\"the maker's catalogue of 2021, page 12\""],
};

const STANDING: KeySpec = KeySpec {
    name: "standing",
    kind: Kind::Choice(&STANDINGS),
    absent: Refused,
    doc: "How well the source is known.",
    examples: &["\"found\""],
};

static FAMILY: TableSpec = TableSpec {
    what: "a family of fenders",
    doc: "Fenders of one shape: a curve that all sizes share, and sizes. Under the name of a family \
          that is known already, sizes alone.",
    keys: &[
        KeySpec {
            name: "rated_deflection",
            kind: Kind::Quantity(OF_HEIGHT),
            absent: Means("the family is known already"),
            doc: "Rated deflection over height.",
            examples: &["0.72"],
        },
        KeySpec {
            name: "reference",
            kind: Kind::Text,
            absent: Means("no sizes are derived from others"),
            doc: "Designation of the size from which others are scaled, reaction by height squared.",
            examples: &["\"1000 A\""],
        },
        KeySpec {
            name: "curve",
            kind: Kind::Table(&CURVE),
            absent: Means("the family is known already"),
            doc: "Reaction against deflection, normalised.",
            examples: &[],
        },
        KeySpec {
            name: "unloading",
            kind: Kind::Table(&UNLOADING),
            absent: Means("the reaction falls by the material's restitution"),
            doc: "How the reaction falls when the hull retreats.",
            examples: &[],
        },
        KeySpec {
            name: "temperature",
            kind: Kind::Table(&TEMPERATURE),
            absent: Means("no correction"),
            doc: "Factor on the reaction by temperature.",
            examples: &[],
        },
        KeySpec {
            name: "velocity",
            kind: Kind::Table(&VELOCITY),
            absent: Means("no correction"),
            doc: "Factor on the reaction by the time to rated deflection.",
            examples: &[],
        },
        KeySpec {
            name: "angle_energy",
            kind: Kind::Table(&ANGLE),
            absent: Means("no correction"),
            doc: "Factor on the energy by the angle of compression.",
            examples: &[],
        },
        KeySpec {
            name: "angle_reaction",
            kind: Kind::Table(&ANGLE),
            absent: Means("no correction"),
            doc: "Factor on the reaction by the angle of compression.",
            examples: &[],
        },
        KeySpec {
            name: "tolerance",
            kind: Kind::Table(&TOLERANCE),
            absent: Means("it is not known"),
            doc: "Manufacturing tolerance of reaction and energy.",
            examples: &[],
        },
        KeySpec {
            name: "size",
            kind: Kind::List(&SIZE),
            absent: Is("[]"),
            doc: "Sizes with their rated reaction.",
            examples: &[],
        },
    ],
    rules: None,
};

const OF_HEIGHT: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1.0 };
const OF_RATED: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 100.0 };
const FACTOR: (&str, Quantity) =
    ("factor", Quantity { measure: &unit::PLAIN_NUMBER, low: 0.01, high: 100.0 });

static CURVE: TableSpec = TableSpec {
    what: "a performance curve",
    doc: "Reaction against deflection, normalised.",
    keys: &[
        KeySpec {
            name: "points",
            kind: Kind::Curve(&CurveSpec {
                from: ("deflection", OF_HEIGHT),
                to: ("reaction", OF_RATED),
                fewest: 2,
            }),
            absent: Refused,
            doc: "Rows of deflection over height and reaction over rated reaction, from [0, 0] to \
                  the rated deflection or beyond; straight between them.",
            examples: &["[[0, 0], [0.25, 0.9], [0.5, 1]]"],
        },
        KeySpec {
            name: "published_energy",
            kind: Kind::Curve(&CurveSpec {
                from: ("deflection", OF_HEIGHT),
                to: ("energy", OF_RATED),
                fewest: 2,
            }),
            absent: Means("none was published"),
            doc: "Rows of deflection over height and energy over rated energy as published: for \
                  comparison only, the energy is the integral of the reaction.",
            examples: &["[[0, 0], [0.25, 0.4], [0.5, 1]]"],
        },
        SOURCE,
        STANDING,
    ],
    rules: None,
};

static UNLOADING: TableSpec = TableSpec {
    what: "an unloading law",
    doc: "How the reaction falls when the hull retreats: `returned_energy` or `points`.",
    keys: &[
        KeySpec {
            name: "returned_energy",
            kind: Kind::Quantity(RETURNED_ENERGY),
            absent: Means("`points` say it"),
            doc: "Share of the energy taken that compressing to any deflection and letting go gives back.",
            examples: &["\"55 %\""],
        },
        KeySpec {
            name: "points",
            kind: Kind::Curve(&CurveSpec {
                from: ("deflection", OF_HEIGHT),
                to: ("reaction", OF_RATED),
                fewest: 2,
            }),
            absent: Means("`returned_energy` is given instead"),
            doc: "Rows of deflection over height and reaction over rated reaction that a retreat comes down to, \
                  from [0, 0]; straight between them, nowhere above the curve. Beyond the last row the reaction \
                  comes down to the same share of the curve as there.",
            examples: &["[[0, 0], [0.25, 0.4], [0.5, 0.9]]"],
        },
        SOURCE,
        STANDING,
    ],
    rules: Some(|| {
        json!({
            "oneOf": [{ "required": ["returned_energy"] }, { "required": ["points"] }]
        })
    }),
};

/// Energy given back over energy taken.
pub(crate) const RETURNED_ENERGY: Quantity =
    Quantity { measure: &unit::PLAIN_NUMBER, low: Unloading::MIN_RETURNED_SHARE, high: 1.0 };

const HOLDS: KeySpec = KeySpec {
    name: "holds",
    kind: Kind::Text,
    absent: Means("wherever the family is used"),
    doc: "Where the factors hold.",
    examples: &["\"blended rubber\""],
};

static TEMPERATURE: TableSpec = TableSpec {
    what: "a temperature table",
    doc: "Factor on the reaction by temperature.",
    keys: &[
        KeySpec {
            name: "points",
            kind: Kind::Curve(&CurveSpec {
                from: (
                    "temperature",
                    Quantity { measure: &unit::PLAIN_NUMBER, low: -100.0, high: 150.0 },
                ),
                to: FACTOR,
                fewest: 1,
            }),
            absent: Refused,
            doc: "Rows of temperature in degrees Celsius, a plain number, and factor.",
            examples: &["[[-10, 1.13], [23, 1], [50, 0.916]]"],
        },
        HOLDS,
        SOURCE,
        STANDING,
    ],
    rules: None,
};

static VELOCITY: TableSpec = TableSpec {
    what: "a velocity table",
    doc: "Factor on the reaction by the time to rated deflection.",
    keys: &[
        KeySpec {
            name: "points",
            kind: Kind::Curve(&CurveSpec {
                from: ("time", Quantity { measure: &unit::TIME, low: 0.0, high: 1e6 }),
                to: FACTOR,
                fewest: 1,
            }),
            absent: Refused,
            doc: "Rows of the time to rated deflection and factor.",
            examples: &["[[\"1 s\", 1.2], [\"20 s\", 1.03]]"],
        },
        HOLDS,
        SOURCE,
        STANDING,
    ],
    rules: None,
};

static ANGLE: TableSpec = TableSpec {
    what: "an angle table",
    doc: "Factor by the angle of compression.",
    keys: &[
        KeySpec {
            name: "points",
            kind: Kind::Curve(&CurveSpec {
                from: ("angle", Quantity { measure: &unit::ANGLE, low: 0.0, high: FRAC_PI_2 }),
                to: FACTOR,
                fewest: 1,
            }),
            absent: Refused,
            doc: "Rows of the angle between hull and panel and factor.",
            examples: &["[[\"0 deg\", 1], [\"20 deg\", 0.739]]"],
        },
        HOLDS,
        SOURCE,
        STANDING,
    ],
    rules: None,
};

static TOLERANCE: TableSpec = TableSpec {
    what: "a tolerance",
    doc: "Manufacturing tolerance of reaction and energy.",
    keys: &[
        KeySpec {
            name: "value",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 0.9 }),
            absent: Refused,
            doc: "To either side.",
            examples: &["\"10 %\""],
        },
        SOURCE,
        STANDING,
    ],
    rules: None,
};

const METRES: Quantity = Quantity { measure: &unit::LENGTH, low: 1e-3, high: 100.0 };

static SIZE: TableSpec = TableSpec {
    what: "a size",
    doc: "One fender of a catalogue.",
    keys: &[
        KeySpec {
            name: "designation",
            kind: Kind::Text,
            absent: Refused,
            doc: "Its name within the family.",
            examples: &["\"1000x1500 50kPa\""],
        },
        KeySpec {
            name: "height",
            kind: Kind::Quantity(METRES),
            absent: Refused,
            doc: "Extent in the direction of compression: height, or diameter.",
            examples: &["\"1000 mm\""],
        },
        KeySpec {
            name: "length",
            kind: Kind::Quantity(METRES),
            absent: Means("it has none of its own"),
            doc: "Length along the berth.",
            examples: &["\"1500 mm\""],
        },
        KeySpec {
            name: "reaction",
            kind: Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e9 }),
            absent: Refused,
            doc: "Rated reaction.",
            examples: &["\"182 kN\""],
        },
        KeySpec {
            name: "published_energy",
            kind: Kind::Quantity(Quantity { measure: &unit::MOMENT, low: 1.0, high: 1e10 }),
            absent: Means("none was published"),
            doc: "Rated energy as published: for comparison only.",
            examples: &["\"32 kJ\""],
        },
        KeySpec {
            name: "hull_pressure",
            kind: Kind::Quantity(PRESSURE),
            absent: Means("the panel sets it"),
            doc: "Pressure on the hull at the rated deflection.",
            examples: &["\"122 kPa\""],
        },
        KeySpec {
            name: "initial_pressure",
            kind: Kind::Quantity(PRESSURE),
            absent: Means("pressures below the rated deflection are not known"),
            doc: "Inner pressure of a fender blown up, at no deflection.",
            examples: &["\"50 kPa\""],
        },
        SOURCE,
        STANDING,
    ],
    rules: None,
};

const PRESSURE: Quantity = Quantity { measure: &unit::STIFFNESS_PER_AREA, low: 1.0, high: 1e9 };

static HULL_PRESSURE: TableSpec = TableSpec {
    what: "a hull pressure limit",
    doc: "What the side of a type of ship bears.",
    keys: &[
        KeySpec {
            name: "limit",
            kind: Kind::Quantity(PRESSURE),
            absent: Refused,
            doc: "Greatest mean pressure under a panel.",
            examples: &["\"150 kN/m^2\""],
        },
        SOURCE,
        STANDING,
    ],
    rules: None,
};
