//! Outlines that the host sets for each fender. The slope of the side is the gradient of the stored energy. Setting an
//! outline again leaves the contact's memory unchanged.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use fenderline_contact::*;

/// A floating hull with a bow, and a fender on a quay that faces her. The fender meets slices of the hull.
fn model(law: FenderLaw) -> (Model, FenderId, BodyId) {
    let mut builder = Model::builder();
    let square = [vec2(-50.0, -20.0), vec2(50.0, -20.0), vec2(50.0, 0.0), vec2(-50.0, 0.0)];
    let quay = builder.body(Body {
        name: "quay".into(),
        key: 1,
        outline: Outline::new(&square).unwrap().0,
        mobility: Mobility::Fixed,
    });
    let hull = builder.body(Body {
        name: "hull".into(),
        key: 2,
        outline: Outline::new(&at(0.0).0).unwrap().0,
        mobility: Mobility::Free { mass_kg: 1e7, yaw_inertia_kgm2: 5e9 },
    });
    let rubber = builder.material(Material {
        stiffness_npm2: 2e6,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e6,
        friction_static: 0.4,
        friction_dynamic: 0.3,
        restitution: 1.0,
    });
    let fender = builder.fender(Fender {
        name: "fender".into(),
        key: 1,
        body: quay,
        position_m: vec2(0.0, 0.0),
        facing_rad: std::f64::consts::FRAC_PI_2,
        width_m: 3.0,
        projection_m: 1.5,
        law,
        unloading: None,
        panel: None,
        material: rubber,
        rated_deflection_m: 1.0,
        stop: None,
        factors: ReactionFactors::default(),
    });
    builder.pair(Pair { bodies: [quay, hull], material: rubber });
    builder.outlines_by_height(hull, 40.0);
    (builder.build().unwrap(), fender, hull)
}

/// The hull's vertices at a height, and how they change with height. Flare grows towards the bow.
fn at(height_m: f64) -> (Vec<Vec2>, Vec<Vec2>) {
    let (foot, rates): (Vec<Vec2>, Vec<Vec2>) = [
        ((-30.0, -8.0), (0.0, -0.1)),
        ((10.0, -8.0), (0.0, -0.3)),
        ((30.0, 0.0), (0.8, 0.0)),
        ((10.0, 8.0), (0.0, 0.3)),
        ((-30.0, 8.0), (0.0, 0.1)),
    ]
    .map(|((x, y), (u, v))| (vec2(x, y), vec2(u, v)))
    .into_iter()
    .unzip();
    (foot.iter().zip(&rates).map(|(&v, &rate)| v + rate * height_m).collect(), rates)
}

fn slice(height_m: f64) -> Option<Slice> {
    let (vertices_m, rates) = at(height_m);
    Some(Slice::new(&vertices_m, &rates).unwrap())
}

/// The hull beside the fender, whose face is at y = 1.5 m.
fn states(along_m: f64, off_m: f64, heading_rad: f64) -> Vec<BodyState> {
    let hull = BodyState { position_m: vec2(along_m, off_m), heading_rad, ..BodyState::default() };
    vec![BodyState::default(), hull]
}

/// If the height rises a little, the work is force times slope times rise. The test checks both laws, on a side, across
/// the shoulder and at the bow. Here central differences over 2 mm are exact to 1e-6.
#[test]
fn the_slope_is_the_gradient_of_the_energy_by_height() {
    let curve = FenderLaw::Curve(vec![[0.0, 0.0], [0.4, 8e5], [1.2, 1e6]]);
    for law in [FenderLaw::linear(3e6), curve, FenderLaw::Area] {
        for (along_m, off_m, heading_rad) in
            [(0.0, 9.2, 0.0), (5.0, 9.1, 0.02), (-9.6, 8.7, 0.1), (-20.0, 11.1, -0.3)]
        {
            let (mut model, fender, hull) = model(law.clone());
            let states = states(along_m, off_m, heading_rad);
            let mut memory = Memory::new(&model);
            let ids = (fender, hull);
            model.renew_slice(
                &mut memory,
                &states,
                ids,
                slice(1.0),
                &mut RenewalBuffers::default(),
            );
            let mut work = Workspace::new(&model);
            advance(&model, &mut memory.clone(), &mut work, &states, &[Wrench::default(); 2], 1e-6)
                .unwrap();
            let contact = work.contacts().iter().find(|contact| contact.fender.is_some());
            let contact = contact.expect("a contact");
            let spring_n = contact.parts.spring_n;
            assert!(spring_n > 1e4, "{spring_n}");
            let side = model.side_met_by(fender, hull, &states).expect("a side");
            let fresh = Memory::new(&model);
            let e = 1e-3;
            model.renew_slice(
                &mut memory,
                &states,
                ids,
                slice(1.0 - e),
                &mut RenewalBuffers::default(),
            );
            let renewal = model.renew_slice(
                &mut fresh.clone(),
                &states,
                ids,
                slice(1.0 + e),
                &mut RenewalBuffers::default(),
            );
            let by_hand_n = renewal.work_j / (2.0 * e);
            let by_slope_n = spring_n * side.slope;
            assert!((by_slope_n / by_hand_n - 1.0).abs() < 1e-5, "{by_slope_n} {by_hand_n}");
        }
    }
}

/// The factor by angle takes the angle in space. Without a slope this angle is the tilt, bit for bit.
#[test]
fn the_angle_in_space_combines_both_angles() {
    assert_eq!(combined_angle_rad(0.123, 0.0).to_bits(), 0.123_f64.to_bits());
    assert!((combined_angle_rad(0.0, 0.5).tan() - 0.5).abs() < 1e-15);
    assert!((combined_angle_rad(0.3, -0.4).tan() - 0.3_f64.tan().hypot(0.4)).abs() < 1e-15);
}

/// A hull slides along the fender with friction. Setting the same outline again in each step changes no bit.
#[test]
fn a_renewal_by_the_same_outline_changes_nothing() {
    let play = |renews: bool| {
        let (mut model, fender, hull) = model(FenderLaw::linear(3e6));
        let mut states = states(0.0, 9.4, 0.05);
        states[1].velocity_mps = vec2(0.3, -0.2);
        let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
        model.renew_slice(
            &mut memory,
            &states,
            (fender, hull),
            slice(1.0),
            &mut RenewalBuffers::default(),
        );
        let mut bits = Vec::new();
        for _ in 0..200 {
            if renews {
                let renewal = model.renew_slice(
                    &mut memory,
                    &states,
                    (fender, hull),
                    slice(1.0),
                    &mut RenewalBuffers::default(),
                );
                assert_eq!(renewal.work_j, 0.0);
                assert_eq!(renewal.before, slice(1.0));
            }
            let loads = [Wrench::default(); 2];
            advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, 0.05).unwrap();
            let BodyState { position_m, heading_rad, .. } = states[1];
            bits.extend([position_m.x, position_m.y, heading_rad].map(f64::to_bits));
        }
        bits
    };
    assert!(play(true) == play(false));
}

#[test]
fn without_a_slice_a_fender_does_not_meet_the_hull() {
    let (mut model, fender, hull) = model(FenderLaw::linear(3e6));
    let states = states(0.0, 9.2, 0.0);
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let loads = [Wrench::default(); 2];
    let count = |model: &Model, memory: &Memory, work: &mut Workspace| {
        advance(model, &mut memory.clone(), work, &states, &loads, 0.01).unwrap();
        work.contacts().len()
    };
    assert_eq!(count(&model, &memory, &mut work), 0);
    assert!(model.side_met_by(fender, hull, &states).is_none());
    assert!(model.would_press((fender, hull), &states, &slice(0.0).unwrap()));
    assert_eq!(count(&model, &memory, &mut work), 0);
    model.renew_slice(
        &mut memory,
        &states,
        (fender, hull),
        slice(0.0),
        &mut RenewalBuffers::default(),
    );
    assert_eq!(count(&model, &memory, &mut work), 1);
    model.undo_renewal((fender, hull), None);
    assert_eq!(count(&model, &memory, &mut work), 0);
}

#[test]
fn bad_bodies_and_radii_of_outlines_by_height_are_refused() {
    let build = |body: u32, radius_m: f64| {
        let mut builder = Model::builder();
        builder.body(Body {
            name: "hull".into(),
            key: 1,
            outline: Outline::new(&at(0.0).0).unwrap().0,
            mobility: Mobility::Fixed,
        });
        builder.outlines_by_height(BodyId(body), radius_m);
        builder.build().map(drop)
    };
    assert!(build(0, 40.0).is_ok());
    assert_eq!(build(7, 40.0), Err(ModelError::UnknownId { what: "body", index: 7 }));
    for radius_m in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(build(0, radius_m), Err(ModelError::OutOfRange { .. })), "{radius_m}");
    }
    assert!(matches!(Slice::new(&at(0.0).0[..2], &[]), Err(OutlineError::TooFewVertices { .. })));
}
