//! Seams: a hull in several convex pieces is one hull. No result of a contact may depend on where the hull is cut.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

use crate::support;

use fenderline_contact::{BodyState, Contact, EventKind, Material, Outline, Vec2, vec2};
use proptest::prelude::*;
use support::harbour::{PAPER, Run, at, body, model};
use support::shapes::{any_convex, beside, hull, points, rectangle};

/// A convex hull, and the same hull with a tiny notch in its far side. The notch forces diagonals across the hull. Some
/// of these end in vertices of the near side.
fn plain_and_notched() -> Vec<(Vec<Vec2>, Vec<Vec2>)> {
    let ship = hull(298.0, 46.0, 24);
    // The far side is the second-last edge: from (0.7 · 149, 23) to (−149, 23).
    let with_notches = |places: &[f64]| {
        let mut ring = ship[..ship.len() - 1].to_vec();
        for &x in places {
            ring.extend([vec2(x + 1e-3, 23.0), vec2(x, 22.999), vec2(x - 1e-3, 23.0)]);
        }
        ring.push(ship[ship.len() - 1]);
        ring
    };
    vec![
        (ship.clone(), with_notches(&[0.0])),
        (ship.clone(), with_notches(&[60.0, -100.0])),
        (ship.clone(), with_notches(&[100.0, 40.0, 0.0, -30.0, -120.0])),
    ]
}

/// Compares two values. The tolerance allows for notches of 1e-6 m² on the far side.
#[track_caller]
fn equal(what: &str, one: f64, two: f64, scale: f64, context: &str) {
    let limit = 1e-9 * scale.abs().max(one.abs());
    assert!((one - two).abs() <= limit, "{what}: {one:e} not {two:e}, {context}");
}

#[track_caller]
fn same_contact(one: &Contact, two: &Contact, context: &str) {
    equal("area", one.area_m2, two.area_m2, 0.0, context);
    equal("depth", one.depth_m, two.depth_m, 0.0, context);
    equal("normal force", one.normal_force_n, two.normal_force_n, 0.0, context);
    equal("friction", one.tangential_force_n, two.tangential_force_n, one.normal_force_n, context);
    equal("shear", one.shear_m, two.shear_m, 1.0, context);
    equal("V_n", one.v_normal_mps, two.v_normal_mps, 1.0, context);
    equal("normal x", one.normal.x, two.normal.x, 1.0, context);
    equal("normal y", one.normal.y, two.normal.y, 1.0, context);
    equal("arm x", one.arm_1_m.x, two.arm_1_m.x, 150.0, context);
    equal("arm y", one.arm_1_m.y, two.arm_1_m.y, 150.0, context);
    assert_eq!((one.friction, one.limited, one.patch), (two.friction, two.limited, two.patch));
}

/// Slides both hulls past a fender with the same states and compares every step.
fn slide(
    plain: &[Vec2],
    cut: &[Vec2],
    fender: &[Vec2],
    material: Material,
    track: &dyn Fn(i32) -> [BodyState; 2],
) {
    let run = |ring: &[Vec2]| {
        Run::new(model(vec![body(1, ring, true), body(2, fender, false)], material))
    };
    let (mut one, mut two) = (run(plain), run(cut));
    let mut touching = 0;
    for step in 0..1000 {
        let states = track(step);
        let (first, second) = (one.step(&states, 0.1), two.step(&states, 0.1));
        let context = format!("step {step}");
        assert_eq!(first.len(), second.len(), "{context}: {second:?}");
        first.iter().zip(&second).for_each(|(c, d)| same_contact(c, d, &context));
        assert_eq!(one.work.events(), two.work.events(), "{context}");
        touching += first.len();
    }
    assert!(touching > 500, "{touching}");
}

#[test]
fn a_hull_in_pieces_slides_along_a_fender_like_a_whole_one() {
    let slippery = Material { friction_static: 0.2, friction_dynamic: 0.15, ..PAPER };
    let damped = Material { damping_nspm2: 300e3, ..PAPER };
    let fenders = [rectangle(4.0, 1.5), points(&[(0.0, -1.0), (2.0, 1.0), (-2.0, 1.0)])];
    for (plain, cut) in plain_and_notched() {
        let (outline, _) = Outline::new(&cut).expect("a good outline");
        assert!(outline.pieces().len() > 1);
        for (fender, top) in fenders.iter().zip([0.75, 1.0]) {
            for material in [PAPER, slippery, damped] {
                // The hulls slide along the near side (y = −23), from aft of midships round the shoulder.
                slide(&plain, &cut, fender, material, &|step| {
                    let t = f64::from(step);
                    let depth_m = 0.2 + 0.1 * libm::sin(0.05 * t);
                    let ship = BodyState {
                        velocity_mps: vec2(2.0, -0.3 + 0.05 * libm::cos(0.05 * t)),
                        ..at(-100.0 + 0.2 * t, 0.0, 0.01 * libm::sin(0.013 * t))
                    };
                    let reach =
                        23.0 + top - depth_m + 0.01 * libm::sin(0.013 * t) * (100.0 - 0.2 * t);
                    [ship, at(0.0, -reach, if top > 0.9 { 0.0 } else { 0.02 })]
                });
            }
        }
    }
}

/// A hull with a real knuckle. With notches at different places, the same outline is cut along different diagonals.
#[test]
fn the_cuts_of_a_knuckled_hull_do_not_matter() {
    let knuckled = points(&[
        (-80.0, -14.0),
        (-20.0, -12.0), // a hollow in the side
        (40.0, -14.0),
        (85.0, 0.0),
        (40.0, 14.0),
        (-80.0, 14.0),
    ]);
    let mut notched = knuckled[..5].to_vec();
    for x in [20.0, -20.0, -60.0] {
        notched.extend([vec2(x + 1e-3, 14.0), vec2(x, 13.999), vec2(x - 1e-3, 14.0)]);
    }
    notched.push(knuckled[5]);
    for fender in [rectangle(30.0, 2.0), rectangle(3.0, 2.0)] {
        slide(&knuckled, &notched, &fender, PAPER, &|step| {
            let t = f64::from(step);
            let ship = BodyState {
                velocity_mps: vec2(0.5, -0.3),
                ..at(-20.0 + 0.05 * t, 0.0, 0.002 * libm::sin(0.01 * t))
            };
            [ship, at(0.0, -12.2 - 0.1 * libm::sin(0.02 * t), 0.0)]
        });
    }
}

/// The fender crosses a seam in ten thousand tiny steps. All results are continuous, and no contact ends or begins.
#[test]
fn a_contact_that_crosses_a_seam_slowly_continues() {
    let mut crossed = 0;
    for (_, cut) in plain_and_notched() {
        // The corner of the stern is left out: there is no side to slide along beyond it.
        let seams = seam_ends_on_the_near_side(&cut).into_iter().filter(|s| s.x > -149.0);
        let fender = points(&[(0.0, -1.0), (2.0, 1.0), (-2.0, 1.0)]); // a flat top, y = 1
        let corner = points(&[(0.0, 1.0), (-2.0, -1.0), (2.0, -1.0)]); // a corner on top, y = 1
        for seam in seams {
            crossed += 1;
            for (shape, depth_m) in
                [(&fender, 1e-3), (&corner, 1e-3), (&fender, 1e-6), (&corner, 1e-6)]
            {
                let bodies = vec![body(1, &cut, true), body(2, shape, false)];
                let mut run = Run::new(model(bodies, PAPER));
                let mut last: Option<Contact> = None;
                for step in 0..2000 {
                    // The steps are 2 nm in the middle, where the tip of the corner passes, and coarser elsewhere.
                    let s = f64::from(step - 1000) / 1000.0;
                    let x = 4.0 * depth_m * s * s * s;
                    let ship = BodyState { velocity_mps: vec2(0.0, -0.5), ..at(0.0, 0.0, 0.0) };
                    let states = [ship, at(seam.x + x, seam.y - 1.0 + depth_m, 0.0)];
                    let contacts = run.step(&states, 0.1);
                    assert_eq!(contacts.len(), 1, "step {step} at {seam:?}, {depth_m:e} deep");
                    if let Some(last) = last {
                        assert!(
                            run.work.events().is_empty(),
                            "step {step}: {:?}",
                            run.work.events()
                        );
                        let (a, b) = (last.area_m2, contacts[0].area_m2);
                        assert!((a - b).abs() <= 0.05 * a, "step {step}: area {a:e} then {b:e}");
                    } else {
                        assert!(run.has_event(EventKind::ContactBegan));
                    }
                    last = Some(contacts[0]);
                }
            }
        }
    }
    assert!(crossed >= 3, "{crossed}");
}

/// Ends of seams on y = −23, where two pieces have the same vertex.
fn seam_ends_on_the_near_side(ring: &[Vec2]) -> Vec<Vec2> {
    let (outline, _) = Outline::new(ring).expect("a good outline");
    let near = ring.iter().copied().filter(|v| v.y < 0.0);
    near.filter(|v| outline.pieces().iter().filter(|p| p.contains(v)).count() > 1).collect()
}

/// The first touch on the end of a seam, however light, is one contact and not two.
#[test]
fn a_touch_of_a_nanometre_on_a_seam_is_one_contact() {
    for (_, cut) in plain_and_notched() {
        for seam in seam_ends_on_the_near_side(&cut) {
            for power in 1..10 {
                let depth_m = libm::pow(10.0, f64::from(-power));
                let wall = rectangle(20.0, 2.0);
                let bodies = vec![body(1, &cut, true), body(2, &wall, false)];
                let mut run = Run::new(model(bodies, PAPER));
                let ship = BodyState { velocity_mps: vec2(0.0, -0.1), ..at(0.0, 0.0, 0.0) };
                let states = [ship, at(seam.x, seam.y - 1.0 + depth_m, 0.0)];
                let contacts = run.step(&states, 0.1);
                assert_eq!(contacts.len(), 1, "{depth_m:e} m at {seam:?}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        ..ProptestConfig::with_cases(1000)
    })]

    /// Any convex body touches the near side, from a millimetre to eight metres deep.
    #[test]
    fn a_hull_in_pieces_contacts_any_body_like_a_whole_one(
        which in 0usize..3,
        other in any_convex(),
        (ship_heading, heading) in (0.0..6.3f64, 0.0..6.3f64),
        (bearing, share) in (-2.6..-0.5f64, -0.5..0.5f64),
        power in -3.0..0.9f64,
    ) {
        let (plain, cut) = &plain_and_notched()[which];
        let ship = at(5.0, 7.0, ship_heading);
        let depth_m = libm::pow(10.0, power);
        let off = (bearing + ship_heading, depth_m, share);
        let place = beside(plain, ship.pose(), &other, heading, off);
        let states = [ship, at(place.position_m.x, place.position_m.y, heading)];
        let contacts = |ring: &[Vec2]| {
            let bodies = vec![body(1, ring, true), body(2, &other, false)];
            Run::new(model(bodies, PAPER)).step(&states, 0.1)
        };
        let (one, two) = (contacts(plain), contacts(cut));
        let far_side = |c: &Contact| ship.pose().apply_inverse(c.point_m).y + c.depth_m > 22.0;
        prop_assume!(!one.iter().chain(&two).any(far_side)); // the notches are real
        // Without crossings the first normal is a choice. Another test checks it.
        let contained = one.iter().any(|c| c.area_m2 > (1.0 - 1e-9) * area_m2(&other));
        prop_assume!(!contained);
        prop_assert_eq!(one.len(), two.len(), "{:?} and {:?}", one, two);
        for (c, d) in one.iter().zip(&two) {
            same_contact(c, d, &format!("{depth_m:e} m deep"));
        }
    }
}

fn area_m2(ring: &[Vec2]) -> f64 {
    Outline::new(ring).expect("a good outline").0.area_m2()
}

/// A body that is first found inside a hull is pushed out through the nearest side of the hull, and not through the
/// nearest seam.
#[test]
fn a_body_found_inside_a_hull_is_not_pushed_through_a_seam() {
    for (plain, cut) in plain_and_notched() {
        for i in 0..40 {
            let states = [at(0.0, 0.0, 0.0), at(-140.0 + 6.0 * f64::from(i), -21.0, 0.0)];
            let normal = |ring: &[Vec2]| {
                let bodies = vec![body(1, ring, true), body(2, &rectangle(0.5, 0.5), true)];
                Run::new(model(bodies, PAPER)).step(&states, 0.1)[0].normal
            };
            let (one, two) = (normal(&plain), normal(&cut));
            assert!((one - two).length() < 1e-9, "{one:?} not {two:?} at {:?}", states[1]);
        }
    }
}
