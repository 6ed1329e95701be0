//! A fender's force is the gradient of its stored energy.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

use fenderline_contact::*;
use proptest::prelude::*;

fn hull(vertices: &[Vec2]) -> Outline {
    Outline::new(vertices).expect("a good outline").0
}

/// A blunt, non-convex hull of 60 m × 16 m, with a step.
fn stepped_hull() -> Outline {
    let points = [(-30.0, -8.0), (22.0, -8.0), (30.0, -2.0), (30.0, 3.0), (20.0, 8.0), (4.0, 8.0)];
    let mut vertices: Vec<Vec2> = points.iter().map(|&(x, y)| vec2(x, y)).collect();
    vertices.extend([vec2(3.0, 7.2), vec2(-30.0, 7.0)]);
    hull(&vertices)
}

const RUBBER: Material = Material {
    stiffness_npm2: 400e3,
    damping_nspm2: 0.0,
    shear_stiffness_npm: 0.0,
    friction_static: 0.0,
    friction_dynamic: 0.0,
    restitution: 0.1,
};

fn fender(body: BodyId, law: FenderLaw) -> Fender {
    Fender {
        name: "fender".into(),
        key: 0,
        body,
        position_m: vec2(0.0, 0.0),
        facing_rad: 0.0,
        width_m: 3.0,
        projection_m: 1.2,
        law,
        unloading: None,
        material: MaterialId(0),
        rated_deflection_m: 0.8,
        stop: Some(Stop { from_m: 0.9, stiffness_npm: 3e7 }),
        factors: ReactionFactors::default(),
        panel: None,
    }
}

fn cone() -> FenderLaw {
    FenderLaw::Curve(vec![[0.0, 0.0], [0.25, 6e5], [0.5, 5e5], [0.8, 6e5], [1.0, 9e5]])
}

/// A quay with a fender that faces north, and a ship. `quay_first` decides in whose frame the pair is computed.
fn model(law: FenderLaw, quay_first: bool) -> (Model, BodyId, BodyId) {
    let mut builder = Model::builder();
    let quay = Body {
        name: "quay".into(),
        key: u64::from(!quay_first),
        outline: hull(&[vec2(-9.0, -50.0), vec2(-0.5, -50.0), vec2(-0.5, 50.0), vec2(-9.0, 50.0)]),
        mobility: Mobility::Fixed,
    };
    let ship = Body {
        name: "ship".into(),
        key: u64::from(quay_first),
        outline: stepped_hull(),
        mobility: Mobility::Free { mass_kg: 5e6, yaw_inertia_kgm2: 1e9 },
    };
    let (quay, ship) = (builder.body(quay), builder.body(ship));
    let material = builder.material(RUBBER);
    builder.fender(fender(quay, law));
    builder.pair(Pair { bodies: [quay, ship], material });
    (builder.build().expect("a good model"), quay, ship)
}

/// Stored energy, and the trial force and moment on the ship about her centre of gravity. The depth goes up to the
/// fender's projection. The fender's zone is twice as deep.
fn pressed(model: &Model, pose: [f64; 3], origin_m: Vec2) -> Option<(f64, [f64; 3])> {
    pressed_up_to(1.2, model, pose, origin_m)
}

/// Computes [`pressed`] for depths up to `most_m` times the projection.
fn pressed_up_to(
    most_m: f64,
    model: &Model,
    pose: [f64; 3],
    origin_m: Vec2,
) -> Option<(f64, [f64; 3])> {
    let (mut memory, mut work) = (Memory::new(model), Workspace::new(model));
    let states = [
        BodyState { position_m: origin_m, ..BodyState::default() },
        BodyState {
            position_m: origin_m + vec2(pose[0], pose[1]),
            heading_rad: pose[2],
            ..BodyState::default()
        },
    ];
    step(model, &mut memory, &mut work, &states, 0.1).expect("a good step");
    let on_fender = |c: &&Contact| c.fender.is_some() && c.depth_m <= most_m;
    let contact = work.contacts().iter().find(on_fender)?;
    // Body 1 is the quay, so the force on the ship is +N n.
    let force = contact.normal * (contact.parts.spring_n + contact.parts.stop_n);
    let moment = contact.arm_2_m.cross(force);
    Some((contact.energy.stored_j, [force.x, force.y, moment]))
}

/// Poses with the ship's side, bow or stern on the fender; at 90° her side is parallel to the quay.
fn poses() -> impl Strategy<Value = [f64; 3]> {
    let along_side = (8.2..9.1_f64, -28.0..28.0_f64, -0.25..0.25_f64)
        .prop_map(|(x, y, tilt)| [x, y, core::f64::consts::FRAC_PI_2 + tilt]);
    let end_on = (30.2..31.1_f64, -8.0..8.0_f64, -0.4..0.4_f64)
        .prop_map(|(x, y, tilt)| [x, y, core::f64::consts::PI + tilt]);
    prop_oneof![along_side, end_on]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6000))]

    /// Central differences over 10 µm. Their error is of the order of 1e-10 of the energy's third derivative. The
    /// rounding of a stored energy of 1e5 J gives 1e-6 of the force. If a corner crosses a side of the fender within
    /// the difference, the force has a kink; 1e-4 allows for it.
    #[test]
    fn the_force_is_the_gradient_of_the_stored_energy(
        pose in poses(),
        area in any::<bool>(),
        quay_first in any::<bool>(),
    ) {
        let law = if area { FenderLaw::Area } else { cone() };
        let (model, ..) = model(law, quay_first);
        // About a quarter of the poses touch the fender within its travel.
        let Some((stored_j, force)) = pressed(&model, pose, Vec2::ZERO) else { return Ok(()) };
        if stored_j < 100.0 {
            return Ok(());
        }
        let size = vec2(force[0], force[1]).length();
        for axis in 0..3 {
            let by = if axis == 2 { 1e-6 } else { 1e-5 };
            let stored = |sign: f64| {
                let mut moved = pose;
                moved[axis] += sign * by;
                // The limit is a little deeper than the pose itself.
                pressed_up_to(1.3, &model, moved, Vec2::ZERO).map_or(0.0, |(stored_j, _)| stored_j)
            };
            let gradient = -(stored(1.0) - stored(-1.0)) / (2.0 * by);
            // The lever of the moment is up to 30 m.
            let scale = if axis == 2 { 30.0 } else { 1.0 } * (size + 1e3);
            prop_assert!(
                (force[axis] - gradient).abs() <= 1e-4 * scale,
                "axis {axis}: {} against {gradient} at {pose:?}", force[axis]
            );
        }
    }

    /// The positions are UTM coordinates of 1e7 m, which are rounded to 2e-9 m.
    #[test]
    fn the_order_of_keys_and_the_charts_origin_do_not_matter(pose in poses()) {
        let (one, ..) = model(cone(), true);
        let (two, ..) = model(cone(), false);
        let here = pressed(&one, pose, Vec2::ZERO);
        let (there, far) = (
            pressed(&two, pose, Vec2::ZERO),
            pressed(&one, pose, vec2(1e7, -1e7)),
        );
        if let (Some((_, here)), Some((_, there)), Some((_, far))) = (here, there, far) {
            for axis in 0..3 {
                let scale = here[0].abs() + here[1].abs() + here[2].abs();
                prop_assert!((here[axis] - there[axis]).abs() <= 1e-12 * scale + 1e-6);
                prop_assert!((here[axis] - far[axis]).abs() <= 1e-7 * scale + 1.0);
            }
        }
    }
}

#[test]
fn a_flat_side_gets_the_reaction_at_its_depth() {
    // The ship's port side at y = −8 is parallel to the face. At heading 90° the face lies to the north of her, at −90°
    // to the south.
    let heading = -core::f64::consts::FRAC_PI_2;
    for depth_m in [0.05, 0.25, 0.4, 0.7, 0.95] {
        // Her port side is at x_ship − 8, and the face at 1.2.
        let pose = [1.2 + 8.0 - depth_m, 0.0, heading];
        let expected = [
            (FenderLaw::Area, 400e3 * 3.0 * depth_m, 0.5 * 400e3 * 3.0 * depth_m * depth_m),
            (cone(), cone().reaction_n(depth_m), cone().energy_j(depth_m)),
        ];
        let past_m = (depth_m - 0.9_f64).max(0.0);
        for (law, force_n, stored_j) in expected {
            let (model, ..) = model(law, true);
            let (stored, force) = pressed(&model, pose, Vec2::ZERO).expect("they touch");
            let force_n = force_n + 3e7 * past_m;
            assert!((force[0] / force_n - 1.0).abs() < 1e-9, "{} N, not {force_n}", force[0]);
            assert!(force[1].abs() < 1e-6 * force_n);
            assert!((stored / (stored_j + 1.5e7 * past_m * past_m) - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn impossible_fenders_are_refused_by_name() {
    let mut body = Model::builder();
    let quay = body.body(Body {
        name: "quay".into(),
        key: 0,
        outline: hull(&[vec2(0.0, 0.0), vec2(1.0, 0.0), vec2(1.0, 1.0)]),
        mobility: Mobility::Fixed,
    });
    body.material(RUBBER);
    let good = fender(quay, cone());
    let bad: Vec<(&str, Fender)> = vec![
        ("width", Fender { width_m: 0.0, ..good.clone() }),
        ("projection", Fender { projection_m: f64::NAN, ..good.clone() }),
        ("facing", Fender { facing_rad: f64::INFINITY, ..good.clone() }),
        ("rated deflection", Fender { rated_deflection_m: -1.0, ..good.clone() }),
        ("stop", Fender { stop: Some(Stop { from_m: 0.0, stiffness_npm: 1.0 }), ..good.clone() }),
        ("curve", Fender { law: FenderLaw::Curve(vec![[0.0, 0.0]]), ..good.clone() }),
        ("curve", Fender { law: FenderLaw::Curve(vec![[0.0, 1.0], [1.0, 2.0]]), ..good.clone() }),
        (
            "deflection of the curve",
            Fender {
                law: FenderLaw::Curve(vec![[0.0, 0.0], [1.0, 2.0], [1.0, 3.0]]),
                ..good.clone()
            },
        ),
        (
            "deflection of the curve",
            Fender { law: FenderLaw::Curve(vec![[0.0, 0.0], [1.0, -2.0]]), ..good.clone() },
        ),
        (
            "factor",
            Fender {
                factors: ReactionFactors { constant: 0.0, ..ReactionFactors::default() },
                ..good.clone()
            },
        ),
    ];
    for (wanted, fender) in bad {
        let mut builder = body.clone();
        builder.fender(fender);
        match builder.build() {
            Err(ModelError::OutOfRange { owner, field, .. }) => {
                assert_eq!((owner.as_str(), field), ("fender", wanted));
            }
            other => panic!("{wanted}: {other:?}"),
        }
    }
    let mut twice = body.clone();
    twice.fender(good.clone());
    twice.fender(good.clone());
    assert!(matches!(twice.build(), Err(ModelError::DuplicateKey { .. })));
    for fender in
        [Fender { body: BodyId(7), ..good.clone() }, Fender { material: MaterialId(7), ..good }]
    {
        let mut builder = body.clone();
        builder.fender(fender);
        assert!(matches!(builder.build(), Err(ModelError::UnknownId { index: 7, .. })));
    }
}
