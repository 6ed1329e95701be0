//! Keys of time and of the contact method.

use fenderline_sim::{Integrator, Method};

use crate::choices::{Choice, Choices};
use crate::held::{Number, OneOf};
use crate::spec::Absent::{Is, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static TIME: TableSpec = TableSpec {
    what: "a time table",
    doc: "Time step and length of the run.",
    keys: TimeKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of the table `[time]`: time step and length of the run.
    pub TimeKey {
        STEP: Number = key(
            "step",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 1e-6, high: 1e4 }),
            Refused,
            "Time step.",
            &["\"0.1 s\"", "0.1"],
        ),
        DURATION: Number = key(
            "duration",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 1e-6, high: 1e9 }),
            Refused,
            "Length of the run: at most 1e9 steps.",
            &["\"20 s\"", "\"15 min\""],
        ),
        INTEGRATOR: OneOf<Integrator> = key(
            "integrator",
            Kind::Choice(&INTEGRATORS),
            Is("\"semi_implicit\""),
            "How positions and velocities advance from step to step.",
            &["\"euler\""],
        ),
    }
}

static INTEGRATORS: Choices<Integrator> = Choices(&[
    Choice {
        word: "euler",
        value: Integrator::Euler,
        doc: "forward Euler, as in the paper: the new positions follow from the old velocities",
    },
    Choice {
        word: "semi_implicit",
        value: Integrator::SemiImplicit,
        doc: "semi-implicit Euler: first the velocities advance, then the positions with the new \
              velocities",
    },
    Choice { word: "rk4", value: Integrator::Rk4, doc: "classical fourth-order Runge-Kutta" },
]);

pub(super) static CONTACT: TableSpec = TableSpec {
    what: "a contact table",
    doc: "How contact forces are computed.",
    keys: ContactKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of the table `[contact]`: the method for contact forces.
    pub ContactKey {
        METHOD: OneOf<Method> = key(
        "method",
        Kind::Choice(&METHODS),
        Is("\"coupled\""),
        "Method for contact forces.",
        &["\"coupled\""],
    ),
    }
}

pub(super) static METHODS: Choices<Method> = Choices(&[
    Choice {
        word: "coupled",
        value: Method::Coupled,
        doc: "the coupled method solves all contacts of a step together with the loads, in \
              sub-steps",
    },
    Choice {
        word: "paper",
        value: Method::Paper,
        doc: "the paper's method limits the force of each pair of bodies separately by impulse and \
              momentum",
    },
]);
