//! Keys of time and of the contact method.

use fenderline_sim::{Integrator, Method};

use crate::choices::{Choice, Choices};
use crate::spec::Absent::{Is, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec};
use crate::units::measures as unit;

pub(super) static TIME: TableSpec = TableSpec {
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

pub(super) static CONTACT: TableSpec = TableSpec {
    what: "a contact table",
    doc: "How contact forces are computed.",
    keys: &[KeySpec {
        name: "method",
        kind: Kind::Choice(&METHODS),
        absent: Is("\"coupled\""),
        doc: "Which method limits contact forces.",
        examples: &["\"coupled\""],
    }],
    rules: None,
};

pub(super) static METHODS: Choices<Method> = Choices(&[
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
