//! Bodies that are not convex in the whole engine: the area compared with an integer-grid clipper, the normal compared
//! with the area's derivative, and patches that split and merge.

use crate::support;

use fenderline_contact::{BodyState, Contact, EventKind, Material, Pose, Vec2, vec2};
use geo::{Area, BooleanOps, Coord, LineString, Polygon};
use proptest::prelude::*;
use support::harbour::{PAPER, Run, at, body, contacts_of, model};
use support::shapes::{beside, hull, points, rectangle, stepped_ship};

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(cases) }
}

/// A basin: two arms around a slip that is open to +x.
fn basin() -> Vec<Vec2> {
    points(&[
        (-10.0, -30.0),
        (60.0, -30.0),
        (60.0, -12.0),
        (0.0, -12.0),
        (0.0, 12.0),
        (60.0, 12.0),
        (60.0, 30.0),
        (-10.0, 30.0),
    ])
}

/// A saw: six teeth of `depth_m` on one back.
fn saw(depth_m: f64) -> Vec<Vec2> {
    let mut ring = points(&[(0.0, 0.0), (60.0, 0.0)]);
    for tooth in (0..6).rev() {
        let x = 10.0 * f64::from(tooth);
        ring.extend([vec2(x + 7.0, 4.0 + depth_m), vec2(x + 0.5, 4.0)]);
    }
    ring.push(vec2(0.0, 4.0));
    ring
}

/// A star. Every second corner is the tip of a ray. It has so many pieces that a tree finds them.
fn star(rays: usize, ray_m: f64) -> Vec<Vec2> {
    let corner = |k: usize| {
        let (sin, cos) = libm::sincos(core::f64::consts::PI * k as f64 / rays as f64);
        vec2(cos, sin) * if k.is_multiple_of(2) { 30.0 } else { 30.0 - ray_m }
    };
    (0..2 * rays).map(corner).collect()
}

fn placed(ring: &[Vec2], pose: Pose) -> Vec<Vec2> {
    ring.iter().map(|&v| pose.apply(v)).collect()
}

/// Area by the crate `geo`. Its coordinates are on an integer grid, so its best accuracy for bodies of 100 m is 1e-5
/// m².
fn geo_area_m2(a: &[Vec2], b: &[Vec2]) -> f64 {
    let polygon = |ring: &[Vec2]| {
        let line: LineString = ring.iter().map(|v| Coord { x: v.x, y: v.y }).collect();
        Polygon::new(line, vec![])
    };
    polygon(a).intersection(&polygon(b)).unsigned_area()
}

fn area_m2(contacts: &[Contact]) -> f64 {
    contacts.iter().map(|c| c.area_m2).sum()
}

fn shape() -> impl Strategy<Value = Vec<Vec2>> {
    prop_oneof![
        Just(basin()),
        Just(stepped_ship()),
        (1.0..9.0f64).prop_map(saw),
        (9usize..60, 0.5..15.0f64).prop_map(|(rays, ray_m)| star(rays, ray_m)),
        (6usize..40).prop_map(|count| hull(120.0, 24.0, count)),
        (1.0..40.0f64, 1.0..9.0f64).prop_map(|(l, w)| rectangle(l, w)),
    ]
}

proptest! {
    #![proptest_config(config(1000))]

    #[test]
    fn the_area_of_non_convex_bodies_matches_an_independent_clipper(
        a in shape(),
        b in shape(),
        (a_heading, b_heading) in (0.0..6.3f64, 0.0..6.3f64),
        (bearing, depth_m, share) in (0.0..6.3f64, 0.05..30.0f64, -0.5..0.5f64),
    ) {
        let one = at(3.0, -4.0, a_heading);
        let place = beside(&a, one.pose(), &b, b_heading, (bearing, depth_m, share));
        let two = at(place.position_m.x, place.position_m.y, b_heading);
        let contacts = contacts_of(&a, one, &b, two);
        let right = geo_area_m2(&placed(&a, one.pose()), &placed(&b, two.pose()));
        let ours = area_m2(&contacts);
        prop_assert!((ours - right).abs() <= 2e-5 + 1e-7 * right, "{ours} not {right}");
    }

    /// The gradient ∂S/∂x₁ = ℓ n, summed over the patches. The area is piecewise quadratic in the position, so a
    /// central difference is exact unless a corner crosses an edge within it.
    #[test]
    fn the_normal_is_the_gradient_of_the_area(
        a in shape(),
        b in shape(),
        (a_heading, b_heading) in (0.0..6.3f64, 0.0..6.3f64),
        (bearing, depth_m, share) in (0.0..6.3f64, 0.05..5.0f64, -0.5..0.5f64),
    ) {
        let one = at(3.0, -4.0, a_heading);
        let place = beside(&a, one.pose(), &b, b_heading, (bearing, depth_m, share));
        let two = at(place.position_m.x, place.position_m.y, b_heading);
        let contacts = contacts_of(&a, one, &b, two);
        let [contact] = contacts[..] else { return Ok(()) };
        let moved = |by: Vec2| {
            let state = BodyState { position_m: one.position_m + by, ..one };
            area_m2(&contacts_of(&a, state, &b, two))
        };
        let gradient = |h: f64| {
            let x = moved(vec2(h, 0.0)) - moved(vec2(-h, 0.0));
            vec2(x, moved(vec2(0.0, h)) - moved(vec2(0.0, -h))) * (0.5 / h)
        };
        // The test takes two widths. If their results differ, a corner crosses an edge.
        let (wide, narrow) = (gradient(1e-4), gradient(0.5e-4));
        prop_assume!((wide - narrow).length() < 1e-7 * (1.0 + wide.length()));
        // ℓ is 0 for a body that lies within another body.
        prop_assume!(wide.length() > 0.1);
        let normal = wide * (1.0 / wide.length());
        prop_assert!((normal - contact.normal).length() < 1e-6, "{:?} not {normal:?}", contact.normal);
    }
}

/// The two arms of a basin touch a quay. They are two patches, each with its own centroid.
#[test]
fn two_arms_against_a_wall_give_two_patches() {
    let wall = rectangle(10.0, 200.0);
    let contacts = contacts_of(&basin(), at(0.0, 0.0, 0.0), &wall, at(64.5, 0.0, 0.0));
    assert_eq!(contacts.len(), 2);
    for (contact, side) in contacts.iter().zip([-1.0, 1.0]) {
        assert!((contact.area_m2 - 18.0 * 0.5).abs() < 1e-11);
        assert!((contact.point_m - vec2(59.75, side * 21.0)).length() < 1e-11);
        assert!((contact.normal - vec2(1.0, 0.0)).length() < 1e-14);
        assert!((contact.depth_m - 0.5).abs() < 1e-12);
    }
    assert_eq!([contacts[0].patch, contacts[1].patch], [0, 1]);
}

const DAMPED: Material = Material { damping_nspm2: 200e3, ..PAPER };

/// A body with two feet is pressed into a quay until its middle touches too, and is pulled out again. The memory of the
/// shear continues while patches merge and split.
#[test]
fn patches_that_merge_and_split_keep_their_shear() {
    let feet = points(&[
        (0.0, -20.0),
        (6.0, -20.0),
        (6.0, -10.0),
        (5.0, -10.0),
        (5.0, 10.0),
        (6.0, 10.0),
        (6.0, 20.0),
        (0.0, 20.0),
    ]);
    let wall = rectangle(10.0, 200.0);
    let bodies = vec![body(1, &feet, true), body(2, &wall, false)];
    let mut run = Run::new(model(bodies, Material { friction_static: 1e3, ..PAPER }));
    let quay = at(11.0, 0.0, 0.0);
    // The body moves sideways by 1 mm per step, while it moves in by 0.1 m per step and out again.
    let mut seen = Vec::new();
    for step in 0..20i32 {
        let depth_m = 0.55 + 0.1 * f64::from(10 - (step - 10).abs());
        let state = BodyState {
            velocity_mps: vec2(1.0, 0.01), // pressed on, so that the limiter lets N be
            ..at(depth_m, 0.001 * f64::from(step), 0.0)
        };
        let contacts = run.step(&[state, quay], 0.1);
        let shears: Vec<f64> = contacts.iter().map(|c| c.shear_m).collect();
        for shear in &shears {
            let right = 0.001 * f64::from(step);
            assert!((shear - right).abs() < 1e-12, "step {step}: {shears:?}");
        }
        if step > 0 {
            assert!(
                !run.has_event(EventKind::ContactBegan) && !run.has_event(EventKind::ContactEnded)
            );
        }
        if run.has_event(EventKind::PatchesMerged) {
            seen.push("merged");
        }
        if run.has_event(EventKind::PatchSplit) {
            seen.push("split");
        }
    }
    assert_eq!(seen, ["merged", "split"]);
}

/// A split does not change the overlap. The damper follows the growth of the area, and must not take half of the patch
/// for a sudden loss of area.
#[test]
fn a_split_does_not_change_the_damper_force() {
    let notched = points(&[
        (0.0, -20.0),
        (6.0, -20.0),
        (6.0, -0.5),
        (5.0, -0.5),
        (5.0, 0.5),
        (6.0, 0.5),
        (6.0, 20.0),
        (0.0, 20.0),
    ]);
    let wall = rectangle(10.0, 200.0);
    let bodies = vec![body(1, &notched, true), body(2, &wall, false)];
    let mut run = Run::new(model(bodies, Material { restitution: 1.0, ..DAMPED }));
    let mut forces = Vec::new();
    let mut patches = Vec::new();
    for step in 0..6 {
        // The body moves out by 5 mm per step. The notch becomes free between the third step and the fourth.
        let depth_m = 1.0125 - 0.005 * f64::from(step);
        let state = BodyState { velocity_mps: vec2(3.0, 0.0), ..at(depth_m, 0.0, 0.0) };
        let contacts = run.step(&[state, at(11.0, 0.0, 0.0)], 0.1);
        forces.push(contacts.iter().map(|c| c.normal_force_n).sum::<f64>());
        patches.push(contacts.len());
    }
    assert_eq!(patches, [1, 1, 1, 2, 2, 2]);
    for two in forces.windows(2).skip(1) {
        assert!((two[1] / two[0] - 1.0).abs() < 0.05, "{forces:?}");
    }
}
