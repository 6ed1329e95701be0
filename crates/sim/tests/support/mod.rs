//! Bodies and set-ups that the tests of this crate share.

#![allow(dead_code, reason = "each test binary uses its own part")]

pub(crate) mod scenes;

use fenderline_contact::{Material, Outline, Vec2, vec2};
use fenderline_sim::{
    BodySetup, BodyVelocity, Integrator, MassProperties, Method, NamedMaterial, PairSetup, Setup,
};

/// A rectangle, length along x, about the origin.
pub(crate) fn rectangle(length_m: f64, width_m: f64) -> Outline {
    let (x, y) = (0.5 * length_m, 0.5 * width_m);
    outline(&[vec2(-x, -y), vec2(x, -y), vec2(x, y), vec2(-x, y)])
}

pub(crate) fn outline(vertices: &[Vec2]) -> Outline {
    Outline::new(vertices).expect("a good outline").0
}

/// A floating body; the yaw inertia from a radius of gyration.
pub(crate) fn floating(name: &str, outline: Outline, mass_kg: f64, gyradius_m: f64) -> BodySetup {
    let mass = MassProperties {
        mass_kg,
        yaw_inertia_kgm2: mass_kg * gyradius_m * gyradius_m,
        ..MassProperties::default()
    };
    BodySetup { mass: Some(mass), ..fixed(name, outline) }
}

pub(crate) fn fixed(name: &str, outline: Outline) -> BodySetup {
    BodySetup {
        name: name.into(),
        outline,
        mass: None,
        position_m: Vec2::ZERO,
        heading_rad: 0.0,
        velocity: BodyVelocity::default(),
    }
}

pub(crate) fn spring(stiffness_npm2: f64, restitution: f64) -> Material {
    Material {
        stiffness_npm2,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 0.0,
        friction_static: 0.0,
        friction_dynamic: 0.0,
        restitution,
    }
}

/// Two bodies of one material.
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
        fenders: vec![],
        berthing: None,
        loads: vec![],
        world: fenderline_sim::WorldSetup::default(),
    }
}
