//! A ship at a berth with eight fenders, and its motion. Several tests share this scene.

use fenderline_contact::{
    Body, BodyState, Material, Mobility, Model, Outline, Vec2, Workspace, vec2,
};

/// Index of the ship; the fenders follow it.
pub(crate) const SHIP: usize = 0;
/// Number of fenders.
pub(crate) const FENDERS: usize = 8;
/// Displacement with the smallest added mass (kg).
pub(crate) const SHIP_MASS_KG: f64 = 9.06e7;
/// Moment of inertia with its added part (kg·m²).
pub(crate) const SHIP_YAW_INERTIA_KGM2: f64 = 8.4e11;
/// East position at which the ship's side touches the fenders' faces (m).
pub(crate) const TOUCH_EAST_M: f64 = 1.0;

/// A container ship of 298 × 46 m and eight fenders 4 m wide, 30 m apart, their faces at 24 m east.
pub(crate) fn berth(stiffness_npm2: f64) -> Model {
    let hull = [(-149.0, -23.0), (104.0, -23.0), (149.0, -3.0)];
    let mirrored = hull.map(|(x, y)| (x, -y));
    let hull: Vec<Vec2> =
        hull.iter().chain(mirrored.iter().rev()).map(|&(x, y)| vec2(x, y)).collect();
    let fender = [vec2(-2.0, 0.0), vec2(2.0, 0.0), vec2(2.0, 1.5), vec2(-2.0, 1.5)];
    let outline = |vertices: &[Vec2]| Outline::new(vertices).expect("a good outline").0;

    let mut builder = Model::builder();
    let ship = Mobility::Free { mass_kg: SHIP_MASS_KG, yaw_inertia_kgm2: SHIP_YAW_INERTIA_KGM2 };
    builder.body(Body { name: "ship".into(), key: 0, outline: outline(&hull), mobility: ship });
    for number in 1..=FENDERS as u64 {
        builder.body(Body {
            name: format!("fender {number}"),
            key: number,
            outline: outline(&fender),
            mobility: Mobility::Fixed,
        });
    }
    let rubber = builder.material(Material {
        stiffness_npm2,
        damping_nspm2: 20e3,
        shear_stiffness_npm: 3e6,
        friction_static: 0.5,
        friction_dynamic: 0.4,
        restitution: 0.1,
    });
    builder.all_other_pairs(rubber);
    builder.build().expect("a good model")
}

/// The states of all bodies of [`berth`] for a state of the ship.
pub(crate) fn states(ship: BodyState) -> Vec<BodyState> {
    let fender = |number: usize| BodyState {
        position_m: vec2(-120.0 + 30.0 * number as f64, 24.0),
        ..BodyState::default()
    };
    std::iter::once(ship).chain((0..FENDERS).map(fender)).collect()
}

/// Moves the ship under its contact forces and a push, by semi-implicit Euler.
pub(crate) fn advance(ship: &mut BodyState, work: &Workspace, push_n: Vec2, step_s: f64) {
    let wrench = work.wrenches()[SHIP];
    ship.velocity_mps += (wrench.force_n + push_n) * (step_s / SHIP_MASS_KG);
    ship.yaw_rate_radps += wrench.moment_nm * step_s / SHIP_YAW_INERTIA_KGM2;
    ship.position_m += ship.velocity_mps * step_s;
    ship.heading_rad += ship.yaw_rate_radps * step_s;
}
