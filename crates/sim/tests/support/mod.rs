//! Bodies and set-ups that the tests of this crate share. The numbers are those of the engine's tests.

#![allow(dead_code, unused_imports, reason = "each test binary uses its own part")]

pub(crate) mod scenes;
#[path = "../../../contact/tests/small_host/mod.rs"]
mod small_host;

use fenderline_contact::{Material, Outline};
use fenderline_sim::{BodySetup, Integrator, Method, NamedMaterial, PairSetup, Setup};

pub(crate) use small_host::{outline, rectangle, spring};

/// A floating body. Its yaw inertia follows from a radius of gyration.
pub(crate) fn floating(name: &str, outline: Outline, mass_kg: f64, gyradius_m: f64) -> BodySetup {
    scenes::body(small_host::floating(name, outline, mass_kg, gyradius_m))
}

pub(crate) fn fixed(name: &str, outline: Outline) -> BodySetup {
    scenes::body(small_host::fixed(name, outline))
}

/// Two bodies with one material.
pub(crate) fn two(
    one: BodySetup,
    two: BodySetup,
    material: Material,
    integrator: Integrator,
    step_s: f64,
    duration_s: f64,
) -> Setup {
    Setup {
        step_s,
        duration_s,
        integrator,
        method: Method::Paper,
        bodies: vec![one, two],
        materials: vec![NamedMaterial { name: "fender".into(), material }],
        pairs: vec![PairSetup { bodies: [0, 1], material: 0 }],
        all_other_pairs: None,
        approaches: vec![],
        fenders: vec![],
        berthing: None,
        loads: vec![],
        world: fenderline_sim::WorldSetup::default(),
    }
}
