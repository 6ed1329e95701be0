//! Every key of a scenario file: its kind, unit, bounds, default and meaning, said once.
//!
//! The bounds keep all that the simulation computes far from overflow and are beyond anything that
//! floats. To add a key: add it here, then use it in [`crate::assemble`].

mod azimuth;
mod environment;
mod fender;
pub(crate) mod order;
mod provider;
mod standing;
mod vessel;
pub(crate) mod windage;
mod world;

use fenderline_sim::{Integrator, Method};
use serde_json::json;

use crate::choices::{Choice, Choices};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec};
use crate::units::measures as unit;

// What vessel files share with scenarios.
pub(crate) use azimuth::AZIMUTH;
pub(crate) use standing::STANDINGS;
pub(crate) use vessel::{STABILITY, THRUSTER};
pub(crate) use windage::WINDAGE;
pub(crate) use world::{LENGTH as LENGTH_M, PLACE as FORWARD_M, key};

/// The whole file.
pub(crate) static SCENARIO: TableSpec = TableSpec {
    what: "a scenario",
    doc: "Ships, fenders, quays and tugs in the horizontal plane: x north, y east, headings \
          clockwise from north. A plain number is in SI units (angles in radians); a string \
          carries its unit, as \"4 kn\".",
    keys: &[
        KeySpec {
            name: "title",
            kind: Kind::Text,
            absent: Means("the name of the file"),
            doc: "Title of reports.",
            examples: &["\"Tug against a container ship's side, 4 kn\""],
        },
        KeySpec {
            name: "time",
            kind: Kind::Table(&TIME),
            absent: Refused,
            doc: "Time step and length of the run.",
            examples: &[],
        },
        KeySpec {
            name: "contact",
            kind: Kind::Table(&CONTACT),
            absent: Is("{}"),
            doc: "How contact forces are found.",
            examples: &[],
        },
        KeySpec {
            name: "material",
            kind: Kind::Named(&MATERIAL),
            absent: Is("{}"),
            doc: "Contact parameters, by name.",
            examples: &[],
        },
        KeySpec {
            name: "body",
            kind: Kind::Named(&BODY),
            absent: Refused,
            doc: "Bodies, by name. Their order in the file is the order of results.",
            examples: &[],
        },
        KeySpec {
            name: "pair",
            kind: Kind::List(&PAIR),
            absent: Is("[]"),
            doc: "Which bodies may touch. Bodies that no pair names do not touch.",
            examples: &[],
        },
        KeySpec {
            name: "fender",
            kind: Kind::Named(&fender::FENDER),
            absent: Is("{}"),
            doc: "Fenders on the bodies, by name.",
            examples: &[],
        },
        KeySpec {
            name: "fender_files",
            kind: Kind::Texts,
            absent: Is("[]"),
            doc: "Files with fender data of your own (fenders/README.md shows their form), relative \
                  to this file.",
            examples: &["[\"our_fenders.toml\"]"],
        },
        KeySpec {
            name: "berthing",
            kind: Kind::Table(&fender::BERTHING),
            absent: Means("no study"),
            doc: "Particulars for the berthing energy by formula beside that of the run.",
            examples: &[],
        },
        KeySpec {
            name: "environment",
            kind: Kind::Table(&environment::ENVIRONMENT),
            absent: Is("{}"),
            doc: "Wind, current, waves and water.",
            examples: &[],
        },
        KeySpec {
            name: "vessel",
            kind: Kind::Named(&vessel::VESSEL),
            absent: Is("{}"),
            doc: "Kinds of vessels of the scenario's own, by name; those of the library need no table here.",
            examples: &[],
        },
        KeySpec {
            name: "vessel_files",
            kind: Kind::Texts,
            absent: Is("[]"),
            doc: "Files with vessels of your own (vessels/README.md shows their form), relative to this file.",
            examples: &["[\"our_vessels.toml\"]"],
        },
        KeySpec {
            name: "tug",
            kind: Kind::Named(&world::TUG),
            absent: Is("{}"),
            doc: "Tugs that are forces on vessels, by name.",
            examples: &[],
        },
        KeySpec {
            name: "line",
            kind: Kind::Named(&world::LINE),
            absent: Is("{}"),
            doc: "Mooring lines, by name.",
            examples: &[],
        },
        KeySpec {
            name: "order",
            kind: Kind::List(&order::ORDER),
            absent: Is("[]"),
            doc: "Orders at times of the run.",
            examples: &[],
        },
        KeySpec {
            name: "provider",
            kind: Kind::List(&provider::PROVIDER),
            absent: Is("[]"),
            doc: "Programs that put forces on bodies.",
            examples: &[],
        },
        KeySpec {
            name: "load",
            kind: Kind::List(&LOAD),
            absent: Is("[]"),
            doc: "Steady or timed external loads.",
            examples: &[],
        },
    ],
    rules: None,
};

static TIME: TableSpec = TableSpec {
    what: "a time table",
    doc: "Time step and length of the run.",
    keys: &[
        KeySpec {
            name: "step",
            kind: Kind::Quantity(Quantity { measure: &unit::TIME, low: 1e-6, high: 1e4 }),
            absent: Refused,
            doc: "Time step.",
            examples: &["\"0.1 s\"", "0.1"],
        },
        KeySpec {
            name: "duration",
            kind: Kind::Quantity(Quantity { measure: &unit::TIME, low: 1e-6, high: 1e9 }),
            absent: Refused,
            doc: "Length of the run: at most 1e9 steps.",
            examples: &["\"20 s\"", "\"15 min\""],
        },
        KeySpec {
            name: "integrator",
            kind: Kind::Choice(&INTEGRATORS),
            absent: Is("\"semi_implicit\""),
            doc: "How states advance from step to step.",
            examples: &["\"euler\""],
        },
    ],
    rules: None,
};

static INTEGRATORS: Choices<Integrator> = Choices(&[
    Choice {
        word: "euler",
        value: Integrator::Euler,
        doc: "forward Euler, as in the paper: positions with the old velocities",
    },
    Choice {
        word: "semi_implicit",
        value: Integrator::SemiImplicit,
        doc: "velocities first, then positions with the new velocities",
    },
    Choice { word: "rk4", value: Integrator::Rk4, doc: "classical fourth-order Runge-Kutta" },
]);

static CONTACT: TableSpec = TableSpec {
    what: "a contact table",
    doc: "How contact forces are found.",
    keys: &[KeySpec {
        name: "method",
        kind: Kind::Choice(&METHODS),
        absent: Is("\"coupled\""),
        doc: "Which method limits contact forces.",
        examples: &["\"coupled\""],
    }],
    rules: None,
};

static METHODS: Choices<Method> = Choices(&[
    Choice {
        word: "coupled",
        value: Method::Coupled,
        doc: "one solve for all contacts of a step with the loads in it, and sub-steps",
    },
    Choice {
        word: "paper",
        value: Method::Paper,
        doc: "the paper's impulse-momentum limiter, each pair by itself",
    },
]);

static MATERIAL: TableSpec = TableSpec {
    what: "a material",
    doc: "Contact parameters of a pair of bodies.",
    keys: &[
        KeySpec {
            name: "stiffness",
            kind: Kind::Quantity(Quantity {
                measure: &unit::STIFFNESS_PER_AREA,
                low: 0.0,
                high: 1e15,
            }),
            absent: Refused,
            doc: "k, normal force per overlap area.",
            examples: &["\"500 kN/m^2\""],
        },
        KeySpec {
            name: "damping",
            kind: Kind::Quantity(Quantity {
                measure: &unit::DAMPING_PER_AREA,
                low: 0.0,
                high: 1e15,
            }),
            absent: Is("0"),
            doc: "c, normal force per rate of change of the overlap area.",
            examples: &["\"20 kN.s/m^2\""],
        },
        KeySpec {
            name: "shear_stiffness",
            kind: Kind::Quantity(Quantity { measure: &unit::STIFFNESS, low: 0.0, high: 1e15 }),
            absent: Is("0"),
            doc: "k_s, tangential force per shear of a contact; without it there is no friction.",
            examples: &["\"3000 kN/m\""],
        },
        KeySpec {
            name: "friction_static",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 10.0 }),
            absent: Is("0"),
            doc: "Coefficient of static friction: 0.1 to 1 in most harbours; more than 1.5 is noticed.",
            examples: &["0.5"],
        },
        KeySpec {
            name: "friction_dynamic",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 10.0 }),
            absent: Means("equal to `friction_static`"),
            doc: "Coefficient of dynamic friction, at most `friction_static`.",
            examples: &["0.4"],
        },
        KeySpec {
            name: "restitution",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1.0 }),
            absent: Is("0"),
            doc: "Speed of leaving over speed of approach, where the limiter acts.",
            examples: &["0.1"],
        },
    ],
    rules: None,
};

static BODY: TableSpec = TableSpec {
    what: "a body",
    doc: "A ship, tug, quay or fender: fixed, or floating with a mass.",
    keys: &[
        KeySpec {
            name: "fixed",
            kind: Kind::Flag,
            absent: Is("false"),
            doc: "True for a body that never moves; it has no mass and no velocity.",
            examples: &["true"],
        },
        KeySpec {
            name: "outline",
            kind: Kind::Outline(Quantity { measure: &unit::LENGTH, low: -1e8, high: 1e8 }),
            absent: Means("that of her vessel"),
            doc: "Vertices, forward and to starboard of the centre of gravity, in either direction \
                  round; need not be convex.",
            examples: &["[[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]"],
        },
        KeySpec {
            name: "vessel",
            kind: Kind::Text,
            absent: Means("a plain body"),
            doc: "The kind of vessel that she is, of this scenario, of the library (`fenderline vessels`) or of \
                  `vessel_files`: it gives mass, added mass, outline and everything that acts on her.",
            examples: &["\"container-ship\""],
        },
        KeySpec {
            name: "running",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -1.0, high: 1.0 }),
            absent: Means("engine stopped"),
            doc: "A vessel's revolutions over full ones at the start.",
            examples: &["0.3"],
        },
        KeySpec {
            name: "mass",
            kind: Kind::Quantity(Quantity { measure: &unit::MASS, low: 1e-3, high: 1e15 }),
            absent: Means("a fixed body"),
            doc: "Displacement, without added mass.",
            examples: &["\"87800 t\""],
        },
        KeySpec {
            name: "gyradius",
            kind: Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1e-3, high: 1e5 }),
            absent: Means("`yaw_inertia` is given"),
            doc: "Radius of gyration about the vertical through the centre of gravity.",
            examples: &["\"74.5 m\""],
        },
        KeySpec {
            name: "yaw_inertia",
            kind: Kind::Quantity(Quantity {
                measure: &unit::MOMENT_OF_INERTIA,
                low: 1e-9,
                high: 1e25,
            }),
            absent: Means("`gyradius` is given"),
            doc: "Moment of inertia about the vertical through the centre of gravity.",
            examples: &["\"4.87e8 t.m^2\""],
        },
        KeySpec {
            name: "added_mass",
            kind: Kind::Table(&ADDED_MASS),
            absent: Means("no added mass"),
            doc: "Added mass as fractions of mass and of yaw inertia.",
            examples: &["{ surge = 0.031, sway = 0.506, yaw = 0.72 }"],
        },
        KeySpec {
            name: "position",
            kind: Kind::Vector(POSITION_M),
            absent: Is("[0, 0]"),
            doc: "Initial position of the centre of gravity: north, east.",
            examples: &["[0, 30]", "[\"1 km\", 0]"],
        },
        KeySpec {
            name: "heading",
            kind: Kind::Quantity(Quantity { measure: &unit::ANGLE, low: -1e6, high: 1e6 }),
            absent: Is("0"),
            doc: "Initial heading, clockwise from north.",
            examples: &["\"270 deg\""],
        },
        KeySpec {
            name: "velocity",
            kind: Kind::Table(&VELOCITY),
            absent: Means("at rest"),
            doc: "Initial velocity in the body's axes.",
            examples: &["{ surge = \"4 kn\" }"],
        },
    ],
    rules: Some(|| {
        json!({
            "if": { "properties": { "fixed": { "const": true } }, "required": ["fixed"] },
            "then": {
                "properties": {
                    "mass": false, "gyradius": false, "yaw_inertia": false,
                    "added_mass": false, "velocity": false, "vessel": false, "running": false
                },
                "required": ["outline"]
            },
            "else": {
                "if": { "required": ["vessel"] },
                "then": {
                    "properties": {
                        "mass": false, "gyradius": false, "yaw_inertia": false, "added_mass": false
                    }
                },
                "else": {
                    "properties": { "running": false },
                    "required": ["mass", "outline"],
                    "oneOf": [{ "required": ["gyradius"] }, { "required": ["yaw_inertia"] }]
                }
            }
        })
    }),
};

const POSITION_M: Quantity = Quantity { measure: &unit::LENGTH, low: -1e8, high: 1e8 };

static ADDED_MASS: TableSpec = TableSpec {
    what: "an added mass",
    doc: "Added mass as fractions of mass and of yaw inertia.",
    keys: &[
        KeySpec {
            name: "surge",
            kind: Kind::Quantity(ADDED_FRACTION),
            absent: Is("0"),
            doc: "Added mass in surge over mass.",
            examples: &["0.031"],
        },
        KeySpec {
            name: "sway",
            kind: Kind::Quantity(ADDED_FRACTION),
            absent: Is("0"),
            doc: "Added mass in sway over mass.",
            examples: &["0.506"],
        },
        KeySpec {
            name: "yaw",
            kind: Kind::Quantity(ADDED_FRACTION),
            absent: Is("0"),
            doc: "Added moment of inertia in yaw over yaw inertia.",
            examples: &["0.72"],
        },
    ],
    rules: None,
};

const ADDED_FRACTION: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1000.0 };

static VELOCITY: TableSpec = TableSpec {
    what: "a velocity",
    doc: "Velocity in the body's axes.",
    keys: &[
        KeySpec {
            name: "surge",
            kind: Kind::Quantity(SPEED),
            absent: Is("0"),
            doc: "Forward.",
            examples: &["\"4 kn\""],
        },
        KeySpec {
            name: "sway",
            kind: Kind::Quantity(SPEED),
            absent: Is("0"),
            doc: "To starboard.",
            examples: &["\"-0.15 m/s\""],
        },
        KeySpec {
            name: "yaw",
            kind: Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: -1e3, high: 1e3 }),
            absent: Is("0"),
            doc: "Rate of turn, to starboard.",
            examples: &["\"3 deg/s\""],
        },
    ],
    rules: None,
};

const SPEED: Quantity = Quantity { measure: &unit::SPEED, low: -1e4, high: 1e4 };

static PAIR: TableSpec = TableSpec {
    what: "a pair",
    doc: "Two bodies that may touch, and how.",
    keys: &[
        KeySpec {
            name: "bodies",
            kind: Kind::TwoBodyNames,
            absent: Refused,
            doc: "Two bodies, at least one of them floating; [\"*\", \"*\"] stands for every two \
                  that no other pair names.",
            examples: &["[\"tug\", \"ship\"]", "[\"*\", \"*\"]"],
        },
        KeySpec {
            name: "material",
            kind: Kind::MaterialName,
            absent: Refused,
            doc: "The material of their contact.",
            examples: &["\"paper\""],
        },
    ],
    rules: None,
};

static LOAD: TableSpec = TableSpec {
    what: "a load",
    doc: "An external load at a body's centre of gravity; it needs a force or a moment.",
    keys: &[
        KeySpec {
            name: "body",
            kind: Kind::BodyName,
            absent: Refused,
            doc: "The floating body that it acts on.",
            examples: &["\"ship\""],
        },
        KeySpec {
            name: "force",
            kind: Kind::Vector(Quantity { measure: &unit::FORCE, low: -1e15, high: 1e15 }),
            absent: Means("no force"),
            doc: "Force: north, east.",
            examples: &["[\"0 kN\", \"-500 kN\"]"],
        },
        KeySpec {
            name: "moment",
            kind: Kind::Quantity(Quantity { measure: &unit::MOMENT, low: -1e20, high: 1e20 }),
            absent: Means("no moment"),
            doc: "Moment about the vertical, positive to starboard.",
            examples: &["\"1.2e3 kN.m\""],
        },
        KeySpec {
            name: "from",
            kind: Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 1e9 }),
            absent: Is("0"),
            doc: "When the load starts.",
            examples: &["\"10 s\""],
        },
        KeySpec {
            name: "until",
            kind: Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 1e9 }),
            absent: Means("the end of the run"),
            doc: "When the load ends, later than `from`.",
            examples: &["\"5 min\""],
        },
    ],
    rules: Some(|| json!({ "anyOf": [{ "required": ["force"] }, { "required": ["moment"] }] })),
};
