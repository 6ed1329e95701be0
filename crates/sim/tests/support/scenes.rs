//! The scenes of the engine's tests as set-ups of the simulator.

use fenderline_contact::{Fender, Material};
use fenderline_sim::{
    BodySetup, BodyVelocity, FenderSetup, HullPressure, Integrator, Load, MassProperties, Method,
    NamedMaterial, PairSetup, Rated, Setup, WorldSetup,
};

use super::small_host::{self, Scene, scenes};

pub(crate) use scenes::{FENDER_HEIGHT_M, cone};

pub(crate) fn tug() -> BodySetup {
    body(scenes::tug())
}

pub(crate) fn quay() -> BodySetup {
    body(scenes::quay())
}

/// Material 0 is concrete. Material 1 is a fender's facing with friction 0.2.
pub(crate) fn berth_materials() -> Vec<NamedMaterial> {
    materials(scenes::berth_materials())
}

/// A cone fender on the west side of body 0, with material 1.
pub(crate) fn cone_fender(
    name: &str,
    along_m: f64,
    height_m: f64,
    rated_reaction_n: f64,
) -> FenderSetup {
    fender(scenes::cone_fender(name, along_m, height_m, rated_reaction_n))
}

pub(crate) fn tug_impact(speed_mps: f64, along_m: f64, step_s: f64) -> Setup {
    setup(scenes::tug_impact(speed_mps, along_m, step_s))
}

pub(crate) fn oblique_berthing(step_s: f64) -> Setup {
    setup(scenes::oblique_berthing(step_s))
}

pub(crate) fn tug_push(step_s: f64) -> Setup {
    setup(scenes::tug_push(step_s))
}

pub(crate) fn body(of: small_host::BodySetup) -> BodySetup {
    let small_host::BodySetup { name, outline, mass, position_m, heading_rad, velocity } = of;
    let small_host::BodyVelocity { surge_mps, sway_mps, yaw_radps } = velocity;
    BodySetup {
        name,
        outline,
        hull: None,
        mass: mass.map(|mass| MassProperties {
            mass_kg: mass.mass_kg,
            yaw_inertia_kgm2: mass.yaw_inertia_kgm2,
            added_surge_kg: mass.added_surge_kg,
            added_sway_kg: mass.added_sway_kg,
            added_yaw_kgm2: mass.added_yaw_kgm2,
        }),
        position_m,
        heading_rad,
        velocity: BodyVelocity { surge_mps, sway_mps, yaw_radps },
        dolphin: None,
    }
}

fn materials(all: Vec<Material>) -> Vec<NamedMaterial> {
    let named = |(index, material)| NamedMaterial { name: format!("material {index}"), material };
    all.into_iter().enumerate().map(named).collect()
}

/// Adds the data of a fender that only the simulator uses: the height of its face, and the pressure on the hull.
fn fender(of: Fender) -> FenderSetup {
    FenderSetup {
        name: of.name,
        body: of.body.0 as usize,
        position_m: of.position_m,
        facing_rad: of.facing_rad,
        width_m: of.width_m,
        height_m: 3.0,
        above_water_m: 2.0,
        floating: false,
        projection_m: of.projection_m,
        rated: Rated::of(&of.law, of.rated_deflection_m),
        stop: of.stop,
        law: of.law,
        unloading: of.unloading,
        material: of.material.0 as usize,
        factors: of.factors,
        energy_by_angle: vec![],
        hull_pressure: HullPressure::OverFace,
        hull_pressure_limit_npm2: None,
        source: None,
        panel: of.panel,
        chains: vec![],
        panel_mass_kg: 0.0,
    }
}

fn setup(of: Scene) -> Setup {
    let pair = |pair: small_host::PairSetup| {
        let small_host::PairSetup { bodies, material } = pair;
        PairSetup { bodies, material }
    };
    let load = |load: small_host::Load| {
        let small_host::Load { body, force_n } = load;
        Load { body, force_n, moment_nm: 0.0, from_s: 0.0, until_s: f64::INFINITY }
    };
    Setup {
        step_s: of.step_s,
        duration_s: of.duration_s,
        integrator: match of.integrator {
            small_host::Integrator::Euler => Integrator::Euler,
            small_host::Integrator::SemiImplicit => Integrator::SemiImplicit,
        },
        method: match of.method {
            small_host::Method::Coupled => Method::Coupled,
            small_host::Method::Paper => Method::Paper,
        },
        bodies: of.bodies.into_iter().map(body).collect(),
        materials: materials(of.materials),
        pairs: of.pairs.into_iter().map(pair).collect(),
        all_other_pairs: None,
        approaches: vec![],
        fenders: of.fenders.into_iter().map(fender).collect(),
        berthing: None,
        loads: of.loads.into_iter().map(load).collect(),
        world: WorldSetup::default(),
    }
}
