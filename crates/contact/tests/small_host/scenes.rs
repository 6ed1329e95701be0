//! Scenes for tests of the coupled method: a tug's impact, an oblique berthing, a tug's push.

use std::f64::consts::FRAC_PI_2;

use fenderline_contact::{
    BodyId, Fender, FenderLaw, Material, MaterialId, Outline, ReactionFactors, Stop, vec2,
};

use super::{BodySetup, Integrator, Load, Mass, Method, PairSetup, Scene, fixed, outline, spring};

/// The material of the paper's Table 1.
pub(crate) fn rubber() -> Material {
    Material {
        shear_stiffness_npm: 3e6,
        friction_static: 0.5,
        friction_dynamic: 0.5,
        ..spring(500e3, 0.1)
    }
}

/// The paper's tug: 32 m × 13 m, with a flat bow 10 m wide. Her added masses are estimated, as in `scenarios/paper`.
pub(crate) fn tug() -> BodySetup {
    let half = [(16.0, 5.0), (15.5, 6.5), (-14.5, 6.5), (-16.0, 5.0)];
    let mass_kg = 930e3;
    BodySetup {
        mass: Some(Mass {
            mass_kg,
            yaw_inertia_kgm2: mass_kg * 64.0,
            added_surge_kg: 0.086 * mass_kg,
            added_sway_kg: 0.84 * mass_kg,
            added_yaw_kgm2: 0.4 * mass_kg * 64.0,
        }),
        ..fixed("tug", mirrored(&half))
    }
}

/// The paper's container ship, 298 m × 46 m, with 190 m of parallel side.
pub(crate) fn ship() -> BodySetup {
    let half = [(149.0, 3.0), (90.0, 23.0), (-100.0, 23.0), (-149.0, 16.0)];
    let mass_kg = 87.8e6;
    let yaw_inertia_kgm2 = mass_kg * 74.5 * 74.5;
    BodySetup {
        mass: Some(Mass {
            mass_kg,
            yaw_inertia_kgm2,
            added_surge_kg: 0.031 * mass_kg,
            added_sway_kg: 0.506 * mass_kg,
            added_yaw_kgm2: 0.72 * yaw_inertia_kgm2,
        }),
        ..fixed("ship", mirrored(&half))
    }
}

/// A hull from its starboard half, which goes from bow to stern.
fn mirrored(half: &[(f64, f64)]) -> Outline {
    let port = half.iter().rev().map(|&(x, y)| vec2(x, -y));
    outline(&half.iter().map(|&(x, y)| vec2(x, y)).chain(port).collect::<Vec<_>>())
}

/// The reaction curve of a cone fender (fenders/cone.toml), scaled to a height and a rated reaction.
pub(crate) fn cone(height_m: f64, rated_reaction_n: f64) -> FenderLaw {
    let reactions =
        [0.0, 0.20, 0.39, 0.58, 0.76, 0.90, 0.98, 1.00, 0.98, 0.94, 0.90, 0.88, 0.88, 0.90, 0.96];
    let points = (0..)
        .zip(reactions)
        .map(|(k, r)| [0.05 * f64::from(k) * height_m, r * rated_reaction_n])
        .chain([0.72, 0.75].map(|d| [d * height_m, (1.0 + (d - 0.72) / 0.3) * rated_reaction_n]));
    FenderLaw::Curve(points.collect())
}

/// A cone fender on the west side of body 0, with material 1.
pub(crate) fn cone_fender(
    name: &str,
    along_m: f64,
    height_m: f64,
    rated_reaction_n: f64,
) -> Fender {
    let law = cone(height_m, rated_reaction_n);
    Fender {
        name: name.into(),
        key: (1000.0 + along_m) as u64,
        body: BodyId(0),
        position_m: vec2(along_m, 0.0),
        facing_rad: -FRAC_PI_2,
        width_m: 2.0,
        projection_m: height_m,
        rated_deflection_m: 0.72 * height_m,
        stop: Some(Stop {
            from_m: 0.75 * height_m,
            stiffness_npm: 50.0 * rated_reaction_n / height_m,
        }),
        law,
        unloading: None,
        material: MaterialId(1),
        factors: ReactionFactors::default(),
        panel: None,
    }
}

/// Material 0 is concrete. Material 1 is a fender's facing with friction 0.2.
pub(crate) fn berth_materials() -> Vec<Material> {
    let of_friction = |friction: f64, shear_stiffness_npm, stiffness| Material {
        shear_stiffness_npm,
        friction_static: friction,
        friction_dynamic: friction,
        ..spring(stiffness, 0.1)
    };
    vec![of_friction(0.5, 1e7, 50e6), of_friction(0.2, 3e6, 0.0)]
}

/// A quay along the meridian with eight cone fenders on its west side.
pub(crate) fn quay() -> BodySetup {
    let corners = [vec2(-250.0, 0.0), vec2(250.0, 0.0), vec2(250.0, 20.0), vec2(-250.0, 20.0)];
    fixed("quay", outline(&corners))
}

pub(crate) const FENDER_HEIGHT_M: f64 = 1.6;

fn eight_fenders() -> Vec<Fender> {
    (0..8)
        .map(|k| {
            let along_m = -84.0 + 24.0 * f64::from(k);
            cone_fender(&format!("fender {k}"), along_m, FENDER_HEIGHT_M, 1.2e6)
        })
        .collect()
}

fn coupled(step_s: f64, duration_s: f64, bodies: Vec<BodySetup>) -> Scene {
    Scene {
        step_s,
        duration_s,
        integrator: Integrator::SemiImplicit,
        method: Method::Coupled,
        bodies,
        materials: berth_materials(),
        pairs: vec![],
        fenders: vec![],
        loads: vec![],
    }
}

/// The paper's experiment. The tug's bow is 2 m from the ship's side, `along_m` forward of midships.
pub(crate) fn tug_impact(speed_mps: f64, along_m: f64, step_s: f64) -> Scene {
    let mut tug = tug();
    tug.heading_rad = FRAC_PI_2;
    tug.position_m = vec2(along_m, -41.0);
    tug.velocity.surge_mps = speed_mps;
    let mut scene = coupled(step_s, 20.0, vec![ship(), tug]);
    scene.materials = vec![rubber()];
    scene.pairs = vec![PairSetup { bodies: [0, 1], material: 0 }];
    scene
}

/// The same tug, 20 m forward of midships, with her bow 20° aft of square. One shoulder touches and sticks. The tug
/// turns and rolls along the side.
pub(crate) fn oblique_tug_impact(speed_mps: f64, step_s: f64) -> Scene {
    let mut scene = tug_impact(speed_mps, 20.0, step_s);
    let tug = &mut scene.bodies[1];
    tug.heading_rad = 70.0_f64.to_radians();
    let (sin, cos) = (libm::sin(tug.heading_rad), libm::cos(tug.heading_rad));
    tug.position_m.y = -23.0 - 1.0 - 16.0 * sin - 5.0 * cos;
    scene
}

/// The ship comes in sideways at 0.15 m/s, with 0.1 m/s along the berth. Her bow is turned 5° towards the quay.
pub(crate) fn oblique_berthing(step_s: f64) -> Scene {
    let mut ship = ship();
    let angle = 5.0_f64.to_radians();
    ship.heading_rad = angle;
    // The forward shoulder is half a metre from the foremost fender.
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    ship.position_m = vec2(0.0, -FENDER_HEIGHT_M - 0.5 - (90.0 * sin + 23.0 * cos));
    ship.velocity.surge_mps = 0.1 * cos + 0.15 * sin;
    ship.velocity.sway_mps = 0.15 * cos - 0.1 * sin;
    let mut scene = coupled(step_s, 180.0, vec![quay(), ship]);
    scene.fenders = eight_fenders();
    scene.pairs = vec![PairSetup { bodies: [0, 1], material: 0 }];
    scene
}

/// The ship lies alongside. The tug pushes at her outer side with 500 kN, 60 m forward of midships.
pub(crate) fn tug_push(step_s: f64) -> Scene {
    let mut ship = ship();
    ship.position_m = vec2(0.0, -FENDER_HEIGHT_M - 23.0);
    let mut tug = tug();
    tug.heading_rad = FRAC_PI_2;
    tug.position_m = ship.position_m + vec2(60.0, -23.0 - 16.0);
    let mut scene = coupled(step_s, 600.0, vec![quay(), ship, tug]);
    scene.fenders = eight_fenders();
    scene.materials.push(rubber());
    scene.pairs =
        vec![PairSetup { bodies: [0, 1], material: 0 }, PairSetup { bodies: [1, 2], material: 2 }];
    scene.loads = vec![Load { body: 2, force_n: vec2(0.0, 500e3) }];
    scene
}
